// The constants of the simulation: unit, reason, and what breaks when one changes.
#pragma once

namespace cairn::physics::tuning {

/// m. Overlap or gap too small to see; the resolution of collision. Smaller: contacts flicker; larger:
/// visible gaps.
inline constexpr float kLinearSlop_m = 0.005f;

/// m. Contacts exist from this distance on, so that a body is caught before it overlaps. Smaller: deeper
/// impacts; larger: more contacts than needed, and bodies graze corners that they pass.
inline constexpr float kSpeculativeDistance_m = 4 * kLinearSlop_m;

/// m. Bounds in the tree are this much larger than the shape (less for small shapes), so that slow bodies
/// leave it alone. Between 2 and 10 cm the time of a step hardly changes.
inline constexpr float kAabbMargin_m = 0.05f;

/// m. What bounds in the tree keep free around their shape at least: with half of the speculative distance on
/// both sides, shapes near enough for a contact point have bounds that overlap. Smaller: contacts start and
/// end late.
inline constexpr float kAabbReach_m = 0.5f * kSpeculativeDistance_m;

/// Hz, and ratio. Stiffness of contacts. Higher frequencies approach what `substeps` can resolve and jitter;
/// the high damping makes overlap creep apart without a bounce.
inline constexpr float kContactFrequency_hz = 30;
inline constexpr float kContactDampingRatio = 10;
/// Contacts with static bodies are this much stiffer: the ground must not give way before what stands on it.
inline constexpr float kStaticContactStiffening = 2;
/// Of the substep rate: a softer limit on all frequencies, above which a soft constraint is not resolved.
inline constexpr float kMaxFrequencyShare = 0.25f;

/// Hz, and ratio. Stiffness of joints that are meant to be rigid.
inline constexpr float kJointFrequency_hz = 60;
inline constexpr float kJointDampingRatio = 2;

/// m/s. A body slower than this (its centre, and its farthest point by rotation) for kTimeToSleep_s may
/// sleep.
inline constexpr float kSleepSpeed_m_s = 0.05f;
/// s. Shorter: things stop at the top of a slow arc; longer: settled scenes cost more.
inline constexpr float kTimeToSleep_s = 0.5f;

}  // namespace cairn::physics::tuning
