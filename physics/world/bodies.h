// Making and changing bodies and their shapes. Callers have checked every number.
#pragma once

#include "collide/convex.h"
#include "world/world_state.h"

namespace cairn::physics {

int create_body(Stores& stores, const BodyDef& def);
void destroy_body(WorldState& world, int body);
int create_shape(Stores& stores, int body, const Convex& convex, const ShapeDef& def);
void destroy_shape(WorldState& world, int shape);

/// A shape in the lists and the broad phase, without its mass; and out of both, when it has no contacts left.
int add_shape(Stores& stores, int body, const Convex& convex, const ShapeDef& def);

/// Tells the broad phase of a shape, but a sensor, whose kin it is: shapes of one body never meet, nor do
/// those of one group below 0. Again when its group, or how many shapes its body has, changed.
void tell_kin(Stores& stores, int shape);
void remove_shape(Stores& stores, int shape);

/// Ends the shape's contacts that its filter no longer allows, and looks for those that it now does.
void refilter_shape(WorldState& world, int shape);

/// What the body does along axes that become locked ends; it wakes.
void set_locks(Stores& stores, int body, AxisLocks locks);

void teleport(Stores& stores, int body, Position origin_m, double angle_rad);

}  // namespace cairn::physics
