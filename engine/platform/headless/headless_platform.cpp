// The headless platform. Invariant: SDL's video, audio and timers are never started.
#include "platform/headless/headless_platform.h"

#include <utility>

#include <cairn/engine/audio.h>
#include <cairn/engine/renderer.h>

#include "audio/null/null_backend.h"
#include "render/null/null_backend.h"
#include "render/surface/surface_backend.h"

namespace cairn::engine {
namespace {

class HeadlessWindow final : public Window {
  public:
    explicit HeadlessWindow(const WindowDef& def)
        : def_(def), title_(def.title), logical_(def.size), size_(own_size(def)) {}

    const std::string& title() const override { return title_; }
    void set_title(const std::string& title) override { title_ = title; }
    Size logical_size() const override { return logical_; }
    void set_logical_size(Size size) override { logical_ = size; }
    Size size() const override { return size_; }
    void set_size(Size size) override {
        def_.is_fullscreen = false;
        if (size != size_ && def_.scaling == WindowScaling::Follow) has_new_size_ = true;
        size_ = size;
    }
    bool is_resizable() const override { return def_.is_resizable; }
    void set_resizable(bool resizable) override { def_.is_resizable = resizable; }
    bool is_fullscreen() const override { return def_.is_fullscreen; }
    void set_fullscreen(bool fullscreen) override { def_.is_fullscreen = fullscreen; }
    bool is_visible() const override { return true; }

    /// Pictures keep the size that they have at the start, because a video cannot change its own.
    Viewport viewport() const { return make_viewport(logical_, own_size(def_)); }

    /// As a desktop tells a game what it did to its window.
    void poll_events(std::vector<InputEvent>& events) {
        if (!std::exchange(has_new_size_, false)) return;
        InputEvent event;
        event.kind = InputKind::WindowResized;
        event.delta = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
        events.push_back(event);
    }

  private:
    static Size own_size(const WindowDef& def) { return def.window_size.value_or(def.size); }

    WindowDef def_;
    std::string title_;
    Size logical_;
    Size size_;
    bool has_new_size_ = false;
};

class HeadlessPlatform final : public Platform {
  public:
    explicit HeadlessPlatform(const PlatformDef& def) : window_(def.window), draws_(def.headless_drawing) {}

    bool is_headless() const override { return true; }
    Window& window() override { return window_; }

    Result<std::unique_ptr<Renderer>> create_renderer(const Files& files) override {
        AskViewport viewport = [this] { return window_.viewport(); };
        std::unique_ptr<RenderBackend> backend;
        if (draws_)
            backend = std::make_unique<SurfaceBackend>(std::move(viewport));
        else
            backend = make_null_backend(std::move(viewport));
        return std::make_unique<Renderer>(files, std::move(backend));
    }

    std::unique_ptr<Audio> create_audio(const Files& files) override {
        return std::make_unique<Audio>(files, make_null_audio());
    }

    void poll_events(std::vector<InputEvent>& events) override { window_.poll_events(events); }
    int end_signal() const override { return 0; }
    void on_end_signal(void (*)()) override {}
    double now_s() const override { return 0; }
    void sleep_s(double) override {}
    void rumble(int, float, float, double) override {}
    Result<void> set_clipboard_text(const std::string&) override { return {}; }

  private:
    HeadlessWindow window_;
    bool draws_;
};

}  // namespace

std::unique_ptr<Platform> make_headless_platform(const PlatformDef& def) {
    return std::make_unique<HeadlessPlatform>(def);
}

}  // namespace cairn::engine
