// The software rasterizer. Invariant: coverage is decided in integers, in 1/256 of a pixel; only colors are
// floats.
#include "render/surface/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace cairn::engine {
namespace {

constexpr std::int64_t kSubpixels = 256;

struct FixedPoint {
    std::int64_t x;
    std::int64_t y;
};

/// Rounds halves away from 0. As std::lround, but inline: 24 bits and a half are exact in a double.
std::int64_t rounded(double v) {
    return static_cast<std::int64_t>(v + std::copysign(0.5, v));
}

FixedPoint to_fixed(Vec2 p) {
    return {rounded(static_cast<double>(p.x) * kSubpixels), rounded(static_cast<double>(p.y) * kSubpixels)};
}

/// The first pixel whose middle is not before a place, and the last one not behind it.
std::int64_t first_pixel(std::int64_t place) {
    return (place - kSubpixels / 2 + kSubpixels - 1) >> 8;
}
std::int64_t last_pixel(std::int64_t place) {
    return (place - kSubpixels / 2) >> 8;
}
static_assert(kSubpixels == 1 << 8);

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

/// E(x, y) >= 0 on the inner side of an edge, at the middle of pixel (x, y).
struct Edge {
    std::int64_t at_origin;
    std::int64_t step_x;
    std::int64_t step_y;
    std::int64_t bias;  ///< -1 for edges whose own points belong to the neighbour (the top-left rule)

    Edge(FixedPoint p, FixedPoint q) {
        const std::int64_t dx = q.x - p.x;
        const std::int64_t dy = q.y - p.y;
        step_x = -dy * kSubpixels;
        step_y = dx * kSubpixels;
        at_origin = dx * (kSubpixels / 2 - p.y) - dy * (kSubpixels / 2 - p.x);
        const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);
        bias = top_or_left ? 0 : -1;
    }

    std::int64_t at(std::int64_t x, std::int64_t y) const { return at_origin + step_x * x + step_y * y; }

    /// Narrows the columns [first, last] to those on the inner side; `start` is E + bias of column 0.
    void narrow(std::int64_t start, std::int64_t& first, std::int64_t& last) const {
        if (step_x > 0)
            first = std::max(first, -floor_div(start, step_x));
        else if (step_x < 0)
            last = std::min(last, floor_div(start, -step_x));
        else if (start < 0)
            last = first - 1;
    }
};

/// The pixels of a row inside of a triangle, and E of its edges at the first of them.
struct Span {
    std::int64_t first;
    std::int64_t last;
    std::array<std::int64_t, 3> at_first;
};

/// `at` is E of the edges at column `first`.
Span find_long_span(const std::array<Edge, 3>& edges, std::array<std::int64_t, 3> at, std::int64_t first,
                    std::int64_t last) {
    std::int64_t left = 0;
    std::int64_t right = last - first;
    for (std::size_t k = 0; k < 3; ++k) edges[k].narrow(at[k] + edges[k].bias, left, right);
    for (std::size_t k = 0; k < 3; ++k) at[k] += edges[k].step_x * left;
    return {first + left, first + right, at};
}

/// The same. The pixels inside lie side by side, so in the short rows of small triangles, which are most,
/// stepping to them costs less than dividing.
[[gnu::always_inline]] inline Span find_short_span(const std::array<Edge, 3>& edges,
                                                   const std::array<std::int64_t, 3>& at, std::int64_t first,
                                                   std::int64_t last) {
    std::int64_t a = at[0] + edges[0].bias;
    std::int64_t b = at[1] + edges[1].bias;
    std::int64_t c = at[2] + edges[2].bias;
    // Not below 0 means that no sign bit is set.
    while ((a | b | c) < 0) {
        if (++first > last) return {first, last, {}};
        a += edges[0].step_x;
        b += edges[1].step_x;
        c += edges[2].step_x;
    }
    const std::array<std::int64_t, 3> at_first = {a - edges[0].bias, b - edges[1].bias, c - edges[2].bias};
    std::int64_t end = first;
    do {
        ++end;
        a += edges[0].step_x;
        b += edges[1].step_x;
        c += edges[2].step_x;
    } while (end <= last && (a | b | c) >= 0);
    return {first, end - 1, at_first};
}

/// r, g, b, a in 0 .. 255, side by side: the compiler does four at a time.
using Texel [[gnu::vector_size(16)]] = float;
using TexelSum [[gnu::vector_size(32)]] = double;
using Words [[gnu::vector_size(16)]] = std::int32_t;
using Bytes [[gnu::vector_size(4)]] = std::uint8_t;
static_assert(sizeof(Texel) == 4 * sizeof(float));

Texel load_texel(const std::uint8_t* from) {
    Bytes bytes;
    std::memcpy(&bytes, from, sizeof bytes);
    return __builtin_convertvector(__builtin_convertvector(bytes, Words), Texel);
}

