// Pins about what they are estimated to bear (docs/adr/017-pin-loads.md). Glossary: p impulse of a substep,
// p0 the one estimated, K inverse effective mass, C error.
//
// A pin that is soft about p0 instead of 0,
//     p += -K^-1 mass_scale (J v + bias_rate C) - impulse_scale (p - p0),
// is a pin as it always is whose error counts from impulse_scale/(mass_scale bias_rate) K p0: so that is
// taken off once per step, and the passes need not know of it.
#pragma once

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// Bounds what a wrong estimate can do: of what the pin bore last, along the estimate.
inline constexpr float kMostOfLastLoad = 1.1f;

struct PinLoads {
    float h_s = 0;   // of a substep
    float give = 0;  // s, impulse_scale/(mass_scale bias_rate)
};

/// Of plain pins, before anything has moved. Those in lanes have a kernel (pin_load_kernel.cpp).
void take_off_load(JointConstraint& pin, Vec2 load_n, const PinLoads& loads, const Motions& motions);

}  // namespace cairn::physics
