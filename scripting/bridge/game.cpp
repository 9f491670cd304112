// Calls the callbacks of a game.
#include "bridge/game.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "bind/callbacks.h"
#include "bind/fields.h"
#include "bind/module.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {
namespace {

using engine::InputEvent;
using engine::InputKind;

void push(lua_State* L, double value) {
    lua_pushnumber(L, value);
}
void push(lua_State* L, int value) {
    lua_pushinteger(L, value);
}
void push(lua_State* L, bool value) {
    lua_pushboolean(L, value ? 1 : 0);
}
void push(lua_State* L, std::string_view value) {
    lua_pushlstring(L, value.data(), value.size());
}
// Floats become doubles here, so that 0.1f is not taken for a boolean or ambiguous.
void push(lua_State* L, float value) {
    lua_pushnumber(L, static_cast<double>(value));
}
void push(lua_State* L, const std::vector<std::string>& list) {
    lua_createtable(L, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        push(L, std::string_view(list[i]));
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
}

/// Mixes a value into a hash so that order matters. Source: the finaliser of SplitMix64, Steele, Lea and
/// Flood 2014.
std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    std::uint64_t z = (hash ^ value) + 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

}  // namespace

Game::Game(const Services& services, const GameOptions& options)
    : context_{.services = services,
               .random = engine::Random(options.seed),
               .visual_random = engine::Random(options.visual_seed, 1)} {
    context_.test = options.test;
    if (options.plays_saves) {
        context_.played_saves.emplace(services.files);
        // Nothing that an earlier game saved is there for this one, nor what was loaded of it.
        services.renderer.forget_files("save");
        services.audio.forget_files("save");
    }
    state_.set_context(&context_);
    register_all(state_.get());
    lua_getglobal(state_.get(), "cairn");
    cairn_ = luaL_ref(state_.get(), LUA_REGISTRYINDEX);
}

Game::~Game() = default;

std::optional<ScriptError> Game::run_file(const std::string& path,
                                          const std::vector<std::string>& arguments) {
    lua_State* L = state_.get();
    const auto text = context_.services.files.read_text(path);
    if (!text) return ScriptError{text.error().message, {}};
    if (auto error = load_text(L, *text, path)) return error;
    state_.keep_source(path, *text);
    luaL_checkstack(L, static_cast<int>(arguments.size()), "arguments of a script");
    for (const std::string& argument : arguments) push(L, std::string_view(argument));
    return protected_call(L, static_cast<int>(arguments.size()), 0);
}

std::optional<ScriptError> Game::load(const std::string& main_path,
                                      const std::vector<std::string>& arguments) {
    if (auto error = run_file(main_path)) return error;
    hint_at_slips();
    auto error = call_load(arguments);
    if (!error) hint_at_slips();
    return error;
}

void Game::hint_at_slips() {
    lua_State* L = state_.get();
    lua_rawgeti(L, LUA_REGISTRYINDEX, cairn_);
    warn_of_slips(L, -1, "cairn.");
    lua_pop(L, 1);
}

struct Game::CallbackCall {
    const char* name;
    const std::function<int(lua_State*)>& push_arguments;  ///< gives their number
    bool reaches_scenes = true;                            ///< not load, which is before all scenes
    bool is_for_visible_scenes = false;                    ///< not only for the top one
    bool result = false;
    std::string problem = {};
};

namespace {

/// Empty when it has left the stack.
std::string place_of_scene(lua_State* L, int table) {
    for (const Scene& scene : context_of(L).scenes) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, scene.reference);
        const bool is_it = lua_rawequal(L, -1, table) != 0;
        lua_pop(L, 1);
        if (is_it) return scene.place;
    }
    return "";
}

}  // namespace

int Game::run_callback(lua_State* L) {
    auto& callback = *static_cast<CallbackCall*>(lua_touserdata(L, 1));
    if (push_callback(L, callback.name)) {
        lua_call(L, callback.push_arguments(L), 1);
        callback.result = lua_toboolean(L, -1) != 0;
    }
    lua_settop(L, 1);
    if (callback.reaches_scenes) run_scene_callbacks(L, callback);
    return 0;
}

