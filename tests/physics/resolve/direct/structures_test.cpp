// Structures of joints that sweeping solvers cannot hold: what they measure and what they keep.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <cairn/physics/state.h>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

// Links of 1 kg and half a metre, straight down from the origin or level from it, and a ball at the end.
struct Hanging {
    World world;
    BodyId hook;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    int links;

    Hanging(int count, double ratio, bool level, JointSolver solver = JointSolver::Automatic)
        : world({.joint_solver = solver, .enable_sleep = false}), links(count) {
        hook = world.create_body({.type = BodyType::Static}).value();
        BodyId last = hook;
        Vec2 anchor{};
        for (int i = 0; i <= count; ++i) {
            const double along = i < count ? 0.5 * i + 0.25 : 0.5 * count;
            const BodyDef def{.position_m = level ? Position{along, 0} : Position{0, -along},
                              .angle_rad = level ? 1.5707963267948966 : 0};
            const ShapeDef link{.density_kg_m2 = 20, .filter = {.group = -1}};
            const ShapeDef ball{.density_kg_m2 = static_cast<float>(ratio / 0.7853981634),
                                .filter = {.group = -1}};
            const BodyId body = i < count ? add(world, def, Box{0.05f, 0.25f}, link)
                                          : add(world, def, Circle{{}, 0.5f}, ball);
            const Vec2 top = i < count ? Vec2{0, 0.25f} : Vec2{};
            joints.push_back(
                world
                    .create_joint(RevoluteJointDef{
                        .body_a = last, .body_b = body, .local_anchor_a_m = anchor, .local_anchor_b_m = top})
                    .value());
            bodies.push_back(body);
            last = body;
            anchor = {0, -0.25f};
        }
    }
    [[nodiscard]] double greatest_gap() const {
        double gap = 0;
        for (const JointId id : joints) gap = std::max(gap, d(world.joint(id)->current_length()));
        return gap;
    }
    [[nodiscard]] double energy() const {
        double sum = 0;
        for (const BodyId id : bodies) {
            const Body body = *world.body(id);
            sum += kinetic_energy(body) + d(body.mass()) * 10 * body.world_center().y;
        }
        return sum;
    }
    // Of all bodies straight down.
    [[nodiscard]] double lowest() const {
        double sum = 0;
        for (int i = 0; i <= links; ++i) {
            const double along = i < links ? 0.5 * i + 0.25 : 0.5 * links;
            sum -= d(world.body(bodies[static_cast<std::size_t>(i)])->mass()) * 10 * along;
        }
        return sum;
    }
};

}  // namespace

TEST_CASE(
    "a chain of a hundred links holds 1e4 times the mass of one to half a millimetre, and keeps its energy") {
    for (const double ratio : {1e2, 1e3, 1e4}) {
        Hanging chain(100, ratio, false);
        chain.world.body(chain.bodies.back())->set_linear_velocity({5, 0}).value();
        const double start = chain.energy() - chain.lowest();
        double gap = 0;
        double most = 0;
        for (int i = 0; i < 300; ++i) {
            chain.world.step(kStep_s).value();
            gap = std::max(gap, chain.greatest_gap());
            most = std::max(most, chain.energy() - chain.lowest());
        }
        INFO(ratio << " : 1");
        CHECK(gap < 5e-4);
        CHECK(most < 1.01 * start);
        CHECK(chain.energy() - chain.lowest() > 0.98 * start);
    }
}

TEST_CASE("a chain of twenty links holds 1e6 times the mass of one, and lets it hang still") {
    Hanging chain(20, 1e6, false);
    for (int i = 0; i < 300; ++i) {
        chain.world.step(kStep_s).value();
        REQUIRE(chain.greatest_gap() < 1e-4);
        REQUIRE(length(chain.world.body(chain.bodies.back())->linear_velocity()) < 1e-3f);
    }
    CHECK(d(chain.world.joint(chain.joints[0])->reaction_force().y) ==
          Approx(10.0 * (1e6 + 20)).epsilon(1e-3));
}

