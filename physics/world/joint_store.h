// Joints: their description as it is now, and the impulses that they remember from step to step.
// Invariant: a joint that has laws (all but filters) is in `active` exactly when one of its bodies is awake;
// every joint is in the lists of both bodies. An
// active joint is either in a lane (`seat`) or in `swept`; what it remembers is in the record unless it has a
// lane (joint_lists.h, memory_of).
#pragma once

#include <cstdint>

#include <cairn/physics/joint.h>

#include "base/slot_map.h"
#include "resolve/joints/joint_constraint.h"
#include "resolve/joints/joint_lanes.h"
#include "world/active_list.h"
#include "world/edge_list.h"

namespace cairn::physics {

struct JointRecord {
    JointDef def;
    int body_a = kNone;
    int body_b = kNone;
    Edges edges;
    int active_index = kNone;
    int swept_index = kNone;
    JointSeat seat;
    bool direct = false;  // solved with its whole structure at once (world/direct_groups.h), and not swept
    bool collide_connected = false;
    bool stepped = false;   // it was active in a step
    float softened_hz = 0;  // what its springs stiffen from (stiff_springs.h); 0: as stiff as asked for
    // Of a distance joint: its line when its spring was set, in the coordinates of each body.
    Vec2 line_a{1, 0};
    Vec2 line_b{1, 0};
    std::uint64_t user_data = 0;
    // Of frame b relative to frame a with its whole turns, rad; as it was at the end of the last step in
    // which the joint was active.
    double angle_rad = 0;
    double geared_sum = 0;  // what a gear keeps
    JointImpulses impulse{};
    Vec2 load_n;              // of a plain pin without a lane: what it would bear if everything stood still
    bool load_known = false;  // estimated, and nothing changed about the joint since (world/pin_loads.h)
    Vec2 reaction_force;      // of the last step, on body b, N
    float reaction_torque = 0;
};

inline JointKind kind_of(const JointRecord& joint) {
    return static_cast<JointKind>(joint.def.index());
}

struct JointStore {
    explicit JointStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<JointRecord, JointId> slots;
    ActiveList<&JointRecord::active_index> active;
    ActiveList<&JointRecord::swept_index> swept;  // of those, the ones without lanes
    JointLanes lanes;
    std::vector<std::uint32_t> colors;  // by body, bits: colours of lanes in which it stands
    std::uint64_t version = 0;          // of what is active, how it is defined and what it joins
};

}  // namespace cairn::physics
