// Sensors: shapes that collide with nothing and note what overlaps them.
// Invariant: sensors stand in no tree and in no contact, and in a list of their body of their own, so that
// the stages that move and collide shapes never meet them; `inside` is what overlapped at the last look, or
// passed through within the step before it, in the order of the shapes' slots.
#pragma once

#include <span>
#include <vector>

#include <cairn/physics/ids.h>
#include <cairn/physics/shape.h>

#include "base/slot_map.h"
#include "collide/convex.h"

namespace cairn::physics {

struct Events;
struct Stores;
struct WorldState;

struct Sensor {
    int shape = kNone;
    std::vector<ShapeId> inside;
    std::vector<BodyId> bodies;  // of those
};

struct SensorStore {
    std::vector<Sensor> all;
    bool outdated = false;  // shapes came, went or jumped since the last look
    // Of one look; kept for their memory.
    std::vector<int> seen;
    std::vector<int> strayed;  // bodies
    Sensor before;
};

int create_sensor(Stores& stores, int body, const Convex& convex, const ShapeDef& def);

/// Its ends are told with the next step.
void destroy_sensor(WorldState& world, int shape);

/// Stage: what came to overlap each sensor, and what ceased to. Does nothing while all that could have moved
/// sleeps. Of the bodies that were fast in the step all are given.
void update_sensors(Stores& stores, std::span<const int> fast, Events& events);

}  // namespace cairn::physics
