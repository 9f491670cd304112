// The first finger as the mouse. Invariant: the mouse is where the finger is before its button changes, as
// with a mouse.
#include <utility>

#include <cairn/engine/input.h>

namespace cairn::engine {

void FingerMouse::append(InputEvent event, std::vector<InputEvent>& events) {
    const bool is_touch = event.kind == InputKind::TouchPressed || event.kind == InputKind::TouchMoved ||
                          event.kind == InputKind::TouchReleased;
    if (is_touch && event.number == 1) {
        if (event.position != position_)
            append({.kind = InputKind::MouseMoved,
                    .position = event.position,
                    .delta = event.position - position_},
                   events);
        if (event.kind != InputKind::TouchMoved)
            append({.kind = event.kind == InputKind::TouchPressed ? InputKind::MousePressed
                                                                  : InputKind::MouseReleased,
                    .button = MouseButton::Left,
                    .position = event.position},
                   events);
    }
    if (event.kind == InputKind::MouseMoved || event.kind == InputKind::MousePressed ||
        event.kind == InputKind::MouseReleased || event.kind == InputKind::WheelMoved)
        position_ = event.position;
    events.push_back(std::move(event));
}

}  // namespace cairn::engine
