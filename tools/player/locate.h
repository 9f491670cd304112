// Finds games by folder, file or name, and the data that Cairn brings along.
#pragma once

#include <string>
#include <vector>

#include <cairn/engine/result.h>
#include <cairn/scripting/play.h>

namespace cairn::player {

/// The folder with games/ and assets/: $CAIRN_DATA, else share/cairn beside the program's bin/, else the
/// source tree.
std::string data_folder(const std::string& program_path);

/// Names of the bundled games, sorted.
std::vector<std::string> bundled_games(const std::string& data_folder);

/// A folder with main.lua, a .lua file, or the name of a bundled game. The error lists the bundled games.
engine::Result<scripting::GameSource> locate_game(const std::string& game, const std::string& program_path);

/// A .lua file. The error says what else was named.
engine::Result<scripting::GameSource> locate_script(const std::string& file, const std::string& program_path);

}  // namespace cairn::player
