// Bounces that win no energy. Each impact gives back a share of the speed at which its own surfaces closed
// in, which is right for one impact. Where a body has several within a step, as a ball between a wall and
// another ball, or a bar that comes down on both ends, the shares may add up to more than the bodies had
// (docs/adr/019-bounces-win-no-energy.md).
#pragma once

#include <array>

#include "world/prepare.h"

namespace cairn::physics {

/// Stage: impacts give back their speed, each group of bodies that touch at most so much of it that it has no
/// more energy than it came with. Groups are left as they are where anything else could give them energy: a
/// joint, or something that is moved from outside. Impulses of impacts are forgotten.
void give_back_speed(Stores& stores, StepScratch& scratch, const ContactRules& rules);

/// The same for one impact by itself, which the solver has just stopped; with the velocities of a and b
/// before that.
void give_back_speed(ContactConstraint& c, const std::array<VelocityRow, 2>& came_with, StepScratch& scratch,
                     const ContactRules& rules);

/// What the lane of a contact did is no first guess for the next step: the bodies part.
void forget_lane_impulses(ContactStore& contacts, int contact);

}  // namespace cairn::physics
