// The platform without a machine. Invariant: its behaviour depends on the calls only, so a headless run
// repeats exactly.
#pragma once

#include <cairn/engine/platform.h>

namespace cairn::engine {

std::unique_ptr<Platform> make_headless_platform(const PlatformDef& def);

}  // namespace cairn::engine
