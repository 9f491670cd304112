// The report of a world, against what was put into it and against formulas.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr double kTwoPi = 2 * 3.14159265358979323846;

const WorldDef kWeightless{.gravity_m_s2 = {}, .enable_sleep = false};

/// A static body at (-1, 0), and a disc about the origin that may be put elsewhere.
struct Pair {
    World world{kWeightless};
    BodyId a = world.create_body({.type = BodyType::Static, .position_m = {-1, 0}}).value();
    BodyId b = add(world, {}, Circle{{}, 0.5f});

    void put(Position position_m, double angle_rad) {
        world.body(b)->set_transform(position_m, angle_rad).value();
    }
    void move(Vec2 velocity_m_s, float spin_rad_s) {
        world.body(b)->set_linear_velocity(velocity_m_s).value();
        world.body(b)->set_angular_velocity(spin_rad_s).value();
    }
};

struct Expected {
    double error_m = 0;
    double error_rad = 0;
    double residual_m_s = 0;
    double residual_rad_s = 0;
};

void check(const WorldReport& report, const Expected& expected) {
    CHECK(report.max_joint_error_m == Approx(expected.error_m).margin(1e-6));
    CHECK(report.max_joint_error_rad == Approx(expected.error_rad).margin(1e-6));
    CHECK(report.residual_m_s == Approx(expected.residual_m_s).margin(1e-6));
    CHECK(report.residual_rad_s == Approx(expected.residual_rad_s).margin(1e-6));
}

/// The anchors are 1 m from a, at the centre of b. The disc then stands 0.3 m to the right and 0.4 m up,
/// turned by 0.2 rad, moves by (3, 4) m/s and turns by 0.5 rad/s.
void check_displaced(const std::function<JointDef(BodyId, BodyId)>& make, const Expected& expected) {
    Pair pair;
    pair.world.create_joint(make(pair.a, pair.b)).value();
    check(pair.world.report(), {});
    pair.put({0.3, 0.4}, 0.2);
    pair.move({3, 4}, 0.5f);
    check(pair.world.report(), expected);
}

double mass_kg(World& world, BodyId body) {
    return static_cast<double>(world.body(body)->mass_data().mass_kg);
}

}  // namespace

TEST_CASE("energy and momentum in a report are those of the formulas") {
    World world({.gravity_m_s2 = {1, -10}});
    const BodyId body = add(world, {.position_m = {3, 4}, .linear_velocity_m_s = {2, -1}}, Box{0.5f, 0.25f});
    world.body(body)->set_angular_velocity(6).value();
    add(world, {.position_m = {10, 2}, .gravity_scale = 0.5f}, Box{0.5f, 0.5f});
    add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {50, 50}}, Box{0.5f, 0.5f});
    const double m = mass_kg(world, body);
    const double inertia = m * (1 + 0.25) / 12;
    const double other = mass_kg(world, world.bodies()[1]);
    const WorldReport report = world.report();
    CHECK(report.kinetic_energy_j == Approx(0.5 * m * 5 + 0.5 * inertia * 36).epsilon(1e-6));
    CHECK(report.potential_energy_j == Approx(m * (40 - 3) + 0.5 * other * (20 - 10)).epsilon(1e-6));
    CHECK(report.elastic_energy_j == 0);
    CHECK(report.momentum_x_kg_m_s == Approx(2 * m).epsilon(1e-6));
    CHECK(report.momentum_y_kg_m_s == Approx(-m).epsilon(1e-6));
    CHECK(report.angular_momentum_kg_m2_s == Approx(6 * inertia + m * (3 * -1 - 4 * 2)).epsilon(1e-6));
}

TEST_CASE("a stretched spring holds the energy that its frequency gives it, and swings it into motion") {
    Pair pair;
    pair.world
        .create_joint(DistanceJointDef{
            .body_a = pair.a, .body_b = pair.b, .length_m = 1, .enable_spring = true, .frequency_hz = 2})
        .value();
    pair.put({0.25, 0}, 0);
    const double stiffness = std::pow(kTwoPi * 2, 2) * mass_kg(pair.world, pair.b);
    const double stored = 0.5 * stiffness * 0.25 * 0.25;
    CHECK(pair.world.report().elastic_energy_j == Approx(stored).epsilon(1e-5));
    double most_kinetic = 0;
    for (int i = 0; i < 120; ++i) {
        step_times(pair.world, 1);
        const WorldReport report = pair.world.report();
        most_kinetic = std::max(most_kinetic, report.kinetic_energy_j);
        // Velocities of the substeps are half a substep late, by up to w h/2 = 2.6 % of a product of the two.
        CHECK(report.energy_j() == Approx(stored).epsilon(0.03));
    }
    CHECK(most_kinetic > 0.95 * stored);
}

