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

std::vector<BundledGame> bundled_games(const std::string& data_folder) {
    std::vector<BundledGame> games;
    const fs::path root = fs::path(data_folder) / "games";
    const auto look_into = [&](const fs::path& folder, const auto& look_deeper) {
        std::error_code failed;
        for (const auto& entry : fs::directory_iterator(folder, failed)) {
            if (is_game_folder(entry.path())) {
                games.push_back({entry.path().filename().string(),
                                 entry.path().lexically_relative(root).generic_string()});
            } else {
                look_deeper(entry.path());
            }
        }
    };
    look_into(root, [&](const fs::path& folder) { look_into(folder, [](const fs::path&) {}); });
    std::sort(games.begin(), games.end(),
              [](const BundledGame& a, const BundledGame& b) { return a.name < b.name; });
    return games;
}

scripting::GameSource launcher(const std::string& program_path) {
    const fs::path data = data_folder(program_path);
    std::error_code ignored;
    fs::path folder = data / "launcher";
    if (!is_game_folder(folder)) folder = fs::path(CAIRN_SOURCE_DATA) / "tools" / "player" / "launcher";
    scripting::GameSource source{.program_path = program_path, .path = folder.string(), .name = "launcher"};
    for (const char* seen : {"assets", "games"}) {
        if (fs::is_directory(data / seen, ignored)) source.assets.push_back((data / seen).string());
    }
    return source;
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
    std::vector<std::string> names;
    for (const BundledGame& bundled : bundled_games(data.string())) {
        names.push_back(bundled.name);
        if (bundled.name != game && bundled.folder != game) continue;
        source.path = (data / "games" / bundled.folder).string();
        source.name = bundled.name;
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
