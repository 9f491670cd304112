// Bad input: for every field, an error that names the field, the value and the rule, and a world unchanged.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kNaND = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinityD = std::numeric_limits<double>::infinity();

template <class T>
std::string message_of(const Result<T>& result) {
    return result ? "no error" : result.error().message;
}

// A world in motion: a stack, a joint, sleepers, contacts with impulses.
struct Scene {
    World world;
    BodyId ground = add_ground(world);
    BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    BodyId ball = add(world, {.position_m = {3, 2}}, Circle{});
    BodyId wall = add(world, {.type = BodyType::Static, .position_m = {9, 0}}, Box{0.5f, 0.5f});
    JointId rod =
        world.create_joint(DistanceJointDef{.body_a = ground, .body_b = ball, .length_m = 3}).value();
    JointId pin =
        world.create_joint(RevoluteJointDef{.body_a = box, .body_b = ball, .local_anchor_b_m = {-3, 0}})
            .value();

    Scene() { step_times(world, 10); }
};

struct Case {
    std::string field;  // and what else the message must contain
    std::string value;
    std::function<std::string(Scene&)> attempt;
};

template <class Def>
Case bad_def(std::string field, std::string value, Def def) {
    return {std::move(field), std::move(value), [def](Scene& s) {
                if constexpr (std::is_same_v<Def, BodyDef>) {
                    return message_of(s.world.create_body(def));
                } else if constexpr (std::is_same_v<Def, ShapeDef>) {
                    return message_of(s.world.create_shape(s.box, Circle{}, def));
                } else {
                    Def joint = def;
                    joint.body_a = s.box;
                    joint.body_b = s.ball;
                    return message_of(s.world.create_joint(joint));
                }
            }};
}

using BodyCall = std::function<Result<void>(Body)>;
Case bad_call(std::string field, std::string value, const BodyCall& call) {
    return {std::move(field), std::move(value),
            [call](Scene& s) { return message_of(call(*s.world.body(s.box))); }};
}

void require_refusals(const std::vector<Case>& cases) {
    Scene scene;
    for (const Case& c : cases) {
        INFO(c.field << " = " << c.value);
        const std::uint64_t hash = scene.world.state_hash();
        const auto before = listed(scene.world.counts());
        CHECK_THAT(c.attempt(scene), Contains(c.field) && Contains(c.value));
        CHECK(scene.world.state_hash() == hash);
        CHECK(listed(scene.world.counts()) == before);
    }
}

std::string world_error(const WorldDef& def) {
    return message_of(World::create(def));
}

}  // namespace

TEST_CASE("bad world definitions give an error that names the field and the value") {
    CHECK_THAT(world_error({.gravity_m_s2 = {kNaN, 0}}), Contains("world.gravity_m_s2 is (nan, 0)"));
    CHECK_THAT(world_error({.gravity_m_s2 = {0, -kInfinity}}), Contains("world.gravity_m_s2 is (0, -inf)"));
    CHECK_THAT(world_error({.substeps = 0}), Contains("world.substeps is 0") && Contains("from 1 to 64"));
    CHECK_THAT(world_error({.substeps = 65}), Contains("world.substeps is 65"));
    CHECK_THAT(world_error({.hit_speed_m_s = -1}), Contains("world.hit_speed_m_s is -1"));
    CHECK_THAT(world_error({.hit_speed_m_s = kNaN}), Contains("world.hit_speed_m_s is nan"));
    CHECK_THAT(world_error({.restitution_speed_m_s = -2}), Contains("world.restitution_speed_m_s is -2"));
    CHECK_THAT(world_error({.max_push_out_speed_m_s = 0}), Contains("world.max_push_out_speed_m_s is 0"));
    CHECK_THAT(world_error({.max_push_out_speed_m_s = kInfinity}),
               Contains("world.max_push_out_speed_m_s is inf"));
    CHECK_THAT(world_error({.threads = 0}), Contains("world.threads is 0") && Contains("from 1 to 64"));
    CHECK_THAT(world_error({.threads = 65}), Contains("world.threads is 65"));
    const TaskSystem no_enqueue{.wait = [](void*, void*) {}};
    CHECK_THAT(world_error({.tasks = &no_enqueue}), Contains("world.tasks.enqueue is null"));
    const TaskSystem no_wait{.enqueue = [](void*, TaskSystem::Task, void*, int) -> void* { return nullptr; }};
    CHECK_THAT(world_error({.threads = 2, .tasks = &no_wait}), Contains("world.tasks.wait is null"));
    CHECK(World::create({}));
    CHECK(World::create({.threads = 64}));
}

