// Shapes: geometry, attributes, and the box that stands for them in the broad phase.
// Invariant: the fat box encloses the shape as of the last step; shapes of a body form a list in order of
// creation, and its sensors another.
#pragma once

#include <cairn/physics/ids.h>
#include <cairn/physics/shape.h>

#include "base/slot_map.h"
#include "broad/broad_phase.h"
#include "collide/convex.h"

namespace cairn::physics {

struct ShapeRecord {
    int body = kNone;
    int next_of_body = kNone;
    Convex convex;
    ShapeDef def;
    Aabb fat_box;
    float margin_m = 0;
    Layer layer = Layer::Fixed;
    int proxy = kNone;
    int sensor = kNone;  // place among the sensors; they have neither box nor proxy
};

using ShapeStore = SlotMap<ShapeRecord, ShapeId>;

}  // namespace cairn::physics
