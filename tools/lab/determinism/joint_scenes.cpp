// Each scene is a row of pairs of boxes, joined and falling onto the ground, so that joints act along with
// contacts. What a pair is made of depends on its number: what is switched on, and whether it hangs from the
// world.
#include "determinism/joint_scenes.h"

#include <functional>
#include <utility>

namespace cairn::lab {
namespace {

using namespace physics;
using bench::BeforeStep;
using bench::Engine;
using bench::Scene;

constexpr int kPairs = 24;
constexpr int kSteps = 120;
constexpr float kHalf_m = 0.25f;  // from the middle of a box to the anchor, which is in between

/// Two bodies to be joined, a to the left of b. Every third pair hangs from the world.
struct Pair {
    World& world;
    BodyId a;
    BodyId b;
    Vec2 anchor_a_m;
    Vec2 anchor_b_m{-kHalf_m, 0};
    Position middle_m;
    int number;

    /// The number as a part of a cycle, to choose what is switched on.
    [[nodiscard]] bool is(int rest, int of) const { return number % of == rest; }

    template <class Def>
    JointId join(Def def) const {
        def.body_a = a;
        def.body_b = b;
        if constexpr (requires { def.local_anchor_a_m; }) def.local_anchor_a_m = anchor_a_m;
        if constexpr (requires { def.local_anchor_b_m; }) def.local_anchor_b_m = anchor_b_m;
        return world.create_joint(def).value();
    }
};

Scene joint_scene(std::string name, std::string summary, std::function<void(const Pair&)> join) {
    const auto build = [join = std::move(join)](Engine& engine) -> BeforeStep {
        World& world = *engine.cairn_world();
        const BodyId ground = world.create_body({.type = BodyType::Static}).value();
        world.create_shape(ground, Box{100, 1, {0, -1}}).value();
        for (int i = 0; i < kPairs; ++i) {
            const Position middle{1.3 * i, 1 + 0.1 * (i % 7)};
            const auto box = [&](float side) {
                const BodyDef def{.position_m = middle + Vec2{side * kHalf_m, 0},
                                  .angle_rad = 0,
                                  .linear_velocity_m_s = {0.5f * side, 0.3f * static_cast<float>(i % 5)}};
                const BodyId body = world.create_body(def).value();
                world
                    .create_shape(body, Box{0.2f, 0.12f},
                                  {.density_kg_m2 = 1 + 0.5f * static_cast<float>(i % 4)})
                    .value();
                return body;
            };
            const BodyId left = box(-1);
            const BodyId right = box(1);
            const bool hangs = i % 3 == 2;
            const Vec2 in_world{static_cast<float>(middle.x), static_cast<float>(middle.y)};
            join({world,
                  hangs ? ground : left,
                  right,
                  hangs ? in_world : Vec2{kHalf_m, 0},
                  {-kHalf_m, 0},
                  middle,
                  i});
        }
        return {};
    };
    return {.name = "joint_" + std::move(name),
            .summary = std::move(summary),
            .world = {.enable_sleep = false},
            .steps = kSteps,
            .build = build};
}

void join_distance(const Pair& pair) {
    DistanceJointDef def{.length_m = 0.3f};
    def.enable_spring = !pair.is(0, 4);
    def.frequency_hz = pair.is(1, 4) ? 0 : 4;
    def.damping_ratio = pair.is(2, 4) ? 0 : 0.3f;
    if (pair.is(1, 4)) def.max_length_m = 0.4f;
    pair.join(def);
}

void join_revolute(const Pair& pair) {
    RevoluteJointDef def;
    def.enable_limit = pair.is(1, 2);
    def.lower_rad = -0.5f;
    def.upper_rad = 0.7f;
    def.enable_motor = pair.is(2, 4) || pair.is(3, 4);
    def.motor_speed_rad_s = 3;
    def.max_motor_torque_nm = 0.5f;
    def.enable_spring = pair.is(5, 8);
    def.frequency_hz = 3;
    def.damping_ratio = pair.is(5, 16) ? 0 : 0.5f;
    pair.join(def);
}

void join_prismatic(const Pair& pair) {
    PrismaticJointDef def{.local_angle_a_rad = 0.4f, .local_angle_b_rad = 0.4f};
    def.enable_limit = pair.is(1, 2);
    def.lower_m = -0.2f;
    def.upper_m = 0.3f;
    def.enable_motor = pair.is(2, 4);
    def.motor_speed_m_s = 1;
    def.max_motor_force_n = 2;
    def.enable_spring = pair.is(3, 4);
    def.frequency_hz = 2;
    pair.join(def);
}

void join_weld(const Pair& pair) {
    WeldJointDef def;
    def.linear_frequency_hz = pair.is(1, 4) || pair.is(2, 4) ? 5 : 0;
    def.angular_frequency_hz = pair.is(2, 4) || pair.is(3, 4) ? 4 : 0;
    pair.join(def);
}

void join_wheel(const Pair& pair) {
    WheelJointDef def{.local_angle_a_rad = kPi / 2};
    def.enable_spring = !pair.is(0, 3);
    def.enable_limit = pair.is(1, 2);
    def.lower_m = -0.1f;
    def.upper_m = 0.1f;
    def.enable_motor = pair.is(2, 4);
    def.motor_speed_rad_s = -6;
    def.max_motor_torque_nm = 1;
    pair.join(def);
}

void join_motor(const Pair& pair) {
    MotorJointDef def{.target_offset_m = {0.1f, 0.2f}, .linear_velocity_m_s = {0.5f, 0}};
    def.linear_frequency_hz = pair.is(0, 2) ? 3 : 0;
    def.angular_frequency_hz = pair.is(0, 3) ? 2 : 0;
    def.angular_velocity_rad_s = 1;
    def.max_force_n = 20;
    def.max_torque_nm = 1;
    pair.join(def);
}

void join_mouse(const Pair& pair) {
    MouseJointDef def{.local_target_m = {static_cast<float>(pair.middle_m.x), 2}, .max_force_n = 30};
    def.body_a = pair.world.bodies().front();
    def.body_b = pair.b;
    def.local_anchor_b_m = pair.anchor_b_m;
    def.damping_ratio = pair.is(0, 2) ? 1 : 0;
    pair.world.create_joint(def).value();
}

void join_gear(const Pair& pair) {
    const BodyId ground = pair.world.bodies().front();
    const auto at = [&](float side) {
        return Vec2{static_cast<float>(pair.middle_m.x) + side * kHalf_m,
                    static_cast<float>(pair.middle_m.y)};
    };
    const BodyId left =
        pair.is(2, 3) ? pair.world.create_body({.position_m = pair.middle_m}).value() : pair.a;
    if (pair.is(2, 3)) pair.world.create_shape(left, Circle{{}, 0.1f}, {.filter = {.mask = 0}}).value();
    const JointId first =
        pair.world
            .create_joint(RevoluteJointDef{.body_a = ground,
                                           .body_b = left,
                                           .local_anchor_a_m = at(pair.is(2, 3) ? 0.0f : -1.0f),
                                           .enable_motor = true,
                                           .motor_speed_rad_s = 2,
                                           .max_motor_torque_nm = 5})
            .value();
    const JointId second = pair.is(0, 2)
                               ? pair.world
                                     .create_joint(RevoluteJointDef{
                                         .body_a = ground, .body_b = pair.b, .local_anchor_a_m = at(1)})
                                     .value()
                               : pair.world
                                     .create_joint(PrismaticJointDef{
                                         .body_a = ground, .body_b = pair.b, .local_anchor_a_m = at(1)})
                                     .value();
    pair.world.create_joint(GearJointDef{.joint_1 = first, .joint_2 = second, .ratio = -1.5f}).value();
}

void join_pulley(const Pair& pair) {
    PulleyJointDef def{.ratio = pair.is(0, 2) ? 1.0f : 2.0f};
    def.wheel_a_m = {pair.middle_m.x - 0.5, 4};
    def.wheel_b_m = {pair.middle_m.x + 0.5, 4};
    pair.join(def);
}

void join_friction(const Pair& pair) {
    pair.join(
        FrictionJointDef{.max_force_n = 0.5f * static_cast<float>(pair.number % 6), .max_torque_nm = 0.1f});
}

void join_filter(const Pair& pair) {
    pair.join(FilterJointDef{});
}

void join_breaking(const Pair& pair) {
    RevoluteJointDef def;
    def.enable_limit = pair.is(0, 2);
    def.strength.break_force_n = 2 + 3 * static_cast<float>(pair.number % 5);
    pair.join(def);
}

}  // namespace

std::vector<Scene> joint_scenes() {
    std::vector<Scene> scenes;
    const auto add = [&](const char* name, const char* summary, void (*join)(const Pair&)) {
        scenes.push_back(joint_scene(name, summary, join));
    };
    add("distance", "rods, ropes and springs", join_distance);
    add("revolute", "pins, with limits, motors and springs", join_revolute);
    add("prismatic", "sliders, with limits, motors and springs", join_prismatic);
    add("weld", "welds, rigid and soft", join_weld);
    add("wheel", "suspensions with motors and limits", join_wheel);
    add("motor", "motor joints that draw and that drive", join_motor);
    add("mouse", "bodies drawn to points", join_mouse);
    add("gear", "gears of pins and sliders", join_gear);
    add("pulley", "ropes over pulleys", join_pulley);
    add("friction", "friction joints", join_friction);
    add("filter", "pairs that do not collide", join_filter);
    add("breaking", "pins that break", join_breaking);
    return scenes;
}

}  // namespace cairn::lab
