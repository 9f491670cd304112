// Contacts remember what they bore in the last step, and begin the next one with it. What was held by
// something that is gone would be thrown after it by all that still presses: a tower of which the ground is
// taken away would burst, and a light body from which a heavy one is lifted jump.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// A contact is about to end, between steps: notes which of its bodies bore much with it.
void note_unheld(Stores& stores, int contact);

/// After contacts have ended: where nothing holds such a body against what its other contacts bore, they
/// forget it; and so on from body to body, as far as the load went.
void forget_unheld(Stores& stores);

}  // namespace cairn::physics
