// 100 cars drive over ten roads that are not even.
#include <array>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::Segment;
using physics::ShapeDef;
using physics::Vec2;

namespace {

constexpr int kRoads = 10;
constexpr int kCarsOnRoad = 10;
constexpr double kBetweenRoads_m = 20;

void add_road(Engine& engine, double y_m) {
    const BodyRef road = engine.add_body({.type = BodyType::Static, .position_m = {0, y_m}});
    constexpr std::array kHeights_m{0.0f, 0.2f, 0.1f, 0.3f, 0.0f, -0.2f, 0.1f, -0.1f};
    const auto corner = [&](int i) {
        return Vec2{-20 + 2 * static_cast<float>(i), kHeights_m[static_cast<std::size_t>(i * 3 % 8)]};
    };
    constexpr int kPieces = 200;
    for (int i = 0; i < kPieces; ++i) {
        engine.add_shape(road, Segment{corner(i), corner(i + 1)}, {.material = {.friction = 0.9f}});
    }
}

// Driven by its rear wheel.
void add_car(Engine& engine, double x_m, double y_m) {
    const BodyRef chassis = engine.add({.position_m = {x_m, y_m}}, Box{1.4f, 0.3f}, {});
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 axle{side, -0.4f};
        const BodyRef wheel =
            engine.add({.position_m = {x_m + static_cast<double>(axle.x), y_m + static_cast<double>(axle.y)}},
                       Circle{{}, 0.4f}, {.material = {.friction = 1.2f}});
        engine.add_wheel(chassis, wheel,
                         {.local_anchor_a_m = axle,
                          .local_angle_a_rad = physics::kPi / 2,
                          .frequency_hz = 4,
                          .damping_ratio = 0.7f,
                          .enable_limit = true,
                          .lower_m = -0.2f,
                          .upper_m = 0.2f,
                          .enable_motor = side < 0,
                          .motor_speed_rad_s = -25,
                          .max_motor_torque_nm = 10});
    }
}

}  // namespace

Scene vehicles_100() {
    return {.name = "vehicles_100",
            .summary = "100 cars with suspensions drive over uneven roads",
            .steps = 600,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                for (int road = 0; road < kRoads; ++road) {
                    add_road(engine, kBetweenRoads_m * road);
                    for (int car = 0; car < kCarsOnRoad; ++car) {
                        add_car(engine, 6.0 * car + 0.3 * road, kBetweenRoads_m * road + 1.3);
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