TEST_CASE("bad body definitions are refused") {
    require_refusals({
        bad_def("body.position_m", "(nan, 0)", BodyDef{.position_m = {kNaND, 0}}),
        bad_def("body.position_m", "(0, inf)", BodyDef{.position_m = {0, kInfinityD}}),
        bad_def("body.position_m", "within 1e12 m", BodyDef{.position_m = {1e300, 0}}),
        bad_def("body.position_m", "1.0001e+12", BodyDef{.position_m = {0, -1.0001e12}}),
        bad_def("body.angle_rad", "nan", BodyDef{.angle_rad = kNaND}),
        bad_def("body.angle_rad", "-inf", BodyDef{.angle_rad = -kInfinityD}),
        bad_def("body.linear_velocity_m_s", "(0, nan)", BodyDef{.linear_velocity_m_s = {0, kNaN}}),
        bad_def("body.linear_velocity_m_s", "(inf, 0)", BodyDef{.linear_velocity_m_s = {kInfinity, 0}}),
        bad_def("body.angular_velocity_rad_s", "nan", BodyDef{.angular_velocity_rad_s = kNaN}),
        bad_def("body.linear_damping_1_s", "-0.5", BodyDef{.linear_damping_1_s = -0.5f}),
        bad_def("body.linear_damping_1_s", "inf", BodyDef{.linear_damping_1_s = kInfinity}),
        bad_def("body.angular_damping_1_s", "-1", BodyDef{.angular_damping_1_s = -1}),
        bad_def("body.angular_damping_1_s", "nan", BodyDef{.angular_damping_1_s = kNaN}),
        bad_def("body.gravity_scale", "nan", BodyDef{.gravity_scale = kNaN}),
        bad_def("body.sleep_speed_m_s", "-1", BodyDef{.sleep_speed_m_s = -1}),
        bad_def("body.type", "7", BodyDef{.type = static_cast<BodyType>(7)}),
        bad_def("body.sleep_speed_m_s", "nan", BodyDef{.sleep_speed_m_s = kNaN}),
    });
}

TEST_CASE("bad shape definitions are refused") {
    require_refusals({
        bad_def("shape.density_kg_m2", "-1", ShapeDef{.density_kg_m2 = -1}),
        bad_def("shape.density_kg_m2", "nan", ShapeDef{.density_kg_m2 = kNaN}),
        bad_def("shape.density_kg_m2", "inf", ShapeDef{.density_kg_m2 = kInfinity}),
        bad_def("material.friction", "-0.1", ShapeDef{.material = {.friction = -0.1f}}),
        bad_def("material.friction", "nan", ShapeDef{.material = {.friction = kNaN}}),
        bad_def("material.restitution", "1.5", ShapeDef{.material = {.restitution = 1.5f}}),
        bad_def("material.restitution", "-0.5", ShapeDef{.material = {.restitution = -0.5f}}),
        bad_def("material.restitution", "nan", ShapeDef{.material = {.restitution = kNaN}}),
        bad_def("material.rolling_resistance", "-1", ShapeDef{.material = {.rolling_resistance = -1}}),
        bad_def("material.rolling_resistance", "inf",
                ShapeDef{.material = {.rolling_resistance = kInfinity}}),
        bad_def("material.surface_speed_m_s", "nan", ShapeDef{.material = {.surface_speed_m_s = kNaN}}),
        bad_def("material.kind", "-1", ShapeDef{.material = {.kind = -1}}),
        bad_def("material.kind", "64", ShapeDef{.material = {.kind = 64}}),
        bad_def("shape.one_way_normal", "(nan, 0)", ShapeDef{.one_way_normal = {kNaN, 0}}),
        bad_def("shape.one_way_normal", "(0, inf)", ShapeDef{.one_way_normal = {0, kInfinity}}),
        {"shape.one_way_normal", "(nan, 1)",
         [](Scene& s) {
             const ShapeId shape = s.world.body(s.box)->shapes()[0];
             return message_of(s.world.shape(shape)->set_one_way_normal({kNaN, 1}));
         }},
        {"circle.radius_m", "0",
         [](Scene& s) {
             return message_of(s.world.create_shape(s.box, Circle{{}, 0}));
         }},
        {"segment.b_m", "(nan, 0)",
         [](Scene& s) {
             return message_of(s.world.create_shape(s.box, Segment{{0, 0}, {kNaN, 0}}));
         }},
        {"from segment.a_m to segment.b_m", "0.004",
         [](Scene& s) {
             return message_of(s.world.create_shape(s.box, Segment{{0, 0}, {0.004f, 0}}));
         }},
        {"polygon.points_m", "2 distinct points",
         [](Scene& s) {
             const std::array<Vec2, 2> points{Vec2{0, 0}, Vec2{1, 0}};
             return message_of(s.world.create_shape(s.box, Polygon{.points_m = points}));
         }},
        {"friction", "-1",
         [](Scene& s) {
             const ShapeId shape = s.world.body(s.box)->shapes()[0];
             return message_of(s.world.shape(shape)->set_material({.friction = -1}));
         }},
    });
}

