// Cases 29 and 36: hulls that hardly are, and numbers that are none.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "torture/case.h"

namespace cairn::lab {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

using physics::BodyDef;
using physics::BodyId;
using physics::Box;
using physics::Capsule;
using physics::Circle;
using physics::Polygon;
using physics::Segment;
using physics::ShapeDef;
using physics::ShapeId;
using physics::World;

// Triangles and boxes of 1 : 10^4, and hulls of points that are nearly on a line. Each is dropped by itself.
void slivers(Trial& trial) {
    const std::vector<std::vector<Vec2>> hulls{
        {{-5, 0}, {5, 0}, {0, 0.001f}},
        {{-0.5f, 0}, {0.5f, 0}, {0, 0.0001f}},
        {{-5, -0.0005f}, {5, -0.0005f}, {5, 0.0005f}, {-5, 0.0005f}},
        {{-1, 0}, {-0.5f, 1e-6f}, {0, 2e-6f}, {0.5f, 1e-6f}, {1, 0}},
        {{-1, 0}, {1, 0}, {1, 0.01f}, {0, 0.01f + 1e-7f}, {-1, 0.01f}},
        {{0, 0}, {1, 1}, {2, 2}},
        {{-100, 0}, {100, 0}, {0, 0.01f}},
    };
    int refused = 0;
    double fastest = 0, lowest = 0;
    for (const std::vector<Vec2>& hull : hulls) {
        Rig& rig = trial.rig();
        rig.add_ground();
        const BodyRef body = rig.add_body({.position_m = {0, 0.5}});
        World& world = *rig.engine().cairn_world();
        if (!world.create_shape(BodyId::from_bits(body.bits), Polygon{.points_m = hull})) {
            ++refused;
            continue;
        }
        rig.begin_books();
        rig.allow_work(1e-3);  // the shape went past the books, which know nothing of its mass
        rig.run(10);
        fastest = std::max(fastest, rig.max_speed_m_s());
        lowest = std::min(lowest, rig.motion(body).position_m.y);
    }
    trial.note("refused_with_an_error", refused);
    trial.at_most("fastest_at_end_m_s", fastest, 0.05);
    trial.at_least("lowest_m", lowest, -slop_m(1));
}

// All that takes a number from outside, with x in one place of it. True when it was accepted.
struct Attempt {
    const char* name;
    bool (*with)(World& world, BodyId body, ShapeId shape, float x);
};

template <class Def>
bool joint(World& world, BodyId body, Def def) {
    def.body_a = world.bodies().front();  // the ground
    def.body_b = body;
    return static_cast<bool>(world.create_joint(def));
}

bool made_body(World& world, const BodyDef& def) {
    const auto made = world.create_body(def);
    if (made) world.destroy_body(*made).value();
    return static_cast<bool>(made);
}

bool made_shape(World& world, BodyId body, const physics::Geometry& geometry, const ShapeDef& def = {}) {
    const auto made = world.create_shape(body, geometry, def);
    if (made) world.destroy_shape(*made).value();
    return static_cast<bool>(made);
}

const std::array kAttempts{
    Attempt{"step", [](World& w, BodyId, ShapeId, float x) { return bool(w.step(x)); }},
    Attempt{"gravity", [](World& w, BodyId, ShapeId, float x) { return bool(w.set_gravity({x, -10})); }},
    Attempt{"set_transform.x", [](World& w, BodyId b, ShapeId, float x) {
                return bool(w.body(b)->set_transform({static_cast<double>(x), 0.5}, 0));
            }},
    Attempt{"set_transform.angle", [](World& w, BodyId b, ShapeId, float x) {
                return bool(w.body(b)->set_transform({0, 0.5}, static_cast<double>(x)));
            }},
    Attempt{"set_linear_velocity",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_linear_velocity({0, x})); }},
    Attempt{"set_angular_velocity",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_angular_velocity(x)); }},
    Attempt{"apply_force", [](World& w, BodyId b, ShapeId, float x) {
                return bool(w.body(b)->apply_force({x, 0}, {0, 0}));
            }},
    Attempt{"apply_force.point", [](World& w, BodyId b, ShapeId, float x) {
                return bool(w.body(b)->apply_force({1, 0}, {0, static_cast<double>(x)}));
            }},
    Attempt{"apply_force_to_center",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->apply_force_to_center({0, x})); }},
    Attempt{"apply_torque", [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->apply_torque(x)); }},
    Attempt{"apply_impulse", [](World& w, BodyId b, ShapeId, float x) {
                return bool(w.body(b)->apply_impulse({x, 0}, {0, 0}));
            }},
    Attempt{"apply_impulse_to_center",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->apply_impulse_to_center({x, x})); }},
    Attempt{"apply_angular_impulse",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->apply_angular_impulse(x)); }},
    Attempt{"set_linear_damping",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_linear_damping(x)); }},
    Attempt{"set_angular_damping",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_angular_damping(x)); }},
    Attempt{"set_gravity_scale",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_gravity_scale(x)); }},
    Attempt{"set_sleep_speed",
            [](World& w, BodyId b, ShapeId, float x) { return bool(w.body(b)->set_sleep_speed(x)); }},
    Attempt{"set_material", [](World& w, BodyId, ShapeId s, float x) {
                return bool(w.shape(s)->set_material({.friction = x}));
            }},
    Attempt{"set_material.restitution", [](World& w, BodyId, ShapeId s, float x) {
                return bool(w.shape(s)->set_material({.restitution = x}));
            }},
    Attempt{"set_one_way_normal",
            [](World& w, BodyId, ShapeId s, float x) { return bool(w.shape(s)->set_one_way_normal({x, 1})); }},
    Attempt{"material_rule", [](World& w, BodyId, ShapeId, float x) {
                return bool(w.set_material_rule(1, 2, {.friction = {physics::Mixing::Fixed, x}}));
            }},
    Attempt{"explode.impulse",
            [](World& w, BodyId, ShapeId, float x) { return bool(w.explode({.impulse_ns_m = x})); }},
    Attempt{"explode.center", [](World& w, BodyId, ShapeId, float x) {
                return bool(w.explode({.center_m = {static_cast<double>(x), 0}, .impulse_ns_m = 0}));
            }},
    Attempt{"wind.velocity", [](World& w, BodyId, ShapeId, float x) {
                return bool(w.apply_wind(physics::WindDef{.velocity_m_s = {x, 0}}, kStep_s));
            }},
    Attempt{"body.position", [](World& w, BodyId, ShapeId, float x) {
                return made_body(w, {.position_m = {static_cast<double>(x), 0}});
            }},
    Attempt{"body.angle",
            [](World& w, BodyId, ShapeId, float x) { return made_body(w, {.angle_rad = static_cast<double>(x)}); }},
    Attempt{"body.velocity",
            [](World& w, BodyId, ShapeId, float x) { return made_body(w, {.linear_velocity_m_s = {x, 0}}); }},
    Attempt{"body.spin",
            [](World& w, BodyId, ShapeId, float x) { return made_body(w, {.angular_velocity_rad_s = x}); }},
    Attempt{"body.damping",
            [](World& w, BodyId, ShapeId, float x) { return made_body(w, {.linear_damping_1_s = x}); }},
    Attempt{"body.gravity_scale",
            [](World& w, BodyId, ShapeId, float x) { return made_body(w, {.gravity_scale = x}); }},
    Attempt{"circle.radius", [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Circle{{}, x}); }},
    Attempt{"circle.center",
            [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Circle{{x, 0}, 0.1f}); }},
    Attempt{"capsule.a",
            [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Capsule{{x, 0}, {9, 9}, 1}); }},
    Attempt{"box.width", [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Box{x, 1}); }},
    Attempt{"box.angle",
            [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Box{1, 1, {}, x}); }},
    Attempt{"box.radius",
            [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Box{1, 1, {}, 0, x}); }},
    Attempt{"segment.a",
            [](World& w, BodyId b, ShapeId, float x) { return made_shape(w, b, Segment{{x, 0}, {9, 9}}); }},
    Attempt{"polygon.point", [](World& w, BodyId b, ShapeId, float x) {
                const std::array points{Vec2{0, 0}, Vec2{1, 0}, Vec2{x, 1}};
                return made_shape(w, b, Polygon{.points_m = points});
            }},
    Attempt{"shape.density", [](World& w, BodyId b, ShapeId, float x) {
                return made_shape(w, b, Circle{}, {.density_kg_m2 = x});
            }},
    Attempt{"shape.friction", [](World& w, BodyId b, ShapeId, float x) {
                return made_shape(w, b, Circle{}, {.material = {.friction = x}});
            }},
    Attempt{"distance.length", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::DistanceJointDef{.length_m = x});
            }},
    Attempt{"distance.anchor", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::DistanceJointDef{.local_anchor_a_m = {x, 0}});
            }},
    Attempt{"revolute.limit", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::RevoluteJointDef{.enable_limit = true, .lower_rad = x, .upper_rad = 9});
            }},
    Attempt{"revolute.motor", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::RevoluteJointDef{.enable_motor = true, .motor_speed_rad_s = x});
            }},
    Attempt{"prismatic.angle", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::PrismaticJointDef{.local_angle_a_rad = x});
            }},
    Attempt{"weld.frequency", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::WeldJointDef{.linear_frequency_hz = x});
            }},
    Attempt{"wheel.damping", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::WheelJointDef{.damping_ratio = x});
            }},
    Attempt{"motor.offset", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::MotorJointDef{.target_offset_m = {0, x}});
            }},
    Attempt{"mouse.target", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::MouseJointDef{.local_target_m = {x, 0}});
            }},
    Attempt{"pulley.wheel", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::PulleyJointDef{.wheel_a_m = {static_cast<double>(x), 5}, .wheel_b_m = {1, 5}});
            }},
    Attempt{"friction.force", [](World& w, BodyId b, ShapeId, float x) {
                return joint(w, b, physics::FrictionJointDef{.max_force_n = x});
            }},
};

