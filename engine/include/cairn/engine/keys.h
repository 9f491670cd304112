// The keys and mouse buttons that a game can see, with the names that Lua and recordings use.
// Invariant: names are unique, lower case and stable: a recording made by one version is read by the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cairn::engine {

/// A key by what is printed on it in the user's layout.
// clang-format off
enum class Key : std::uint8_t {
    Unknown,
    A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
    Space, Return, Escape, Tab, Backspace, Delete, Insert, Home, End, PageUp, PageDown,
    Left, Right, Up, Down,
    F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
    LeftShift, RightShift, LeftControl, RightControl, LeftAlt, RightAlt, LeftMeta, RightMeta,
    CapsLock, NumLock, ScrollLock, PrintScreen, Pause, Menu,
    Minus, Equals, LeftBracket, RightBracket, Backslash, Semicolon, Quote, Backquote, Comma, Period, Slash,
    Keypad0, Keypad1, Keypad2, Keypad3, Keypad4, Keypad5, Keypad6, Keypad7, Keypad8, Keypad9,
    KeypadPeriod, KeypadDivide, KeypadMultiply, KeypadMinus, KeypadPlus, KeypadEnter,
};
// clang-format on
inline constexpr int kKeyCount = static_cast<int>(Key::KeypadEnter) + 1;

/// "a", "0", "space", "left", "f5", "left_shift", "-", "keypad_7", ...; "unknown" for a key without a name
/// here.
std::string_view key_name(Key key);
std::optional<Key> key_from_name(std::string_view name);

enum class MouseButton : std::uint8_t { Left, Middle, Right, X1, X2 };
inline constexpr int kMouseButtonCount = static_cast<int>(MouseButton::X2) + 1;

/// "left", "middle", "right", "x1", "x2".
std::string_view mouse_button_name(MouseButton button);
std::optional<MouseButton> mouse_button_from_name(std::string_view name);

}  // namespace cairn::engine
