// A kinematic drum of 40 quads, with four paddles inside, turns 8,100 small boxes over and over.
#include <array>
#include <numbers>

#include <cairn/physics/math.h>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Polygon;
using physics::Vec2;

namespace {

Vec2 at(double degrees, double radius_m) {
    const double angle_rad = degrees * std::numbers::pi / 180;
    return {static_cast<float>(radius_m * physics::deterministic::cos(angle_rad)),
            static_cast<float>(radius_m * physics::deterministic::sin(angle_rad))};
}

// A piece of a ring, with straight edges.
void add_quad(Engine& engine, BodyRef drum, double from_degrees, double to_degrees, double inner_m,
              double outer_m) {
    const std::array corners{at(from_degrees, inner_m), at(from_degrees, outer_m), at(to_degrees, inner_m),
                             at(to_degrees, outer_m)};
    engine.add_shape(drum, Polygon{.points_m = corners}, {});
}

}  // namespace

Scene washer() {
    return {.name = "washer",
            .summary = "8,100 boxes in a drum with paddles, hits reported",
            .steps = 500,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                const BodyRef drum =
                    engine.add_body({.type = BodyType::Kinematic,
                                     .position_m = {0, 10},
                                     .linear_velocity_m_s = {0.001f, -0.002f},
                                     .angular_velocity_rad_s = 25 * std::numbers::pi_v<float> / 180});
                for (int k = 0; k < 36; ++k) {
                    add_quad(engine, drum, 10.0 * k - 1, 10.0 * k + 11, 16, 18);
                    if (k % 9 == 0) add_quad(engine, drum, 10.0 * k, 10.0 * k + 10, 14, 16);
                }
                for (int row = 0; row < 90; ++row) {
                    for (int column = 0; column < 90; ++column) {
                        engine.add({.position_m = {-9.9 + 0.21 * column, 0.1 + 0.21 * row}}, Box{0.1f, 0.1f},
                                   {.hit_events = true});
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
