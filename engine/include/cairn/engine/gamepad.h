// The parts of a gamepad, in the layout that most of them share, with the names that Lua and recordings use.
// Invariant: names are unique, lower case and stable: a recording made by one version is read by the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cairn::engine {

/// A, B, X and Y by their place: below, right, left, above.
enum class GamepadButton : std::uint8_t {
    A,
    B,
    X,
    Y,
    Back,
    Guide,
    Start,
    LeftStick,
    RightStick,
    LeftShoulder,
    RightShoulder,
    DpadUp,
    DpadDown,
    DpadLeft,
    DpadRight,
};
inline constexpr int kGamepadButtonCount = static_cast<int>(GamepadButton::DpadRight) + 1;

/// Sticks are -1 .. 1, right and up positive; triggers 0 .. 1.
enum class GamepadAxis : std::uint8_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
inline constexpr int kGamepadAxisCount = static_cast<int>(GamepadAxis::RightTrigger) + 1;

/// Gamepads are numbered from 1 in order of their coming; a number that got free is given again.
inline constexpr int kMaxGamepads = 8;

/// "a", "start", "left_shoulder", "dpad_up", ...
std::string_view gamepad_button_name(GamepadButton button);
std::optional<GamepadButton> gamepad_button_from_name(std::string_view name);
/// "left_x", "right_trigger", ...
std::string_view gamepad_axis_name(GamepadAxis axis);
std::optional<GamepadAxis> gamepad_axis_from_name(std::string_view name);

}  // namespace cairn::engine
