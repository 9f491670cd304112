// All that enters a game from outside, as plain values that can be recorded and replayed, and the state they
// lead to. Invariant: InputState depends only on the events applied to it, so that a replay sees what the
// recording saw.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/gamepad.h>
#include <cairn/engine/geometry.h>
#include <cairn/engine/keys.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

/// Which fields of InputEvent mean something is said at each kind. The first finger also arrives as the left
/// mouse button, so that a game that knows the mouse can be played by touch.
enum class InputKind : std::uint8_t {
    KeyPressed,           ///< key, is_repeat
    KeyReleased,          ///< key
    TextEntered,          ///< text (UTF-8)
    MouseMoved,           ///< position, delta
    MousePressed,         ///< position, button
    MouseReleased,        ///< position, button
    WheelMoved,           ///< position, delta in notches, y up and x right positive
    GamepadConnected,     ///< number, text: its name
    GamepadDisconnected,  ///< number
    GamepadPressed,       ///< number, gamepad_button
    GamepadReleased,      ///< number, gamepad_button
    GamepadMoved,         ///< number, gamepad_axis, value
    TouchPressed,         ///< number, position
    TouchMoved,           ///< number, position, delta
    TouchReleased,        ///< number, position
    WindowResized,        ///< delta: the new logical width and height
    FocusGained,
    FocusLost,
    QuitRequested,
};
inline constexpr int kInputKindCount = static_cast<int>(InputKind::QuitRequested) + 1;

/// "key_pressed", "mouse_moved", ...: the names of the Lua callbacks.
std::string_view input_kind_name(InputKind kind);

struct InputEvent {
    InputKind kind = InputKind::QuitRequested;
    Key key = Key::Unknown;
    MouseButton button = MouseButton::Left;
    bool is_repeat = false;  ///< the key is held and the system repeats it
    Vec2 position = {};      ///< logical pixels
    Vec2 delta = {};
    std::string text = {};
    int number = 0;  ///< of the gamepad or the finger, from 1
    GamepadButton gamepad_button = GamepadButton::A;
    GamepadAxis gamepad_axis = GamepadAxis::LeftX;
    float value = 0;  ///< of the axis

    friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// One line without a newline, such as "mouse_pressed left 320 200.5"; numbers keep every bit.
std::string to_text(const InputEvent& event);
/// Reads what to_text wrote; the error names the word that is wrong.
Result<InputEvent> input_event_from_text(std::string_view line);

/// Fingers are numbered like gamepads, from 1.
inline constexpr int kMaxTouches = 10;

/// Makes the first finger the mouse too. Whatever makes events, a device or a test, passes all of them
/// through one of these.
class FingerMouse {
  public:
    /// Appends an event; before one of the first finger, what the mouse does at it.
    void append(InputEvent event, std::vector<InputEvent>& events);

  private:
    Vec2 position_;  ///< of the mouse, after all that was appended
};

class Gamepad {
  public:
    bool is_connected() const { return is_connected_; }
    const std::string& name() const { return name_; }
    bool is_down(GamepadButton button) const { return buttons_[static_cast<std::size_t>(button)]; }
    float axis(GamepadAxis axis) const { return axes_[static_cast<std::size_t>(axis)]; }

  private:
    friend class InputState;
    void release() {
        buttons_.reset();
        axes_ = {};
    }

    bool is_connected_ = false;
    std::string name_;
    std::bitset<kGamepadButtonCount> buttons_;
    std::array<float, kGamepadAxisCount> axes_{};
};

/// What is held down and where mouse and fingers are.
class InputState {
  public:
    /// Losing the focus releases everything, because the releases that follow go to another window.
    void apply(const InputEvent& event);

    bool is_down(Key key) const { return keys_[static_cast<std::size_t>(key)]; }
    bool is_down(MouseButton button) const { return buttons_[static_cast<std::size_t>(button)]; }
    Vec2 mouse_position() const { return mouse_position_; }
    bool has_focus() const { return has_focus_; }
    /// 1 .. kMaxGamepads; others, and those that are not there, are at rest.
    const Gamepad& gamepad(int number) const;
    /// Where a finger is, 1 .. kMaxTouches; absent when it does not touch.
    std::optional<Vec2> touch(int number) const;

  private:
    /// What a gamepad's event does to its gamepad.
    static void apply(const InputEvent& event, Gamepad& gamepad);

    std::bitset<kKeyCount> keys_;
    std::bitset<kMouseButtonCount> buttons_;
    Vec2 mouse_position_;
    bool has_focus_ = true;
    std::array<Gamepad, kMaxGamepads> gamepads_;  ///< number - 1
    std::array<std::optional<Vec2>, kMaxTouches> touches_;
};

}  // namespace cairn::engine
