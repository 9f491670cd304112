// The names of gamepads' parts. Invariant: each table has one name per enumerator, in the order of the enum.
#include <array>
#include <span>

#include <cairn/engine/gamepad.h>

namespace cairn::engine {
namespace {

constexpr std::array<std::string_view, kGamepadButtonCount> kButtonNames = {
    "a",
    "b",
    "x",
    "y",
    "back",
    "guide",
    "start",
    "left_stick",
    "right_stick",
    "left_shoulder",
    "right_shoulder",
    "dpad_up",
    "dpad_down",
    "dpad_left",
    "dpad_right",
};
constexpr std::array<std::string_view, kGamepadAxisCount> kAxisNames = {
    "left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger"};
static_assert(!kButtonNames.back().empty() && !kAxisNames.back().empty());

template <typename Enum>
std::optional<Enum> find_name(std::span<const std::string_view> names, std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<Enum>(i);
    return std::nullopt;
}

}  // namespace

std::string_view gamepad_button_name(GamepadButton button) {
    return kButtonNames[static_cast<std::size_t>(button)];
}
std::optional<GamepadButton> gamepad_button_from_name(std::string_view name) {
    return find_name<GamepadButton>(kButtonNames, name);
}
std::string_view gamepad_axis_name(GamepadAxis axis) {
    return kAxisNames[static_cast<std::size_t>(axis)];
}
std::optional<GamepadAxis> gamepad_axis_from_name(std::string_view name) {
    return find_name<GamepadAxis>(kAxisNames, name);
}

}  // namespace cairn::engine
