// Follows the events to know what is held down. Invariant: nothing but apply() changes it.
#include <cairn/engine/input.h>

namespace cairn::engine {

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
        case InputKind::FocusGained:
            has_focus_ = true;
            break;
        case InputKind::FocusLost:
            has_focus_ = false;
            keys_.reset();
            buttons_.reset();
            break;
        case InputKind::TextEntered:
        case InputKind::WindowResized:
        case InputKind::QuitRequested:
            break;
    }
}

}  // namespace cairn::engine
