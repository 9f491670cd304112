// Bounces win no energy, whatever meets within a step, and lose none where nothing should be lost. The oracle
// is the energy that was there.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

enum class Form { Discs, Boxes, Both };

// In a box of 10 m, on a grid at first.
class Gas {
  public:
    Gas(Form form, int count, float fastest_m_s, float restitution, std::uint64_t seed, float friction = 0)
        : world_({.gravity_m_s2 = {}, .enable_sleep = false}) {
        Random random(seed);
        const ShapeDef def{.material = {.friction = friction, .restitution = restitution}};
        for (const double side : {-6.0, 6.0}) {
            add(world_, {.type = BodyType::Static, .position_m = {side, 0}}, Box{1, 7}, def);
            add(world_, {.type = BodyType::Static, .position_m = {0, side}}, Box{7, 1}, def);
        }
        for (int i = 0; i < count; ++i) {
            const float size = random.real_f(0.1, 0.2);
            const auto any_speed = [&] { return fastest_m_s * random.real_f(-1, 1); };
            const BodyDef body{.position_m = {-4.5 + i % 10, -4.5 + i / 10},
                               .linear_velocity_m_s = {any_speed(), any_speed()}};
            const bool is_disc = form == Form::Discs || (form == Form::Both && i % 2 == 0);
            ids_.push_back(is_disc ? add(world_, body, Circle{{}, size}, def)
                                   : add(world_, body, Box{size, 0.5f * size}, def));
        }
    }

    void step() { world_.step(1.0f / 60).value(); }

    [[nodiscard]] double energy() const {
        double sum = 0;
        for (const BodyId id : ids_) {
            const Body body = *world_.body(id);
            const MassData mass = body.mass_data();
            const auto spin = static_cast<double>(body.angular_velocity());
            sum += 0.5 * static_cast<double>(mass.mass_kg) *
                       static_cast<double>(length_squared(body.linear_velocity())) +
                   0.5 * static_cast<double>(mass.inertia_kg_m2) * spin * spin;
        }
        return sum;
    }

  private:
    World world_;
    std::vector<BodyId> ids_;
};

}  // namespace

TEST_CASE("a gas of bodies that bounce wins no energy, however fast and dense it is") {
    for (const Form form : {Form::Discs, Form::Boxes, Form::Both}) {
        for (const int count : {1, 2, 5, 20, 100}) {
            for (const float fastest_m_s : {5.0f, 20.0f, 70.0f, 200.0f}) {
                for (const float restitution : {0.5f, 1.0f}) {
                    Gas gas(form, count, fastest_m_s, restitution, 5);
                    const double first = gas.energy();
                    for (int i = 0; i < 150; ++i) {
                        gas.step();
                        INFO("form " << static_cast<int>(form) << ", " << count << " at " << fastest_m_s
                                     << " m/s, restitution " << restitution << ", step " << i);
                        REQUIRE(gas.energy() <= 1.01 * first);
                    }
                }
            }
        }
    }
}

// Their energy is not added up (world/bounce_energy.h), so it must not grow by itself.
TEST_CASE("bodies that bounce little win no energy in a crowd") {
    for (const Form form : {Form::Discs, Form::Boxes, Form::Both}) {
        for (const float fastest_m_s : {5.0f, 20.0f, 70.0f, 200.0f}) {
            for (const float friction : {0.0f, 0.05f, 1.0f}) {
                Gas gas(form, 100, fastest_m_s, 0.2f, 5, friction);
                const double first = gas.energy();
                double last = first;
                for (int i = 0; i < 150; ++i) {
                    gas.step();
                    INFO("form " << static_cast<int>(form) << " at " << fastest_m_s << " m/s, friction "
                                 << friction << ", step " << i);
                    REQUIRE(gas.energy() <= 1.01 * last);
                    REQUIRE(gas.energy() <= first);
                    last = gas.energy();
                }
            }
        }
    }
}

TEST_CASE("a gas of discs that lose nothing keeps nearly all of its energy") {
    for (const int count : {2, 20, 100}) {
        for (const float fastest_m_s : {5.0f, 20.0f, 70.0f}) {
            Gas gas(Form::Discs, count, fastest_m_s, 1, 7);
            const double first = gas.energy();
            for (int i = 0; i < 120; ++i) gas.step();
            INFO(count << " at " << fastest_m_s << " m/s");
            CHECK(gas.energy() > 0.95 * first);
        }
    }
}

}  // namespace cairn::physics
