// Stands for characters that walk in a build without them: none can be made.
#include <cairn/physics/mover.h>

#include "world/features.h"

namespace cairn::physics {

Result<Mover> Mover::create(const MoverDef&, Position) {
    return absence(Feature::Mover);
}
Result<void> Mover::teleport(Position) {
    return absence(Feature::Mover);
}
Result<void> Mover::move(World&, Vec2, float, QueryFilter) {
    return absence(Feature::Mover);
}

}  // namespace cairn::physics