void Game::run_scene_callbacks(lua_State* L, CallbackCall& callback) {
    // Taken onto the stack first: a callback may change the scenes.
    const std::vector<Scene>& scenes = context_of(L).scenes;
    luaL_checkstack(L, static_cast<int>(scenes.size()) + LUA_MINSTACK, "scenes");
    for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, scene->reference);
        if (!callback.is_for_visible_scenes) break;
        lua_getfield(L, -1, "overlay");
        const bool is_overlay = lua_toboolean(L, -1) != 0;
        lua_pop(L, 1);
        if (!is_overlay) break;
    }
    // From the lowest to the top one.
    for (int scene = lua_gettop(L); scene > 1; --scene) {
        lua_getfield(L, scene, callback.name);
        if (lua_isfunction(L, -1)) {
            lua_pushvalue(L, scene);
            lua_call(L, 1 + callback.push_arguments(L), 1);
            callback.result = callback.result || lua_toboolean(L, -1) != 0;
        } else if (!lua_isnil(L, -1)) {
            callback.problem = place_of_scene(L, scene) + "the " + callback.name +
                               " of the scene that is put on here is " + describe_value(L, -1) +
                               " by now; expected a function";
            return;
        }
        lua_settop(L, scene - 1);
    }
}

template <class... Arguments>
std::optional<ScriptError> Game::call(const char* name, bool* result, const Arguments&... arguments) {
    const std::function<int(lua_State*)> push_arguments = [&]([[maybe_unused]] lua_State* L) {
        (push(L, arguments), ...);
        return static_cast<int>(sizeof...(Arguments));
    };
    CallbackCall callback{.name = name, .push_arguments = push_arguments};
    callback.reaches_scenes = std::string_view(name) != "load";
    callback.is_for_visible_scenes = std::string_view(name) == "draw";
    lua_State* L = state_.get();
    lua_pushcfunction(L, run_callback);
    lua_pushlightuserdata(L, &callback);
    if (auto error = protected_call(L, 1, 0)) return error;
    if (!callback.problem.empty()) return ScriptError{callback.problem, {}};
    if (result != nullptr) *result = callback.result;
    return std::nullopt;
}

std::optional<ScriptError> Game::call_load(const std::vector<std::string>& arguments) {
    return call("load", nullptr, arguments);
}

std::optional<ScriptError> Game::deliver(const InputEvent& event) {
    if (context_.typing.takes(event, context_.input)) return std::nullopt;
    context_.input.apply(event);
    if (context_.listener != LUA_NOREF) {
        if (const auto source = engine::pressed_source(event)) {
            context_.actions.settle(context_.input);
            return tell_listener(*source);
        }
    }
    if (auto error = deliver_alone(event)) return error;
    for (const engine::Actions::Change& change : context_.actions.follow(context_.input)) {
        const char* name = change.is_pressed ? "action_pressed" : "action_released";
        if (auto error = call(name, nullptr, std::string_view(change.name))) return error;
    }
    return std::nullopt;
}

std::optional<ScriptError> Game::tell_listener(const engine::InputSource& source) {
    lua_State* L = state_.get();
    lua_rawgeti(L, LUA_REGISTRYINDEX, context_.listener);
    luaL_unref(L, LUA_REGISTRYINDEX, std::exchange(context_.listener, LUA_NOREF));
    const std::string text = engine::to_text(source);
    lua_pushlstring(L, text.data(), text.size());
    return protected_call(L, 1, 0);
}

