// Into which pieces a body would fall: worked out without changing anything.
// Invariant: a plan has no pieces, when the body would stay as it is, or at least two.
#pragma once

#include <vector>

#include <cairn/physics/fracture.h>

#include "base/check.h"
#include "world/fragments.h"

namespace cairn::physics {

using FracturePlan = std::vector<Piece>;

/// The way of a cut, in the frame of a body.
struct CutWay {
    DirectedLine line;  // from where the cut begins
    double length_m = 0;
};

CutWay cut_way(const Transform& xf, Position from, Position to);
/// In the frame of a body, in double.
RingPoint local_point(const Transform& xf, Position point);

/// m. Half the width of the strip that stands for the line where its way through a ring is measured.
inline constexpr double kLineReach_m = 1e-6;

/// For one convex shape: what lies left of the way, then what lies right.
FracturePlan plan_cut(const Stores& stores, int body, const CutWay& way);

/// impact in the frame of the body.
FracturePlan plan_break(const Stores& stores, int body, RingPoint impact, const FractureDef& def);

check::Fault validate(const FractureDef& def);

check::Fault validate(const BreakableDef& def);

/// What keeps the body from being divided at all: lines, which have no area; nothing that could be divided.
check::Fault validate_divisible(const Stores& stores, int body);

}  // namespace cairn::physics
