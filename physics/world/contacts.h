// The life of contacts: made when fat boxes begin to overlap, gone when the boxes part.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: contacts for the pairs that the broad phase reports.
void find_new_pairs(Stores& stores, StepScratch& scratch, TaskPool& tasks);

/// Those that scratch lists as gone end: the list is empty afterwards.
void remove_gone(Stores& stores, Events& events, StepScratch& scratch);

/// Between steps: the two bodies wake if the contact held them; its end is told with the next step.
void destroy_contact(Stores& stores, Events& events, int contact);

}  // namespace cairn::physics
