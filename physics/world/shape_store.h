// Shapes: geometry, attributes, and the box that stands for them in the broad phase.
// Invariant: the fat box (Stores::fat_boxes) encloses the shape as of the last step, with kAabbReach_m to
// spare; the broad phase knows it by the number of the shape's slot; shapes of a body form a list in order of
// creation, and its sensors another.
#pragma once

#include <cstddef>

#include <cairn/physics/ids.h>
#include <cairn/physics/shape.h>

#include "base/aabb.h"
#include "base/slot_map.h"
#include "collide/convex.h"

namespace cairn::physics {

/// What boxes of the broad phase are made of stands within the first two cache lines.
struct ShapeRecord {
    int body = kNone;
    int previous_of_body = kNone;
    int next_of_body = kNone;
    int chain = kNone;   // whose segment it is
    int sensor = kNone;  // place among the sensors; they have no box
    float margin_m = 0;  // of the fat box
    Convex convex;
    ShapeDef def;
};

using ShapeStore = SlotMap<ShapeRecord, ShapeId>;

/// Asks for what is needed to collide a shape.
inline void ask_for_geometry(const ShapeStore& shapes, int shape) {
    shapes.ask_for(shape, offsetof(ShapeRecord, def));
}

}  // namespace cairn::physics
