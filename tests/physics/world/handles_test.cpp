// Null, stale and foreign handles: each function that takes one says which it was, and changes nothing.
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

struct Use {
    std::string name;
    std::function<std::string(World&)> message;  // of the error; empty when there is none
};

template <class T>
std::string message_of(const Result<T>& result) {
    return result ? "" : result.error().message;
}

std::vector<Use> uses_of(BodyId bad, BodyId good) {
    return {
        {"body", [=](World& w) { return message_of(w.body(bad)); }},
        {"const body", [=](World& w) { return message_of(std::as_const(w).body(bad)); }},
        {"destroy_body", [=](World& w) { return message_of(w.destroy_body(bad)); }},
        {"destroy_bodies",
         [=](World& w) {
             return message_of(w.destroy_bodies(std::array{good, bad}));
         }},
        {"create_shape", [=](World& w) { return message_of(w.create_shape(bad, Circle{})); }},
        {"revolute body_a",
         [=](World& w) {
             return message_of(w.create_joint(RevoluteJointDef{.body_a = bad, .body_b = good}));
         }},
        {"revolute body_b",
         [=](World& w) {
             return message_of(w.create_joint(RevoluteJointDef{.body_a = good, .body_b = bad}));
         }},
        {"distance body_a",
         [=](World& w) {
             return message_of(w.create_joint(DistanceJointDef{.body_a = bad, .body_b = good}));
         }},
        {"distance body_b",
         [=](World& w) {
             return message_of(w.create_joint(DistanceJointDef{.body_a = good, .body_b = bad}));
         }},
    };
}

std::vector<Use> uses_of(ShapeId bad) {
    return {
        {"shape", [=](World& w) { return message_of(w.shape(bad)); }},
        {"const shape", [=](World& w) { return message_of(std::as_const(w).shape(bad)); }},
        {"destroy_shape", [=](World& w) { return message_of(w.destroy_shape(bad)); }},
        {"sensor_overlaps", [=](World& w) { return message_of(w.sensor_overlaps(bad)); }},
    };
}

std::vector<Use> uses_of(JointId bad) {
    return {
        {"joint", [=](World& w) { return message_of(w.joint(bad)); }},
        {"const joint", [=](World& w) { return message_of(std::as_const(w).joint(bad)); }},
        {"destroy_joint", [=](World& w) { return message_of(w.destroy_joint(bad)); }},
    };
}

void require_refusal(World& world, const std::vector<Use>& uses, const std::string& kind,
                     const std::string& why) {
    for (const Use& use : uses) {
        INFO(use.name << " with a handle that is " << why);
        const auto before = listed(world.counts());
        const std::uint64_t hash = world.state_hash();
        CHECK_THAT(use.message(world), Contains(kind) && Contains(why));
        CHECK(listed(world.counts()) == before);
        CHECK(world.state_hash() == hash);
    }
}

// A world with two of everything, of which the second of each has been destroyed.
struct Populated {
    World world;
    BodyId body;
    BodyId stale_body;
    ShapeId stale_shape;
    JointId stale_joint;

    Populated() {
        const BodyId anchor = world.create_body({.type = BodyType::Static}).value();
        body = add(world, {}, Circle{});
        stale_shape = world.create_shape(body, Circle{}).value();
        stale_joint = world.create_joint(RevoluteJointDef{.body_a = anchor, .body_b = body}).value();
        stale_body = add(world, {.position_m = {5, 0}}, Circle{});
        world.destroy_joint(stale_joint).value();
        world.destroy_shape(stale_shape).value();
        world.destroy_body(stale_body).value();
    }
};

}  // namespace

TEST_CASE("a null handle is refused as null") {
    Populated p;
    require_refusal(p.world, uses_of(BodyId{}, p.body), "body", "null");
    require_refusal(p.world, uses_of(ShapeId{}), "shape", "null");
    require_refusal(p.world, uses_of(JointId{}), "joint", "null");
}

