// Bodies that break, and the contacts that were too much for them in the last step.
// Invariant: a breakable body's record names its place among the breakable ones, and this names it back.
#pragma once

#include <cairn/physics/events.h>
#include <cairn/physics/fracture.h>

#include "base/slot_map.h"

namespace cairn::physics {

struct Breakable {
    int body = kNone;
    BreakableDef def;
};

/// A contact that pressed harder than the body withstands.
struct Overload {
    BodyBreak event;
    float excess_ns = 0;  // beyond the strength, until it has been given back
};

}  // namespace cairn::physics
