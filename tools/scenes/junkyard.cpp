// 8,000 pentagons rain into a wide trough, in which a heavy pusher sweeps to and fro.
#include <array>
#include <numbers>

#include <cairn/physics/math.h>

#include "scene.h"
#include "trough.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Polygon;
using physics::Vec2;

namespace {

std::array<Vec2, 5> pentagon(double radius_m) {
    // Turning by the golden angle each time spreads any number of points evenly over a circle.
    const double turn_rad = std::numbers::pi * (std::sqrt(5.0) - 1);
    std::array<Vec2, 5> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle_rad = turn_rad * static_cast<double>(i);
        points[i] = {static_cast<float>(radius_m * physics::deterministic::cos(angle_rad)),
                     static_cast<float>(radius_m * physics::deterministic::sin(angle_rad))};
    }
    return points;
}

}  // namespace

Scene junkyard() {
    return {.name = "junkyard",
            .summary = "8,000 pentagons in a trough, swept by a kinematic pusher",
            .steps = 800,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                add_trough(engine, 80, 50);
                const std::array corners = pentagon(0.25);
                double shift = -0.1;
                for (int column = 0; column < 200; ++column) {
                    for (int row = 0; row < 40; ++row) {
                        engine.add({.position_m = {0.75 * column - 75 + shift, 15.0 + row}},
                                   Polygon{.points_m = corners});
                        shift = -shift;
                    }
                }
                const BodyRef pusher = engine.add({.type = BodyType::Kinematic}, Box{2, 4, {0, 4}});
                return [pusher](Engine& run, int step, Findings&) {
                    const auto dt_s = static_cast<double>(kStep_s);
                    const double target_m = 60 * physics::deterministic::sin(0.2 * dt_s * step);
                    const physics::Position now = run.position(pusher);
                    run.set_linear_velocity(pusher, {static_cast<float>((target_m - now.x) / dt_s),
                                                     static_cast<float>(-now.y / dt_s)});
                };
            }};
}

}  // namespace cairn::bench
