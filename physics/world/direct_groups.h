// Which joints and contacts are solved together, as one system: structures of joints that sweeping would not
// hold, and contacts of bodies of very different mass, with what touches either.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// A contact whose bodies' masses differ by more than this is uneven: sweeping leaves errors that grow with
/// the ratio.
inline constexpr float kUnevenMasses = 50;

/// Stage: finds structures anew when joints or what they join changed, or substeps so much that springs are
/// stiff that were not, and takes their joints out of the lanes; then what touches structures and uneven
/// contacts. Marks the bodies of all groups in their places.
void choose_direct_groups(Stores& stores, JointSolver solver, float most_swept_hz, DirectGroups& groups);

}  // namespace cairn::physics
