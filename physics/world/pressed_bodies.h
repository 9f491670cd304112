// Bodies that others press so deep into what cannot give way that their centres could pass its surface by
// less than what counts as fast. Contacts tell which these are when they are updated; the guard
// (fast_guard.h) follows all their ways, however short.
#pragma once

#include <vector>

#include "world/world_state.h"

namespace cairn::physics {

/// Adds the bodies of a block in a colour that are. Whether there are any.
bool note_pressed(const Stores& stores, int block, std::vector<int>& pressed);

/// The same for a contact in plain form.
void note_pressed(const Stores& stores, const ContactInput& input, std::vector<int>& pressed);

}  // namespace cairn::physics