TEST_CASE("a handle of something destroyed is refused as such, even when its slot is in use again") {
    Populated p;
    for (const bool reused : {false, true}) {
        if (reused) {
            const BodyId anchor = add(p.world, {.type = BodyType::Static, .position_m = {5, 0}}, Circle{});
            p.world.create_shape(p.body, Circle{}).value();
            p.world.create_joint(RevoluteJointDef{.body_a = anchor, .body_b = p.body}).value();
        }
        require_refusal(p.world, uses_of(p.stale_body, p.body), "body", "destroyed");
        require_refusal(p.world, uses_of(p.stale_shape), "shape", "destroyed");
        require_refusal(p.world, uses_of(p.stale_joint), "joint", "destroyed");
        CHECK_FALSE(p.world.contains(p.stale_body));
        CHECK_FALSE(p.world.contains(p.stale_shape));
        CHECK_FALSE(p.world.contains(p.stale_joint));
    }
}

TEST_CASE("a handle of another world is refused as foreign") {
    Populated p;
    World other;
    const BodyId a = add(other, {}, Circle{});
    const BodyId b = add(other, {.position_m = {5, 0}}, Circle{});
    const ShapeId shape = other.body(a)->shapes()[0];
    const JointId joint = other.create_joint(RevoluteJointDef{.body_a = a, .body_b = b}).value();
    require_refusal(p.world, uses_of(a, p.body), "body", "another world");
    require_refusal(p.world, uses_of(shape), "shape", "another world");
    require_refusal(p.world, uses_of(joint), "joint", "another world");
    CHECK_FALSE(p.world.contains(a));
    CHECK_FALSE(p.world.contains(shape));
    CHECK_FALSE(p.world.contains(joint));
    CHECK(other.contains(a));
}

TEST_CASE("handles stay good when their world is moved") {
    World first;
    const BodyId body = add(first, {.user_data = 42}, Circle{});
    World second = std::move(first);
    REQUIRE(second.contains(body));
    CHECK(second.body(body)->user_data() == 42);
    World third;
    third = std::move(second);
    CHECK(third.body(body)->user_data() == 42);
}

TEST_CASE("destroying a body destroys its shapes and joints, and nobody else's") {
    World world;
    const BodyId a = add(world, {}, Circle{});
    const BodyId b = add(world, {.position_m = {2, 0}}, Circle{});
    const BodyId c = add(world, {.position_m = {4, 0}}, Circle{});
    const JointId ab = world.create_joint(DistanceJointDef{.body_a = a, .body_b = b}).value();
    const JointId bc = world.create_joint(DistanceJointDef{.body_a = b, .body_b = c}).value();
    const ShapeId shape_a = world.body(a)->shapes()[0];
    const ShapeId shape_b = world.body(b)->shapes()[0];
    CHECK(world.body(b)->joints().size() == 2);
    world.destroy_body(a).value();
    CHECK_FALSE(world.contains(ab));
    CHECK_FALSE(world.contains(shape_a));
    CHECK(world.contains(bc));
    CHECK(world.contains(shape_b));
    CHECK(world.body(b)->joints() == std::vector<JointId>{bc});
    CHECK(world.bodies() == std::vector<BodyId>{b, c});
    CHECK(world.counts().joints == 1);
}

TEST_CASE("user data is kept for bodies, shapes and joints") {
    World world;
    const BodyId a = world.create_body({.user_data = 1}).value();
    const BodyId b = world.create_body({.user_data = 2}).value();
    const ShapeId shape = world.create_shape(a, Circle{}, {.user_data = 3}).value();
    const JointId joint =
        world.create_joint(RevoluteJointDef{.body_a = a, .body_b = b, .user_data = ~std::uint64_t{0}})
            .value();
    CHECK(world.body(b)->user_data() == 2);
    CHECK(world.shape(shape)->user_data() == 3);
    CHECK(world.joint(joint)->user_data() == ~std::uint64_t{0});
    world.body(b)->set_user_data(4);
    world.shape(shape)->set_user_data(5);
    world.joint(joint)->set_user_data(6);
    CHECK(world.body(b)->user_data() == 4);
    CHECK(world.shape(shape)->user_data() == 5);
    CHECK(world.joint(joint)->user_data() == 6);
}

