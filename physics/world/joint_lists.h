// In which lists a joint is: active while one of its bodies is awake; then either in a SIMD lane, or swept as
// a scalar.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime;

/// A joint that has laws becomes active; it gets its lane with the next step.
void list_joint(Stores& stores, int joint);
/// It is active no more, and remembers its impulses.
void unlist_joint(Stores& stores, int joint);
/// After something changed that lanes keep a copy of: the joint is swept until the next step, and remembers.
void unseat_joint(Stores& stores, int joint);

/// Takes it out of its lane, if it has one, and it remembers: it is swept, or solved directly, until the next
/// step.
void leave_lane(Stores& stores, int joint);

/// What it gave goes for nothing, since no number is left of it, nor of its angle where that is none: turns
/// are counted anew.
void forget_memory(Stores& stores, int joint);

/// Stage: lanes for joints that fit into them and have none.
void seat_joints(Stores& stores, const StepTime& time, StepScratch& scratch);

/// Stage: now and then joints in lanes are put in the order of the rows of their bodies, as contacts are
/// (world/contact_order.h), so that threads meet in few of them.
void order_joints(Stores& stores, std::uint64_t step_count, StepScratch& scratch);

/// A joint in a lane goes to one of another domain.
void move_to_domain(JointStore& joints, int joint, int domain);

/// Two points held together as firmly as by default, and nothing else.
bool is_plain_pin(const RevoluteJointDef& def);

/// What the joint remembers, wherever it is.
JointMemory memory_of(const JointStore& joints, int joint);

/// Calls visit(body) for the bodies of a joint; those of a gear are the bodies of its joints.
template <class Visit>
void for_each_body(const Stores& stores, int joint, Visit&& visit) {
    const JointRecord& record = stores.joints.slots[joint];
    visit(record.body_a);
    visit(record.body_b);
    if (const auto* gear = std::get_if<GearJointDef>(&record.def)) {
        for (const JointId id : {gear->joint_1, gear->joint_2}) {
            const JointRecord& geared = stores.joints.slots[stores.joints.slots.find(id)];
            visit(geared.body_a);
            visit(geared.body_b);
        }
    }
}

/// A gear on the joint, or kNone. It is on one of the bodies of the joint.
int find_gear_on(const Stores& stores, int joint);

}  // namespace cairn::physics
