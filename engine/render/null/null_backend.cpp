// The null back-end. Invariant: no pixel is kept.
#include "render/null/null_backend.h"

#include <utility>

namespace cairn::engine {
namespace {

class NullBackend final : public RenderBackend {
  public:
    explicit NullBackend(AskViewport viewport) : viewport_(std::move(viewport)) {}

    Viewport viewport() const override { return viewport_(); }
    bool keeps_pixels() const override { return false; }
    Result<BackendTexture> create_texture(const Image&, TextureFilter) override { return ++last_texture_; }
    Result<BackendTexture> create_canvas(Size, TextureFilter) override { return ++last_texture_; }
    void set_target(BackendTexture) override {}
    void update_texture(BackendTexture, int, int, const Image&) override {}
    void destroy_texture(BackendTexture) override {}
    void clear(Color) override {}
    void draw(std::span<const RenderVertex>, std::span<const int>, BackendTexture, BlendMode,
              const PixelRect&) override {}
    Result<Image> read_pixels() override {
        return Error{"there is no picture to capture: this headless run was started without drawing"};
    }
    void present() override {}

  private:
    AskViewport viewport_;
    BackendTexture last_texture_ = 0;
};

}  // namespace

std::unique_ptr<RenderBackend> make_null_backend(AskViewport viewport) {
    return std::make_unique<NullBackend>(std::move(viewport));
}

}  // namespace cairn::engine
