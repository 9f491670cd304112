// Keeps ALSA's library from writing to standard error.
#pragma once

namespace cairn::engine {

/// Before SDL looks for sound devices. What is wrong with them is told by SDL's error.
void silence_alsa();

}  // namespace cairn::engine
