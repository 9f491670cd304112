// The translation of SDL's events. Invariant: positions and movements leave here in logical pixels.
#include "platform/sdl/sdl_events.h"

#include <SDL.h>
#include <array>
#include <utility>

namespace cairn::engine {
namespace {

using KeyPair = std::pair<SDL_KeyCode, Key>;

// clang-format off
constexpr std::array kKeys = {
    KeyPair{SDLK_SPACE, Key::Space}, KeyPair{SDLK_RETURN, Key::Return}, KeyPair{SDLK_ESCAPE, Key::Escape},
    KeyPair{SDLK_TAB, Key::Tab}, KeyPair{SDLK_BACKSPACE, Key::Backspace},
    KeyPair{SDLK_DELETE, Key::Delete}, KeyPair{SDLK_INSERT, Key::Insert}, KeyPair{SDLK_HOME, Key::Home},
    KeyPair{SDLK_END, Key::End}, KeyPair{SDLK_PAGEUP, Key::PageUp}, KeyPair{SDLK_PAGEDOWN, Key::PageDown},
    KeyPair{SDLK_LEFT, Key::Left}, KeyPair{SDLK_RIGHT, Key::Right}, KeyPair{SDLK_UP, Key::Up},
    KeyPair{SDLK_DOWN, Key::Down}, KeyPair{SDLK_LSHIFT, Key::LeftShift},
    KeyPair{SDLK_RSHIFT, Key::RightShift}, KeyPair{SDLK_LCTRL, Key::LeftControl},
    KeyPair{SDLK_RCTRL, Key::RightControl}, KeyPair{SDLK_LALT, Key::LeftAlt},
    KeyPair{SDLK_RALT, Key::RightAlt}, KeyPair{SDLK_LGUI, Key::LeftMeta},
    KeyPair{SDLK_RGUI, Key::RightMeta}, KeyPair{SDLK_CAPSLOCK, Key::CapsLock},
    KeyPair{SDLK_NUMLOCKCLEAR, Key::NumLock}, KeyPair{SDLK_SCROLLLOCK, Key::ScrollLock},
    KeyPair{SDLK_PRINTSCREEN, Key::PrintScreen}, KeyPair{SDLK_PAUSE, Key::Pause},
    KeyPair{SDLK_APPLICATION, Key::Menu}, KeyPair{SDLK_MINUS, Key::Minus},
    KeyPair{SDLK_EQUALS, Key::Equals}, KeyPair{SDLK_LEFTBRACKET, Key::LeftBracket},
    KeyPair{SDLK_RIGHTBRACKET, Key::RightBracket}, KeyPair{SDLK_BACKSLASH, Key::Backslash},
    KeyPair{SDLK_SEMICOLON, Key::Semicolon}, KeyPair{SDLK_QUOTE, Key::Quote},
    KeyPair{SDLK_BACKQUOTE, Key::Backquote}, KeyPair{SDLK_COMMA, Key::Comma},
    KeyPair{SDLK_PERIOD, Key::Period}, KeyPair{SDLK_SLASH, Key::Slash}, KeyPair{SDLK_KP_0, Key::Keypad0},
    KeyPair{SDLK_KP_PERIOD, Key::KeypadPeriod}, KeyPair{SDLK_KP_DIVIDE, Key::KeypadDivide},
    KeyPair{SDLK_KP_MULTIPLY, Key::KeypadMultiply}, KeyPair{SDLK_KP_MINUS, Key::KeypadMinus},
    KeyPair{SDLK_KP_PLUS, Key::KeypadPlus}, KeyPair{SDLK_KP_ENTER, Key::KeypadEnter},
};
// clang-format on

Key offset(Key first, int distance) {
    return static_cast<Key>(static_cast<int>(first) + distance);
}

Key to_key(SDL_Keycode code) {
    if (code >= SDLK_a && code <= SDLK_z) return offset(Key::A, code - SDLK_a);
    if (code >= SDLK_0 && code <= SDLK_9) return offset(Key::Digit0, code - SDLK_0);
    if (code >= SDLK_F1 && code <= SDLK_F12) return offset(Key::F1, code - SDLK_F1);
    if (code >= SDLK_KP_1 && code <= SDLK_KP_9) return offset(Key::Keypad1, code - SDLK_KP_1);
    for (const auto& [sdl, key] : kKeys)
        if (sdl == code) return key;
    return Key::Unknown;
}

std::optional<MouseButton> to_button(Uint8 button) {
    switch (button) {
        case SDL_BUTTON_LEFT:
            return MouseButton::Left;
        case SDL_BUTTON_MIDDLE:
            return MouseButton::Middle;
        case SDL_BUTTON_RIGHT:
            return MouseButton::Right;
        case SDL_BUTTON_X1:
            return MouseButton::X1;
        case SDL_BUTTON_X2:
            return MouseButton::X2;
        default:
            return std::nullopt;
    }
}

Vec2 point(Sint32 x, Sint32 y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

InputEvent of_kind(InputKind kind) {
    InputEvent event;
    event.kind = kind;
    return event;
}

std::optional<InputEvent> translate_window(const SDL_WindowEvent& sdl, const SdlWindow& window) {
    switch (sdl.event) {
        case SDL_WINDOWEVENT_FOCUS_GAINED:
            return of_kind(InputKind::FocusGained);
        case SDL_WINDOWEVENT_FOCUS_LOST:
            return of_kind(InputKind::FocusLost);
        case SDL_WINDOWEVENT_SIZE_CHANGED: {
            if (window.def().scaling != WindowScaling::Follow) return std::nullopt;
            InputEvent event = of_kind(InputKind::WindowResized);
            event.delta = point(sdl.data1, sdl.data2);
            return event;
        }
        default:
            return std::nullopt;
    }
}

}  // namespace

std::optional<InputEvent> translate(const SDL_Event& sdl, const SdlWindow& window) {
    switch (sdl.type) {
        case SDL_KEYDOWN:
        case SDL_KEYUP: {
            const bool pressed = sdl.type == SDL_KEYDOWN;
            InputEvent event = of_kind(pressed ? InputKind::KeyPressed : InputKind::KeyReleased);
            event.key = to_key(sdl.key.keysym.sym);
            event.is_repeat = pressed && sdl.key.repeat != 0;
            if (event.key == Key::Unknown) return std::nullopt;
            return event;
        }
        case SDL_TEXTINPUT: {
            InputEvent event = of_kind(InputKind::TextEntered);
            event.text = sdl.text.text;
            if (event.text.empty()) return std::nullopt;
            return event;
        }
        case SDL_MOUSEMOTION: {
            InputEvent event = of_kind(InputKind::MouseMoved);
            event.position = window.position_from_points(point(sdl.motion.x, sdl.motion.y));
            event.delta = window.movement_from_points(point(sdl.motion.xrel, sdl.motion.yrel));
            return event;
        }
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: {
            const std::optional<MouseButton> button = to_button(sdl.button.button);
            if (!button) return std::nullopt;
            InputEvent event =
                of_kind(sdl.type == SDL_MOUSEBUTTONDOWN ? InputKind::MousePressed : InputKind::MouseReleased);
            event.button = *button;
            event.position = window.position_from_points(point(sdl.button.x, sdl.button.y));
            return event;
        }
        case SDL_MOUSEWHEEL: {
            InputEvent event = of_kind(InputKind::WheelMoved);
            event.position = window.position_from_points(point(sdl.wheel.mouseX, sdl.wheel.mouseY));
            // "Natural" scrolling arrives with its signs turned round.
            const float sign = sdl.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0f : 1.0f;
            event.delta = Vec2{sdl.wheel.preciseX, sdl.wheel.preciseY} * sign;
            return event;
        }
        case SDL_WINDOWEVENT:
            return translate_window(sdl.window, window);
        case SDL_QUIT:
            return of_kind(InputKind::QuitRequested);
        default:
            return std::nullopt;
    }
}

}  // namespace cairn::engine
