// The solver's passes over all constraints of a step.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

// Joints before contacts: what comes last is satisfied best, and overlap is worse to see than a stretched
// joint.

/// The impulses of the last substep, as the first guess. Those of contacts are applied once per step:
/// integrate_velocities carries them on.
inline void warm_start(StepScratch& scratch, bool first_substep) {
    for (const RevoluteConstraint& c : scratch.revolutes) warm_start_revolute(c, scratch.motions);
    for (const DistanceConstraint& c : scratch.distances) warm_start_distance(c, scratch.motions);
    if (!first_substep) return;
    for (const int i : scratch.scalar_contacts) warm_start_contact(scratch.contacts[i], scratch.motions);
    scratch.blocks.warm_start(scratch.motions);
}

inline void solve(StepScratch& scratch, const ContactRules& rules, float h_s, Pass pass) {
    for (RevoluteConstraint& c : scratch.revolutes) solve_revolute(c, scratch.motions, h_s, pass);
    for (DistanceConstraint& c : scratch.distances) solve_distance(c, scratch.motions, h_s, pass);
    for (const int i : scratch.scalar_contacts) {
        solve_contact(scratch.contacts[i], scratch.motions, rules, h_s, pass);
    }
    scratch.blocks.solve(scratch.motions, rules, h_s, pass);
}

}  // namespace cairn::physics
