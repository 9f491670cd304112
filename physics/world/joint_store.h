// Joints: their description as it is now, and the impulses that they remember from step to step.
// Invariant: a joint that has laws (all but filters) is in `active` exactly when one of its bodies is awake;
// every joint is in the lists of both bodies.
#pragma once

#include <cstdint>

#include <cairn/physics/joint.h>

#include "base/slot_map.h"
#include "resolve/joints/joint_constraint.h"
#include "world/active_list.h"
#include "world/edge_list.h"

namespace cairn::physics {

struct JointRecord {
    JointDef def;
    int body_a = kNone;
    int body_b = kNone;
    Edges edges;
    int active_index = kNone;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
    // Of frame b relative to frame a with its whole turns, rad; as it was at the end of the last step in
    // which the joint was active.
    double angle_rad = 0;
    double geared_sum = 0;  // what a gear keeps
    JointImpulses impulse{};
    Vec2 reaction_force;  // of the last step, on body b, N
    float reaction_torque = 0;
};

inline JointKind kind_of(const JointRecord& joint) {
    return static_cast<JointKind>(joint.def.index());
}

struct JointStore {
    explicit JointStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<JointRecord, JointId> slots;
    ActiveList active;
};

}  // namespace cairn::physics
