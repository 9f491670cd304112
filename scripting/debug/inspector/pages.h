// The pages of the inspector. Each shows what it is given and, where `can_change` says so, changes it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cairn/engine/log.h>
#include <cairn/physics/world.h>

#include "bridge/game.h"
#include "debug/lua_values.h"

namespace cairn::scripting {

/// What is looked at.
struct Selection {
    std::size_t world = 0;
    physics::BodyId body{};
    physics::JointId joint{};
};

struct LogLine {
    engine::LogLevel level;
    std::string text;
};

/// Of the selected world: counts, gravity, exactness.
void show_world_page(const Context& context, Selection& selection, bool can_change);
/// A list of bodies, and everything about the selected one.
void show_bodies_page(physics::World& world, Selection& selection, bool can_change);
/// The same for joints.
void show_joints_page(physics::World& world, Selection& selection, bool can_change);
void show_script_page(const std::vector<LuaValue>& values);
void show_assets_page(const Context& context);
void show_log_page(const std::vector<LogLine>& lines);

}  // namespace cairn::scripting
