// Stiff springs on rails beside what other joints hold: bounded. In what stands on the ground by them,
// vehicles and tables, they are as stiff as asked for.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"
#include "resolve/joints/exact_spring.h"

namespace cairn::physics {
namespace {

using namespace test;

using Spring = SpringTone;

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}
    float uniform(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() >> 8) * 0x1p-24f;
    }
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  private:
    std::mt19937 random_;
};

// A position in the world as the body sees it.
Vec2 seen_by(const World& world, BodyId id, Position at) {
    const Position p = world.body(id)->position();
    const double angle = world.body(id)->angle();
    const double x = at.x - p.x;
    const double y = at.y - p.y;
    return {static_cast<float>(x * std::cos(angle) + y * std::sin(angle)),
            static_cast<float>(y * std::cos(angle) - x * std::sin(angle))};
}

enum class Rail { Wheel, Prismatic, Either, Weld };

// Joins two bodies half way between them, along a line of some angle in the world.
void add_rail(World& world, Rail kind, BodyId a, BodyId b, double angle_rad, const Spring& spring) {
    const Position p = world.body(a)->position();
    const Position q = world.body(b)->position();
    const Position middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const auto frame = [&](BodyId id) { return static_cast<float>(angle_rad - world.body(id)->angle()); };
    if (kind == Rail::Wheel) {
        world
            .create_joint(WheelJointDef{.body_a = a,
                                        .body_b = b,
                                        .local_anchor_a_m = seen_by(world, a, middle),
                                        .local_anchor_b_m = seen_by(world, b, middle),
                                        .local_angle_a_rad = frame(a),
                                        .frequency_hz = spring.frequency_hz,
                                        .damping_ratio = spring.damping_ratio})
            .value();
    } else if (kind == Rail::Weld) {
        world
            .create_joint(WeldJointDef{.body_a = a,
                                       .body_b = b,
                                       .local_anchor_a_m = seen_by(world, a, middle),
                                       .local_anchor_b_m = seen_by(world, b, middle),
                                       .local_angle_a_rad = frame(a),
                                       .local_angle_b_rad = frame(b),
                                       .linear_frequency_hz = spring.frequency_hz,
                                       .linear_damping_ratio = spring.damping_ratio})
            .value();
    } else {
        world
            .create_joint(PrismaticJointDef{.body_a = a,
                                            .body_b = b,
                                            .local_anchor_a_m = seen_by(world, a, middle),
                                            .local_anchor_b_m = seen_by(world, b, middle),
                                            .local_angle_a_rad = frame(a),
                                            .local_angle_b_rad = frame(b),
                                            .enable_spring = true,
                                            .frequency_hz = spring.frequency_hz,
                                            .damping_ratio = spring.damping_ratio})
            .value();
    }
}

// Boxes that pass through each other, each on a rail from one before it, and some from a wall.
struct Tangle {
    World world;

    Tangle(Rail rail, Draw& draw, float frequency_hz, float damping_ratio)
        : world({.gravity_m_s2 = {}, .substeps = 1 << draw.below(4), .enable_sleep = false}) {
        const int count = 2 + draw.below(9);
        const bool is_uneven = draw.below(3) == 0;
        std::vector<BodyId> boxes;
        for (int i = 0; i < count; ++i) {
            const BodyDef def{.position_m = {i + d(draw.uniform(-0.3f, 0.3f)), d(draw.uniform(-1, 1))},
                              .angle_rad = d(draw.uniform(-3, 3)),
                              .linear_velocity_m_s = {draw.uniform(-0.3f, 0.3f), draw.uniform(-0.3f, 0.3f)},
                              .angular_velocity_rad_s = draw.uniform(-0.5f, 0.5f)};
            const Box box{draw.uniform(0.2f, 0.5f), draw.uniform(0.1f, 0.3f)};
            const float density = is_uneven ? std::exp(draw.uniform(-1.5f, 1.5f)) : 1;
            boxes.push_back(add(world, def, box, {.density_kg_m2 = density, .filter = {.mask = 0}}));
        }
        const auto join = [&](BodyId a, BodyId b) {
            const Rail kind = rail != Rail::Either ? rail
                              : draw.below(2) == 0 ? Rail::Wheel
                                                   : Rail::Prismatic;
            add_rail(world, kind, a, b, d(draw.uniform(-3, 3)), {frequency_hz, damping_ratio});
        };
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            const bool in_row = draw.below(3) > 0;
            join(boxes[in_row ? i - 1 : static_cast<std::size_t>(draw.below(static_cast<int>(i)))], boxes[i]);
        }
        if (draw.below(2) == 0) {
            const BodyId wall = world.create_body({.type = BodyType::Static}).value();
            join(wall, boxes.front());
            if (draw.below(2) == 0) join(wall, boxes.back());
        }
    }
};

