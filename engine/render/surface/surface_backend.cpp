// The back-end that draws into memory. Invariant: every pixel of the picture is opaque.
#include "render/surface/surface_backend.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "render/surface/rasterizer.h"

namespace cairn::engine {

SurfaceBackend::SurfaceBackend(const Viewport& viewport) {
    set_viewport(viewport);
}

void SurfaceBackend::set_viewport(const Viewport& viewport) {
    viewport_ = viewport;
    if (picture_.size == viewport.output) return;
    picture_.size = viewport.output;
    picture_.rgba.resize(4 * static_cast<std::size_t>(viewport.output.width) * viewport.output.height);
    clear({0, 0, 0, 1});
}

Result<BackendTexture> SurfaceBackend::create_texture(const Image& image) {
    auto free_slot =
        std::find_if(textures_.begin(), textures_.end(), [](const Image& t) { return t.rgba.empty(); });
    if (free_slot == textures_.end()) free_slot = textures_.insert(free_slot, Image{});
    *free_slot = image;
    return static_cast<BackendTexture>(free_slot - textures_.begin()) + 1;
}

void SurfaceBackend::update_texture(BackendTexture texture, int x, int y, const Image& part) {
    Image& whole = textures_[texture - 1];
    assert(x >= 0 && y >= 0 && x + part.size.width <= whole.size.width &&
           y + part.size.height <= whole.size.height);
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(part.size.width);
    for (int row = 0; row < part.size.height; ++row)
        std::memcpy(whole.rgba.data() + 4 * (static_cast<std::size_t>(y + row) * whole.size.width + x),
                    part.rgba.data() + row * row_bytes, row_bytes);
}

void SurfaceBackend::destroy_texture(BackendTexture texture) {
    textures_[texture - 1] = {};
}

void SurfaceBackend::clear(Color color) {
    const Rgba8 c = to_rgba8(color);
    for (std::size_t i = 0; i < picture_.rgba.size(); i += 4) {
        picture_.rgba[i] = c.r;
        picture_.rgba[i + 1] = c.g;
        picture_.rgba[i + 2] = c.b;
        picture_.rgba[i + 3] = 255;
    }
}

void SurfaceBackend::draw(std::span<const RenderVertex> vertices, std::span<const int> indices,
                          BackendTexture texture, BlendMode blend, const PixelRect& scissor) {
    const Image* image = texture ? &textures_[texture - 1] : nullptr;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        rasterize_triangle(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]], image,
                           blend, scissor, picture_);
}

}  // namespace cairn::engine
