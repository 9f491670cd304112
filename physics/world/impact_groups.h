// Impacts among bodies that touch each other, as in Newton's cradle and at the break of billiards.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage, after the substeps and before other impacts give back their speed: where a body is hit that touches
/// others, and all of them give back more than a little and feel nothing but each other, forces and what
/// cannot be moved, the impacts go from one to the next (resolve/impacts.h). Velocities start again from free
/// flight then.
void pass_impacts_on(Stores& stores, StepScratch& scratch, const StepTime& time, const ContactRules& rules);

}  // namespace cairn::physics