std::optional<ScriptError> Game::deliver_alone(const InputEvent& event) {
    const engine::Vec2 p = event.position;
    switch (event.kind) {
        case InputKind::KeyPressed:
            return call("key_pressed", nullptr, engine::key_name(event.key), event.is_repeat);
        case InputKind::KeyReleased:
            return call("key_released", nullptr, engine::key_name(event.key));
        case InputKind::TextEntered:
            return call("text_input", nullptr, std::string_view(event.text));
        case InputKind::MouseMoved:
            return call("mouse_moved", nullptr, p.x, p.y, event.delta.x, event.delta.y);
        case InputKind::MousePressed:
            return call("mouse_pressed", nullptr, p.x, p.y, engine::mouse_button_name(event.button));
        case InputKind::MouseReleased:
            return call("mouse_released", nullptr, p.x, p.y, engine::mouse_button_name(event.button));
        case InputKind::WheelMoved:
            return call("wheel", nullptr, event.delta.x, event.delta.y);
        case InputKind::GamepadConnected:
            return call("gamepad_connected", nullptr, event.number, std::string_view(event.text));
        case InputKind::GamepadDisconnected:
            return call("gamepad_disconnected", nullptr, event.number);
        case InputKind::GamepadPressed:
            return call("gamepad_pressed", nullptr, event.number,
                        engine::gamepad_button_name(event.gamepad_button));
        case InputKind::GamepadReleased:
            return call("gamepad_released", nullptr, event.number,
                        engine::gamepad_button_name(event.gamepad_button));
        case InputKind::GamepadMoved:
            return call("gamepad_moved", nullptr, event.number, engine::gamepad_axis_name(event.gamepad_axis),
                        event.value);
        case InputKind::TouchPressed:
            return call("touch_pressed", nullptr, event.number, p.x, p.y);
        case InputKind::TouchMoved:
            return call("touch_moved", nullptr, event.number, p.x, p.y, event.delta.x, event.delta.y);
        case InputKind::TouchReleased:
            return call("touch_released", nullptr, event.number, p.x, p.y);
        case InputKind::WindowResized:
            return follow_window({static_cast<int>(event.delta.x), static_cast<int>(event.delta.y)});
        case InputKind::FocusGained:
            return call("focus", nullptr, true);
        case InputKind::FocusLost:
            return call("focus", nullptr, false);
        case InputKind::QuitRequested: {
            bool goes_on = false;
            auto error = call("quit_requested", &goes_on);
            if (!goes_on) context_.wants_quit = true;
            return error;
        }
    }
    return std::nullopt;
}

std::optional<ScriptError> Game::follow_window(engine::Size size) {
    engine::Window& window = context_.services.window;
    size = {std::clamp(size.width, 1, engine::kMaxWindowSide),
            std::clamp(size.height, 1, engine::kMaxWindowSide)};
    if (size == window.logical_size()) return std::nullopt;  // desktops repeat themselves
    window.set_logical_size(size);
    return call("window_resized", nullptr, size.width, size.height);
}

std::optional<ScriptError> Game::run_timers() {
    lua_State* L = state_.get();
    while (const auto timer = context_.timers.take_due(context_.frame)) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, timer->function);
        // Put back first, so that the action can cancel its own timer.
        if (timer->repeats) context_.timers.repeat(*timer, context_.frame);
        if (auto error = protected_call(L, 0, 1)) return error;
        const bool is_over = lua_isboolean(L, -1) && lua_toboolean(L, -1) == 0;
        lua_pop(L, 1);
        bool is_done = !timer->repeats;
        // Not when the action has cancelled its own timer, which gave the reference back.
        if (!is_done && is_over) is_done = context_.timers.cancel(timer->number).has_value();
        if (is_done) luaL_unref(L, LUA_REGISTRYINDEX, timer->function);
    }
    return std::nullopt;
}

std::optional<ScriptError> Game::update(std::span<const InputEvent> events) {
    ++context_.frame;
    context_.actions.begin_update();
    context_.typing.begin_update(state_.get(), events);
    context_.events = events;
    auto error = update_within(events);
    context_.events = {};  // after an error too: the game may go on by other scripts
    if (!error) context_.services.audio.advance(context_.step_s());
    return error;
}

std::optional<ScriptError> Game::update_within(std::span<const InputEvent> events) {
    for (const InputEvent& event : events) {
        if (auto error = deliver(event)) return error;
    }
    if (auto error = run_timers()) return error;
    if (!context_.tweens.running.empty()) {
        lua_pushcfunction(state_.get(), run_tweens);
        if (auto error = protected_call(state_.get(), 0, 0)) return error;
    }
    return call("update", nullptr, context_.step_s());
}

void Game::release_input() {
    const bool has_focus = context_.input.has_focus();
    context_.input.apply({.kind = InputKind::FocusLost});
    if (has_focus) context_.input.apply({.kind = InputKind::FocusGained});
    context_.actions.settle(context_.input);
}

std::optional<ScriptError> Game::draw(double alpha) {
    context_.alpha = alpha;
    context_.draw = {};
    context_.world_view.reset();
    context_.is_drawing = true;
    auto error = call("draw", nullptr, alpha);
    context_.is_drawing = false;
    return error;
}

std::uint64_t Game::state_hash() const {
    std::uint64_t hash = context_.worlds.size();
    for (const WorldObject* world : context_.worlds) hash = mix(hash, world->world->state_hash());
    const engine::RandomState random = context_.random.state();
    return mix(mix(hash, random.state), random.increment);
}

}  // namespace cairn::scripting
