// Stages before and after the substeps: constraints are packed from the stores, impulses go back to them.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct StepTime {
    float dt_s = 0;
    float h_s = 0;  // of one substep
    int substeps = 0;
    float step_ratio = 1;  // of this step's substep to the last one's
    // The same, at most 1: impulses of which no estimate is known do not grow with the step.
    float impulse_ratio = 1;
};

StepTime make_step_time(float dt_s, int substeps, float previous_h_s);

/// Stage: what acts on each awake body in this step.
void prepare_motions(const BodyStore& bodies, Vec2 gravity_m_s2, StepScratch& scratch);
/// Stage: contacts with points.
void prepare_contacts(const Stores& stores, const StepTime& time, const ContactRules& rules,
                      StepScratch& scratch);
/// Stage: active joints.
void prepare_joints(const Stores& stores, const StepTime& time, StepScratch& scratch);

/// Stage: what the solver found, in the plain form of the contacts that impact or are told about.
void collect_outcomes(StepScratch& scratch);

/// Stage: impulses to start the next step from.
void store_contact_impulses(ContactStore& contacts, const StepScratch& scratch);
/// Stage: the same for joints, and their reactions.
void store_joint_impulses(JointStore& joints, const StepTime& time, const StepScratch& scratch);

}  // namespace cairn::physics
