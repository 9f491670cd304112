// The platform on SDL2. Invariant: members are destroyed in the order renderer's window, then SDL's video.
#include "platform/sdl/sdl_platform.h"

#include <SDL.h>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <utility>

#include <cairn/engine/audio.h>
#include <cairn/engine/renderer.h>

#include "audio/sdl/mixer_backend.h"
#include "platform/sdl/end_signals.h"
#include "platform/sdl/sdl_events.h"
#include "platform/sdl/sdl_gamepads.h"
#include "platform/sdl/sdl_window.h"
#include "render/sdl/window_backend.h"

namespace cairn::engine {
namespace {

/// Holds SDL's video subsystem open.
class VideoSubsystem {
  public:
    VideoSubsystem() : is_open_(SDL_InitSubSystem(SDL_INIT_VIDEO) == 0) {}
    ~VideoSubsystem() {
        if (is_open_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    VideoSubsystem(VideoSubsystem&& other) noexcept : is_open_(std::exchange(other.is_open_, false)) {}
    VideoSubsystem& operator=(VideoSubsystem&&) = delete;

    bool is_open() const { return is_open_; }

  private:
    bool is_open_;
};

/// SDL falls back to drivers that show nothing when it finds no display; a game would then run unseen until
/// somebody kills it. Only who names such a driver in SDL_VIDEODRIVER wants it.
bool shows_nothing_unasked(std::string_view driver) {
    if (driver != "offscreen" && driver != "dummy") return false;
    const char* asked = std::getenv("SDL_VIDEODRIVER");
    return asked == nullptr || std::string_view(asked).find(driver) == std::string_view::npos;
}

class SdlPlatform final : public Platform {
  public:
    SdlPlatform(VideoSubsystem video, std::unique_ptr<SdlWindow> window)
        : video_(std::move(video)), window_(std::move(window)) {}

    bool is_headless() const override { return false; }
    Window& window() override { return *window_; }

    Result<std::unique_ptr<Renderer>> create_renderer(const Files& files) override {
        Result<std::unique_ptr<RenderBackend>> backend = make_window_backend(*window_);
        if (!backend) return backend.error();
        return std::make_unique<Renderer>(files, std::move(*backend));
    }

    std::unique_ptr<Audio> create_audio(const Files& files) override {
        return std::make_unique<Audio>(files, make_mixer_audio());
    }

    void poll_events(std::vector<InputEvent>& events) override {
        // Those that still wait for an update are heard before what comes now.
        for (const InputEvent& waiting : events) expect_size_of(waiting);
        SDL_Event sdl;
        while (SDL_PollEvent(&sdl)) {
            if (gamepads_.translate(sdl, events)) continue;
            std::optional<InputEvent> event = touches_.translate(sdl, *window_);
            if (!event) event = translate(sdl, *window_);
            if (!event) continue;
            finger_mouse_.append(std::move(*event), events);
            expect_size_of(events.back());
        }
        window_->expect_logical_size(std::nullopt);
    }

    int end_signal() const override { return EndSignals::received(); }
    void on_end_signal(void (*call)()) override { EndSignals::call_on_first(call); }

    double now_s() const override {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    void sleep_s(double duration_s) override {
        if (duration_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
    }

    void rumble(int gamepad, float low, float high, double duration_s) override {
        gamepads_.rumble(gamepad, low, high, duration_s);
    }

    Result<void> set_clipboard_text(const std::string& text) override {
        if (SDL_SetClipboardText(text.c_str()) != 0)
            return Error{std::string("clipboard: ") + SDL_GetError()};
        return {};
    }

  private:
    void expect_size_of(const InputEvent& event) {
        if (event.kind != InputKind::WindowResized) return;
        window_->expect_logical_size(Size{static_cast<int>(event.delta.x), static_cast<int>(event.delta.y)});
    }

    EndSignals signals_;
    VideoSubsystem video_;
    std::unique_ptr<SdlWindow> window_;
    SdlGamepads gamepads_;
    SdlTouches touches_;
    FingerMouse finger_mouse_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Result<std::unique_ptr<Platform>> make_sdl_platform(const PlatformDef& def) {
    SDL_SetMainReady();  // the program's main is its own, not SDL's
    // FingerMouse does it, for tests and for devices alike; whoever sets SDL's variable would get it twice.
    SDL_SetHintWithPriority(SDL_HINT_TOUCH_MOUSE_EVENTS, "0", SDL_HINT_OVERRIDE);
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // EndSignals tells them from the close button
    VideoSubsystem video;
    constexpr const char* kWayOut = "; set DISPLAY, or play without a display: --headless";
    if (!video.is_open()) return Error{std::string("there is no display: ") + SDL_GetError() + kWayOut};
    if (shows_nothing_unasked(SDL_GetCurrentVideoDriver()))
        return Error{std::string("there is no display") + kWayOut};
    Result<std::unique_ptr<SdlWindow>> window = SdlWindow::create(def.window);
    if (!window) return window.error();
    return std::unique_ptr<Platform>(std::make_unique<SdlPlatform>(std::move(video), std::move(*window)));
}

}  // namespace cairn::engine