TEST_CASE("bad revolute joints are refused") {
    using Def = RevoluteJointDef;
    require_refusals({
        bad_def("revolute_joint.local_anchor_a_m", "(nan, 0)", Def{.local_anchor_a_m = {kNaN, 0}}),
        bad_def("revolute_joint.local_anchor_b_m", "(0, inf)", Def{.local_anchor_b_m = {0, kInfinity}}),
        bad_def("revolute_joint.local_angle_a_rad", "nan", Def{.local_angle_a_rad = kNaN}),
        bad_def("revolute_joint.lower_rad", "at most upper_rad", Def{.lower_rad = 0.5f, .upper_rad = 0.25f}),
        bad_def("revolute_joint.lower_rad", "-inf", Def{.lower_rad = -kInfinity}),
        bad_def("revolute_joint.upper_rad", "nan", Def{.upper_rad = kNaN}),
        bad_def("revolute_joint.motor_speed_rad_s", "inf", Def{.motor_speed_rad_s = kInfinity}),
        bad_def("revolute_joint.max_motor_torque_nm", "-1", Def{.max_motor_torque_nm = -1}),
        bad_def("revolute_joint.max_motor_torque_nm", "nan", Def{.max_motor_torque_nm = kNaN}),
        {"same body", "revolute_joint",
         [](Scene& s) { return message_of(s.world.create_joint(Def{.body_a = s.box, .body_b = s.box})); }},
        {"immovable", "revolute_joint",
         [](Scene& s) {
             return message_of(s.world.create_joint(Def{.body_a = s.ground, .body_b = s.wall}));
         }},
    });
}

TEST_CASE("bad distance joints are refused") {
    using Def = DistanceJointDef;
    require_refusals({
        bad_def("distance_joint.local_anchor_a_m", "(nan, 0)", Def{.local_anchor_a_m = {kNaN, 0}}),
        bad_def("distance_joint.local_anchor_b_m", "(0, nan)", Def{.local_anchor_b_m = {0, kNaN}}),
        bad_def("distance_joint.length_m", "0.001", Def{.length_m = 0.001f}),
        bad_def("distance_joint.length_m", "nan", Def{.length_m = kNaN}),
        bad_def("distance_joint.length_m", "inf", Def{.length_m = kInfinity}),
        bad_def("distance_joint.frequency_hz", "inf", Def{.enable_spring = true, .frequency_hz = kInfinity}),
        bad_def("distance_joint.frequency_hz", "-2", Def{.frequency_hz = -2}),
        bad_def("distance_joint.damping_ratio", "-0.5", Def{.damping_ratio = -0.5f}),
        bad_def("distance_joint.damping_ratio", "nan", Def{.damping_ratio = kNaN}),
        bad_def("distance_joint.min_length_m", "-1", Def{.min_length_m = -1}),
        bad_def("distance_joint.min_length_m", "at most length_m", Def{.length_m = 1, .min_length_m = 2}),
        bad_def("distance_joint.max_length_m", "at least length_m", Def{.length_m = 1, .max_length_m = 0.5f}),
        bad_def("distance_joint.max_length_m", "nan", Def{.max_length_m = kNaN}),
        {"same body", "distance_joint",
         [](Scene& s) { return message_of(s.world.create_joint(Def{.body_a = s.box, .body_b = s.box})); }},
        {"immovable", "distance_joint",
         [](Scene& s) {
             return message_of(s.world.create_joint(Def{.body_a = s.ground, .body_b = s.wall}));
         }},
    });
}

