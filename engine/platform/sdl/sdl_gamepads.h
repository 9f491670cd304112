// Gamepads and fingers as SDL reports them. Invariant: a number names the same gamepad from its connected
// event to its disconnected one, and the same finger from its pressed event to its released one; freed
// numbers are given again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <cairn/engine/gamepad.h>
#include <cairn/engine/input.h>

#include "platform/sdl/sdl_window.h"

struct _SDL_GameController;
union SDL_Event;

namespace cairn::engine {

class SdlGamepads {
  public:
    /// Without support for gamepads there are none; that is no error.
    SdlGamepads();
    ~SdlGamepads();
    SdlGamepads(const SdlGamepads&) = delete;
    SdlGamepads& operator=(const SdlGamepads&) = delete;

    /// Appends what an event of SDL means; false when it has nothing to do with gamepads.
    bool translate(const SDL_Event& sdl, std::vector<InputEvent>& events);
    /// Shakes a gamepad; nothing when it is not there or cannot.
    void rumble(int gamepad, float low, float high, double duration_s);

  private:
    struct Pad {
        _SDL_GameController* controller = nullptr;  ///< null: the number is free
        std::int32_t instance = -1;
        std::array<float, kGamepadAxisCount> axes{};  ///< as reported last
    };
    /// The number of a gamepad, 0 for one that is not open.
    int number_of(std::int32_t instance) const;
    void connect(int device, std::vector<InputEvent>& events);
    void disconnect(std::int32_t instance, std::vector<InputEvent>& events);
    void move(int number, int sdl_axis, int raw, std::vector<InputEvent>& events);

    std::array<Pad, kMaxGamepads> pads_;  ///< number - 1
    bool is_open_;
};

class SdlTouches {
  public:
    std::optional<InputEvent> translate(const SDL_Event& sdl, const SdlWindow& window);

  private:
    std::array<std::optional<std::int64_t>, kMaxTouches> fingers_;  ///< number - 1
};

}  // namespace cairn::engine