TEST_CASE("a heavy ball on a chain falls from level as a pendulum does") {
    Hanging chain(50, 5e4, true);
    // The links weigh a thousandth of the ball.
    const double start = chain.energy();
    double lowest = 0;
    for (int i = 0; i < 240; ++i) {
        chain.world.step(kStep_s).value();
        lowest = std::min(lowest, chain.world.body(chain.bodies.back())->position().y);
        REQUIRE(chain.greatest_gap() < 1e-4);
    }
    CHECK(lowest == Approx(-25).epsilon(1e-3));
    CHECK(chain.energy() - chain.lowest() == Approx(start - chain.lowest()).epsilon(0.01));
}

TEST_CASE("a cantilever of forty welds stays level and carries the moment of its weight") {
    World world({.enable_sleep = false});
    BodyId last = world.create_body({.type = BodyType::Static}).value();
    JointId root{};
    Vec2 anchor{};
    double mass = 0;
    for (int i = 0; i < 40; ++i) {
        const BodyId beam = add(world, {.position_m = {0.25 + 0.5 * i, 0}}, Box{0.25f, 0.05f});
        const JointId weld = world
                                 .create_joint(WeldJointDef{.body_a = last,
                                                            .body_b = beam,
                                                            .local_anchor_a_m = anchor,
                                                            .local_anchor_b_m = {-0.25f, 0}})
                                 .value();
        if (i == 0) root = weld;
        mass += d(world.body(beam)->mass());
        last = beam;
        anchor = {0.25f, 0};
    }
    run_for(world, 2);
    CHECK(std::fabs(world.body(last)->position().y) < 1e-4);
    CHECK(d(world.joint(root)->reaction_force().y) == Approx(10 * mass).epsilon(1e-3));
    CHECK(d(world.joint(root)->reaction_torque()) == Approx(10 * mass * 10).epsilon(1e-3));
}

