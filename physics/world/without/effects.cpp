// Stands for explosions and wind in a build without them: the world refuses both.
#include <cairn/physics/world.h>

#include "world/features.h"

namespace cairn::physics {

Result<void> World::explode(const ExplosionDef&) {
    return absence(Feature::Effects);
}
Result<void> World::apply_wind(const WindDef&, float) {
    return absence(Feature::Effects);
}
Result<void> World::apply_wind(BodyId, const WindDef&, float) {
    return absence(Feature::Effects);
}

}  // namespace cairn::physics
