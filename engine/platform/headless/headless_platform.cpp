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
        : title_(def.title), size_(def.size), is_fullscreen_(def.is_fullscreen) {}

    const std::string& title() const override { return title_; }
    void set_title(const std::string& title) override { title_ = title; }
    Size logical_size() const override { return size_; }
    bool is_fullscreen() const override { return is_fullscreen_; }
    void set_fullscreen(bool fullscreen) override { is_fullscreen_ = fullscreen; }
    bool is_visible() const override { return true; }

  private:
    std::string title_;
    Size size_;
    bool is_fullscreen_;
};

class HeadlessPlatform final : public Platform {
  public:
    explicit HeadlessPlatform(const PlatformDef& def) : window_(def.window), draws_(def.headless_drawing) {}

    bool is_headless() const override { return true; }
    Window& window() override { return window_; }

    Result<std::unique_ptr<Renderer>> create_renderer(const Files& files) override {
        const Size size = window_.logical_size();
        std::unique_ptr<RenderBackend> backend;
        if (draws_)
            backend = std::make_unique<SurfaceBackend>(make_viewport(WindowScaling::Fit, size, size, size));
        else
            backend = make_null_backend(size);
        return std::make_unique<Renderer>(files, std::move(backend));
    }

    std::unique_ptr<Audio> create_audio(const Files& files) override {
        return std::make_unique<Audio>(files, make_null_audio());
    }

    void poll_events(std::vector<InputEvent>&) override {}
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
