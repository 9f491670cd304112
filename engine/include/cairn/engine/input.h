// All that enters a game from outside, as plain values that can be recorded and replayed, and the state they
// lead to. Invariant: InputState depends only on the events applied to it, so that a replay sees what the
// recording saw.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cairn/engine/geometry.h>
#include <cairn/engine/keys.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

/// Which fields of InputEvent mean something is said at each kind. Touches arrive as the left mouse button.
enum class InputKind : std::uint8_t {
    KeyPressed,     ///< key, is_repeat
    KeyReleased,    ///< key
    TextEntered,    ///< text (UTF-8)
    MouseMoved,     ///< position, delta
    MousePressed,   ///< position, button
    MouseReleased,  ///< position, button
    WheelMoved,     ///< position, delta in notches, y up and x right positive
    WindowResized,  ///< delta: the new logical width and height
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

    friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// One line without a newline, such as "mouse_pressed left 320 200.5"; numbers keep every bit.
std::string to_text(const InputEvent& event);
/// Reads what to_text wrote; the error names the word that is wrong.
Result<InputEvent> input_event_from_text(std::string_view line);

/// What is held down and where the mouse is.
class InputState {
  public:
    /// Losing the focus releases everything, because the releases that follow go to another window.
    void apply(const InputEvent& event);

    bool is_down(Key key) const { return keys_[static_cast<std::size_t>(key)]; }
    bool is_down(MouseButton button) const { return buttons_[static_cast<std::size_t>(button)]; }
    Vec2 mouse_position() const { return mouse_position_; }
    bool has_focus() const { return has_focus_; }

  private:
    std::bitset<kKeyCount> keys_;
    std::bitset<kMouseButtonCount> buttons_;
    Vec2 mouse_position_;
    bool has_focus_ = true;
};

}  // namespace cairn::engine
