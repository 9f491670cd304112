// cairn.window. Invariant: the logical size changes only by the game itself or by an event, so a replay has
// it too; what the desktop decides (the window's own size, the scale) is for drawing alone.
#include "bind/context.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

using Pair = std::tuple<std::int64_t, std::int64_t>;

engine::Window& window_of(lua_State* L) {
    return context_of(L).services.window;
}

constexpr Range kSides{1, engine::kMaxWindowSide};
using Side = Ranged<kSides, std::int64_t>;

engine::Size to_size(Side width, Side height) {
    return {static_cast<int>(width.value), static_cast<int>(height.value)};
}

Pair size(lua_State* L) {
    const engine::Size logical = window_of(L).logical_size();
    return {logical.width, logical.height};
}
void set_logical_size(lua_State* L, Side width, Side height) {
    window_of(L).set_logical_size(to_size(width, height));
}
Pair window_size(lua_State* L) {
    const engine::Size points = window_of(L).size();
    return {points.width, points.height};
}
void set_window_size(lua_State* L, Side width, Side height) {
    window_of(L).set_size(to_size(width, height));
}
void set_title(lua_State* L, std::string_view title) {
    window_of(L).set_title(std::string(title));
}
void set_fullscreen(lua_State* L, bool on) {
    window_of(L).set_fullscreen(on);
}
bool is_fullscreen(lua_State* L) {
    return window_of(L).is_fullscreen();
}
void set_resizable(lua_State* L, bool on) {
    window_of(L).set_resizable(on);
}
bool is_resizable(lua_State* L) {
    return window_of(L).is_resizable();
}
float pixel_scale(lua_State* L) {
    return context_of(L).services.renderer.pixel_scale();
}
bool has_focus(lua_State* L) {
    return context_of(L).input.has_focus();
}

constexpr Function kWindowFunctions[] = {
    function<&size>("size", "", "width [px], height [px]",
                    "Logical pixels: what the game draws in and where the mouse is. As conf.lua says, until "
                    "`set_logical_size` or, with `scaling = \"follow\"`, the window changes it."),
    function<&set_logical_size>("set_logical_size", "width [px], height [px]", "",
                                "From the next picture on the game draws in so many pixels, 1 to 8192 a "
                                "side, scaled to fit the window."),
    function<&window_size>(
        "window_size", "", "width, height",
        "Of the window itself, in the desktop's points. The desktop decides it, so nothing but drawing may "
        "depend on it. Headless: as conf.lua or `set_window_size` said."),
    function<&set_window_size>("set_window_size", "width, height", "",
                               "Points of the desktop, 1 to 8192 a side; leaves full screen. With `scaling = "
                               "\"follow\"` the picture "
                               "follows, and `cairn.window_resized` is called."),
    function<&set_title>("set_title", "title", "", ""),
    function<&set_fullscreen>("set_fullscreen", "on", "", "Over the whole display, in its own resolution."),
    function<&is_fullscreen>("is_fullscreen", "", "on", ""),
    function<&set_resizable>("set_resizable", "on", "", "Whether the player can change the window's size."),
    function<&is_resizable>("is_resizable", "", "on", ""),
    function<&pixel_scale>(
        "pixel_scale", "", "scale",
        "How many pixels of the display a logical pixel is wide: more than 1 on dense displays and in large "
        "windows. A canvas that is to look sharp has as many times its size, and is drawn as many times "
        "smaller; text, shapes and fonts follow by themselves. It differs between machines, so nothing but "
        "drawing may depend on it."),
    function<&has_focus>("has_focus", "", "focus", ""),
};

}  // namespace

const Module kWindowModule = {"cairn.window", "The window; headless runs pretend to have one.",
                              kWindowFunctions};

}  // namespace cairn::scripting
