// Stands for surfaces that run in a build without them: validate(Material) refuses them, so all stand still.
#include "world/surface_speed.h"

namespace cairn::physics {

bool runs(const Material&) {
    return false;
}
float mixed_surface_speed(const Material&, const Material&) {
    return 0;
}

}  // namespace cairn::physics
