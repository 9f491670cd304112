// Problems 4, 5, 6 and 18: sliding, sticking, rolling and tipping. Slopes are level grounds under a gravity
// that is tilted, so that no angle of a shape is rounded.
#include <algorithm>
#include <cmath>

#include "accuracy/problem.h"

namespace cairn::lab {
namespace {

using physics::Box;
using physics::Circle;
using physics::ShapeDef;

constexpr double kGravity_m_s2 = 10;

ShapeDef rough(double friction) {
    return {.material = {.friction = static_cast<float>(friction)}};
}

Vec2 gravity_on_slope(double tangent) {
    const double angle = std::atan(tangent);
    return {static_cast<float>(kGravity_m_s2 * std::sin(angle)),
            static_cast<float>(-kGravity_m_s2 * std::cos(angle))};
}

BodyRef add_box(Rig& rig, double friction, double half_width_m, double half_height_m, float speed_m_s = 0) {
    rig.add_ground(0, rough(friction));
    return rig.add({.position_m = {0, half_height_m}, .linear_velocity_m_s = {speed_m_s, 0}},
                   Box{static_cast<float>(half_width_m), static_cast<float>(half_height_m)}, rough(friction));
}

BodyRef add_disc(Rig& rig, double friction) {
    rig.add_ground(0, rough(friction));
    return rig.add({.position_m = {0, 0.5}}, Circle{{}, 0.5f}, rough(friction));
}

// 4: d = v^2 / (2 mu g).
std::vector<double> sliding_errors(const Setting& setting) {
    const auto rig = rig_of(setting);
    const BodyRef box = add_box(*rig, 0.5, 1, 0.25, 4);
    rig->run(2, setting.dt_s);
    return {std::fabs(rig->motion(box).position_m.x / (4 * 4 / (2 * 0.5 * kGravity_m_s2)) - 1)};
}

// 5: it slips if tan(theta) > mu. What moves by 0.1 mm from the first to the second second slips: at 10^-4
// above the angle that is 0.7 mm.
std::vector<double> incline_errors(const Setting& setting) {
    constexpr double kFriction = 0.6;
    const auto moved = [&](double tangent, double from_s, double to_s) {
        const auto rig = rig_of(setting, gravity_on_slope(tangent));
        const BodyRef box = add_box(*rig, kFriction, 1, 0.25);
        rig->run(from_s, setting.dt_s);
        const double before = rig->motion(box).position_m.x;
        rig->run(to_s - from_s, setting.dt_s);
        return rig->motion(box).position_m.x - before;
    };
    const double slips_at = bisect(0.5 * kFriction, 1.5 * kFriction, 1e-6,
                                   [&](double tangent) { return moved(tangent, 1, 2) > 1e-5; });
    return {std::fabs(slips_at / kFriction - 1), std::fabs(moved(0.95 * kFriction, 0, 60)) / 2};
}

// 6: a = 2/3 g sin(theta); slips if tan(theta) > 3 mu.
std::vector<double> rolling_errors(const Setting& setting) {
    constexpr double kTangent = 0.3;
    const Vec2 gravity = gravity_on_slope(kTangent);
    const auto rig = rig_of(setting, gravity);
    const BodyRef disc = add_disc(*rig, 0.6);
    rig->run(2, setting.dt_s);
    const double t = setting.steps(2) * static_cast<double>(setting.dt_s);
    const double exact = 0.5 * (2.0 / 3) * static_cast<double>(gravity.x) * t * t;
    const double distance_error = std::fabs(rig->motion(disc).position_m.x / exact - 1);

    constexpr double kFriction = 0.2;
    const double slips_at = bisect(1.5 * kFriction, 4.5 * kFriction, 1e-6, [&](double tangent) {
        const auto trial = rig_of(setting, gravity_on_slope(tangent));
        const BodyRef rolling = add_disc(*trial, kFriction);
        trial->run(1, setting.dt_s);
        const Motion m = trial->motion(rolling);
        return m.vx_m_s + 0.5 * m.angular_velocity_rad_s > 1e-5 * m.vx_m_s;  // it turns clockwise
    });
    return {distance_error, std::fabs(slips_at / (3 * kFriction) - 1)};
}

// 18: tan(theta) = b / h.
std::vector<double> tipping_errors(const Setting& setting) {
    constexpr double kWidth_m = 0.5, kHeight_m = 1;
    const double tips_at = bisect(0.25, 0.75, 1e-6, [&](double tangent) {
        const auto rig = rig_of(setting, gravity_on_slope(tangent));
        const BodyRef box = add_box(*rig, 2, kWidth_m / 2, kHeight_m / 2);
        rig->run(8, setting.dt_s);
        return std::fabs(rig->motion(box).s) > 0.3;
    });
    return {std::fabs(tips_at / (kWidth_m / kHeight_m) - 1)};
}

}  // namespace

void add_friction(std::vector<Problem>& problems) {
    problems.push_back(
        {.number = 4,
         .name = "sliding_box",
         .metrics = {{"distance", "of the distance"}},
         .errors = sliding_errors,
         .timed_s = 2,
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_box(rig, 0.5, 1, 0.25, 4), nullptr; }});
    problems.push_back(
        {.number = 5,
         .name = "incline",
         .metrics = {{"slip_angle", "of its tangent"}, {"creep_60_s", "of the box's length"}},
         .errors = incline_errors,
         .timed_s = 2,
         .timed_gravity_m_s2 = gravity_on_slope(0.57),
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_box(rig, 0.6, 1, 0.25), nullptr; }});
    problems.push_back({.number = 6,
                        .name = "rolling_disc",
                        .metrics = {{"distance", "of the distance"}, {"slip_angle", "of its tangent"}},
                        .errors = rolling_errors,
                        .timed_s = 2,
                        .timed_gravity_m_s2 = gravity_on_slope(0.3),
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_disc(rig, 0.6), nullptr; }});
    problems.push_back(
        {.number = 18,
         .name = "tipping_box",
         .metrics = {{"angle", "of its tangent"}},
         .errors = tipping_errors,
         .timed_s = 6,
         .timed_gravity_m_s2 = gravity_on_slope(0.49),
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_box(rig, 2, 0.25, 0.5), nullptr; }});
}

}  // namespace cairn::lab