/// Rounded and clamped.
void store_texel(std::uint8_t* to, Texel color) {
    const Texel black = {0, 0, 0, 0};
    const Texel white = {255, 255, 255, 255};
    color += 0.5f;
    color = color > black ? color : black;
    color = color < white ? color : white;
    const Bytes bytes = __builtin_convertvector(__builtin_convertvector(color, Words), Bytes);
    std::memcpy(to, &bytes, sizeof bytes);
}

/// As Image::pixel, but inline.
const std::uint8_t* texel_at(const Image& image, int x, int y) {
    return image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                                    static_cast<std::size_t>(x));
}

/// Linear filter, clamped at the edges.
Texel sample(const Image& texture, float u, float v) {
    const float x = std::clamp(u, 0.0f, 1.0f) * static_cast<float>(texture.size.width) - 0.5f;
    const float y = std::clamp(v, 0.0f, 1.0f) * static_cast<float>(texture.size.height) - 0.5f;
    const float floor_x = std::floor(x);
    const float floor_y = std::floor(y);
    const float fx = x - floor_x;
    const float fy = y - floor_y;
    const int x0 = std::clamp(static_cast<int>(floor_x), 0, texture.size.width - 1);
    const int y0 = std::clamp(static_cast<int>(floor_y), 0, texture.size.height - 1);
    const int x1 = std::clamp(static_cast<int>(floor_x) + 1, 0, texture.size.width - 1);
    const int y1 = std::clamp(static_cast<int>(floor_y) + 1, 0, texture.size.height - 1);
    const std::uint8_t* p00 = texel_at(texture, x0, y0);
    const std::uint8_t* p10 = texel_at(texture, x1, y0);
    const std::uint8_t* p01 = texel_at(texture, x0, y1);
    const std::uint8_t* p11 = texel_at(texture, x1, y1);
    const Texel t00 = load_texel(p00);
    const Texel t01 = load_texel(p01);
    const Texel upper = t00 + (load_texel(p10) - t00) * fx;
    const Texel lower = t01 + (load_texel(p11) - t01) * fx;
    return upper + (lower - upper) * fy;
}

/// The texel that holds a place.
Texel sample_nearest(const Image& texture, float u, float v) {
    const auto index = [](float share, int size) {
        return std::clamp(static_cast<int>(share * static_cast<float>(size)), 0, size - 1);
    };
    const std::uint8_t* p = texel_at(texture, index(u, texture.size.width), index(v, texture.size.height));
    return load_texel(p);
}

/// What a color, premultiplied, makes of what lies under it.
template <BlendMode kBlend>
Texel blended(Texel under, Texel color) {
    constexpr float kShare = 1.0f / 255;
    const float uncovered = 1 - color[3] * kShare;
    Texel result = color;
    switch (kBlend) {
        case BlendMode::Alpha:
            return color + under * uncovered;
        case BlendMode::Add:
            result = under + color;
            result[3] = under[3];
            return result;
        case BlendMode::Multiply:
            result = under * (color * kShare + uncovered);
            result[3] = under[3];
            return result;
        case BlendMode::Screen:
            return color + under * (1 - color * kShare);
        case BlendMode::Replace:
            return color;
    }
    return result;
}

/// A triangle that has pixels, and where they may be.
struct Triangle {
    std::array<const RenderVertex*, 3> corner;
    std::array<Edge, 3> edge;  ///< edge[i] lies opposite of corner i, so E / area is the weight of corner i
    std::int64_t area;
    std::int64_t first_column;
    std::int64_t last_column;
    std::int64_t first_row;
    std::int64_t last_row;
};

/// Calls `draw(row, span)` for each row with pixels inside.
template <class Draw>
[[gnu::always_inline]] inline void for_each_span(const Triangle& t, const Draw& draw) {
    constexpr std::int64_t kShort = 8;
    const bool is_short = t.last_column - t.first_column < kShort;
    std::array<std::int64_t, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = t.edge[k].at(t.first_column, t.first_row);
    for (std::int64_t y = t.first_row; y <= t.last_row; ++y) {
        const Span span = is_short ? find_short_span(t.edge, at, t.first_column, t.last_column)
                                   : find_long_span(t.edge, at, t.first_column, t.last_column);
        if (span.first <= span.last) draw(y, span);
        for (std::size_t k = 0; k < 3; ++k) at[k] += t.edge[k].step_y;
    }
}

std::uint8_t* pixel_of(Image& target, std::int64_t x, std::int64_t y) {
    return target.rgba.data() + 4 * (y * target.size.width + x);
}

/// One opaque color.
void fill_triangle(const Triangle& t, Image& target) {
    const Rgba8 color = t.corner[0]->color;
    for_each_span(t, [&](std::int64_t y, const Span& span) {
        std::uint8_t* pixel = pixel_of(target, span.first, y);
        for (std::int64_t x = span.first; x <= span.last; ++x, pixel += sizeof color)
            std::memcpy(pixel, &color, sizeof color);
    });
}