struct Sandbox {
    BodyId body;
    ShapeId shape;
};

// A small stack that is watched, and far from it, at the origin, a body that suffers the attempts.
Sandbox build(Rig& rig) {
    rig.add_ground();
    for (int i = 0; i < 4; ++i) rig.add({.position_m = {500 + 0.05 * i, i + 0.7}}, Box{0.5f, 0.5f});
    World& world = *rig.engine().cairn_world();
    const BodyId body = world.create_body({.position_m = {0, 0.5}}).value();
    return {body, world.create_shape(body, Box{0.5f, 0.5f}).value()};
}

std::uint64_t hash_after(Rig& rig) {
    rig.run(1);
    return rig.engine().cairn_world()->state_hash();
}

void wrong_numbers(Trial& trial) {
    Rig& untouched = trial.rig();
    build(untouched);
    const std::uint64_t expected = hash_after(untouched);
    int accepted = 0, differed = 0, not_finite = 0;
    for (const Attempt& attempt : kAttempts) {
        for (const float x : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
            Rig& rig = trial.rig();
            const Sandbox box = build(rig);
            if (attempt.with(*rig.engine().cairn_world(), box.body, box.shape, x)) {
                ++accepted;
                std::fprintf(stderr, "cairn-lab: case 36: %s accepts %g\n", attempt.name,
                             static_cast<double>(x));
            } else if (hash_after(rig) != expected) {
                ++differed;
                std::fprintf(stderr, "cairn-lab: case 36: %s changes the world\n", attempt.name);
            }
        }
        for (const float x : {std::numeric_limits<float>::denorm_min(), -0.0f, 1e-40f}) {
            Rig& rig = trial.rig();
            const Sandbox box = build(rig);
            attempt.with(*rig.engine().cairn_world(), box.body, box.shape, x);
            rig.run(1);
            if (!rig.finite() ||
                !physics::is_finite(rig.engine().cairn_world()->body(box.body)->position())) {
                ++not_finite;
            }
        }
    }
    trial.note("places", static_cast<double>(kAttempts.size()));
    trial.at_most("accepted", accepted, 0);
    trial.at_most("changed_the_world", differed, 0);
    trial.at_most("not_finite", not_finite, 0);
}

