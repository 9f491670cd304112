// What draws triangles: the only part of rendering that differs between a window, memory, and nothing.
// Invariant: everything arrives in output pixels, with texture coordinates in 0 .. 1 and finite numbers only;
// all colors, those of textures too, are multiplied by their alpha. So a canvas can be drawn as it lies, and
// a filter does not mix the invisible color of a transparent pixel into a sprite's edge. Source: T. Porter,
// T. Duff, "Compositing Digital Images", 1984.
//
// To add a back-end: derive from RenderBackend, and let Platform::create choose it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <cairn/engine/image.h>
#include <cairn/engine/renderer.h>
#include <cairn/engine/result.h>

#include "render/viewport.h"

namespace cairn::engine {

struct Rgba8 {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 0;

    friend bool operator==(Rgba8, Rgba8) = default;
};

/// Multiplied by its alpha. Components outside 0 .. 1 are clamped first; NaN counts as 0.
Rgba8 to_rgba8(Color color);
/// Multiplies the colors of a picture by their alpha.
void premultiply(Image& image);

struct RenderVertex {
    Vec2 position;
    Rgba8 color;
    Vec2 uv;
};

struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Where the picture lies now: asked for with each frame, because windows and games change it.
using AskViewport = std::function<Viewport()>;

/// 0 is no texture: plain colors.
using BackendTexture = std::uint32_t;

class RenderBackend {
  public:
    virtual ~RenderBackend() = default;

    virtual Viewport viewport() const = 0;
    /// Whether textures are looked at; if not, images need not be decoded.
    virtual bool keeps_pixels() const = 0;

    /// The picture is premultiplied.
    virtual Result<BackendTexture> create_texture(const Image& image, TextureFilter filter) = 0;
    /// A transparent texture that can be a target.
    virtual Result<BackendTexture> create_canvas(Size size, TextureFilter filter) = 0;
    /// Replaces the part of a texture whose top left is (x, y); the part lies inside.
    virtual void update_texture(BackendTexture texture, int x, int y, const Image& part) = 0;
    virtual void destroy_texture(BackendTexture texture) = 0;

    /// What clear and draw act on from now on: a canvas, or with 0 the output.
    virtual void set_target(BackendTexture canvas) = 0;
    /// Fills the whole target.
    virtual void clear(Color color) = 0;
    /// Textures are sampled by their filter and clamped at their edges. Drawing is cut to `scissor`, which
    /// lies inside the target.
    virtual void draw(std::span<const RenderVertex> vertices, std::span<const int> indices,
                      BackendTexture texture, BlendMode blend, const PixelRect& scissor) = 0;
    /// The output's.
    virtual Result<Image> read_pixels() = 0;
    virtual void present() = 0;
    /// Whether `present` waits for the display; if not, the caller has to.
    virtual bool waits_for_display() const { return false; }
};

}  // namespace cairn::engine
