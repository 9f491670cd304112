// Stands for the direct solver in a build without it: there are no groups, and everything is swept.
#include "world/direct_groups.h"
#include "world/direct_solve.h"
#include "world/pin_loads.h"
#include "world/prepare.h"
#include "world/solve.h"

namespace cairn::physics {

void estimate_pin_loads(Stores&, Vec2, const StepTime&, DirectGroups&) {}
void forget_loads_around(Stores&, int) {}
void choose_direct_groups(Stores&, JointSolver, float, DirectGroups&) {}
void start_direct_solve(Stores&, const ContactRules&, const StepTime&, StepScratch&, DirectGroups&,
                        TaskPool&) {}
void solve_direct(DirectGroups&, StepScratch&, const ContactRules&, float, Acting, TaskPool&) {}
void move_direct(DirectGroups&, StepScratch&, const ContactRules&, float, Acting, TaskPool&) {}
void store_direct(const DirectGroups&, Stores&, StepScratch&) {}

}  // namespace cairn::physics
