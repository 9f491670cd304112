// The back-end that draws into memory. Invariant: a picture that is read back is opaque.
#include "render/surface/surface_backend.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <utility>

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

/// What one triangle costs before it has a pixel, in pixels.
constexpr float kPixelsPerTriangle = 30;
/// From here on several threads are sooner done than one: a third of a millisecond.
constexpr float kMuch = 60'000;
/// More than one, because rows in the middle of a picture tend to hold more.
constexpr int kBandsPerThread = 3;

/// By the boxes of the triangles, wherever they lie.
bool is_much(std::span<const RenderVertex> vertices, std::span<const int> indices) {
    float pixels = 0;
    for (std::size_t i = 0; i + 2 < indices.size() && pixels < kMuch; i += 3) {
        const auto [a, b, c] = std::array{vertices[indices[i]].position, vertices[indices[i + 1]].position,
                                          vertices[indices[i + 2]].position};
        const float width = std::max({a.x, b.x, c.x}) - std::min({a.x, b.x, c.x});
        const float height = std::max({a.y, b.y, c.y}) - std::min({a.y, b.y, c.y});
        pixels += kPixelsPerTriangle + width * height;
    }
    return pixels >= kMuch;
}

}  // namespace

SurfaceBackend::SurfaceBackend(AskViewport viewport, int threads)
    : workers_(threads), viewport_(std::move(viewport)) {
    fit_picture();
}

void SurfaceBackend::fit_picture() {
    const Size output = viewport_().output;
    if (picture_.size == output) return;
    picture_.size = output;
    picture_.rgba.resize(4 * static_cast<std::size_t>(output.width) * output.height);
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
    if (target_ == 0) fit_picture();
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
    Paint paint{.blend = blend};
    if (texture) {
        paint.texture = &textures_[texture - 1].image;
        paint.filter = textures_[texture - 1].filter;
    }
    Image& to = target();
    assert(paint.texture != &to);  // the renderer shows no canvas to itself
    places_.clear();
    for (const RenderVertex& vertex : vertices) places_.push_back(to_fixed(vertex.position));
    const auto rasterize = [&](std::size_t i, const PixelRect& clip) {
        const auto [a, b, c] = std::array{indices[i], indices[i + 1], indices[i + 2]};
        rasterize_triangle({&vertices[a], &vertices[b], &vertices[c]}, {places_[a], places_[b], places_[c]},
                           paint, clip, to);
    };
    if (workers_.threads() == 1 || !is_much(vertices, indices)) {
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) rasterize(i, scissor);
        return;
    }
    const int bands = kBandsPerThread * workers_.threads();
    bins_.sort(places_, indices, scissor, bands, workers_);
    workers_.run(bands, [&](int band) {
        const PixelRect rows = bins_.rows(band);
        bins_.for_each(band, [&](std::size_t i) { rasterize(i, rows); });
    });
}

}  // namespace cairn::engine
