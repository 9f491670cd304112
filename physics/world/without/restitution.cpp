// Stands for restitution in a build without it: validate(Material) refuses what bounces.
#include "world/bounce_energy.h"
#include "world/bounces.h"
#include "world/faint_bounces.h"
#include "world/impact_groups.h"

namespace cairn::physics {

void bounce_in_lanes(ContactStore&, StepScratch&, const StepTime&, const ContactRules&, TaskPool&) {}
void place_bounces(const BodyRows&, StepScratch&, const StepTime&, const ContactRules&) {}
void give_back_speed(Stores&, StepScratch&, const ContactRules&) {}
void give_back_speed(ContactConstraint&, const std::array<VelocityRow, 2>&, StepScratch&,
                     const ContactRules&) {}
void pass_impacts_on(Stores&, StepScratch&, const StepTime&, const ContactRules&) {}

}  // namespace cairn::physics
