// What a file is follows from its ending, and from whether a level that is in use was read from it.
#include "bridge/hot_reload.h"

#include <filesystem>

#include <cairn/engine/log.h>

#include "bind/level.h"
#include "lua/errors.h"

namespace cairn::scripting {
namespace {

namespace fs = std::filesystem;

bool is_folder(const GameSource& source) {
    std::error_code ignored;
    return fs::is_directory(source.path, ignored);
}
std::string folder_of(const GameSource& source) {
    std::error_code ignored;
    const fs::path path = fs::absolute(source.path, ignored);
    return (is_folder(source) ? path : path.parent_path()).string();
}

/// In small letters, as cameras and other systems do not write it.
std::string ending_of(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    return ending;
}
bool is_image(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}
bool is_sound(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".wav" || ending == ".ogg" || ending == ".mp3" || ending == ".flac";
}
/// The player's saves, which the game writes itself; a game's own folder of this name is hidden behind them.
bool is_save(const std::string& path) {
    return path.starts_with("save/");
}
/// What scripts may be made of, or read: of any name, for levels and data have the endings that a game likes.
/// Not what only the program and tests read, nor what editors leave beside a file in a folder that was
/// listed.
bool can_be_read(const std::string& path) {
    const bool is_leftover = path.ends_with('~') || path.ends_with('#');
    return !is_leftover && !is_save(path) && path != "conf.lua" && path != "check.lua" &&
           !path.starts_with("tests/");
}

}  // namespace

HotReload::HotReload(const GameSource& source, Machine& machine, const std::vector<std::string>& arguments)
    : machine_(machine), arguments_(arguments), watch_(folder_of(source), is_folder(source)) {}

void HotReload::expect_what_is_missing() {
    const auto& asked_for = machine_.files->asked_for();
    if (asked_for.size() == expected_ || watch_.is_full()) return;
    expected_ = asked_for.size();
    for (const std::string& path : asked_for) {
        // Whatever leads out of the folder is none of the game's files.
        if (!is_save(path) && engine::check_virtual_path(path)) watch_.expect(path);
    }
}

bool HotReload::has_changes(double now_s) {
    expect_what_is_missing();
    for (std::string& path : watch_.changes(now_s)) {
        if (path == "conf.lua")
            engine::log(engine::LogLevel::Info, "conf.lua counts when the game is started the next time");
        const bool is_used = can_be_read(path) && machine_.files->was_asked_for(path);
        if (!is_image(path) && !is_sound(path) && !is_used) continue;
        changed_.insert(std::move(path));
        has_news_ = true;
    }
    return has_news_;
}

std::set<std::string> HotReload::take(bool (*belongs)(const std::string& path)) {
    std::set<std::string> taken;
    for (auto path = changed_.begin(); path != changed_.end();) {
        if (belongs(*path)) {
            taken.insert(*path);
            path = changed_.erase(path);
        } else {
            ++path;
        }
    }
    return taken;
}

void HotReload::take_in_assets() {
    // A picture that is damaged is no reason to stop: the old one stays until the next save.
    for (const std::string& path : take(is_image)) {
        if (const auto loaded = machine_.renderer->reload_texture(path); !loaded)
            engine::log(engine::LogLevel::Warning, loaded.error().message);
    }
    for (const std::string& path : take(is_sound)) {
        if (const auto loaded = machine_.audio->reload_sound(path); !loaded)
            engine::log(engine::LogLevel::Warning, loaded.error().message);
    }
}

std::optional<ScriptError> HotReload::check_syntax(Game& game, const std::set<std::string>& files) const {
    for (const std::string& path : files) {
        if (game.state().source(path) == nullptr) continue;  // data, or a script that it no longer requires
        const auto text = machine_.files->read_text(path);
        if (!text) continue;  // gone again
        if (auto error = load_text(game.lua(), *text, path)) return error;
        lua_pop(game.lua(), 1);
    }
    return std::nullopt;
}

HotReload::Outcome HotReload::take_in(Game& game, bool has_failed) {
    has_news_ = false;
    take_in_assets();
    // Levels that the game has loaded stay what they are, whatever their names.
    std::set<std::string> level_files;
    if (auto error = reload_levels(game.lua(), changed_, level_files))
        return {.error = std::move(error), .wants_restart = false, .keeps_the_game = true};
    for (const std::string& path : level_files) changed_.erase(path);
    // Whatever has changed may be what the new scripts failed of.
    if (changed_.empty() && !game.waits_for_scripts()) return {};

    if (auto error = check_syntax(game, changed_))
        return {.error = std::move(error), .wants_restart = false, .keeps_the_game = true};
    changed_.clear();
    if (!game.can_reload()) return {.error = std::nullopt, .wants_restart = true, .keeps_the_game = false};
    Game::Reloaded reloaded = game.reload(machine_.main_path, arguments_);
    if (has_failed && reloaded.is_unchanged) {
        engine::log(engine::LogLevel::Warning,
                    "the game starts anew, because cairn.before_reload failed: " + reloaded.error->message);
        return {.error = std::nullopt, .wants_restart = true, .keeps_the_game = false};
    }
    if (reloaded.is_unchanged) {
        engine::log(
            engine::LogLevel::Warning,
            "nothing of the game can be kept, because cairn.before_reload failed: it starts anew with "
            "the next save");
    }
    return {.error = std::move(reloaded.error), .wants_restart = false, .keeps_the_game = false};
}

}  // namespace cairn::scripting
