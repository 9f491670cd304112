// Contacts of long bodies that turn far in a step, as a rod that pivots about a pin and slides along it: the
// normal turns with the rod, and where the pin slides by 6 cm while the rod turns by 0.4 rad, the gap along
// the normal of the start is wrong by 2 cm, as much as rods are thick. So what touches, or soon may, is
// collided anew in each substep.
// Invariant: its arms are of now, not of the start of the step as those of other contacts; what it did in the
// last substep is applied along the normal of this one, and not with the sum that bodies go on with.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Whether the arm of a body is more than three times what is solid about its thinnest shape.
inline bool is_long(const BodyRecord& body) {
    return body.turn_arm_m > 3 * body.inner_radius_m;
}
/// Whether it turns so far in a step, too, that it sweeps: that bends the ways of its points by more than
/// half of what is solid.
inline bool sweeps(const BodyRecord& body, float turn_rad) {
    return is_long(body) && turn_rad * turn_rad * body.turn_arm_m > 0.5f * body.inner_radius_m;
}

/// The contact that was added last in plain form is one, from a substep on.
void add_sweeping(StepScratch& scratch, int first_substep);

/// Stage of a substep, once forces have acted: how the bodies lie now, of all that are.
void collide_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                      float h_s);

/// A pass over all that are. The relaxing one collides them once more, since bodies have moved: an impulse on
/// arms that do not end in one place would change angular momentum.
void solve_sweeping(const Stores& stores, StepScratch& scratch, int substep, const ContactRules& rules,
                    float h_s, Pass pass);

/// Stage after all impulses: arms are those of the start of the step, as of other contacts, for events.
void turn_arms_back(StepScratch& scratch, int substeps);

}  // namespace cairn::physics
