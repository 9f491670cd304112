// The names of keys and mouse buttons. Invariant: each table has one name per enumerator, in the order of the
// enum.
#include <array>
#include <span>

#include <cairn/engine/keys.h>

namespace cairn::engine {
namespace {

// clang-format off
constexpr std::array<std::string_view, kKeyCount> kKeyNames = {
    "unknown",
    "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p", "q", "r", "s", "t",
    "u", "v", "w", "x", "y", "z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "space", "return", "escape", "tab", "backspace", "delete", "insert", "home", "end", "page_up",
    "page_down",
    "left", "right", "up", "down",
    "f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8", "f9", "f10", "f11", "f12",
    "left_shift", "right_shift", "left_control", "right_control", "left_alt", "right_alt", "left_meta",
    "right_meta",
    "caps_lock", "num_lock", "scroll_lock", "print_screen", "pause", "menu",
    "-", "=", "[", "]", "\\", ";", "'", "`", ",", ".", "/",
    "keypad_0", "keypad_1", "keypad_2", "keypad_3", "keypad_4", "keypad_5", "keypad_6", "keypad_7",
    "keypad_8", "keypad_9",
    "keypad_period", "keypad_divide", "keypad_multiply", "keypad_minus", "keypad_plus", "keypad_enter",
};
// clang-format on
static_assert(!kKeyNames.back().empty(), "a key lacks its name");

constexpr std::array<std::string_view, kMouseButtonCount> kButtonNames = {"left", "middle", "right", "x1",
                                                                          "x2"};

template <typename Enum>
std::optional<Enum> find_name(std::span<const std::string_view> names, std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace

std::string_view key_name(Key key) {
    return kKeyNames[static_cast<std::size_t>(key)];
}
std::optional<Key> key_from_name(std::string_view name) {
    return find_name<Key>(kKeyNames, name);
}

std::string_view mouse_button_name(MouseButton button) {
    return kButtonNames[static_cast<std::size_t>(button)];
}
std::optional<MouseButton> mouse_button_from_name(std::string_view name) {
    return find_name<MouseButton>(kButtonNames, name);
}

}  // namespace cairn::engine
