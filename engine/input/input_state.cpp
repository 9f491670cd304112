// Follows the events to know what is held down. Invariant: nothing but apply() changes it.
#include <cairn/engine/input.h>

namespace cairn::engine {

const Gamepad& InputState::gamepad(int number) const {
    static const Gamepad kNone;
    return number >= 1 && number <= kMaxGamepads ? gamepads_[number - 1] : kNone;
}

std::optional<Vec2> InputState::touch(int number) const {
    return number >= 1 && number <= kMaxTouches ? touches_[number - 1] : std::nullopt;
}

void InputState::apply(const InputEvent& event) {
    switch (event.kind) {
        case InputKind::KeyPressed:
        case InputKind::KeyReleased:
            keys_[static_cast<std::size_t>(event.key)] = event.kind == InputKind::KeyPressed;
            break;
        case InputKind::MousePressed:
        case InputKind::MouseReleased:
            buttons_[static_cast<std::size_t>(event.button)] = event.kind == InputKind::MousePressed;
            mouse_position_ = event.position;
            break;
        case InputKind::MouseMoved:
        case InputKind::WheelMoved:
            mouse_position_ = event.position;
            break;
        case InputKind::GamepadConnected:
        case InputKind::GamepadDisconnected:
        case InputKind::GamepadPressed:
        case InputKind::GamepadReleased:
        case InputKind::GamepadMoved:
            if (event.number >= 1 && event.number <= kMaxGamepads) apply(event, gamepads_[event.number - 1]);
            break;
        case InputKind::TouchPressed:
        case InputKind::TouchMoved:
        case InputKind::TouchReleased:
            if (event.number < 1 || event.number > kMaxTouches) break;
            touches_[event.number - 1] = event.position;
            if (event.kind == InputKind::TouchReleased) touches_[event.number - 1].reset();
            break;
        case InputKind::FocusGained:
            has_focus_ = true;
            break;
        case InputKind::FocusLost:
            has_focus_ = false;
            keys_.reset();
            buttons_.reset();
            touches_ = {};
            for (Gamepad& gamepad : gamepads_) gamepad.release();
            break;
        case InputKind::TextEntered:
        case InputKind::WindowResized:
        case InputKind::QuitRequested:
            break;
    }
}

void InputState::apply(const InputEvent& event, Gamepad& gamepad) {
    if (event.kind == InputKind::GamepadConnected) {
        gamepad.is_connected_ = true;
        gamepad.name_ = event.text;
    } else if (event.kind == InputKind::GamepadDisconnected) {
        gamepad = {};
    } else if (event.kind == InputKind::GamepadMoved) {
        gamepad.axes_[static_cast<std::size_t>(event.gamepad_axis)] = event.value;
    } else {
        gamepad.buttons_[static_cast<std::size_t>(event.gamepad_button)] =
            event.kind == InputKind::GamepadPressed;
    }
}

}  // namespace cairn::engine