TEST_CASE("bad numbers for a body's setters are refused") {
    require_refusals({
        bad_call("body.position_m", "nan",
                 [](Body b) {
                     return b.set_transform({kNaND, 0}, 0);
                 }),
        bad_call("body.angle_rad", "inf",
                 [](Body b) {
                     return b.set_transform({0, 0}, kInfinityD);
                 }),
        bad_call("body.linear_velocity_m_s", "nan",
                 [](Body b) {
                     return b.set_linear_velocity({kNaN, 0});
                 }),
        bad_call("body.angular_velocity_rad_s", "inf",
                 [](Body b) { return b.set_angular_velocity(kInfinity); }),
        bad_call("force_n", "nan",
                 [](Body b) {
                     return b.apply_force({kNaN, 0}, {0, 0});
                 }),
        bad_call("point_m", "inf",
                 [](Body b) {
                     return b.apply_force({1, 0}, {0, kInfinityD});
                 }),
        bad_call("force_n", "inf",
                 [](Body b) {
                     return b.apply_force_to_center({kInfinity, 0});
                 }),
        bad_call("torque_nm", "nan", [](Body b) { return b.apply_torque(kNaN); }),
        bad_call("impulse_ns", "nan",
                 [](Body b) {
                     return b.apply_impulse({0, kNaN}, {0, 0});
                 }),
        bad_call("point_m", "nan",
                 [](Body b) {
                     return b.apply_impulse({0, 1}, {kNaND, 0});
                 }),
        bad_call("impulse_ns", "inf",
                 [](Body b) {
                     return b.apply_impulse_to_center({0, kInfinity});
                 }),
        bad_call("impulse_nms", "nan", [](Body b) { return b.apply_angular_impulse(kNaN); }),
        bad_call("body.linear_damping_1_s", "-1", [](Body b) { return b.set_linear_damping(-1); }),
        bad_call("body.angular_damping_1_s", "nan", [](Body b) { return b.set_angular_damping(kNaN); }),
        bad_call("body.gravity_scale", "inf", [](Body b) { return b.set_gravity_scale(kInfinity); }),
        bad_call("body.sleep_speed_m_s", "-2", [](Body b) { return b.set_sleep_speed(-2); }),
        bad_call("body.sleep_speed_m_s", "inf", [](Body b) { return b.set_sleep_speed(kInfinity); }),
    });
}

TEST_CASE("bad numbers and wrong kinds for a joint's setters are refused") {
    require_refusals({
        {"length_m", "-1", [](Scene& s) { return message_of(s.world.joint(s.rod)->set_length(-1)); }},
        {"frequency_hz", "-1",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->set_spring(true, -1, 0)); }},
        {"damping_ratio", "-1",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->set_spring(true, 1, -1)); }},
        {"motor_speed_rad_s", "nan",
         [](Scene& s) { return message_of(s.world.joint(s.pin)->set_motor(true, kNaN, 1)); }},
        {"max_motor_torque_nm", "-1",
         [](Scene& s) { return message_of(s.world.joint(s.pin)->set_motor(true, 1, -1)); }},
        {"lower_rad", "at most upper_rad",
         [](Scene& s) { return message_of(s.world.joint(s.pin)->set_limits(true, 1, 0)); }},
        {"set_length", "distance", [](Scene& s) { return message_of(s.world.joint(s.pin)->set_length(1)); }},
        {"set_target", "mouse",
         [](Scene& s) { return message_of(s.world.joint(s.pin)->set_target(Position{})); }},
        {"set_target", "revolute",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->set_target(1.0f)); }},
        {"redefine", "revolute_joint",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->redefine(RevoluteJointDef{})); }},
        {"set_motor", "revolute",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->set_motor(true, 1, 1)); }},
        {"set_limits", "revolute",
         [](Scene& s) { return message_of(s.world.joint(s.rod)->set_limits(true, 0, 1)); }},
    });
}

