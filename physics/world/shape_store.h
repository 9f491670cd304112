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
    std::int32_t group = 0;  // of its filter: each ragdoll has its own, so it is no part of a prototype

    [[nodiscard]] const Convex& convex() const { return prototype->convex; }
    [[nodiscard]] ShapeDef def() const {
        ShapeDef def = prototype->def;
        def.user_data = user_data;
        def.filter.group = group;
        return def;
    }
    /// The prototype that it had before, if any, is not released.
    void take_prototype(ShapePrototypes& prototypes, const Convex& convex, const ShapeDef& def) {
        prototype = prototypes.take(convex, def);
        take_own(def);
    }
    /// What each shape has for itself of its definition.
    void take_own(const ShapeDef& def) {
        user_data = def.user_data;
        group = def.filter.group;
    }
};

using ShapeStore = SlotMap<ShapeRecord, ShapeId>;

}  // namespace cairn::physics
