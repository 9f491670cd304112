// Stands for the direct solver in a build without it: there are no groups, and everything is swept.
#include "world/direct_groups.h"
#include "world/direct_solve.h"
#include "world/prepare.h"

namespace cairn::physics {

void choose_direct_groups(Stores&, JointSolver, DirectGroups&) {}
void start_direct_solve(Stores&, const ContactRules&, const StepTime&, StepScratch&, DirectGroups&,
                        TaskPool&) {}
void solve_direct(DirectGroups&, StepScratch&, const ContactRules&, float, TaskPool&) {}
void move_direct(DirectGroups&, StepScratch&, const ContactRules&, float, TaskPool&) {}
void store_direct(const DirectGroups&, Stores&) {}

}  // namespace cairn::physics