TEST_CASE("springs that turn and springs of two directions hold half k q squared") {
    Pair turning;
    turning.world
        .create_joint(WeldJointDef{.body_a = turning.a,
                                   .body_b = turning.b,
                                   .local_anchor_a_m = {1, 0},
                                   .linear_frequency_hz = 3,
                                   .angular_frequency_hz = 5})
        .value();
    turning.put({0.3, 0.4}, 0.2);
    const MassData mass = turning.world.body(turning.b)->mass_data();
    const double linear = 0.5 * std::pow(kTwoPi * 3, 2) * static_cast<double>(mass.mass_kg) * 0.25;
    const double angular = 0.5 * std::pow(kTwoPi * 5, 2) * static_cast<double>(mass.inertia_kg_m2) * 0.04;
    CHECK(turning.world.report().elastic_energy_j == Approx(linear + angular).epsilon(1e-5));
}

TEST_CASE("the errors of a joint are what its kind holds, and how fast that changes") {
    const Vec2 anchor{1, 0};
    SECTION("revolute") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return RevoluteJointDef{.body_a = a, .body_b = b, .local_anchor_a_m = anchor};
            },
            {.error_m = 0.5, .residual_m_s = 5});
    }
    SECTION("revolute, beyond a limit and leaving it farther behind") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return RevoluteJointDef{.body_a = a,
                                        .body_b = b,
                                        .local_anchor_a_m = anchor,
                                        .enable_limit = true,
                                        .lower_rad = -0.1f,
                                        .upper_rad = 0.05f};
            },
            {.error_m = 0.5, .error_rad = 0.15, .residual_m_s = 5, .residual_rad_s = 0.5});
    }
    SECTION("prismatic") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return PrismaticJointDef{.body_a = a, .body_b = b, .local_anchor_a_m = anchor};
            },
            {.error_m = 0.4, .error_rad = 0.2, .residual_m_s = 4, .residual_rad_s = 0.5});
    }
    SECTION("weld") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return WeldJointDef{.body_a = a, .body_b = b, .local_anchor_a_m = anchor};
            },
            {.error_m = 0.5, .error_rad = 0.2, .residual_m_s = 5, .residual_rad_s = 0.5});
    }
    SECTION("wheel, with a limit along its axis") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return WheelJointDef{.body_a = a,
                                     .body_b = b,
                                     .local_anchor_a_m = anchor,
                                     .enable_spring = false,
                                     .enable_limit = true,
                                     .lower_m = -1,
                                     .upper_m = 0.2f};
            },
            {.error_m = 0.4, .residual_m_s = 4});
    }
    SECTION("distance") {
        check_displaced(
            [&](BodyId a, BodyId b) { return DistanceJointDef{.body_a = a, .body_b = b, .length_m = 1}; },
            {.error_m = std::hypot(1.3, 0.4) - 1,
             .residual_m_s = (1.3 * 3 + 0.4 * 4) / std::hypot(1.3, 0.4)});
    }
    SECTION("pulley, whose rope runs out") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return PulleyJointDef{.body_a = a,
                                      .body_b = b,
                                      .wheel_a_m = {-1, 5},
                                      .wheel_b_m = {0.3, 5},
                                      .ratio = 2,
                                      .length_m = static_cast<float>(5 + 2 * std::hypot(0.3, 5.0))};
            },
            {});  // up is slack
    }
    SECTION("those that draw and do not hold") {
        check_displaced(
            [&](BodyId a, BodyId b) {
                return MotorJointDef{
                    .body_a = a, .body_b = b, .local_anchor_a_m = anchor, .linear_frequency_hz = 1};
            },
            {});
        check_displaced(
            [&](BodyId a, BodyId b) {
                return MouseJointDef{.body_a = a, .body_b = b, .local_target_m = anchor};
            },
            {});
        check_displaced(
            [&](BodyId a, BodyId b) { return FrictionJointDef{.body_a = a, .body_b = b, .max_force_n = 1}; },
            {});
    }
}

TEST_CASE("a slider that turns with its body is held in the axes of that body") {
    World world(kWeightless);
    const BodyId a = add(world, {}, Circle{{}, 0.5f});
    const BodyId b = add(world, {.position_m = {2, 0}}, Circle{{}, 0.5f});
    world.create_joint(PrismaticJointDef{.body_a = a, .body_b = b}).value();
    // Both turn about a's centre as one body would, while b slides outward: nothing is violated.
    world.body(a)->set_angular_velocity(3).value();
    world.body(b)->set_angular_velocity(3).value();
    world.body(b)->set_linear_velocity({0.7f, 6}).value();
    check(world.report(), {});
}

