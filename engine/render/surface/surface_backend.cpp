// The back-end that draws into memory. Invariant: a picture that is read back is opaque.
#include "render/surface/surface_backend.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "render/surface/rasterizer.h"

namespace cairn::engine {

namespace {

void fill(Image& image, Rgba8 color) {
    std::uint32_t pixel;
    static_assert(sizeof pixel == sizeof color);
    std::memcpy(&pixel, &color, sizeof pixel);
    for (std::size_t i = 0; i < image.rgba.size(); i += sizeof pixel)
        std::memcpy(image.rgba.data() + i, &pixel, sizeof pixel);
}

}  // namespace

SurfaceBackend::SurfaceBackend(const Viewport& viewport) {
    set_viewport(viewport);
}

void SurfaceBackend::set_viewport(const Viewport& viewport) {
    viewport_ = viewport;
    if (picture_.size == viewport.output) return;
    picture_.size = viewport.output;
    picture_.rgba.resize(4 * static_cast<std::size_t>(viewport.output.width) * viewport.output.height);
    fill(picture_, {0, 0, 0, 255});
}

Result<BackendTexture> SurfaceBackend::create_texture(const Image& image, TextureFilter filter) {
    auto free_slot = std::find_if(textures_.begin(), textures_.end(),
                                  [](const Texture& t) { return t.image.rgba.empty(); });
    if (free_slot == textures_.end()) free_slot = textures_.insert(free_slot, Texture{});
    *free_slot = {image, filter};
    return static_cast<BackendTexture>(free_slot - textures_.begin()) + 1;
}

Result<BackendTexture> SurfaceBackend::create_canvas(Size size, TextureFilter filter) {
    Image blank{size, {}};
    blank.rgba.resize(4 * static_cast<std::size_t>(size.width) * size.height);
    return create_texture(blank, filter);
}

void SurfaceBackend::update_texture(BackendTexture texture, int x, int y, const Image& part) {
    Image& whole = textures_[texture - 1].image;
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
    fill(target(), to_rgba8(color));
}

Result<Image> SurfaceBackend::read_pixels() {
    Image image = picture_;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;  // BlendMode::Replace writes others
    return image;
}

void SurfaceBackend::draw(std::span<const RenderVertex> vertices, std::span<const int> indices,
                          BackendTexture texture, BlendMode blend, const PixelRect& scissor) {
    const Image* image = texture ? &textures_[texture - 1].image : nullptr;
    const TextureFilter filter = texture ? textures_[texture - 1].filter : TextureFilter::Linear;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        rasterize_triangle(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]], image,
                           filter, blend, scissor, target());
}

}  // namespace cairn::engine
