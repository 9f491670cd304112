// cairn.input and cairn.window.
#include "bind/context.h"
#include "bind/modules.h"
#include "data/nearest.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

const std::vector<std::string>& key_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (int i = 1; i < engine::kKeyCount; ++i)
            list.emplace_back(engine::key_name(static_cast<engine::Key>(i)));
        return list;
    }();
    return names;
}

bool is_down(lua_State* L, std::string_view name) {
    const auto key = engine::key_from_name(name);
    if (!key)
        call_error(L, "key is \"" + std::string(name) + "\": no such key" + suggestion(name, key_names()));
    return context_of(L).input.is_down(*key);
}

bool is_mouse_down(lua_State* L, std::string_view name) {
    const auto button = engine::mouse_button_from_name(name);
    if (!button) argument_error(L, 1, "\"left\", \"middle\", \"right\", \"x1\" or \"x2\"");
    return context_of(L).input.is_down(*button);
}

std::tuple<float, float> mouse_position(lua_State* L) {
    const engine::Vec2 p = context_of(L).input.mouse_position();
    return {p.x, p.y};
}

constexpr Function kInputFunctions[] = {
    function<&is_down>(
        "is_down", "key", "down",
        "Keys: \"a\" to \"z\", \"0\" to \"9\", \"space\", \"return\", \"escape\", \"tab\", \"backspace\", "
        "\"delete\", \"insert\", \"home\", \"end\", \"page_up\", \"page_down\", \"left\", \"right\", \"up\", "
        "\"down\", \"f1\" to \"f12\", \"left_shift\", \"right_shift\", \"left_control\", "
        "\"right_control\", \"left_alt\", \"right_alt\", punctuation by its sign (\"-\"), \"keypad_0\", ..."),
    function<&is_mouse_down>(
        "is_mouse_down", "button", "down",
        "Buttons: \"left\", \"middle\", \"right\", \"x1\", \"x2\". A touch is the left button."),
    function<&mouse_position>("mouse_position", "", "x [px], y [px]", "Logical pixels."),
};

// ---- Window

std::tuple<std::int64_t, std::int64_t> size(lua_State* L) {
    const engine::Size logical = context_of(L).services.window.logical_size();
    return {logical.width, logical.height};
}
void set_title(lua_State* L, std::string_view title) {
    context_of(L).services.window.set_title(std::string(title));
}
void set_fullscreen(lua_State* L, bool on) {
    context_of(L).services.window.set_fullscreen(on);
}
bool is_fullscreen(lua_State* L) {
    return context_of(L).services.window.is_fullscreen();
}
bool has_focus(lua_State* L) {
    return context_of(L).input.has_focus();
}

constexpr Function kWindowFunctions[] = {
    function<&size>("size", "", "width [px], height [px]",
                    "Logical pixels, as conf.lua says, whatever the real window is."),
    function<&set_title>("set_title", "title", "", ""),
    function<&set_fullscreen>("set_fullscreen", "on", "", ""),
    function<&is_fullscreen>("is_fullscreen", "", "on", ""),
    function<&has_focus>("has_focus", "", "focus", ""),
};

}  // namespace

const Module kInputModule = {
    "cairn.input",
    "What is held down. It follows the events of the callbacks, so it is the same in a replay.",
    kInputFunctions};
const Module kWindowModule = {"cairn.window", "The window; headless runs pretend to have one.",
                              kWindowFunctions};

}  // namespace cairn::scripting