TEST_CASE("a rope over pulleys counts only once it is taut") {
    Pair pair;
    pair.world
        .create_joint(PulleyJointDef{
            .body_a = pair.a, .body_b = pair.b, .wheel_a_m = {-1, 5}, .wheel_b_m = {0, 5}, .ratio = 2})
        .value();
    pair.put({0, -0.1}, 0);
    pair.move({0, -3}, 0);
    check(pair.world.report(), {.error_m = 0.2, .residual_m_s = 6});
}

TEST_CASE("a gear is off by what its joints add up to") {
    World world(kWeightless);
    const BodyId ground = world.create_body({.type = BodyType::Static}).value();
    const BodyId small = add(world, {.position_m = {1, 0}}, Circle{{}, 0.2f});
    const BodyId rack = add(world, {.position_m = {5, 0}}, Box{0.5f, 0.1f});
    const JointId turning =
        world.create_joint(RevoluteJointDef{.body_a = ground, .body_b = small, .local_anchor_a_m = {1, 0}})
            .value();
    const JointId sliding =
        world.create_joint(PrismaticJointDef{.body_a = ground, .body_b = rack, .local_anchor_a_m = {5, 0}})
            .value();
    world.create_joint(GearJointDef{.joint_1 = turning, .joint_2 = sliding, .ratio = 4}).value();
    check(world.report(), {});
    world.body(small)->set_transform({1, 0}, 0.3).value();
    world.body(rack)->set_transform({5.1, 0}, 0).value();
    world.body(small)->set_angular_velocity(1).value();
    world.body(rack)->set_linear_velocity({2, 0}).value();
    check(world.report(), {.error_rad = 0.3 + 4 * 0.1, .residual_rad_s = 1 + 4 * 2});
}

TEST_CASE("overlapping shapes that approach are a residual; those that part are none") {
    World world(kWeightless);
    const BodyId below = add(world, {.type = BodyType::Static}, Box{0.5f, 0.5f});
    const BodyId above = add(world, {.position_m = {0, 0.98}}, Box{0.5f, 0.5f});
    world.step(1e-6f).value();
    world.body(above)->set_linear_velocity({3, -0.7f}).value();
    CHECK(world.report().residual_m_s == Approx(0.7).epsilon(1e-5));
    CHECK(world.report().max_penetration_m == world.max_penetration_m());
    CHECK(world.report().max_penetration_m == Approx(0.02).margin(1e-5));
    world.body(above)->set_linear_velocity({3, 0.7f}).value();
    CHECK(world.report().residual_m_s == 0);
    CHECK(world.contains(below));
}

TEST_CASE("islands in a report are the groups that will sleep together") {
    World world;
    add_ground(world);
    for (int stack = 0; stack < 3; ++stack) {
        for (int i = 0; i < 2; ++i) add(world, {.position_m = {4.0 * stack, 0.5 + i}}, Box{0.5f, 0.5f});
    }
    const BodyId left = add(world, {.position_m = {20, 0.5}}, Circle{{}, 0.5f});
    const BodyId right = add(world, {.position_m = {24, 0.5}}, Circle{{}, 0.5f});
    world.create_joint(DistanceJointDef{.body_a = left, .body_b = right, .length_m = 4}).value();
    const BodyId lift =
        add(world, {.type = BodyType::Kinematic, .position_m = {40, 3}, .linear_velocity_m_s = {0, 0.01f}},
            Box{1, 1});
    step_times(world, 2);
    WorldReport report = world.report();
    CHECK(report.islands == 4);
    CHECK(report.awake_joints == 1);
    CHECK(report.awake_touching == 8);
    CHECK(report.counts.awake_bodies == 9);
    run_for(world, 2);
    report = world.report();
    CHECK(report.islands == 0);
    CHECK(report.awake_joints == 0);
    CHECK(report.awake_touching == 0);
    CHECK(report.counts.touching == 8);
    CHECK(listed(report.counts) == listed(world.counts()));
    CHECK(world.body(lift)->is_awake());
}

TEST_CASE("a solved scene leaves small residuals, and asking for them changes nothing") {
    World asked;
    World plain;
    for (World* world : {&asked, &plain}) build_pile(*world, 60, 4);
    for (int i = 0; i < 240; ++i) {
        step_times(asked, 1);
        step_times(plain, 1);
        const WorldReport report = asked.report();
        REQUIRE(std::isfinite(report.energy_j()));
        REQUIRE(asked.state_hash() == plain.state_hash());
    }
    CHECK(asked.report().residual_m_s < 0.05f);
}

TEST_CASE("the stages in a report are those of the profile") {
    World world({.enable_sleep = false});
    build_pyramid(world, 5);
    step_times(world, 2);
    CHECK(world.report().stages.total_ms() == 0);
    world.set_profiling(true);
    step_times(world, 2);
    CHECK(world.report().stages.stage_ms == world.profile().stage_ms);
    CHECK(world.report().stages.total_ms() > 0);
}

}  // namespace cairn::physics