// Finite numbers whose motion is not: those bodies are put back, all others go on bit for bit.
void quarantine(Trial& trial) {
    const auto stack_places = [&](bool disturbed) {
        Rig& rig = trial.rig();
        rig.add_ground();
        std::vector<BodyRef> boxes;
        for (int i = 0; i < 4; ++i)
            boxes.push_back(rig.add({.position_m = {0.05 * i, i + 0.7}}, Box{0.5f, 0.5f}));
        World& world = *rig.engine().cairn_world();
        const BodyId victim = world.create_body({.position_m = {500, 50}}).value();
        world.create_shape(victim, Circle{}).value();
        if (disturbed) {
            const float huge = std::numeric_limits<float>::max();
            for (int i = 0; i < 4; ++i) world.body(victim)->apply_force_to_center({huge, huge}).value();
        }
        rig.run(1);
        std::vector<Position> places;
        for (const BodyRef box : boxes) places.push_back(rig.motion(box).position_m);
        trial.require(disturbed ? "disturbed_is_finite" : "undisturbed_is_finite",
                      physics::is_finite(world.body(victim)->position()));
        return places;
    };
    const std::vector<Position> calm = stack_places(false);
    trial.require("others_are_bit_identical", calm == stack_places(true));
}

}  // namespace

void add_bad_input(std::vector<Case>& cases) {
    cases.push_back({"29", "slivers of 1 : 10^4, hulls nearly on a line", false, slivers});
    cases.push_back({"36", "NaN, infinity, denormals and -0 through every setter", false, [](Trial& trial) {
                         wrong_numbers(trial);
                         quarantine(trial);
                     }});
}

}  // namespace cairn::lab
