// Which events go into a field of a menu that is being typed into, and so not to the game: keys, texts and
// the buttons of gamepads. Sticks go to both: a field does not use them. Invariant: the game sees both ends
// of a key or button or neither: of each that it has seen go down it sees the release, and of one that went
// into a field nothing.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <lua.hpp>
#include <span>
#include <vector>

#include <cairn/engine/input.h>
#include <cairn/engine/ui.h>

namespace cairn::scripting {

/// A menu takes its events in cairn.update, after the game's callbacks got them. What it will do with them is
/// therefore foreseen on a copy; the functions that it calls, which may do anything, are not.
class Typing {
  public:
    /// The menu of a Ui at an index has taken the events of this update; so it will take those of the next.
    /// It is kept until then, because what keys do must not depend on when garbage is collected.
    void follow(lua_State* L, int index, const engine::Ui& menu);
    /// Begins an update, which has these events.
    void begin_update(lua_State* L, std::span<const engine::InputEvent> events);
    /// Whether the game must not see an event. To be asked of each event of an update, in order, before it is
    /// applied to the state.
    bool takes(const engine::InputEvent& event, const engine::InputState& state);
    /// Whether an event of this update, counted from 0, goes into a field of another menu.
    [[nodiscard]] bool is_of_another(const engine::Ui& menu, std::size_t event) const {
        return event < owners_.size() && owners_[event] != nullptr && owners_[event] != &menu;
    }

  private:
    struct Menu {
        const engine::Ui* ui;
        int reference;  ///< in the registry
    };
    [[nodiscard]] const engine::Ui* typed_into() const;
    bool takes_key(const engine::InputEvent& event, const engine::InputState& state, bool is_typed);
    bool takes_button(const engine::InputEvent& event, const engine::InputState& state, bool is_typed);

    std::vector<Menu> followed_;     ///< since this update
    std::vector<Menu> menus_;        ///< since the last one
    std::vector<engine::Ui> later_;  ///< what each of those is after the events so far; empty without events
    std::vector<const engine::Ui*> owners_;  ///< of the events of this update so far; null: everybody
    // What went down in a field and has not gone up.
    std::bitset<engine::kKeyCount> keys_;
    std::array<std::bitset<engine::kGamepadButtonCount>, engine::kMaxGamepads> buttons_;  ///< number - 1
};

}  // namespace cairn::scripting