/// Colors that change over the triangle, and blend with what lies under it. `sample_texture(u, v)` gives what
/// they are multiplied by; where there is no texture it is not called.
template <BlendMode kBlend, bool kIsTextured, class Sample>
void shade_triangle(const Triangle& t, const Sample& sample_texture, Image& target) {
    const double reciprocal_area = 1.0 / static_cast<double>(t.area);
    std::array<TexelSum, 3> colors;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rgba8 c = t.corner[k]->color;
        colors[k] = TexelSum{static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b),
                             static_cast<double>(c.a)};
    }
    // Of E of the three edges, or of the steps of E to the next pixel.
    const auto color_of = [&](const std::array<std::int64_t, 3>& e) {
        const TexelSum sum = static_cast<double>(e[0]) * colors[0] + static_cast<double>(e[1]) * colors[1] +
                             static_cast<double>(e[2]) * colors[2];
        return __builtin_convertvector(sum * reciprocal_area, Texel);
    };
    const auto number_of = [&](const std::array<std::int64_t, 3>& e, float Vec2::*part) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum += static_cast<double>(e[k]) * static_cast<double>(t.corner[k]->uv.*part);
        return static_cast<float>(sum * reciprocal_area);
    };
    const std::array<std::int64_t, 3> to_next = {t.edge[0].step_x, t.edge[1].step_x, t.edge[2].step_x};
    const Texel color_step = color_of(to_next);
    Vec2 uv_step;
    if constexpr (kIsTextured) uv_step = {number_of(to_next, &Vec2::x), number_of(to_next, &Vec2::y)};
    for_each_span(t, [&](std::int64_t y, const Span& span) {
        const Texel start = color_of(span.at_first);
        Vec2 uv;
        if constexpr (kIsTextured)
            uv = {number_of(span.at_first, &Vec2::x), number_of(span.at_first, &Vec2::y)};
        std::uint8_t* pixel = pixel_of(target, span.first, y);
        const auto count = static_cast<int>(span.last - span.first);
        for (int x = 0; x <= count; ++x, pixel += 4) {
            const auto distance = static_cast<float>(x);
            Texel color = start + color_step * distance;
            if constexpr (kIsTextured)
                color *=
                    sample_texture(uv.x + uv_step.x * distance, uv.y + uv_step.y * distance) * (1.0f / 255);
            store_texel(pixel, blended<kBlend>(load_texel(pixel), color));
        }
    });
}

template <BlendMode kBlend>
void shade_triangle(const Triangle& t, const Image* texture, TextureFilter filter, Image& target) {
    if (texture == nullptr) {
        shade_triangle<kBlend, false>(
            t, [](float, float) { return Texel{}; }, target);
    } else if (filter == TextureFilter::Nearest) {
        const auto nearest = [&](float u, float v) { return sample_nearest(*texture, u, v); };
        shade_triangle<kBlend, true>(t, nearest, target);
    } else {
        shade_triangle<kBlend, true>(
            t, [&](float u, float v) { return sample(*texture, u, v); }, target);
    }
}

}  // namespace

void rasterize_triangle(const RenderVertex& a, const RenderVertex& b, const RenderVertex& c,
                        const Image* texture, TextureFilter filter, BlendMode blend, const PixelRect& clip,
                        Image& target) {
    std::array<const RenderVertex*, 3> corner = {&a, &b, &c};
    std::array<FixedPoint, 3> p = {to_fixed(a.position), to_fixed(b.position), to_fixed(c.position)};
    const auto [min_x, max_x] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [min_y, max_y] = std::minmax({p[0].y, p[1].y, p[2].y});
    const std::int64_t first_column = std::max<std::int64_t>(clip.x, first_pixel(min_x));
    const std::int64_t last_column = std::min<std::int64_t>(clip.x + clip.width - 1, last_pixel(max_x));
    const std::int64_t first_row = std::max<std::int64_t>(clip.y, first_pixel(min_y));
    const std::int64_t last_row = std::min<std::int64_t>(clip.y + clip.height - 1, last_pixel(max_y));
    // Many of the triangles that smooth edges are so thin that they hold the middle of no pixel.
    if (first_column > last_column || first_row > last_row) return;

    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) return;
    if (area < 0) {
        std::swap(corner[1], corner[2]);
        std::swap(p[1], p[2]);
        area = -area;
    }
    const Triangle t{
        .corner = corner,
        .edge = {Edge(p[1], p[2]), Edge(p[2], p[0]), Edge(p[0], p[1])},
        .area = area,
        .first_column = first_column,
        .last_column = last_column,
        .first_row = first_row,
        .last_row = last_row,
    };

    switch (blend) {
        case BlendMode::Alpha:
            if (texture == nullptr && a.color.a == 255 && a.color == b.color && b.color == c.color)
                return fill_triangle(t, target);
            return shade_triangle<BlendMode::Alpha>(t, texture, filter, target);
        case BlendMode::Add:
            return shade_triangle<BlendMode::Add>(t, texture, filter, target);
        case BlendMode::Multiply:
            return shade_triangle<BlendMode::Multiply>(t, texture, filter, target);
        case BlendMode::Screen:
            return shade_triangle<BlendMode::Screen>(t, texture, filter, target);
        case BlendMode::Replace:
            return shade_triangle<BlendMode::Replace>(t, texture, filter, target);
    }
}

}  // namespace cairn::engine
