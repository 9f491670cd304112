// What the bindings of one Lua state work on. Invariant: owned by the host, outlives the state, and is the
// only way from Lua to the engine, so that two states never share anything by accident.
#pragma once

#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <cairn/engine/actions.h>
#include <cairn/engine/audio.h>
#include <cairn/engine/files.h>
#include <cairn/engine/input.h>
#include <cairn/engine/platform.h>
#include <cairn/engine/played_saves.h>
#include <cairn/engine/random.h>
#include <cairn/engine/renderer.h>

#include "bind/matter.h"
#include "bind/timers.h"
#include "bind/tweens.h"
#include "bind/typing.h"

namespace cairn::scripting {

struct WorldObject;
class TestDriver;

/// What cairn.result reported.
struct GameResult {
    std::string outcome;
    std::optional<std::string> level;
    std::optional<double> score;
    std::optional<std::int64_t> stars;
};

/// A camera that is attached.
struct AttachedCamera {
    const void* camera;
    engine::TextureId canvas;  ///< that it draws on; null: the picture
    int depth;                 ///< transforms there below its own
};

/// The drawing state of cairn.graphics that the renderer does not keep itself.
struct DrawState {
    engine::Color color;
    float line_width = 1;
    engine::FontId font;
    std::vector<AttachedCamera> cameras;  ///< not yet detached
};

struct Scene {
    int reference;      ///< to its table, in the registry
    std::string place;  ///< where it was put on the stack, "main.lua:12: "
};

struct Services {
    engine::Files& files;
    engine::Renderer& renderer;
    engine::Audio& audio;
    engine::Window& window;
    engine::Platform& platform;
    int updates_per_second = kUpdatesPerSecond;
};

struct Context {
    Services services;
    engine::Random random;         ///< of gameplay: seeded, recorded, hashed
    engine::Random visual_random;  ///< of what decides nothing
    engine::InputState input{};
    std::span<const engine::InputEvent> events{};  ///< of the update that runs
    engine::Actions actions{};
    Typing typing{};
    int listener = LUA_NOREF;  ///< in the registry: what cairn.input.listen was given
    Timers timers{services.updates_per_second};
    Tweens tweens{};
    std::vector<Scene> scenes{};  ///< the top one last

    std::uint64_t frame = 0;  ///< updates so far
    double alpha = 1;         ///< of the picture being drawn
    bool is_drawing = false;
    bool wants_quit = false;
    std::optional<GameResult> result{};
    DrawState draw{};
    /// Of the camera attached last in the present picture: what the debug drawing of F2 goes through.
    std::optional<engine::Affine2> world_view{};
    engine::FontId default_font{};

    /// In order of creation; each is kept alive until the script destroys it, because the state hash covers
    /// all of them and must not depend on when garbage is collected.
    std::vector<WorldObject*> worlds{};

    Materials materials{};  ///< that cairn.physics.define_material has named

    lua_Integer levels_loaded = 0;  ///< numbers them for hot reload

    std::set<std::string> hints_told{};  ///< each once

    /// With a value, the save folder is only played: files written are kept here and the real folder is
    /// neither read nor written by anything, so that a replay does not depend on what the player saved.
    std::optional<engine::PlayedSaves> played_saves{};

    /// In `cairn test`: what the running test does to its game; else null.
    TestDriver* test = nullptr;

    /// What each update is told, and steps its worlds by.
    [[nodiscard]] double step_s() const { return 1.0 / services.updates_per_second; }
    /// Of the game, since its start.
    [[nodiscard]] double time_s() const { return static_cast<double>(frame) / services.updates_per_second; }
    [[nodiscard]] std::uint64_t frames_of(double time_s) const {
        return Timers::frames_of(time_s, services.updates_per_second);
    }
};

}  // namespace cairn::scripting
