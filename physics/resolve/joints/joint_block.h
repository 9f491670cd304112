// Eight revolute or wheel joints side by side, as the SIMD kernels read them.
// Invariant: no body that can be moved stands in two lanes of blocks of one colour; body b can always be
// moved; unused lanes point to the row of the world and have arms and impulses of zero. Arms that end in
// `_now` are scaled as in base/motion.h, and are kept by the relaxing pass for the next biased one.
#pragma once

#include <cstdint>

#include "base/lanes.h"

namespace cairn::physics {

/// The bodies of the joints of a block, as rows of the motions. Every block begins with them.
struct alignas(32) JointRows {
    Lanes<std::int32_t> a;
    Lanes<std::int32_t> b;
};

/// Two points held together. What every pass reads comes first.
struct alignas(32) PinBlock : JointRows {
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

/// A limit that is off is this far away, rad or m: no arithmetic with it is undefined.
inline constexpr float kNoLimit = 1e30f;

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

/// A point that slides along an axis of body a, on a spring and within limits, and a motor that turns b. What
/// is switched off is as in a DriveBlock. Levers are the scaled arms across an axis (that of a reaches to the
/// anchor of b): `u` along the axis, `n` along the axis turned left.
struct alignas(32) WheelBlock : JointRows {
    Lanes<float> axis_x;  // now, in the axes of the world
    Lanes<float> axis_y;
    Lanes<float> lever_an;
    Lanes<float> lever_bn;
    Lanes<float> lever_au;
    Lanes<float> lever_bu;
    Lanes<float> k_a;  // sqrt(1/I)
    Lanes<float> k_b;
    Lanes<float> error;  // m, anchor b minus anchor a, now, along n
    Lanes<float> way;    // m, the same along u
    Lanes<float> bias_rate;
    Lanes<float> mass_scale;
    Lanes<float> impulse_scale;
    Lanes<float> impulse;  // N s, of one substep, as all of them; along n, on b
    Lanes<float> spring_d1;
    Lanes<float> spring_d0;
    Lanes<float> spring_stiffness;
    Lanes<float> spring_target;
    Lanes<float> speed_before;
    Lanes<float> spring_impulse;
    Lanes<float> lower;
    Lanes<float> upper;
    Lanes<float> lower_impulse;
    Lanes<float> upper_impulse;
    Lanes<float> motor_speed;
    Lanes<float> motor_limit;    // N m s
    Lanes<float> motor_impulse;  // N m s
    Lanes<float> crowded;        // 1: the spring is (exact_spring.h)
    // At the start of the step, in the axes of the world.
    Lanes<float> start_axis_x;
    Lanes<float> start_axis_y;
    Lanes<float> arm_ax;  // m, from the centre of mass
    Lanes<float> arm_ay;
    Lanes<float> arm_bx;
    Lanes<float> arm_by;
    Lanes<float> offset_x;  // m, centre of b minus centre of a
    Lanes<float> offset_y;
    Lanes<float> turned;   // rad, of b relative to a, since then: wheels go round more than once in a step
    Lanes<float> total_x;  // N s, over the step, on b
    Lanes<float> total_y;
    Lanes<float> total_angular;  // N m s
    // As in a DriveBlock.
    Lanes<float> own_d1;
    Lanes<float> own_d0;
    Lanes<float> square;
    Lanes<float> damping;
    Lanes<float> frequency;
    Lanes<float> local_axis_x;  // in the axes of body a
    Lanes<float> local_axis_y;
};

inline JointRows& rows_of(JointRows& block) {
    return block;
}
inline JointRows& rows_of(DriveBlock& block) {
    return block.pin;
}
inline const JointRows& rows_of(const JointRows& block) {
    return block;
}
inline const JointRows& rows_of(const DriveBlock& block) {
    return block.pin;
}

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