TEST_CASE("the mass of a body is that of its shapes, as they come and go") {
    World world;
    const BodyId body = world.create_body({}).value();
    CHECK(world.body(body)->mass() == 0);
    const ShapeId left = world.create_shape(body, Box{0.5f, 0.5f, {-2, 0}}).value();
    const ShapeId right = world.create_shape(body, Box{0.5f, 0.5f, {2, 0}}, {.density_kg_m2 = 3}).value();
    const MassData both = world.body(body)->mass_data();
    CHECK(both.mass_kg == Approx(4));
    CHECK(both.center_m.x == Approx(1));
    // Two unit squares of 1 and 3 kg, 3 m and 1 m from the common centre.
    CHECK(both.inertia_kg_m2 == Approx(4.0 / 6 + 1 * 9 + 3 * 1));
    CHECK(world.body(body)->shapes() == std::vector<ShapeId>{left, right});
    world.destroy_shape(right).value();
    CHECK(world.body(body)->mass() == Approx(1));
    CHECK(world.body(body)->mass_data().center_m.x == Approx(-2));
    CHECK(world.body(body)->position() == Position{0, 0});
    const BodyId fixed = add(world, {.type = BodyType::Static}, Circle{});
    CHECK(world.body(fixed)->mass() == 0);
}

TEST_CASE("the place of a body is told without a view, if there is such a body") {
    World world;
    World other;
    const BodyId body = world.create_body({.position_m = {3, 4}, .angle_rad = 2}).value();
    world.create_shape(body, Box{0.5f, 0.5f, {-2, 0}}).value();
    const ShapeId lost = world.create_shape(body, Box{0.5f, 0.5f, {2, 1}}, {.density_kg_m2 = 3}).value();
    CHECK(world.position_of(body) == world.body(body)->position());
    world.destroy_shape(lost).value();
    CHECK(world.position_of(body) == world.body(body)->position());
    CHECK(world.position_of({}) == std::nullopt);
    CHECK(other.position_of(body) == std::nullopt);
    world.destroy_body(body).value();
    CHECK(world.position_of(body) == std::nullopt);
}

TEST_CASE("all places are told in the order of the bodies, with the handles that the world gave out") {
    World world;
    const auto add_one = [&](int i) {
        return add(world, {.position_m = {1.5 * i, 9}, .angle_rad = 0.1 * i}, Box{0.5f, 0.25f, {0.1f, 0}});
    };
    std::vector<BodyId> made;
    for (int i = 0; i < 20; ++i) made.push_back(add_one(i));
    for (std::size_t i = 0; i < made.size(); i += 3) world.destroy_body(made[i]).value();
    for (int i = 20; i < 23; ++i) add_one(i);  // in slots that were used before
    std::vector<BodyTransform> places(7);
    world.read_transforms(places);
    const std::vector<BodyId> bodies = world.bodies();
    REQUIRE(places.size() == bodies.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        CHECK(places[i].body == bodies[i]);
        CHECK(places[i].transform.p == world.body(bodies[i])->position());
        CHECK(places[i].transform.q.s == world.body(bodies[i])->transform().q.s);
    }
}

TEST_CASE("a shape can be read back as it was made") {
    World world;
    const BodyId body = world.create_body({}).value();
    const ShapeId id = world
                           .create_shape(body, Capsule{{-1, 0}, {1, 0}, 0.25f},
                                         {.density_kg_m2 = 2,
                                          .material = {.friction = 0.1f, .restitution = 0.2f},
                                          .filter = {.categories = 5, .mask = 6, .group = -7}})
                           .value();
    const Shape shape = *world.shape(id);
    CHECK(shape.id() == id);
    CHECK(shape.body() == body);
    CHECK(shape.outline().kind == ShapeKind::Capsule);
    CHECK(shape.outline().count == 2);
    CHECK(shape.outline().points_m[1] == Vec2{1, 0});
    CHECK(shape.outline().radius_m == 0.25f);
    CHECK(shape.density() == 2);
    CHECK(shape.material().friction == 0.1f);
    CHECK(shape.material().restitution == 0.2f);
    CHECK(shape.filter().categories == 5);
    CHECK(shape.filter().mask == 6);
    CHECK(shape.filter().group == -7);
}

}  // namespace cairn::physics
