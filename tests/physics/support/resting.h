// How long it takes until all is asleep.
#pragma once

#include "physics/support/making.h"

namespace cairn::physics::test {

/// Steps until no body is awake, at most for that long; whether it came to that.
inline bool sleeps_within(World& world, double time_s) {
    const int steps = static_cast<int>(std::lround(time_s / static_cast<double>(kStep_s)));
    for (int i = 0; i < steps && world.awake_body_count() > 0; ++i) world.step(kStep_s).value();
    return world.awake_body_count() == 0;
}

}  // namespace cairn::physics::test
