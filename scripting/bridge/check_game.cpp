// `cairn check`: each file is read the way the game would read it, by its ending. Nothing of the game runs
// but check.lua, with which games examine data that has a format of their own.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

#include <cairn/engine/atlas.h>
#include <cairn/engine/audio.h>
#include <cairn/engine/printable.h>
#include <cairn/engine/tile_map.h>
#include <cairn/scripting/check_game.h>

#include "bind/level.h"
#include "bridge/conf.h"
#include "bridge/game.h"
#include "bridge/machine.h"
#include "bridge/replay.h"

namespace cairn::scripting {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOwnCheck = "check.lua";

/// What stands below `levels/` and is no level: notes, and files that Tiled keeps beside its maps.
bool is_beside_levels(std::string_view ending) {
    constexpr std::string_view kEndings[] = {".md", ".txt",   ".tsx",           ".tsj",          ".tx",
                                             ".tj", ".world", ".tiled-project", ".tiled-session"};
    return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

class Inspector {
  public:
    Inspector(Machine& machine) : machine_(machine), game_(machine.services(), {.plays_saves = true}) {}

    void inspect(const std::string& path) {
        std::string ending = fs::path(path).extension().string();
        for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
        const bool is_level = path.starts_with("levels/") && !machine_.files->exists(kOwnCheck);
        if (ending == ".lua") {
            if (path == "conf.lua") return inspect_conf(path);
            if (is_level) return inspect_level(path);
            inspect_script(path);
        } else if (ending == ".tmx" || ending == ".tmj") {
            inspect_map(path, is_level);
        } else if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") {
            inspect_asset(path, machine_.renderer->load_texture(path));
        } else if (ending == ".wav" || ending == ".ogg" || ending == ".mp3" || ending == ".flac") {
            inspect_asset(path, engine::check_sound(*machine_.files, path));
        } else if (ending == ".ttf" || ending == ".otf") {
            inspect_asset(path, machine_.renderer->load_font(path, 16));
        } else if (ending == ".replay") {
            inspect_replay(path);
        } else if (ending == ".json" && is_atlas(path)) {
            inspect_atlas(path);
        } else if (ending == ".json" && is_level) {
            inspect_map(path, is_level);
        } else if (is_level && !is_beside_levels(ending)) {
            inspect_level(path);
        }
    }

    /// What the game says about its own data.
    void run_own_check() {
        if (!machine_.files->exists(kOwnCheck)) return;
        lua_State* L = game_.lua();
        const auto text = machine_.files->read_text(kOwnCheck);
        if (!text) return note(kOwnCheck, text.error().message);
        auto error = load_text(L, *text, kOwnCheck);
        if (error) return;  // told with the other scripts
        error = protected_call(L, 0, 1);
        if (error) return note(kOwnCheck, error->message);
        const auto count = lua_istable(L, -1) ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
        if (!lua_istable(L, -1)) note(kOwnCheck, "must return a list of faults, empty when there are none");
        for (lua_Integer i = 1; i <= count; ++i) {
            lua_rawgeti(L, -1, i);
            const char* fault = lua_tostring(L, -1);
            note(kOwnCheck, fault == nullptr ? "returned a list with something that is no text" : fault);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }

    /// Prints how it went; the exit status.
    int finish() const {
        const auto plural = [](int count, const char* word) {
            return std::to_string(count) + ' ' + word + (count == 1 ? "" : "s");
        };
        std::printf("%s, %s\n", plural(files_, "file").c_str(), plural(faults_, "fault").c_str());
        return faults_ == 0 ? 0 : 1;
    }

  private:
    /// A file that was read, and its fault, if any.
    void note(const std::string& path, const std::string& fault) {
        ++files_;
        if (!fault.empty()) tell(path, fault);
    }
    void tell(const std::string& path, const std::string& fault) {
        ++faults_;
        // Most messages name the file already.
        const bool names_file = fault.find(path) != std::string::npos || place_of(fault).has_value();
        std::printf("%s%s\n", names_file ? "" : (engine::printable(path) + ": ").c_str(),
                    engine::printable(fault).c_str());
    }

    template <class T>
    void inspect_asset(const std::string& path, const engine::Result<T>& loaded) {
        note(path, loaded ? "" : loaded.error().message);
    }

    void inspect_conf(const std::string& path) {
        const auto text = machine_.files->read_text(path);
        if (!text) return note(path, text.error().message);
        ++files_;
        for (const std::string& fault : faults_of_conf(*text, path)) tell(path, fault);
    }

    bool is_atlas(const std::string& path) const {
        const auto text = machine_.files->read_text(path);
        return text && engine::is_atlas_text(*text);
    }

    void inspect_atlas(const std::string& path) {
        const auto atlas = engine::load_atlas(*machine_.files, path);
        if (!atlas) return note(path, atlas.error().message);
        const auto texture = machine_.renderer->load_texture(atlas->image_path);
        if (!texture)
            return note(path, "atlas '" + path + "': meta.image is \"" + atlas->image_path + "\", but " +
                                  texture.error().message);
        const auto fits = engine::check_atlas(*atlas, machine_.renderer->texture_size(*texture), path);
        note(path, fits ? "" : fits.error().message);
    }

    /// A map, which may be a level, and the pictures of its tiles.
    void inspect_map(const std::string& path, bool is_level) {
        const engine::TileMapReading reading = engine::read_tile_map(*machine_.files, path);
        if (is_level) {
            inspect_level(path);
        } else {
            ++files_;
            for (const std::string& fault : reading.faults) tell(path, fault);
        }
        for (const engine::MapLayer& layer : reading.map.layers) {
            if (layer.image_path.empty()) continue;
            if (const auto texture = machine_.renderer->load_texture(layer.image_path); !texture)
                tell(path,
                     layer.place + ": image is \"" + layer.image_path + "\", but " + texture.error().message);
        }
        for (const engine::TileSet& set : reading.map.sets) {
            if (set.image_path.empty()) continue;  // a fault, told above
            const auto texture = machine_.renderer->load_texture(set.image_path);
            if (!texture) {
                tell(path,
                     set.place + ": image is \"" + set.image_path + "\", but " + texture.error().message);
            } else if (reading.faults.empty()) {
                const auto fits = set.check_image(machine_.renderer->texture_size(*texture));
                if (!fits) tell(path, fits.error().message);
            }
        }
    }

    void inspect_level(const std::string& path) {
        ++files_;
        for (const std::string& fault : faults_of_level(game_.lua(), path)) tell(path, fault);
    }

    void inspect_script(const std::string& path) {
        const auto text = machine_.files->read_text(path);
        if (!text) return note(path, text.error().message);
        lua_State* L = game_.lua();
        const auto error = load_text(L, *text, path);
        if (!error) lua_pop(L, 1);
        note(path, error ? error->message : "");
    }

    void inspect_replay(const std::string& path) {
        const auto text = machine_.files->read_text(path);
        if (!text) return note(path, text.error().message);
        inspect_asset(path, parse_replay(*text, path));
    }

    Machine& machine_;
    Game game_;
    int files_ = 0;
    int faults_ = 0;
};

/// The game's own files, sorted; those of the shared assets are not its business. What cannot be listed is
/// told.
std::vector<std::string> files_below(const fs::path& root, std::string& problem) {
    std::vector<std::string> paths;
    std::error_code failed;
    for (fs::recursive_directory_iterator entry(root, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) {
            if (entry->is_directory(failed)) entry.disable_recursion_pending();
            continue;
        }
        if (entry->is_regular_file(failed))
            paths.push_back(entry->path().lexically_relative(root).generic_string());
    }
    if (failed) problem = "cannot list the files of \"" + root.string() + "\": " + failed.message();
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace

int check_game(const GameSource& source) {
    // Drawing into memory decodes images whole; a plain headless run would read their headers only.
    auto machine = make_machine(source, MachineKind::HeadlessDrawing, ConfSlips::Passed);
    if (!machine) {
        std::printf("%s\n1 fault\n", engine::printable(machine.error().message).c_str());
        return 1;
    }
    std::string problem;
    std::vector<std::string> paths;
    std::error_code ignored;
    if (fs::is_directory(source.path, ignored)) {
        paths = files_below(source.path, problem);
    } else {
        paths.push_back((*machine)->main_path);
    }
    if (!problem.empty()) {
        std::fprintf(stderr, "cairn: error: %s\n", engine::printable(problem).c_str());
        return 1;
    }
    Inspector inspector(**machine);
    for (const std::string& path : paths) inspector.inspect(path);
    inspector.run_own_check();
    return inspector.finish();
}

}  // namespace cairn::scripting
