// Keys, text and buttons on their way into fields of menus.
#include "bind/typing.h"

#include <algorithm>
#include <utility>

namespace cairn::scripting {

using engine::InputEvent;
using engine::InputKind;
using engine::Ui;
using engine::WidgetKind;

namespace {

bool has_field(const Ui& menu) {
    return std::any_of(menu.widgets().begin(), menu.widgets().end(),
                       [](const engine::Widget& widget) { return widget.kind == WidgetKind::TextField; });
}

}  // namespace

void Typing::follow(lua_State* L, int index, const Ui& menu) {
    if (!has_field(menu)) return;
    lua_pushvalue(L, index);
    followed_.push_back({&menu, luaL_ref(L, LUA_REGISTRYINDEX)});
}

void Typing::begin_update(lua_State* L, std::span<const InputEvent> events) {
    owners_.clear();
    later_.clear();
    for (const Menu& menu : menus_) luaL_unref(L, LUA_REGISTRYINDEX, menu.reference);
    menus_ = std::exchange(followed_, {});
    if (events.empty()) return;
    for (const Menu& menu : menus_) later_.push_back(*menu.ui);
}

const Ui* Typing::typed_into() const {
    // The last is above the others.
    for (std::size_t i = later_.size(); i-- > 0;)
        if (later_[i].is_editing()) return menus_[i].ui;
    return nullptr;
}

bool Typing::takes_key(const InputEvent& event, const engine::InputState& state, bool is_typed) {
    const auto key = static_cast<std::size_t>(event.key);
    if (event.kind == InputKind::KeyReleased) {
        const bool was_typed = keys_[key];
        keys_.reset(key);
        return was_typed;
    }
    if (!is_typed) {
        // What closed the field is still held: no news for the game either.
        if (event.is_repeat) return keys_[key];
        keys_.reset(key);  // its release went to whoever else had the keyboard meanwhile
        return false;
    }
    // What the game has seen go down before it will see go up.
    keys_[key] = !state.is_down(event.key);
    return true;
}

bool Typing::takes_button(const InputEvent& event, const engine::InputState& state, bool is_typed) {
    if (event.number < 1 || event.number > engine::kMaxGamepads) return is_typed;
    auto& buttons = buttons_[static_cast<std::size_t>(event.number - 1)];
    const auto button = static_cast<std::size_t>(event.gamepad_button);
    if (event.kind == InputKind::GamepadReleased) {
        const bool was_typed = buttons[button];
        buttons.reset(button);
        return was_typed;
    }
    buttons[button] = is_typed && !state.gamepad(event.number).is_down(event.gamepad_button);
    return is_typed;
}

bool Typing::takes(const InputEvent& event, const engine::InputState& state) {
    const Ui* field = typed_into();
    const bool is_key = event.kind == InputKind::KeyPressed || event.kind == InputKind::KeyReleased;
    const bool is_button =
        event.kind == InputKind::GamepadPressed || event.kind == InputKind::GamepadReleased;
    const bool is_typed =
        field != nullptr && (event.kind == InputKind::KeyPressed || event.kind == InputKind::TextEntered ||
                             event.kind == InputKind::GamepadPressed);
    owners_.push_back(is_typed ? field : nullptr);
    for (std::size_t i = 0; i < later_.size(); ++i)
        if (!is_typed || menus_[i].ui == field) later_[i].apply(event);
    // Its buttons never go up: another that gets its number begins with none.
    if (event.kind == InputKind::GamepadDisconnected && event.number >= 1 &&
        event.number <= engine::kMaxGamepads)
        buttons_[static_cast<std::size_t>(event.number - 1)].reset();
    if (is_button) return takes_button(event, state, is_typed);
    return is_key ? takes_key(event, state, is_typed) : is_typed;
}

}  // namespace cairn::scripting
