// Joints: their description as it is now, and the impulses that they remember from step to step.
// Invariant: a joint is in `active` exactly when one of its bodies is awake; it is in the lists of both
// bodies.
#pragma once

#include <cstdint>
#include <variant>

#include <cairn/physics/joint.h>

#include "base/slot_map.h"
#include "world/active_list.h"
#include "world/edge_list.h"

namespace cairn::physics {

struct JointRecord {
    std::variant<RevoluteJointDef, DistanceJointDef> def;
    int body_a = kNone;
    int body_b = kNone;
    Edges edges;
    int active_index = kNone;
    bool collide_connected = false;
    std::uint64_t user_data = 0;
    // Impulses of one substep, N s and N m s. A distance joint keeps that along its axis in x.
    Vec2 impulse;
    float motor_impulse = 0;
    float lower_impulse = 0;
    float upper_impulse = 0;
    Vec2 reaction_force;  // of the last step, on body b, N
    float reaction_torque = 0;
};

struct JointStore {
    explicit JointStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<JointRecord, JointId> slots;
    ActiveList active;
};

}  // namespace cairn::physics
