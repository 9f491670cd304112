// What is told for debug drawing, against statics, against who falls asleep with whom, and against the
// shapes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "physics/support/scenes.h"

namespace cairn::physics {

using namespace test;

TEST_CASE("contacts of a box at rest bear its weight, upward from the ground") {
    World world({.gravity_m_s2 = {0, -10}, .enable_sleep = false});
    const BodyId ground = add_ground(world);
    const BodyId box = add(world, {.position_m = {3, 0.5}}, Box{0.5f, 0.5f});
    step_times(world, 120);
    const std::vector<DebugContact> contacts = world.debug_contacts();
    REQUIRE(contacts.size() == 1);
    const DebugContact& contact = contacts[0];
    CHECK(contact.body_a == ground);
    CHECK(contact.body_b == box);
    CHECK(contact.normal.x == Approx(0).margin(1e-4));
    CHECK(contact.normal.y == Approx(1));
    REQUIRE(contact.count == 2);
    const float weight_ns = world.body(box)->mass() * 10 * kStep_s;
    CHECK(contact.points[0].impulse_ns + contact.points[1].impulse_ns == Approx(weight_ns).epsilon(1e-3));
    CHECK(std::min(contact.points[0].point_m.x, contact.points[1].point_m.x) == Approx(2.5).margin(1e-3));
    CHECK(std::max(contact.points[0].point_m.x, contact.points[1].point_m.x) == Approx(3.5).margin(1e-3));
    for (const DebugContactPoint& point : contact.points) CHECK(point.point_m.y == Approx(0).margin(2e-3));
}

TEST_CASE("friction that holds a box on a slope bears the part of the weight along the slope") {
    const float slope_rad = 0.3f;
    const Rotation q = Rotation::from_angle(static_cast<double>(slope_rad));
    World world({.gravity_m_s2 = inverse_rotate(q, {0, -10}), .enable_sleep = false});
    add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    step_times(world, 120);
    const std::vector<DebugContact> contacts = world.debug_contacts();
    REQUIRE(contacts.size() == 1);
    // The tangent is the normal (0, 1) turned clockwise: (1, 0). Gravity pulls the box towards -x.
    const float along_ns = world.body(box)->mass() * 10 * std::sin(slope_rad) * kStep_s;
    CHECK(contacts[0].friction_impulse_ns == Approx(along_ns).epsilon(2e-2));
}

TEST_CASE("the bodies of an island are those that fall asleep together") {
    const auto build = [](World& world) {
        build_pyramid(world, 3);
        for (int i = 0; i < 4; ++i) add(world, {.position_m = {20, 0.5 + i}}, Box{0.5f, 0.5f});
        const BodyId a = add(world, {.position_m = {30, 0.5}}, Box{0.5f, 0.5f});
        const BodyId b = add(world, {.position_m = {32, 0.5}}, Box{0.5f, 0.5f});
        world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length_m = 2}).value();
        add(world, {.position_m = {40, 0.5}}, Box{0.5f, 0.5f});
        step_times(world, 10);
    };
    World world;
    build(world);
    const std::vector<DebugIsland> islands = world.debug_islands();
    REQUIRE(islands.size() == 13);
    CHECK(std::all_of(islands.begin(), islands.end(), [](const DebugIsland& i) { return i.is_awake; }));
    std::map<int, int> sizes;
    for (const DebugIsland& island : islands) ++sizes[island.island];
    CHECK(sizes == std::map<int, int>{{0, 6}, {1, 4}, {2, 2}, {3, 1}});
    for (const DebugIsland& chosen : islands) {
        World twin;
        build(twin);
        const std::vector<DebugIsland> of_twin = twin.debug_islands();
        const auto index = static_cast<std::size_t>(&chosen - islands.data());
        twin.body(of_twin[index].body)->set_awake(false);
        for (const DebugIsland& other : of_twin)
            CHECK(twin.body(other.body)->is_awake() == (other.island != of_twin[index].island));
        // Asleep they are one island still.
        const std::vector<DebugIsland> after = twin.debug_islands();
        for (std::size_t i = 0; i < after.size(); ++i) CHECK(after[i].island == of_twin[i].island);
    }
}

TEST_CASE("boxes of the broad phase enclose their shapes, and no sensor has one") {
    World world;
    const BodyId body = add(world, {.position_m = {100, -50}, .angle_rad = 0.7}, Box{2, 0.5f});
    world.create_shape(body, Circle{{3, 0}, 0.25f}).value();
    world.create_shape(body, Circle{{0, 0}, 5}, {.sensor = true}).value();
    step_times(world, 5);
    const std::vector<DebugBox> boxes = world.debug_boxes();
    REQUIRE(boxes.size() == 2);
    for (const DebugBox& box : boxes) {
        const Outline outline = world.shape(box.shape)->outline();
        for (int i = 0; i < outline.count; ++i) {
            const Position p = transform_point(world.body(body)->transform(), outline.points_m[i]);
            const auto r = static_cast<double>(outline.radius_m);
            CHECK(box.lower_m.x <= p.x - r);
            CHECK(box.upper_m.x >= p.x + r);
            CHECK(box.lower_m.y <= p.y - r);
            CHECK(box.upper_m.y >= p.y + r);
            CHECK(box.upper_m.x - box.lower_m.x < 8);
        }
    }
}

TEST_CASE("asking leaves a world as it is") {
    World asked;
    World twin;
    for (World* world : {&asked, &twin}) build_pyramid(*world, 6);
    for (int i = 0; i < 90; ++i) {
        for (World* world : {&asked, &twin}) step_times(*world, 1);
        CHECK_FALSE(asked.debug_contacts().size() < 6);
        CHECK(asked.debug_islands().size() == 21);
        CHECK(asked.debug_boxes().size() == 22);
        CHECK(asked.state_hash() == twin.state_hash());
    }
}

}  // namespace cairn::physics
