// Joints of which a body was put elsewhere.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr WorldDef kWeightless{.gravity_m_s2 = {}, .enable_sleep = false};
constexpr ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

std::vector<JointDef> joints_between(BodyId a, BodyId b) {
    return {RevoluteJointDef{.body_a = a, .body_b = b, .local_anchor_b_m = {0, 1}},
            RevoluteJointDef{.body_a = a,
                             .body_b = b,
                             .local_anchor_b_m = {0, 1},
                             .enable_limit = true,
                             .lower_rad = -1,
                             .upper_rad = 1},
            WeldJointDef{.body_a = a, .body_b = b, .local_anchor_b_m = {0, 1}},
            PrismaticJointDef{.body_a = a, .body_b = b, .local_anchor_b_m = {0, 1}},
            WheelJointDef{.body_a = a, .body_b = b, .local_anchor_b_m = {0, 1}, .enable_spring = false},
            DistanceJointDef{.body_a = a, .body_b = b, .length_m = 1}};
}

}  // namespace

TEST_CASE("a joint torn far apart is closed at once, and leaves no speed behind") {
    for (std::size_t kind = 0; kind < 6; ++kind) {
        for (const Position to : {Position{100, 70}, Position{-5, -30}}) {
            INFO("joint " << kind << ", to (" << to.x << ", " << to.y << ")");
            World world(kWeightless);
            const BodyId hook = world.create_body({.type = BodyType::Static}).value();
            const BodyId bob = add(world, {.position_m = {0, -1}}, Circle{{}, 0.25f}, kMeetsNothing);
            world.create_joint(joints_between(hook, bob)[kind]).value();
            world.body(bob)->set_transform(to, 0).value();
            run_for(world, 0.5);
            CHECK(world.report().max_joint_error_m < 1e-4f);
            CHECK(length(world.body(bob)->linear_velocity()) < 1e-3f);
            CHECK(std::fabs(world.body(bob)->angular_velocity()) < 1e-3f);
        }
    }
}

TEST_CASE("two free bodies of a torn joint meet where their masses say") {
    World world(kWeightless);
    const BodyId light = add(world, {}, Circle{{}, 0.5f}, kMeetsNothing);
    const BodyId heavy = add(world, {}, Circle{{}, 1}, kMeetsNothing);
    world.create_joint(RevoluteJointDef{.body_a = light, .body_b = heavy}).value();
    world.body(heavy)->set_transform({10, 0}, 0).value();
    world.step(kStep_s).value();
    // Masses as 1 : 4.
    CHECK(world.body(light)->position().x == Approx(8).epsilon(1e-5));
    CHECK(world.body(heavy)->position().x == Approx(8).epsilon(1e-5));
}

TEST_CASE("a torn joint whose body is hurled beyond all measure leaves what it hangs on where it is") {
    const float push_n = GENERATE(1e18f, 1e20f, 1e22f, 1e24f, 1e28f, 1e32f, 1e36f, 1e38f, 3e38f);
    for (std::size_t kind = 0; kind < 6; ++kind) {
        INFO("joint " << kind << ", " << push_n << " N");
        World world;
        const BodyId ground = add_ground(world);
        const BodyId bob = add(world, {.position_m = {0, 1}}, Circle{{}, 0.25f}, kMeetsNothing);
        world.create_joint(joints_between(ground, bob)[kind]).value();
        world.step(kStep_s).value();
        add(world, {.position_m = {20, 0.5}}, Circle{}, {.contact_events = true});
        world.body(bob)->set_transform({100, 70}, 0).value();
        world.body(bob)->apply_force_to_center({push_n, push_n}).value();
        world.step(kStep_s).value();
        REQUIRE(world.contact_begins().size() == 1);
        const Position point = world.contact_begins()[0].point_m;
        CHECK(point.x == Approx(20).margin(0.01));
        CHECK(point.y == Approx(0).margin(0.01));
    }
}

TEST_CASE("a chain of which a link was put elsewhere comes together") {
    World world(kWeightless);
    std::vector<BodyId> links;
    for (int i = 0; i < 12; ++i) {
        links.push_back(add(world, {.position_m = {0.5 * i, 0}}, Box{0.25f, 0.05f}, kMeetsNothing));
        if (i == 0) continue;
        world
            .create_joint(RevoluteJointDef{.body_a = links[links.size() - 2],
                                           .body_b = links.back(),
                                           .local_anchor_a_m = {0.25f, 0},
                                           .local_anchor_b_m = {-0.25f, 0}})
            .value();
    }
    world.body(links[5])->set_transform({0, 200}, 0).value();
    run_for(world, 3);
    CHECK(world.report().max_joint_error_m < 5e-3f);
}

// An undamped spring keeps a joint out of the lanes. This one is too soft to matter.
TEST_CASE("a wheel of a stiffness of its own is torn in a lane as without one") {
    const auto height_after = [](const JointStiffness& stiffness, float damping_ratio) {
        World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping});
        const BodyId wall = world.create_body({.type = BodyType::Static}).value();
        const BodyId wheel = add(world, {}, Circle{{}, 0.3f});
        world
            .create_joint(WheelJointDef{.body_a = wall,
                                        .body_b = wheel,
                                        .enable_spring = true,
                                        .frequency_hz = 0.01f,
                                        .damping_ratio = damping_ratio,
                                        .stiffness = stiffness})
            .value();
        step_times(world, 10);
        world.body(wheel)->set_transform({0, 6}, 0).value();
        step_times(world, 1);
        return world.body(wheel)->position().y;
    };
    for (const JointStiffness& stiffness :
         {JointStiffness{60, 2}, JointStiffness{30, 0.5f}, JointStiffness{20, 0.1f}, JointStiffness{60, 5},
          JointStiffness{120, 10}}) {
        INFO(stiffness.frequency_hz << " Hz, damping ratio " << stiffness.damping_ratio);
        const double in_lane = height_after(stiffness, 1e-4f);
        CHECK(in_lane == Approx(height_after(stiffness, 0)).margin(1e-5));
        CHECK((in_lane < 1e-5) == (stiffness.frequency_hz >= 60));
    }
}

TEST_CASE("what is soft is left to its forces when it is torn") {
    const auto run = [](const JointDef& joint) {
        World world(kWeightless);
        const BodyId hook = world.create_body({.type = BodyType::Static}).value();
        const BodyId bob = add(world, {}, Circle{{}, 0.25f}, kMeetsNothing);
        JointDef def = joint;
        std::visit(
            [&](auto& d) {
                if constexpr (requires { d.body_a; }) {
                    d.body_a = hook;
                    d.body_b = bob;
                }
            },
            def);
        world.create_joint(def).value();
        world.body(bob)->set_transform({20, 0}, 0).value();
        world.step(kStep_s).value();
        return world.body(bob)->position().x;
    };
    CHECK(run(RevoluteJointDef{}) == Approx(0).margin(1e-4));
    CHECK(run(RevoluteJointDef{.stiffness = {.frequency_hz = 1}}) > 15);
    CHECK(run(WeldJointDef{.linear_frequency_hz = 1}) > 15);
}

}  // namespace cairn::physics