TEST_CASE("bad steps, gravity and queries are refused") {
    require_refusals({
        {"step.dt_s", "0", [](Scene& s) { return message_of(s.world.step(0)); }},
        {"step.dt_s", "-0.1", [](Scene& s) { return message_of(s.world.step(-0.1f)); }},
        {"step.dt_s", "1.5", [](Scene& s) { return message_of(s.world.step(1.5f)); }},
        {"step.dt_s", "nan", [](Scene& s) { return message_of(s.world.step(kNaN)); }},
        {"step.dt_s", "inf", [](Scene& s) { return message_of(s.world.step(kInfinity)); }},
        {"world.gravity_m_s2", "nan",
         [](Scene& s) {
             return message_of(s.world.set_gravity({kNaN, 0}));
         }},
        {"ray.origin_m", "nan",
         [](Scene& s) {
             return message_of(s.world.cast_ray({kNaND, 0}, {1, 0}));
         }},
        {"ray.translation_m", "inf",
         [](Scene& s) {
             return message_of(s.world.cast_ray({0, 0}, {kInfinity, 0}));
         }},
        {"point_m", "nan",
         [](Scene& s) {
             return message_of(s.world.shape_at({0, kNaND}));
         }},
        {"ray.origin_m", "1e12",
         [](Scene& s) {
             return message_of(s.world.cast_ray({1e300, 0}, {1, 0}));
         }},
        {"ray.translation_m", "1e9",
         [](Scene& s) {
             return message_of(s.world.cast_ray_all({0, 0}, {0, 1e30f}));
         }},
        {"shape_cast.start.p", "nan",
         [](Scene& s) {
             return message_of(s.world.cast_shape(Circle{}, {{kNaND, 0}, {}}, {1, 0}));
         }},
        {"shape_cast.start.q", "2",
         [](Scene& s) {
             return message_of(s.world.cast_shape(Circle{}, {{}, {2, 0}}, {1, 0}));
         }},
        {"shape_cast.start.q", "nan",
         [](Scene& s) {
             return message_of(s.world.cast_shape(Circle{}, {{}, {kNaN, 0}}, {1, 0}));
         }},
        {"shape_cast.translation_m", "inf",
         [](Scene& s) {
             return message_of(s.world.cast_shape_all(Circle{}, {}, {kInfinity, 0}));
         }},
        {"circle.radius_m", "-1",
         [](Scene& s) {
             return message_of(s.world.cast_shape(Circle{{}, -1}, {}, {1, 0}));
         }},
        {"box.half_width_m", "0",
         [](Scene& s) {
             return message_of(s.world.shapes_overlapping(Box{0, 1}, {}));
         }},
        {"pose.p", "inf",
         [](Scene& s) {
             return message_of(s.world.shapes_overlapping(Circle{}, {{kInfinityD, 0}, {}}));
         }},
        {"box.lower_m", "nan",
         [](Scene& s) {
             return message_of(s.world.shapes_in_box({kNaND, 0}, {1, 1}));
         }},
        {"box.lower_m.y", "at most upper_m.y",
         [](Scene& s) {
             return message_of(s.world.shapes_in_box({0, 2}, {1, 1}));
         }},
        {"point_m", "inf",
         [](Scene& s) {
             return message_of(s.world.closest_point({kInfinityD, 0}, 1));
         }},
        {"radius_m", "-1",
         [](Scene& s) {
             return message_of(s.world.closest_points({0, 0}, -1));
         }},
        {"reach_m", "nan", [](Scene& s) { return message_of(s.world.collision_planes(Circle{}, {}, kNaN)); }},
        {"polygon", "", [](Scene& s) { return message_of(s.world.collision_planes(Polygon{}, {}, 1)); }},
    });
}

TEST_CASE("friction joints are refused whose force or torque is not finite") {
    using Def = FrictionJointDef;
    require_refusals({
        bad_def("friction_joint.max_force_n", "inf", Def{.max_force_n = kInfinity}),
        bad_def("friction_joint.max_force_n", "-1", Def{.max_force_n = -1}),
        bad_def("friction_joint.max_torque_nm", "inf", Def{.max_torque_nm = kInfinity}),
        bad_def("friction_joint.max_torque_nm", "nan", Def{.max_torque_nm = kNaN}),
    });
}

TEST_CASE("a motor may have infinite torque, and a spring no greatest length") {
    Scene scene;
    CHECK(scene.world.joint(scene.pin)->set_motor(true, 1, kInfinity));
    step_times(scene.world, 10);
    CHECK(is_finite(scene.world.body(scene.box)->linear_velocity()));
    CHECK(scene.world.create_joint(
        DistanceJointDef{.body_a = scene.box, .body_b = scene.ball, .max_length_m = kInfinity}));
}

TEST_CASE("setters leave bodies alone that forces do not move") {
    World world;
    const BodyId fixed = add(world, {.type = BodyType::Static}, Circle{});
    const BodyId driven = add(world, {.type = BodyType::Kinematic, .position_m = {5, 0}}, Circle{});
    for (const BodyId id : {fixed, driven}) {
        CHECK(world.body(id)->apply_force_to_center({100, 0}));
        CHECK(world.body(id)->apply_impulse_to_center({100, 0}));
        CHECK(world.body(id)->apply_torque(100));
        CHECK(world.body(id)->apply_angular_impulse(100));
    }
    CHECK(world.body(fixed)->set_linear_velocity({1, 0}));
    CHECK(world.body(fixed)->set_angular_velocity(1));
    run_for(world, 1);
    CHECK(world.body(fixed)->position() == Position{0, 0});
    CHECK(world.body(fixed)->linear_velocity() == Vec2{});
    CHECK(world.body(driven)->position() == Position{5, 0});
}

}  // namespace cairn::physics
