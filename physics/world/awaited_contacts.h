// Contacts of bodies that turn so far in a step that where they are met says nothing about the way there: the
// impulse of a tip that comes round in the third substep must not fall in the first, and what it closes with
// then does not last for a substep. They act once, when they are reached.
// Invariant: both arms end in one place as the bodies stand then, so that the impulse changes neither
// momentum nor angular momentum.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// The contact that was added last in plain form is reached at input.reached_s. `between` leads from the
/// centre of a to that of b.
void await_contact(const ContactInput& input, Vec2 between, const StepTime& time, StepScratch& scratch);

/// Stage of a substep, once forces have acted: those that are reached in it give their impulses.
void reach_contacts(StepScratch& scratch, int substep, const ContactRules& rules, const StepTime& time);

}  // namespace cairn::physics
