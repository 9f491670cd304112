// What a game says about itself in conf.lua: data, never run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/engine/platform.h>
#include <cairn/engine/result.h>

#include "bind/fields.h"

namespace cairn::scripting {

/// Fewer would make input late; more cost more than they show.
inline constexpr int kLeastUpdates = 10;
inline constexpr int kMostUpdates = 240;

struct Conf {
    std::string title;
    std::string identity;          ///< names the save folder
    engine::Size size{1280, 720};  ///< logical; at the start, when the picture follows the window
    engine::WindowScaling scaling = engine::WindowScaling::Fit;
    std::optional<engine::Size> window_size;  ///< of the window itself; absent: as `size`
    bool is_resizable = true;
    bool is_fullscreen = false;
    bool is_high_dpi = true;
    bool has_vsync = true;
    int updates_per_second = 60;     ///< kLeastUpdates to kMostUpdates
    bool has_developer_keys = true;  ///< F1, F2 ... open tools instead of reaching the game
    engine::Color background{0, 0, 0, 1};

    [[nodiscard]] engine::WindowDef window() const;
};

/// What it may say, in the order of the reference.
std::span<const Field* const> conf_fields();

/// Of a game without conf.lua.
Conf default_conf(const std::string& game_name);

/// Everything that is wrong with the text of a conf.lua, each fault one text. `path` is for messages.
std::vector<std::string> faults_of_conf(std::string_view text, const std::string& path);

/// The error is the first fault.
engine::Result<Conf> parse_conf(std::string_view text, const std::string& path, const std::string& game_name);

}  // namespace cairn::scripting
