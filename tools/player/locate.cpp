// A path wins over a bundled game of the same name, as a file in the present folder is what a person sees.
#include "locate.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <cairn/scripting/suggest.h>

namespace cairn::player {
namespace {

namespace fs = std::filesystem;

bool is_game_folder(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / "main.lua", ignored);
}

/// Where bundled games are, and the smaller ones among them.
constexpr const char* kGameFolders[] = {"games", "games/examples"};

fs::path own_folder(const std::string& program_path) {
    std::error_code failed;
    // argv[0] has no path when the shell found the program; Linux knows.
    const fs::path running = fs::read_symlink("/proc/self/exe", failed);
    return (failed ? fs::absolute(program_path, failed) : running).parent_path();
}

}  // namespace

std::string data_folder(const std::string& program_path) {
    std::error_code ignored;
    if (const char* given = std::getenv("CAIRN_DATA"); given != nullptr && *given != '\0') return given;
    const fs::path installed = own_folder(program_path).parent_path() / "share" / "cairn";
    if (fs::is_directory(installed / "games", ignored)) return installed.string();
    return CAIRN_SOURCE_DATA;
}

std::vector<std::string> bundled_games(const std::string& data_folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (const char* folder : kGameFolders) {
        for (const auto& entry : fs::directory_iterator(fs::path(data_folder) / folder, failed)) {
            if (is_game_folder(entry.path())) names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

engine::Result<scripting::GameSource> locate_game(const std::string& game, const std::string& program_path) {
    std::error_code ignored;
    const fs::path data = data_folder(program_path);
    scripting::GameSource source;
    source.program_path = program_path;
    if (fs::is_directory(data / "assets", ignored)) source.assets.push_back((data / "assets").string());

    const fs::path path = game;
    if (fs::is_regular_file(path, ignored) && path.extension() == ".lua") {
        source.path = path.string();
        source.name = path.stem().string();
        return source;
    }
    if (path.extension() == ".lua" && !fs::exists(path, ignored))
        return engine::Error{"the file \"" + game + "\" does not exist"};
    if (is_game_folder(path)) {
        source.path = path.string();
        source.name = fs::canonical(path, ignored).filename().string();
        return source;
    }
    if (fs::is_directory(path, ignored)) {
        return engine::Error{"the folder \"" + game + "\" is no game: it holds no main.lua"};
    }
    const std::vector<std::string> names = bundled_games(data.string());
    if (std::find(names.begin(), names.end(), game) != names.end()) {
        for (const char* folder : kGameFolders) {
            if (is_game_folder(data / folder / game)) source.path = (data / folder / game).string();
        }
        source.name = game;
        return source;
    }
    std::string message = "no game \"" + game +
                          "\": it is neither a folder with main.lua, nor a .lua file, nor a bundled game" +
                          scripting::suggestion(game, names);
    if (names.empty())
        message += " (no bundled games in \"" + data.string() + "\"; CAIRN_DATA can name another folder)";
    return engine::Error{message};
}

engine::Result<scripting::GameSource> locate_script(const std::string& file,
                                                    const std::string& program_path) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored))
        return engine::Error{"\"" + file + "\" is a folder: cairn run takes a .lua file, cairn play a game"};
    if (!fs::exists(file, ignored)) return engine::Error{"the file \"" + file + "\" does not exist"};
    if (fs::path(file).extension() != ".lua")
        return engine::Error{"\"" + file + "\" is no script: the file's name must end in .lua"};
    return locate_game(file, program_path);
}

}  // namespace cairn::player
