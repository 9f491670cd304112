// Which springs a world solves directly by its own choice, by what comes of it: they sag as statics says, and
// what lies on them comes to rest.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

// Balls of mass m that hang on each other by springs of m w^2. Between two of them the effective mass is half
// of one, so w is sqrt(2) times that of the first spring.
struct HangingBalls {
    World world{{.enable_sleep = false}};
    std::vector<JointId> springs;
    BodyId lowest;
    int count;

    HangingBalls(int balls, float damping_ratio) : count(balls) {
        lowest = world.create_body({.type = BodyType::Static}).value();
        for (int i = 1; i <= count; ++i) {
            const BodyId ball = add(world, {.position_m = {0, -1.0 * i}}, Circle{{}, 0.25f});
            springs.push_back(world
                                  .create_joint(DistanceJointDef{.body_a = lowest,
                                                                 .body_b = ball,
                                                                 .length_m = 1,
                                                                 .enable_spring = true,
                                                                 .damping_ratio = damping_ratio})
                                  .value());
            lowest = ball;
        }
    }

    void set_frequency(float hz, float damping_ratio) {
        for (std::size_t i = 0; i < springs.size(); ++i)
            world.joint(springs[i])
                ->set_spring(true, i == 0 ? hz : hz * std::sqrt(2.0f), damping_ratio)
                .value();
    }
    // By statics: the i-th spring bears all balls from the i-th on.
    [[nodiscard]] double sag_at(float hz) const {
        const double w = 2 * kPiD * d(hz);
        return 0.5 * count * (count + 1) * 10 / (w * w);
    }
    [[nodiscard]] double mean_sag(int steps, float dt_s) {
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            world.step(dt_s).value();
            sum += -count - world.body(lowest)->position().y;
        }
        return sum / steps;
    }
};

// Boxes pinned end to end, with springs about their pins; the first at `wall` if there is one.
std::vector<JointId> pin_boxes(World& world, int count, float hz, float damping_ratio, BodyId wall,
                               std::vector<BodyId>& boxes) {
    std::vector<JointId> pins;
    BodyId last = wall;
    for (int i = 0; i < count; ++i) {
        const BodyId box =
            add(world, {.position_m = {1.0 * i, 0}}, Box{.half_width_m = 0.45f, .half_height_m = 0.08f});
        boxes.push_back(box);
        if (last != BodyId{}) {
            pins.push_back(world
                               .create_joint(RevoluteJointDef{.body_a = last,
                                                              .body_b = box,
                                                              .local_anchor_a_m = {i > 0 ? 0.5f : -0.5f, 0},
                                                              .local_anchor_b_m = {-0.5f, 0},
                                                              .enable_spring = true,
                                                              .frequency_hz = hz,
                                                              .damping_ratio = damping_ratio})
                               .value());
        }
        last = box;
    }
    return pins;
}

}  // namespace

TEST_CASE("a world chooses a solver by which springs that bear each other sag as far as they should") {
    // Errors of a joint below 0.1 um are let alone.
    constexpr double kRounding_m = 1e-7;
    for (const int balls : {2, 3, 6, 8, 20}) {
        for (const float hz : {20.0f, 33.0f, 43.0f, 60.0f, 120.0f, 1200.0f, 120000.0f}) {
            for (const float damping : {0.0f, 0.1f, 1.0f}) {
                HangingBalls chain(balls, damping);
                chain.set_frequency(hz, damping);
                run_for(chain.world, 5);
                INFO(balls << " balls, " << hz << " Hz, damping ratio " << damping);
                CHECK(chain.mean_sag(600, kStep_s) ==
                      Approx(chain.sag_at(hz)).epsilon(0.02).margin(balls * kRounding_m));
            }
        }
    }
}

TEST_CASE("springs that become stiff sag as far as they should, by their frequency or by longer steps") {
    HangingBalls chain(6, 1);
    chain.set_frequency(30, 1);
    run_for(chain.world, 5);
    CHECK(chain.mean_sag(60, kStep_s) == Approx(chain.sag_at(30)).epsilon(0.02));
    run_for(chain.world, 5, 1.0f / 15);
    CHECK(chain.mean_sag(60, 1.0f / 15) == Approx(chain.sag_at(30)).epsilon(0.02));
    run_for(chain.world, 5);
    chain.set_frequency(240, 1);
    run_for(chain.world, 5);
    CHECK(chain.mean_sag(60, kStep_s) == Approx(chain.sag_at(240)).epsilon(0.02));
}

TEST_CASE("what hangs quietly by stiff springs flies quietly when it is let go") {
    World world({.enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    std::vector<BodyId> boxes;
    const std::vector<JointId> pins = pin_boxes(world, 6, 200, 0.7f, wall, boxes);
    run_for(world, 5);
    REQUIRE(world.report().kinetic_energy_j < 1e-3);
    world.destroy_joint(pins.front()).value();
    run_for(world, 1);
    // They fall together; what bent them before is all that parts them.
    for (const BodyId box : boxes) {
        CHECK(length(world.body(box)->linear_velocity() - Vec2{0, -10}) < 0.5f);
    }
}

TEST_CASE("what lies on a sprung tray comes to rest, few things and many") {
    for (const float hz : {60.0f, 120.0f}) {
        for (const int count : {4, 20, 40}) {
            World world;
            const BodyId frame = world.create_body({.type = BodyType::Static}).value();
            const BodyId tray = add(world, {}, Box{.half_width_m = 3, .half_height_m = 0.1f});
            for (const float side : {-1.0f, 1.0f}) {
                world.create_shape(tray, Box{0.1f, 1.6f, {2.9f * side, 1.6f}}).value();
                world
                    .create_joint(WheelJointDef{.body_a = frame,
                                                .body_b = tray,
                                                .local_anchor_a_m = {2 * side, 0},
                                                .local_anchor_b_m = {2 * side, 0},
                                                .local_angle_a_rad = kPi / 2,
                                                .frequency_hz = hz,
                                                .damping_ratio = 0.7f})
                    .value();
            }
            for (int i = 0; i < count; ++i) {
                add(world, {.position_m = {-2.1 + 0.6 * (i % 8), 0.6 + 0.55 * (i / 8)}},
                    Box{.half_width_m = 0.25f, .half_height_m = 0.25f});
            }
            INFO(hz << " Hz, " << count << " boxes");
            int steps = 0;
            while (world.counts().awake_bodies > 0 && steps < 1200) {
                step_times(world, 1);
                ++steps;
            }
            CHECK(steps < 1200);
            CHECK(world.report().max_penetration_m < 2e-3);
        }
    }
}

}  // namespace cairn::physics
