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

struct BundledGame {
    std::string name;    ///< of its folder: what `cairn play` knows it by
    std::string folder;  ///< below games/
};

/// The folders with main.lua in games/ and one level below, sorted by name.
std::vector<BundledGame> bundled_games(const std::string& data_folder);

/// What `cairn` alone plays: it shows the bundled games, and its result names the folder of one.
scripting::GameSource launcher(const std::string& program_path);

/// A folder with main.lua, a .lua file, or the name of a bundled game. The error lists the bundled games.
engine::Result<scripting::GameSource> locate_game(const std::string& game, const std::string& program_path);

/// A .lua file. The error says what else was named.
engine::Result<scripting::GameSource> locate_script(const std::string& file, const std::string& program_path);

}  // namespace cairn::player
