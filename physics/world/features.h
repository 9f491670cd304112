// The words when something is asked for that the build has left out.
#pragma once

#include <cairn/physics/features.h>

#include "base/check.h"

namespace cairn::physics {

/// "sensors were left out of this build, which was made with CAIRN_WITH_SENSORS=OFF".
Error absence(Feature feature);

/// An error when the feature is used and not there.
check::Fault require_built_in(Feature feature, bool used);

}  // namespace cairn::physics
