// Bodies that break when something presses on them hard enough.
// Invariant: a contact has special::kWatched exactly when one of its bodies is breakable. A world without
// breakable bodies does nothing here.
#pragma once

#include <vector>

#include "world/fracture_plan.h"

namespace cairn::physics {

inline bool is_breakable(const Stores& stores, int body) {
    return stores.bodies.slots[body].breakable != kNone;
}

void make_breakable(Stores& stores, int body, const BreakableDef& def);
/// Does nothing for a body that is not breakable.
void forget_breakable(Stores& stores, int body);
/// The pieces become breakable as what is left of the body's generations allows.
void inherit_breakable(Stores& stores, int body, const FracturePlan& plan, const std::vector<int>& pieces);

/// Stage: which contacts pressed harder than a body withstands.
void find_overloads(const Stores& stores, const StepScratch& scratch, Events& events);

/// Stage, the last: breaks the overloaded bodies that the world is to break by itself, by slot.
void break_overloaded(WorldState& world);

/// Breaks one body that was overloaded at a point in the last step. None when it is too small, or there is no
/// room.
std::vector<int> break_as_told(WorldState& world, int body, Position point);

}  // namespace cairn::physics