// A hull on two wheels of 1 kg that falls on the ground.
struct Vehicle {
    World world{{.gravity_m_s2 = {0, -10}, .enable_sleep = false}};
    BodyId hull;
    std::vector<JointId> suspensions;

    struct Setting {
        Spring spring;
        double fall_m = 0;
        float hull_kg = 12;
        float target_m = 0;
        float lower_m = -kUnlimited;
    };

    explicit Vehicle(const Setting& setting) {
        const BodyId ground = world.create_body({.type = BodyType::Static}).value();
        world.create_shape(ground, Segment{{-50, 0}, {50, 0}}).value();
        hull = add(world, {.position_m = {0, setting.fall_m + 0.6}}, Box{1.5f, 0.25f},
                   {.density_kg_m2 = setting.hull_kg / 1.5f});
        for (const float x : {-1.0f, 1.0f}) {
            const BodyId wheel = add(world, {.position_m = {d(x), setting.fall_m + 0.3}}, Circle{{}, 0.3f},
                                     {.density_kg_m2 = 1 / (kPi * 0.09f)});
            WheelJointDef def{.body_a = hull,
                              .body_b = wheel,
                              .local_anchor_a_m = {x, -0.3f},
                              .local_angle_a_rad = kPi / 2,
                              .frequency_hz = setting.spring.frequency_hz,
                              .damping_ratio = setting.spring.damping_ratio,
                              .target_m = setting.target_m};
            def.enable_limit = setting.lower_m > -kUnlimited;
            if (def.enable_limit) {
                def.lower_m = setting.lower_m;
                def.upper_m = 1;
            }
            suspensions.push_back(world.create_joint(def).value());
        }
    }

    double deepest_m(int steps) {
        double most = 0;
        for (int step = 0; step < steps; ++step) {
            world.step(kStep_s).value();
            most = std::max(most, d(world.joint(suspensions.back())->translation()));
        }
        return most;
    }
};

