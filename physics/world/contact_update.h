// Contacts from step to step: where they touch now, and what became of those that did.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: manifolds of all listed contacts, and from them the constraints of this step, in lanes or in plain
/// form; sleeping bodies that are touched wake, and take part in this step.
void update_contacts(WorldState& world, const StepTime& time, const ContactRules& rules);

}  // namespace cairn::physics
