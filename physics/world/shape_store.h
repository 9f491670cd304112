// Shapes: what they are made of, and the box that stands for them in the broad phase.
// Invariant: the fat box (Stores::fat_boxes) encloses the shape as of the last step, with kAabbReach_m to
// spare; the broad phase knows it by the number of the shape's slot; shapes of a body form a list in order of
// creation, and its sensors another; each shape counts among those of its prototype.
#pragma once

#include <cstdint>

#include <cairn/physics/ids.h>
#include <cairn/physics/shape.h>

#include "base/aabb.h"
#include "base/slot_map.h"
#include "collide/convex.h"
#include "world/shape_prototypes.h"

namespace cairn::physics {

struct ShapeRecord {
    int body = kNone;
    int previous_of_body = kNone;
    int next_of_body = kNone;
    int chain = kNone;   // whose segment it is
    int sensor = kNone;  // place among the sensors; they have no box
    float margin_m = 0;  // of the fat box
    ShapePrototype* prototype = nullptr;
    std::uint64_t user_data = 0;

    [[nodiscard]] const Convex& convex() const { return prototype->convex; }
    [[nodiscard]] ShapeDef def() const {
        ShapeDef def = prototype->def;
        def.user_data = user_data;
        return def;
    }
};

using ShapeStore = SlotMap<ShapeRecord, ShapeId>;

}  // namespace cairn::physics
