// Stands for restitution in a build without it: validate(Material) refuses what bounces.
#include "world/bounces.h"
#include "world/impact_groups.h"

namespace cairn::physics {

void apply_restitution(std::span<ContactConstraint>, Motions&, std::span<const Drive>, const ContactRules&) {}
void place_bounces(const BodyRows&, StepScratch&, const StepTime&, const ContactRules&) {}
void pass_impacts_on(Stores&, StepScratch&, const StepTime&, const ContactRules&) {}

}  // namespace cairn::physics
