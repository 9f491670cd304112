// Problems 10, 23 and 25: Newton's cradle, billiards, and walls that are passed through.
#include <algorithm>
#include <array>
#include <cmath>

#include "accuracy/problem.h"
#include "reference/billiards.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

constexpr Vec2 kNoGravity{0, 0};
const ShapeDef kElastic{.material = {.friction = 0, .restitution = 1}};
constexpr double kRadius_m = 0.5;
constexpr double kSpeed_m_s = 5;

struct Totals {
    double momentum_x = 0, momentum_y = 0, energy = 0;  // per kg
};

Totals totals(Rig& rig, const std::vector<BodyRef>& balls) {
    Totals sum;
    for (const BodyRef ball : balls) {
        const Motion m = rig.motion(ball);
        sum.momentum_x += m.vx_m_s;
        sum.momentum_y += m.vy_m_s;
        sum.energy += 0.5 * speed(m) * speed(m);
    }
    return sum;
}

// 10: five discs in a row touch; a sixth runs into them, and the last leaves with its speed.
std::vector<BodyRef> add_cradle(Rig& rig) {
    std::vector<BodyRef> balls{
        rig.add({.position_m = {-2, 0}, .linear_velocity_m_s = {static_cast<float>(kSpeed_m_s), 0}},
                Circle{{}, static_cast<float>(kRadius_m)}, kElastic)};
    for (int i = 0; i < 5; ++i) {
        balls.push_back(rig.add({.position_m = {2 * kRadius_m * i, 0}},
                                Circle{{}, static_cast<float>(kRadius_m)}, kElastic));
    }
    return balls;
}

std::vector<double> cradle_errors(const Setting& setting) {
    const auto rig = rig_of(setting, kNoGravity);
    const std::vector<BodyRef> balls = add_cradle(*rig);
    rig->run(1, setting.dt_s);
    double velocity_error = std::fabs(rig->motion(balls.back()).vx_m_s / kSpeed_m_s - 1);
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
        velocity_error = std::max(velocity_error, speed(rig->motion(balls[i])) / kSpeed_m_s);
    }
    const Totals after = totals(*rig, balls);
    return {velocity_error, std::fabs(after.momentum_x / kSpeed_m_s - 1),
            std::fabs(after.energy / (0.5 * kSpeed_m_s * kSpeed_m_s) - 1)};
}

// 23: a ball runs into others that stand apart from each other.
const std::array<reference::Ball, 6> kTable{{
    {-3, 0.1, 5, 0},
    {0, 0, 0, 0},
    {2.2, -0.6, 0, 0},
    {1.9, 1.4, 0, 0},
    {4.4, -1.5, 0, 0},
    {3.6, 2.9, 0, 0},
}};
constexpr int kHits = 5;

std::vector<BodyRef> add_table(Rig& rig) {
    std::vector<BodyRef> balls;
    for (const reference::Ball& ball : kTable) {
        balls.push_back(rig.add(
            {.position_m = {ball.x_m, ball.y_m},
             .linear_velocity_m_s = {static_cast<float>(ball.vx_m_s), static_cast<float>(ball.vy_m_s)}},
            Circle{{}, static_cast<float>(kRadius_m)}, kElastic));
    }
    return balls;
}

std::vector<double> billiards_errors(const Setting& setting) {
    std::vector<reference::Ball> exact(kTable.begin(), kTable.end());
    const double duration_s = reference::play(exact, kRadius_m, kHits);
    const auto rig = rig_of(setting, kNoGravity);
    const std::vector<BodyRef> balls = add_table(*rig);
    const Totals before = totals(*rig, balls);
    const int steps = setting.steps(duration_s);
    for (int i = 0; i < steps; ++i) rig->step(setting.dt_s);
    // The last step ends a little before or after; what is compared is where the balls are then.
    const double rest = duration_s - steps * static_cast<double>(setting.dt_s);
    double position_error = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Position there{exact[i].x_m - exact[i].vx_m_s * rest, exact[i].y_m - exact[i].vy_m_s * rest};
        position_error =
            std::max(position_error, distance(rig->motion(balls[i]).position_m, there) / kRadius_m);
    }
    const Totals after = totals(*rig, balls);
    return {
        position_error,
        std::hypot(after.momentum_x - before.momentum_x, after.momentum_y - before.momentum_y) / kSpeed_m_s,
        std::fabs(after.energy / before.energy - 1)};
}

// 25: small discs at walls of 1 cm, from 1 to 10^4 thicknesses a step, at random phases of the step.
constexpr double kWall_m = 0.01;

BodyRef shoot(Rig& rig, double speed_m_s, double start_m) {
    rig.add({.type = BodyType::Static, .position_m = {kWall_m / 2, 0}},
            Box{static_cast<float>(kWall_m / 2), 10});
    return rig.add({.position_m = {start_m, 0}, .linear_velocity_m_s = {static_cast<float>(speed_m_s), 0}},
                   Circle{{}, static_cast<float>(kWall_m / 2)});
}

std::vector<double> tunnelling_errors(const Setting& setting) {
    const int phases = setting.quick ? 50 : 200;
    int misses = 0, shots = 0;
    for (const double thicknesses : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
        const double way = thicknesses * kWall_m;
        for (int i = 0; i < phases; ++i) {
            const auto rig = rig_of(setting, kNoGravity);
            // Phases by the golden ratio cover the step evenly at any count.
            const double phase = std::fmod(0.5 + 0.6180339887498949 * i, 1.0);
            const BodyRef bullet =
                shoot(*rig, way / static_cast<double>(setting.dt_s), -kWall_m - way * (1 + phase));
            for (int k = 0; k < 6; ++k) rig->step(setting.dt_s);
            if (!(rig->motion(bullet).position_m.x < kWall_m)) ++misses;
            ++shots;
        }
    }
    return {static_cast<double>(misses) / shots};
}

}  // namespace

void add_collisions(std::vector<Problem>& problems) {
    problems.push_back({.number = 10,
                        .name = "cradle",
                        .metrics = {{"velocities", "of the speed"},
                                    {"momentum", "of the momentum"},
                                    {"energy", "of the energy"}},
                        .errors = cradle_errors,
                        .timed_s = 1,
                        .timed_gravity_m_s2 = kNoGravity,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_cradle(rig), nullptr; }});
    problems.push_back({.number = 23,
                        .name = "billiards",
                        .metrics = {{"positions", "of the radius"},
                                    {"momentum", "of the momentum"},
                                    {"energy", "of the energy"}},
                        .errors = billiards_errors,
                        .timed_s = 2,
                        .timed_gravity_m_s2 = kNoGravity,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_table(rig), nullptr; }});
    problems.push_back({.number = 25,
                        .name = "tunnelling",
                        .metrics = {{"misses", "of the shots"}},
                        .errors = tunnelling_errors,
                        .timed_s = 1,
                        .timed_gravity_m_s2 = kNoGravity,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return shoot(rig, 60, -2), nullptr; }});
}

}  // namespace cairn::lab
