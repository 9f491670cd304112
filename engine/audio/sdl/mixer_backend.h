// Plays through SDL2_mixer. Invariant: the device is opened by the first sound or music, and tried only once.
#pragma once

#include <memory>

#include "audio/backend.h"

namespace cairn::engine {

std::unique_ptr<AudioBackend> make_mixer_audio();

}  // namespace cairn::engine
