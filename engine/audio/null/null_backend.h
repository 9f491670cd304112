// Plays nothing: for headless runs. Invariant: opens no device and starts no thread.
#pragma once

#include <memory>

#include "audio/backend.h"

namespace cairn::engine {

std::unique_ptr<AudioBackend> make_null_audio();

}  // namespace cairn::engine