double kinetic_energy_j(const World& world) {
    double sum = 0;
    for (const BodyId id : world.bodies()) {
        const Body body = *world.body(id);
        if (body.type() != BodyType::Dynamic) continue;
        const Vec2 v = body.linear_velocity();
        const double w = d(body.angular_velocity());
        sum += (d(body.mass()) * d(dot(v, v)) + d(body.mass_data().inertia_kg_m2) * w * w) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("structures of boxes on rails with stiff springs give back no more than was put in") {
    const Rail rail = GENERATE(Rail::Wheel, Rail::Prismatic, Rail::Either);
    for (unsigned seed = 0; seed < 60; ++seed) {
        Draw draw(seed);
        const float frequency_hz = std::exp(draw.uniform(std::log(30.0f), std::log(120'000.0f)));
        const float damping_ratio = draw.below(3) == 0 ? 0 : draw.uniform(0, 2);
        Tangle tangle(rail, draw, frequency_hz, damping_ratio);
        const double energy = kinetic_energy_j(tangle.world);
        double most = 0;
        for (int step = 0; step < 600; ++step) {
            tangle.world.step(kStep_s).value();
            most = std::max(most, kinetic_energy_j(tangle.world));
        }
        CAPTURE(static_cast<int>(rail), seed, frequency_hz, damping_ratio);
        CHECK(most <= 1.02 * energy);
    }
}

// Also when a longer step finds them in lanes, where shorter ones could follow them.
TEST_CASE("nine wheels at the rim of one hub give back no more than was put in") {
    const float first_step_s = GENERATE(1 / 60.0f, 1 / 1920.0f);
    for (const float frequency_hz : {20.0f, 40.0f, 60.0f, 120.0f, 600.0f, 120'000.0f}) {
        for (const float damping_ratio : {0.0f, 0.1f, 1.0f}) {
            World world({.gravity_m_s2 = {}, .enable_sleep = false});
            const BodyId hub = add(world, {}, Box{0.5f, 0.5f}, {.filter = {.mask = 0}});
            for (int i = 0; i < 9; ++i) {
                const double angle = 2 * kPiD * i / 9;
                const Vec2 at{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
                const BodyId wheel = add(world,
                                         {.position_m = {d(at.x), d(at.y)},
                                          .linear_velocity_m_s = {0.3f * static_cast<float>(i % 3), 0.2f}},
                                         Circle{{}, 0.3f}, {.filter = {.mask = 0}});
                world
                    .create_joint(WheelJointDef{.body_a = hub,
                                                .body_b = wheel,
                                                .local_anchor_a_m = at,
                                                .local_angle_a_rad = static_cast<float>(2.1 * i),
                                                .frequency_hz = frequency_hz,
                                                .damping_ratio = damping_ratio})
                    .value();
            }
            const double energy = kinetic_energy_j(world);
            for (int step = 0; step < 3; ++step) world.step(first_step_s).value();
            double most = 0;
            for (int step = 0; step < 1200; ++step) {
                world.step(kStep_s).value();
                most = std::max(most, kinetic_energy_j(world));
            }
            CAPTURE(first_step_s, frequency_hz, damping_ratio);
            CHECK(most <= 1.02 * energy);
        }
    }
}

// What is softened in a long step would be stiffer in a short one, and give back more than it took.
TEST_CASE("boxes on rails with stiff springs give back no more than was put in by steps long and short") {
    const Rail rail = GENERATE(Rail::Wheel, Rail::Prismatic);
    const float short_s = GENERATE(1 / 120.0f, 1 / 480.0f);
    for (unsigned seed = 0; seed < 20; ++seed) {
        Draw draw(seed);
        const float frequency_hz = std::exp(draw.uniform(std::log(40.0f), std::log(10'000.0f)));
        const float damping_ratio = draw.uniform(0.1f, 1);
        Tangle tangle(rail, draw, frequency_hz, damping_ratio);
        const double energy = kinetic_energy_j(tangle.world);
        double most = 0;
        for (int step = 0; step < 600; ++step) {
            tangle.world.step(step % 2 == 0 ? kStep_s : short_s).value();
            most = std::max(most, kinetic_energy_j(tangle.world));
        }
        CAPTURE(static_cast<int>(rail), short_s, seed, frequency_hz, damping_ratio);
        CHECK(most <= 1.02 * energy);
    }
}

// Where one of the steps is short enough to sweep these springs and the other one is not.
TEST_CASE("boxes on a wall, welded with springs, give back no more than was put in by steps long and short") {
    const auto [frequency_hz, other_step_s] = GENERATE(table<float, float>(
        {{20.0f, 1 / 30.0f}, {36.0f, 1 / 120.0f}, {42.0f, 1 / 120.0f}, {42.0f, 1 / 240.0f}}));
    const float damping_ratio = GENERATE(0.1f, 0.3f);
    for (unsigned seed = 0; seed < 40; ++seed) {
        Draw draw(seed);
        Tangle tangle(Rail::Weld, draw, frequency_hz, damping_ratio);
        const double energy = kinetic_energy_j(tangle.world);
        double most = 0;
        for (int step = 0; step < 600; ++step) {
            tangle.world.step(step % 2 == 0 ? kStep_s : other_step_s).value();
            most = std::max(most, kinetic_energy_j(tangle.world));
        }
        CAPTURE(frequency_hz, damping_ratio, other_step_s, seed);
        CHECK(most <= 1.02 * energy);
    }
}

// k = (2 pi f)^2/K, with K = 1/M + x^2/I + 1/m along the suspension, bears half of the weight of the hull.
// Places are told to some nanometres.
TEST_CASE("a vehicle that lands on stiff suspensions stands as deep in them as they are stiff") {
    constexpr double kGravity_m_s2 = 10;
    constexpr double kRounding_m = 5e-8;
    for (const float frequency_hz : {10.0f, 30.0f, 60.0f, 100.0f, 1'000.0f, 120'000.0f}) {
        for (const float hull_kg : {2.0f, 12.0f, 40.0f}) {
            Vehicle vehicle({.spring = {frequency_hz, 0.7f}, .fall_m = 0.5, .hull_kg = hull_kg});
            World& world = vehicle.world;
            const BodyId hull = vehicle.hull;
            run_for(world, 8);
            const MassData mass = world.body(hull)->mass_data();
            const double k_inverse_mass = 1 / d(mass.mass_kg) + 1 / d(mass.inertia_kg_m2) + 1;
            const double w = 2 * kPiD * d(frequency_hz);
            const double sag = d(mass.mass_kg) * kGravity_m_s2 / 2 * k_inverse_mass / (w * w);
            CAPTURE(frequency_hz, hull_kg, sag);
            CHECK(std::abs(world.body(hull)->angle()) < 1e-3);
            for (const JointId id : vehicle.suspensions)
                CHECK(d(world.joint(id)->translation()) == Approx(sag).epsilon(0.02).margin(kRounding_m));
            CHECK(length(world.body(hull)->linear_velocity()) < 1e-3f);
        }
    }
}

// What falls on stiff legs presses them together as long as it is slowed down, and a box on top that is far
// lighter has the whole solved directly from then on: that must not give back what the legs would bear when
// they were pressed so far at rest.
TEST_CASE("a table on a stiff leg gives back no more than it fell, when a light box falls on it too") {
    const auto [frequency_hz, other_step_s] = GENERATE(table<float, float>(
        {{60.0f, kStep_s}, {640.0f, kStep_s}, {640.0f, kStep_s / 4}, {80'000.0f, kStep_s / 4}}));
    const int substeps = GENERATE(2, 4);
    for (const float table_kg : {5.0f, 20.0f, 44.0f}) {
        World world({.gravity_m_s2 = {0, -10}, .substeps = substeps, .enable_sleep = false});
        const BodyId ground = world.create_body({.type = BodyType::Static}).value();
        world.create_shape(ground, Segment{{-10, 0}, {10, 0}}).value();
        const BodyId foot = add(world, {.position_m = {0, 0.6}}, Box{1, 0.2f}, {.density_kg_m2 = 1 / 0.8f});
        const BodyId table =
            add(world, {.position_m = {0, 1.6}}, Box{1, 0.2f}, {.density_kg_m2 = table_kg / 0.8f});
        add(world, {.position_m = {0, 3}}, Box{0.2f, 0.2f}, {.density_kg_m2 = 0.7f / 0.16f});
        world
            .create_joint(PrismaticJointDef{.body_a = table,
                                            .body_b = foot,
                                            .local_anchor_a_m = {0, -1},
                                            .local_angle_a_rad = kPi / 2,
                                            .local_angle_b_rad = kPi / 2,
                                            .enable_spring = true,
                                            .frequency_hz = frequency_hz,
                                            .damping_ratio = 0.1f})
            .value();
        const auto energy_j = [&] {
            double sum = kinetic_energy_j(world);
            for (const BodyId id : world.bodies())
                sum += 10 * d(world.body(id)->mass()) * world.body(id)->position().y;
            return sum;
        };
        const double energy = energy_j();
        double most = 0;
        for (int step = 0; step < 600; ++step) {
            world.step(step % 2 == 0 ? kStep_s : other_step_s).value();
            most = std::max(most, energy_j());
        }
        CAPTURE(frequency_hz, other_step_s, substeps, table_kg);
        CHECK(most <= 1.001 * energy);
        CHECK(length(world.body(table)->linear_velocity()) < 0.05f);
    }
}

// Its springs are stiff for a second then, and on bumps damping holds them away from where they belong.
TEST_CASE("a vehicle on bumps sags no deeper after a long step than on the softer spring of that step") {
    const auto [frequency_hz, long_step_s] =
        GENERATE(table<float, float>({{25.0f, 1 / 30.0f}, {20.0f, 1 / 20.0f}, {20.0f, 1 / 10.0f}}));
    const auto on_bumps = [](float hz) {
        Vehicle vehicle({.spring = {hz, 0.7f}, .fall_m = 0.05});
        const BodyId bumps = vehicle.world.create_body({.type = BodyType::Static}).value();
        for (int i = 0; i < 30; ++i)
            vehicle.world.create_shape(bumps, Circle{{2 + 1.3f * static_cast<float>(i), -0.15f}, 0.2f})
                .value();
        for (const BodyId id : vehicle.world.bodies()) {
            if (vehicle.world.body(id)->type() == BodyType::Dynamic)
                vehicle.world.body(id)->set_linear_velocity({6, 0}).value();
        }
        return vehicle;
    };
    const double softer = on_bumps(most_swept_frequency(long_step_s / 4)).deepest_m(300);
    for (int at = 20; at < 90; at += 2) {
        Vehicle vehicle = on_bumps(frequency_hz);
        (void)vehicle.deepest_m(at);
        vehicle.world.step(long_step_s).value();
        CAPTURE(frequency_hz, long_step_s, at);
        CHECK(vehicle.deepest_m(240) <= softer);
    }
}

// Limits give a little, the more the stiffer what pushes: no more than by a spring that can be swept.
TEST_CASE("a stiff suspension that is drawn against its stop does not push through it") {
    const auto stands_at = [](float frequency_hz) {
        Vehicle vehicle(
            {.spring = {frequency_hz, 0.7f}, .fall_m = 0.1, .target_m = -0.1f, .lower_m = -0.02f});
        run_for(vehicle.world, 5);
        return vehicle.world.joint(vehicle.suspensions.back())->translation();
    };
    const float by_swept = stands_at(most_swept_frequency(kStep_s / 4));
    for (const float frequency_hz : {40.0f, 60.0f, 200.0f, 1'000.0f, 1e6f}) {
        CAPTURE(frequency_hz);
        CHECK(stands_at(frequency_hz) == Approx(by_swept).margin(1e-3));
    }
}

}  // namespace cairn::physics
