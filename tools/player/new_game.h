// `cairn new`: a game to begin with.
#pragma once

#include <string>

#include <cairn/engine/result.h>

namespace cairn::player {

/// Writes conf.lua, main.lua and a test into a new or empty folder.
engine::Result<void> new_game(const std::string& folder);

/// A path as it can be typed into a shell behind a command: in quotes where it needs them.
std::string shell_word(const std::string& path);

}  // namespace cairn::player