TEST_CASE("ten welds that say the same share the load, and a torn loop finds a middle") {
    World world({.joint_solver = JointSolver::Direct, .enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    const BodyId box = add(world, {}, Box{0.5f, 0.5f});
    Vec2 sum{};
    std::vector<JointId> welds;
    for (int i = 0; i < 10; ++i)
        welds.push_back(world.create_joint(WeldJointDef{.body_a = wall, .body_b = box}).value());
    run_for(world, 2);
    for (const JointId id : welds) sum += world.joint(id)->reaction_force();
    CHECK(d(sum.y) == Approx(10 * d(world.body(box)->mass())).epsilon(1e-3));
    CHECK(std::fabs(world.body(box)->position().y) < 1e-5);

    // One more wants it two metres to the right.
    world.create_joint(WeldJointDef{.body_a = wall, .body_b = box, .local_anchor_a_m = {2, 0}}).value();
    for (int i = 0; i < 300; ++i) {
        world.step(kStep_s).value();
        REQUIRE(std::fabs(world.body(box)->position().x) < 2.1);
        REQUIRE(length(world.body(box)->linear_velocity()) < 100);
    }
}

TEST_CASE("a torque turns a link of a taut chain as far as the tension lets it") {
    const bool is_plain = GENERATE(true, false);  // a row of pins has a solver of its own
    const float torque_nm = GENERATE(-20.0f, 500.0f);
    Hanging chain(10, 1000, false);
    if (!is_plain) chain.world.joint(chain.joints[0])->set_limits(true, -3, 3).value();
    for (const BodyId id : chain.bodies) {
        chain.world.body(id)->set_linear_damping(2).value();
        chain.world.body(id)->set_angular_damping(2).value();
    }
    const BodyId link = chain.bodies[4];
    for (int i = 0; i < 1200; ++i) {
        chain.world.body(link)->apply_torque(torque_nm).value();
        chain.world.step(kStep_s).value();
    }
    // All others hang straight down, so the pins bear no more than what lies below them.
    const double tension_n = 10 * (1000 + 5 + 0.5);
    CHECK(std::sin(chain.world.body(link)->angle()) ==
          Approx(d(torque_nm) / (0.5 * tension_n)).epsilon(2e-3));
}

TEST_CASE("limits and motors within a structure hold as they do alone") {
    // A boom of three arms: the first is driven against its limit with a load at the end, the others are
    // held.
    World world({.joint_solver = JointSolver::Direct, .enable_sleep = false});
    BodyId last = world.create_body({.type = BodyType::Static}).value();
    Vec2 anchor{};
    std::vector<JointId> joints;
    for (int i = 0; i < 3; ++i) {
        const BodyId arm = add(world, {.position_m = {0.5 + i, 0}}, Box{0.5f, 0.1f});
        joints.push_back(world
                             .create_joint(RevoluteJointDef{.body_a = last,
                                                            .body_b = arm,
                                                            .local_anchor_a_m = anchor,
                                                            .local_anchor_b_m = {-0.5f, 0},
                                                            .enable_limit = true,
                                                            .lower_rad = -0.2f,
                                                            .upper_rad = i == 0 ? 0.5f : 0.2f,
                                                            .enable_motor = i == 0,
                                                            .motor_speed_rad_s = 1,
                                                            .max_motor_torque_nm = 100})
                             .value());
        last = arm;
        anchor = {0.5f, 0};
    }
    for (int i = 0; i < 240; ++i) {
        world.step(kStep_s).value();
        for (const JointId id : joints) {
            REQUIRE(world.joint(id)->joint_angle() < 0.51f);
            REQUIRE(world.joint(id)->joint_angle() > -0.21f);
            REQUIRE(world.joint(id)->current_length() < 1e-4f);
        }
    }
    CHECK(d(world.joint(joints[0])->joint_angle()) == Approx(0.5).margin(1e-3));
    CHECK(d(world.joint(joints[1])->joint_angle()) == Approx(-0.2).margin(1e-3));
}

TEST_CASE("a direct solution is the same at any number of threads") {
    const auto run = [](int threads) {
        World world({.threads = threads});
        for (int k = 0; k < 6; ++k) {
            BodyId last = world.create_body({.type = BodyType::Static, .position_m = {4.0 * k, 0}}).value();
            for (int i = 0; i < 12; ++i) {
                const BodyId link = add(world, {.position_m = {4.0 * k, -0.25 - 0.5 * i}}, Box{0.05f, 0.25f});
                world
                    .create_joint(RevoluteJointDef{.body_a = last,
                                                   .body_b = link,
                                                   .local_anchor_a_m = {0, i == 0 ? 0.0f : -0.25f},
                                                   .local_anchor_b_m = {0, 0.25f}})
                    .value();
                last = link;
            }
            world.body(last)->set_linear_velocity({3.0f + static_cast<float>(k), 0}).value();
        }
        step_times(world, 120);
        return world.state_hash();
    };
    CHECK(run(1) == run(2));
    CHECK(run(1) == run(5));
}

// Its groups are those of a chain that never slept.
TEST_CASE("a sleeping chain that bears a heavy ball is held in the step in which it is hit") {
    Hanging asleep(20, 1e4, false);
    Hanging awake(20, 1e4, false);
    std::vector<double> gaps;
    for (Hanging* chain : {&asleep, &awake}) {
        step_times(chain->world, 60);
        if (chain == &asleep) chain->world.body(chain->bodies.front())->set_awake(false);
        const BodyId bird =
            add(chain->world, {.position_m = {-3, -5}, .linear_velocity_m_s = {20, 0}, .gravity_scale = 0},
                Circle{{}, 0.2f});
        REQUIRE(chain->world.counts().awake_bodies == (chain == &asleep ? 1 : 22));
        double gap = 0;
        for (int i = 0; i < 20; ++i) {
            chain->world.step(kStep_s).value();
            gap = std::max(gap, chain->greatest_gap());
        }
        REQUIRE(chain->world.counts().awake_bodies == 22);
        CHECK(d(chain->world.body(bird)->linear_velocity().x) < 10);  // it hit
        gaps.push_back(gap);
    }
    CHECK(gaps[0] < 2 * gaps[1]);
}

// A contact without a lane is judged before the chain that it wakes is in a group.
TEST_CASE("a sleeping chain that something is put into is held as one that is awake") {
    std::vector<double> gaps;
    for (const bool sleeps : {true, false}) {
        Hanging chain(20, 1e4, false);
        step_times(chain.world, 60);
        if (sleeps) chain.world.body(chain.bodies.front())->set_awake(false);
        add(chain.world, {.position_m = {-0.25, -5.2}, .gravity_scale = 0}, Box{0.3f, 0.3f},
            {.density_kg_m2 = 2000, .material = {.rolling_resistance = 0.01f}});
        double gap = 0;
        for (int i = 0; i < 6; ++i) {
            chain.world.step(kStep_s).value();
            gap = std::max(gap, chain.greatest_gap());
        }
        REQUIRE(chain.world.counts().awake_bodies == 22);
        gaps.push_back(gap);
    }
    CHECK(gaps[0] < 2 * gaps[1]);
}

TEST_CASE("a rod that whirls into a sleeping chain brings no energy but its own") {
    for (const float restitution : {0.0f, 1.0f}) {
        for (int i = 0; i < 60; ++i) {
            Hanging chain(20, 1e4, false);
            step_times(chain.world, 60);
            chain.world.body(chain.bodies.front())->set_awake(false);
            const double at_rest = chain.energy();
            const BodyId rod =
                add(chain.world,
                    {.position_m = {-1, -5.2 - 0.01 * i},
                     .angle_rad = -0.5 - 0.02 * i,
                     .angular_velocity_rad_s = 40.0f + static_cast<float>(i),
                     .gravity_scale = 0},
                    Box{1.1f, 0.03f}, {.density_kg_m2 = 2000, .material = {.restitution = restitution}});
            const double brought = kinetic_energy(*chain.world.body(rod));
            INFO("restitution " << restitution << ", pose " << i);
            for (int step = 0; step < 6; ++step) {
                chain.world.step(kStep_s).value();
                const double now = chain.energy() + kinetic_energy(*chain.world.body(rod));
                CHECK(now - at_rest <= 1.01 * brought);
            }
            CHECK(chain.world.counts().awake_bodies == 22);
        }
    }
}

TEST_CASE(
    "a restored world solves the same joints directly as the one that it is of, after a body fell asleep") {
    // By the choice of the world, stiff springs.
    const auto [solver, frequency_hz] =
        GENERATE(std::pair{JointSolver::Direct, 30.0f}, std::pair{JointSolver::Automatic, 300.0f});
    const WorldDef def{.joint_solver = solver};
    World world(def);
    const BodyId carrier = world.create_body({.type = BodyType::Kinematic, .allow_sleep = false}).value();
    const BodyId ball = add(world, {.position_m = {0, -1}}, Circle{{}, 0.25f});
    for (const float side : {-1.0f, 1.0f}) {
        world
            .create_joint(DistanceJointDef{.body_a = carrier,
                                           .body_b = ball,
                                           .local_anchor_a_m = {side, 0},
                                           .length_m = std::sqrt(2.0f),
                                           .enable_spring = true,
                                           .frequency_hz = frequency_hz,
                                           .damping_ratio = 0.7f})
            .value();
    }
    world.body(carrier)->set_linear_velocity({0.5f, 0}).value();
    world.body(ball)->set_linear_velocity({1, 1}).value();
    step_times(world, 25);
    world.body(carrier)->set_linear_velocity({}).value();
    world.body(ball)->set_awake(false);
    REQUIRE_FALSE(world.body(ball)->is_awake());
    step_times(world, 1);
    World other(def);
    other.restore(world.snapshot().value().bytes()).value();
    for (int i = 0; i < 120; ++i) {
        if (i == 10) {
            for (World* each : {&world, &other}) each->body(each->own(ball))->set_awake(true);
        }
        world.step(kStep_s).value();
        other.step(kStep_s).value();
        INFO("step " << i);
        REQUIRE(world.state_hash() == other.state_hash());
    }
}

}  // namespace cairn::physics
