// Stands for joints in a build without them: none can be made, so the stages have nothing to do.
#include "world/joints.h"

#include "resolve/joints/joint_solver.h"
#include "resolve/joints/torn_joints.h"
#include "world/features.h"
#include "world/joint_constraints.h"
#include "world/joint_lists.h"
#include "world/joint_measures.h"
#include "world/joint_rules.h"

namespace cairn::physics {

check::Fault validate(const JointDef&, const Stores&) {
    return absence(Feature::Joints);
}

const char* name_of(JointKind) {
    return "joint";
}
JointBodies bodies_of(const JointDef&, const Stores&) {
    return {};
}
int create_joint(WorldState&, JointDef) {
    return kNone;
}
void redefine_joint(WorldState&, int, JointDef) {}
void rehang_joint(Stores&, int, int, int) {}
void destroy_joint(Stores&, int) {}
void wake_joint_bodies(Stores&, int) {}
bool takes_part(const JointRecord&) {
    return false;
}
bool acts(const BodyStore&, const JointRecord&) {
    return false;
}

void list_joint(Stores&, int) {}
void unlist_joint(Stores&, int) {}
void unseat_joint(Stores&, int) {}
void forget_memory(Stores&, int) {}
JointMemory memory_of(const JointStore&, int) {
    return {};
}
int find_gear_on(const Stores&, int) {
    return kNone;
}
JointErrors measure_joints(const Stores&) {
    return {};
}

// Stages and passes.

void seat_joints(Stores&, const StepTime&, StepScratch&) {}
void move_to_domain(JointStore&, int, int) {}
void order_joints(Stores&, std::uint64_t, StepScratch&) {}
void prepare_joints(Stores&, const StepTime&, StepScratch&, TaskPool&) {}
void store_joint_impulses(JointStore&, const StepTime&, const StepScratch&) {}
void break_joints(Stores&, StepScratch&, Events&) {}

Softness softness_of(const JointStiffness&, float) {
    return {};
}
void note_spring_speeds(std::span<JointConstraint>, std::span<const JointPlace>, const Motions&) {}
void warm_start_joints(std::span<JointConstraint>, std::span<const JointPlace>, Motions&) {}
void sweep_crowded_springs(std::span<JointConstraint>, std::span<const JointPlace>, Motions&, bool) {}
void solve_joints(std::span<JointConstraint>, std::span<JointPlace>, Motions&, float, Pass) {}
void close_tears(std::span<const TornJoint>, Motions&) {}
void JointLanes::arrange() {}
void JointLanes::note_spring_speeds(const Motions&, TaskPool&) {}
void JointLanes::warm_start(Motions&, TaskPool&) {}
void JointLanes::sweep_crowded_springs(Motions&, bool) {}
void JointLanes::solve(Motions&, const JointPassTime&, TaskPool&) {}
void JointLanes::relax(Motions&, const JointPassTime&, TaskPool&) {}

}  // namespace cairn::physics
