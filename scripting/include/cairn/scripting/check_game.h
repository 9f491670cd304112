// Examines a game without playing it.
#pragma once

#include <cairn/scripting/play.h>

namespace cairn::scripting {

/// Levels, scripts, maps, images, sounds, fonts, atlases and recordings in the game's folder. Prints every
/// fault on a line of its own, with its file and place, then how many files were read. Returns the exit
/// status: 0 when there is no fault.
int check_game(const GameSource& source);

}  // namespace cairn::scripting
