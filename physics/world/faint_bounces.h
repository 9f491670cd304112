// Impacts of crowds, which give back little and need no more looking after than that.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: impacts of faint restitution (faint_restitution in contact_store.h) give their speed back in their
/// lanes. They are neither placed within the step, nor passed on from body to body, nor weighed against
/// energy.
void bounce_in_lanes(ContactStore& contacts, StepScratch& scratch, const StepTime& time,
                     const ContactRules& rules, TaskPool& tasks);

}  // namespace cairn::physics
