// What has passed through another shape all the same, because something turned it aside on its way, or only
// a corner of it was stopped, is put back.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Whether it is looked at: fast, and free to be put back.
bool is_guarded(const Stores& stores, int body);

/// Turning takes the centre of a shape along only where that is not the body's.
bool takes_shapes_round(const BodyRecord& record);

/// As far as it was free to go of what it moved by in the last step, and of what it turned by if it `turns`.
void put_back(Stores& stores, int body, float share, bool turns);

/// Stage at the end of the step: a fast body whose centre passed into another shape is put back to where it
/// met that shape. It keeps its velocity, so that the next step sees them meet.
void hold_fast_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks);

/// Stage: the same for what is pressed, however slow, and what it is pressed into.
void hold_pressed_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks);

}  // namespace cairn::physics
