// Bodies that move so far in a step that they could pass through others. Their way is looked at before the
// step: boxes cover it, and a pair that will meet gets its contact from the place where it meets. The solver
// then stops them there, in the substep in which it happens, against static, kinematic and dynamic bodies
// alike.
#pragma once

#include "continuous/sweep.h"
#include "world/world_state.h"

namespace cairn::physics {

/// Stage: the boxes of fast bodies cover the way of the coming step. The bodies are noted in `fast`.
void cover_fast_ways(Stores& stores, Vec2 gravity_m_s2, float dt_s, std::vector<int>& fast);

/// Stage at the end of the step: a fast body whose centre passed into another shape, because something else
/// turned it aside on its way, is put back to where it met that shape. It keeps its velocity, so that the
/// next step sees them meet.
void hold_fast_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks);

/// An axis, from a to b, along which two shapes are at least this far apart; 0 says nothing.
struct AxisGap {
    Vec2 axis;
    float gap_m = 0;
};

/// The contact of a pair that is apart now but meets within the step, as seen from now; false when it does
/// not.
bool predict_contact(const Stores& stores, const ContactRecord& contact, const AxisGap& seen,
                     Vec2 gravity_m_s2, float dt_s, ContactInput& input);

}  // namespace cairn::physics
