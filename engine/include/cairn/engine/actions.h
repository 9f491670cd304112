// Named actions ("jump", "left") over whatever keys, buttons and sticks they are bound to, which a player may
// change. Invariant: what an action does depends only on its sources and on the events applied, so replays do
// the same.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/gamepad.h>
#include <cairn/engine/input.h>
#include <cairn/engine/keys.h>

namespace cairn::engine {

/// One thing that a finger can press or move.
struct InputSource {
    enum class Kind : std::uint8_t { Key, MouseButton, GamepadButton, GamepadAxis };

    Kind kind = Kind::Key;
    Key key = Key::Unknown;
    MouseButton mouse_button = MouseButton::Left;
    int gamepad = 0;  ///< 0: any
    GamepadButton button = GamepadButton::A;
    GamepadAxis axis = GamepadAxis::LeftX;
    int direction = 1;  ///< of the axis: 1 or -1

    /// 0 .. 1; keys and buttons are 0 or 1.
    float value(const InputState& state) const;

    friend bool operator==(const InputSource&, const InputSource&) = default;
};

/// "space", "mouse_left", "gamepad_a", "gamepad2_left_x+", "gamepad_left_trigger".
std::string to_text(const InputSource& source);
/// The error names the word and what is possible.
Result<InputSource> input_source_from_text(std::string_view text);
/// What an event presses, or moves by more than half: for asking a player to press something.
std::optional<InputSource> pressed_source(const InputEvent& event);

class Actions {
  public:
    /// An action is down when a source is more than half; it is released again below a third, so that a
    /// trembling stick does not press it twice.
    static constexpr float kPress = 0.5f;
    static constexpr float kRelease = 0.35f;

    /// Replaces the sources of an action, which is made if it was not there.
    void bind(std::string_view name, std::vector<InputSource> sources);
    /// Null for an action that is not there.
    const std::vector<InputSource>* sources(std::string_view name) const;
    std::vector<std::string> names() const;

    /// What an event changed, in the order of names.
    struct Change {
        std::string name;
        bool is_pressed;
    };
    /// Begins an update: nothing has been pressed or released in it yet.
    void begin_update();
    /// After the event was applied to the state.
    std::vector<Change> follow(const InputState& state);
    /// Takes what is held down as it is, as if nothing had been pressed or released.
    void settle(const InputState& state);

    bool is_down(std::string_view name) const;
    bool was_pressed(std::string_view name) const;
    bool was_released(std::string_view name) const;
    /// 0 .. 1, that of the strongest source.
    float value(std::string_view name, const InputState& state) const;

  private:
    struct Action {
        std::vector<InputSource> sources;
        bool is_down = false;
        bool was_pressed = false;
        bool was_released = false;
    };
    const Action* find(std::string_view name) const;
    static bool would_be_down(const Action& action, const InputState& state);

    std::map<std::string, Action, std::less<>> actions_;
};

}  // namespace cairn::engine
