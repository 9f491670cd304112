// 6,076 small bodies inside a closed chain, stirred by a rotor whose motor knows no limit.
#include <array>
#include <limits>
#include <numbers>

#include <cairn/physics/math.h>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Capsule;
using physics::Circle;
using physics::Geometry;
using physics::ShapeDef;
using physics::Vec2;

namespace {

// Clockwise, so that things are held inside. The step is a little more than a 360th of a turn: the last
// points lie past the first, as in the scene that others measure.
std::array<Vec2, 360> ring() {
    const double step_rad = 1.01748 * std::numbers::pi / 180;
    std::array<Vec2, 360> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle_rad = -step_rad * static_cast<double>(i);
        points[i] = {static_cast<float>(40 * physics::deterministic::cos(angle_rad)),
                     static_cast<float>(32 + 40 * physics::deterministic::sin(angle_rad))};
    }
    return points;
}

}  // namespace

Scene spinner() {
    return {
        .name = "spinner",
        .summary = "6,076 circles, capsules and boxes in a round chain, stirred by a rotor",
        .steps = 500,
        .build = [](Engine& engine) -> BeforeStep {
            const BodyRef ground = engine.add_body({.type = BodyType::Static});
            engine.add_closed_chain(ground, ring(), {.friction = 0.1f});
            const BodyRef rotor = engine.add({.position_m = {0, 12}, .allow_sleep = false},
                                             Box{.half_width_m = 0.4f, .half_height_m = 20, .radius_m = 0.2f},
                                             {.material = {.friction = 0}});
            engine.add_revolute(ground, rotor,
                                {.local_anchor_a_m = {0, 12},
                                 .enable_motor = true,
                                 .motor_speed_rad_s = 5,
                                 .max_motor_torque_nm = std::numeric_limits<float>::infinity()});
            const Geometry kinds[] = {Capsule{{-0.25f, 0}, {0.25f, 0}, 0.25f}, Circle{{}, 0.35f},
                                      Box{0.35f, 0.35f}};
            const ShapeDef def{.density_kg_m2 = 0.25f, .material = {.friction = 0.1f, .restitution = 0.1f}};
            constexpr int kPerRow = 92;
            for (int i = 0; i < 6076; ++i) {
                engine.add({.position_m = {-23 + 0.5 * (i % kPerRow), 2 + 0.5 * (i / kPerRow)}}, kinds[i % 3],
                           def);
            }
            return {};
        }};
}

}  // namespace cairn::bench
