// The part of groups that are solved directly in a step.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

struct Acting;
struct StepTime;

/// Stage, when all constraints are described: takes the bodies and contacts of groups over.
void start_direct_solve(Stores& stores, const ContactRules& rules, const StepTime& time, StepScratch& scratch,
                        DirectGroups& groups, TaskPool& tasks);
/// Within a substep; see resolve/direct/direct_component.h.
void solve_direct(DirectGroups& groups, StepScratch& scratch, const ContactRules& rules, float h_s,
                  Acting acting, TaskPool& tasks);
void move_direct(DirectGroups& groups, StepScratch& scratch, const ContactRules& rules, float h_s,
                 Acting acting, TaskPool& tasks);
/// Stage: impulses of joints into the scratch, and what bodies remember.
void store_direct(const DirectGroups& groups, Stores& stores, StepScratch& scratch);

}  // namespace cairn::physics
