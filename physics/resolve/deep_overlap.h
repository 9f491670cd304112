// Overlap too deep to be pushed apart by velocities. Soft contacts make a push-out velocity and relaxing
// takes it out again, but one sweep takes only a part of it out of bodies that are pushed from several sides:
// a pile that was put into each other would be thrown apart. So what was put in deep is solved as if it only
// just touched, and its bodies are moved apart when the substeps are over. What others pressed together is
// not: moving apart reaches two bodies at a time, velocities all of a pile. Invariant: moving apart changes
// no velocity, and no centre of mass of a pair of bodies. Source: nonlinear Gauss-Seidel on positions, as in
// Catto, "Modeling and Solving Constraints", GDC 2009.
#pragma once

#include <array>
#include <span>

#include <cairn/physics/tuning.h>

#include "base/motion.h"
#include "resolve/contact_block.h"
#include "resolve/contact_constraint.h"

namespace cairn::physics {

/// m. From here on an overlap is deep: what is pushed softly does not leave with a speed that shows.
inline constexpr float kDeepOverlap_m = 10 * tuning::kLinearSlop_m;

/// A contact with a deep point, for the end of the step.
struct DeepOverlap {
    int contact;                      ///< in the plain form
    std::array<float, 2> separation;  ///< of its points at the start of the step, m
};

/// Whether a point is deep, and that not because it is seen first, or was, a step after the surfaces met.
bool overlaps_deeply(const ContactConstraint& c, float dt_s);

/// The points only just touch, as far as the solver is concerned.
void hide_overlap(ContactConstraint& c);
void hide_overlap(ContactBlock& block, int lane);
/// As it was before it was hidden.
void show_overlap(ContactConstraint& c, const DeepOverlap& overlap);

/// Moves the bodies of each contact apart until its overlap is not deep any more, but by no more than most_m.
void push_apart(std::span<const DeepOverlap> overlaps, std::span<const ContactConstraint> contacts,
                float most_m, Motions& motions);

}  // namespace cairn::physics
