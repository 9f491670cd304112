// Eight revolute joints side by side, as the SIMD kernels read them.
// Invariant: no body that can be moved stands in two lanes of blocks of one colour; body b can always be
// moved; unused lanes point to the row of the world and have arms and impulses of zero. Arms that end in
// `_now` are scaled as in base/motion.h, and are kept by the relaxing pass for the next biased one.
#pragma once

#include <cstdint>

#include "base/lanes.h"

namespace cairn::physics {

/// Two points held together. What every pass reads comes first.
struct alignas(32) PinBlock {
    Lanes<std::int32_t> a;  // rows
    Lanes<std::int32_t> b;
    Lanes<float> arm_ax_now;
    Lanes<float> arm_ay_now;
    Lanes<float> arm_bx_now;
    Lanes<float> arm_by_now;
    Lanes<float> error_x;  // m, anchor b minus anchor a, now
    Lanes<float> error_y;
    Lanes<float> impulse_x;  // N s, of one substep, on b
    Lanes<float> impulse_y;
    // At the start of the step, in the axes of the world.
    Lanes<float> arm_ax;  // m, from the centre of mass
    Lanes<float> arm_ay;
    Lanes<float> arm_bx;
    Lanes<float> arm_by;
    Lanes<float> offset_x;  // m, centre of b minus centre of a
    Lanes<float> offset_y;
    Lanes<float> total_x;  // N s, over the step
    Lanes<float> total_y;
    Lanes<float> load_x;  // N, on b, if everything stood still; 0: unknown
    Lanes<float> load_y;
};

/// A limit that is off is this far away, rad: no arithmetic with it is undefined.
inline constexpr float kNoLimit_rad = 1e30f;

/// What acts on the angle, and a softness of the joint's own. What is switched off has constants of zero, or
/// limits that are never met.
struct alignas(32) DriveBlock {
    PinBlock pin;
    Lanes<float> k_a;  // sqrt(1/I)
    Lanes<float> k_b;
    Lanes<float> bias_rate;
    Lanes<float> mass_scale;
    Lanes<float> impulse_scale;
    Lanes<float> angle;  // rad, of b relative to a, now; at the start of the step in (-pi, pi]
    Lanes<float> spring_d1;
    Lanes<float> spring_d0;
    Lanes<float> spring_stiffness;
    Lanes<float> spring_target;  // less the whole turns, as the limits
    Lanes<float> speed_before;
    Lanes<float> spring_impulse;  // N m s, of one substep
    Lanes<float> motor_speed;
    Lanes<float> motor_limit;  // N m s
    Lanes<float> motor_impulse;
    Lanes<float> lower;
    Lanes<float> upper;
    Lanes<float> lower_impulse;
    Lanes<float> upper_impulse;
    Lanes<float> start_angle;
    Lanes<float> total_angular;  // N m s, over the step
    Lanes<float> crowded;        // 1: the spring is (exact_spring.h)
    // What springs that share bodies make of theirs is found once per step from these.
    Lanes<float> own_d1;
    Lanes<float> own_d0;
    Lanes<float> square;     // (w h)^2
    Lanes<float> damping;    // 2 z w h
    Lanes<float> frequency;  // w, rad/s
    // As defined, less the angle between the frames.
    Lanes<float> own_target;
    Lanes<float> own_lower;
    Lanes<float> own_upper;
};

/// Where the joints of a block are on their bodies. Read once per step.
struct alignas(32) AnchorBlock {
    Lanes<std::int32_t> joint;
    Lanes<std::int32_t> body_a;  // slots
    Lanes<std::int32_t> body_b;
    Lanes<float> local_ax;  // m, from the centre of mass
    Lanes<float> local_ay;
    Lanes<float> local_bx;
    Lanes<float> local_by;
    // How b stood to a at the start of the last step: cosine and sine, and how often the angle went round.
    Lanes<float> cosine;
    Lanes<float> sine;
    Lanes<float> turns;
    std::uint8_t breakable = 0;  // bits
};

}  // namespace cairn::physics
