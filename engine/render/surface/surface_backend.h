// Draws into memory, with no display and no graphics driver: for screenshots of headless runs, and for
// windows on machines without accelerated graphics. Invariant: the same calls give the same bytes on every
// machine, with any number of threads: what is much to draw is cut into bands of whole rows, and a row
// depends on no other.
#pragma once

#include <memory>
#include <vector>

#include "render/backend.h"
#include "render/surface/band_workers.h"
#include "render/surface/triangle_bins.h"

namespace cairn::engine {

class SurfaceBackend final : public RenderBackend {
  public:
    explicit SurfaceBackend(AskViewport viewport, int threads = BandWorkers::threads_of_machine());

    /// Its alpha means nothing: the picture counts as opaque.
    const Image& picture() const { return picture_; }

    Viewport viewport() const override { return viewport_(); }
    bool keeps_pixels() const override { return true; }
    Result<BackendTexture> create_texture(const Image& image, TextureFilter filter) override;
    Result<BackendTexture> create_canvas(Size size, TextureFilter filter) override;
    void set_target(BackendTexture canvas) override { target_ = canvas; }
    void update_texture(BackendTexture texture, int x, int y, const Image& part) override;
    void destroy_texture(BackendTexture texture) override;
    /// The picture is thrown away first when the output has another size now.
    void clear(Color color) override;
    void draw(std::span<const RenderVertex> vertices, std::span<const int> indices, BackendTexture texture,
              BlendMode blend, const PixelRect& scissor) override;
    Result<Image> read_pixels() override;
    void present() override {}

  private:
    struct Texture {
        Image image;  ///< without area: the place is free
        TextureFilter filter = TextureFilter::Linear;
    };
    void fit_picture();
    Image& target() { return target_ ? textures_[target_ - 1].image : picture_; }

    BandWorkers workers_;
    AskViewport viewport_;
    Image picture_;
    BackendTexture target_ = 0;
    std::vector<Texture> textures_;   ///< texture id - 1
    std::vector<FixedPoint> places_;  ///< of the vertices of a draw call
    TriangleBins bins_;
};

}  // namespace cairn::engine
