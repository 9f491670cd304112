// Stands for sensors in a build without them: validate(ShapeDef) refuses them, so there are none.
#include "world/sensors.h"

namespace cairn::physics {

int create_sensor(Stores&, int, const Convex&, const ShapeDef&) {
    return kNone;
}
void destroy_sensor(WorldState&, int) {}
void update_sensors(Stores&, std::span<const int>, Events&) {}

}  // namespace cairn::physics
