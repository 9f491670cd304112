// The translation of gamepads and fingers. Invariant: an axis is reported only when its value has changed by
// a step that can be felt, so that a trembling stick fills neither the queue nor recordings.
#include "platform/sdl/sdl_gamepads.h"

#include <SDL.h>
#include <algorithm>
#include <cmath>

namespace cairn::engine {
namespace {

/// How far worn sticks stand from their middle at rest. Less lets characters creep; more is felt as play.
constexpr float kDeadZone = 0.15f;
/// Fine enough to aim with.
constexpr float kAxisSteps = 64;

InputEvent of_kind(InputKind kind, int number) {
    InputEvent event;
    event.kind = kind;
    event.number = number;
    return event;
}

std::optional<GamepadButton> to_button(int sdl) {
    static_assert(SDL_CONTROLLER_BUTTON_A == 0 &&
                      SDL_CONTROLLER_BUTTON_DPAD_RIGHT == static_cast<int>(GamepadButton::DpadRight),
                  "the order is SDL's");
    if (sdl < 0 || sdl >= kGamepadButtonCount) return std::nullopt;
    return static_cast<GamepadButton>(sdl);
}

/// -1 .. 1 with the dead zone taken out, in steps, up positive.
float to_axis_value(GamepadAxis axis, int raw) {
    const float value = std::clamp(static_cast<float>(raw) / 32767, -1.0f, 1.0f);
    const float beyond = std::max(0.0f, std::fabs(value) - kDeadZone) / (1 - kDeadZone);
    const float stepped = std::round(beyond * kAxisSteps) / kAxisSteps;
    const bool is_down_positive = axis == GamepadAxis::LeftY || axis == GamepadAxis::RightY;
    return stepped == 0 ? 0 : std::copysign(stepped, is_down_positive ? -value : value);
}

}  // namespace

SdlGamepads::SdlGamepads() : is_open_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {}

SdlGamepads::~SdlGamepads() {
    for (const Pad& pad : pads_)
        if (pad.controller) SDL_GameControllerClose(pad.controller);
    if (is_open_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

int SdlGamepads::number_of(std::int32_t instance) const {
    for (int i = 0; i < kMaxGamepads; ++i)
        if (pads_[i].controller && pads_[i].instance == instance) return i + 1;
    return 0;
}

void SdlGamepads::connect(int device, std::vector<InputEvent>& events) {
    const auto free =
        std::find_if(pads_.begin(), pads_.end(), [](const Pad& pad) { return !pad.controller; });
    if (free == pads_.end() || number_of(SDL_JoystickGetDeviceInstanceID(device)) != 0) return;
    SDL_GameController* controller = SDL_GameControllerOpen(device);
    if (!controller) return;
    *free = {controller, SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(controller)), {}};
    InputEvent event = of_kind(InputKind::GamepadConnected, static_cast<int>(free - pads_.begin()) + 1);
    const char* name = SDL_GameControllerName(controller);
    event.text = name && *name ? name : "gamepad";
    events.push_back(std::move(event));
}

void SdlGamepads::disconnect(std::int32_t instance, std::vector<InputEvent>& events) {
    const int number = number_of(instance);
    if (number == 0) return;
    SDL_GameControllerClose(pads_[number - 1].controller);
    pads_[number - 1] = {};
    events.push_back(of_kind(InputKind::GamepadDisconnected, number));
}

void SdlGamepads::move(int number, int sdl_axis, int raw, std::vector<InputEvent>& events) {
    if (sdl_axis < 0 || sdl_axis >= kGamepadAxisCount) return;
    const auto axis = static_cast<GamepadAxis>(sdl_axis);
    const float value = to_axis_value(axis, raw);
    float& last = pads_[number - 1].axes[sdl_axis];
    if (value == last) return;
    last = value;
    InputEvent event = of_kind(InputKind::GamepadMoved, number);
    event.gamepad_axis = axis;
    event.value = value;
    events.push_back(std::move(event));
}

bool SdlGamepads::translate(const SDL_Event& sdl, std::vector<InputEvent>& events) {
    switch (sdl.type) {
        case SDL_CONTROLLERDEVICEADDED:
            connect(sdl.cdevice.which, events);
            return true;
        case SDL_CONTROLLERDEVICEREMOVED:
            disconnect(sdl.cdevice.which, events);
            return true;
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP: {
            const int number = number_of(sdl.cbutton.which);
            const std::optional<GamepadButton> button = to_button(sdl.cbutton.button);
            if (number == 0 || !button) return true;
            InputEvent event = of_kind(
                sdl.type == SDL_CONTROLLERBUTTONDOWN ? InputKind::GamepadPressed : InputKind::GamepadReleased,
                number);
            event.gamepad_button = *button;
            events.push_back(std::move(event));
            return true;
        }
        case SDL_CONTROLLERAXISMOTION:
            if (const int number = number_of(sdl.caxis.which); number != 0)
                move(number, sdl.caxis.axis, sdl.caxis.value, events);
            return true;
        default:
            return false;
    }
}

void SdlGamepads::rumble(int gamepad, float low, float high, double duration_s) {
    if (gamepad < 1 || gamepad > kMaxGamepads || !pads_[gamepad - 1].controller) return;
    const auto strength = [](float v) { return static_cast<Uint16>(std::clamp(v, 0.0f, 1.0f) * 65535); };
    // A gamepad that cannot shake says so with an error, which nobody can mend.
    SDL_GameControllerRumble(pads_[gamepad - 1].controller, strength(low), strength(high),
                             static_cast<Uint32>(std::clamp(duration_s, 0.0, 60.0) * 1000));
}

std::optional<InputEvent> SdlTouches::translate(const SDL_Event& sdl, const SdlWindow& window) {
    if (sdl.type != SDL_FINGERDOWN && sdl.type != SDL_FINGERMOTION && sdl.type != SDL_FINGERUP)
        return std::nullopt;
    const auto held = std::find(fingers_.begin(), fingers_.end(), sdl.tfinger.fingerId);
    auto finger = held;
    if (sdl.type == SDL_FINGERDOWN && held == fingers_.end())
        finger = std::find(fingers_.begin(), fingers_.end(), std::nullopt);
    if (finger == fingers_.end()) return std::nullopt;
    InputEvent event = of_kind(InputKind::TouchMoved, static_cast<int>(finger - fingers_.begin()) + 1);
    event.position = window.position_from_share({sdl.tfinger.x, sdl.tfinger.y});
    event.delta = event.position - window.position_from_share(
                                       {sdl.tfinger.x - sdl.tfinger.dx, sdl.tfinger.y - sdl.tfinger.dy});
    if (sdl.type == SDL_FINGERDOWN) {
        *finger = sdl.tfinger.fingerId;
        event.kind = InputKind::TouchPressed;
    } else if (sdl.type == SDL_FINGERUP) {
        finger->reset();
        event.kind = InputKind::TouchReleased;
    }
    return event;
}

}  // namespace cairn::engine
