// The solver's passes over all constraints of a step.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

// Joints before contacts: what comes last is satisfied best, and overlap is worse to see than a stretched
// joint.

inline void warm_start(StepScratch& scratch) {
    for (const RevoluteConstraint& c : scratch.revolutes) warm_start_revolute(c, scratch.motions);
    for (const DistanceConstraint& c : scratch.distances) warm_start_distance(c, scratch.motions);
    warm_start_contacts(scratch.contacts, scratch.motions);
}

inline void solve(StepScratch& scratch, const ContactRules& rules, float h_s, Pass pass) {
    for (RevoluteConstraint& c : scratch.revolutes) solve_revolute(c, scratch.motions, h_s, pass);
    for (DistanceConstraint& c : scratch.distances) solve_distance(c, scratch.motions, h_s, pass);
    solve_contacts(scratch.contacts, scratch.motions, rules, h_s, pass);
}

}  // namespace cairn::physics
