// The software rasterizer. Invariant: coverage is decided in integers, in 1/256 of a pixel; only colors are
// floats.
#include "render/surface/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// `at` is E of the edges at column `first`. The pixels inside lie side by side, so in the short rows of
/// small triangles, which are most, stepping to them costs less than dividing.
Span find_span(const std::array<Edge, 3>& edges, std::array<std::int64_t, 3> at, std::int64_t first,
               std::int64_t last) {
    constexpr std::int64_t kShort = 8;
    if (last - first >= kShort) {
        std::int64_t left = 0;
        std::int64_t right = last - first;
        for (std::size_t k = 0; k < 3; ++k) edges[k].narrow(at[k] + edges[k].bias, left, right);
        for (std::size_t k = 0; k < 3; ++k) at[k] += edges[k].step_x * left;
        return {first + left, first + right, at};
    }
    // Not below 0 means that no sign bit is set.
    std::array<std::int64_t, 3> e;
    for (std::size_t k = 0; k < 3; ++k) e[k] = at[k] + edges[k].bias;
    const auto step = [&] {
        for (std::size_t k = 0; k < 3; ++k) e[k] += edges[k].step_x;
    };
    std::int64_t begin = first;
    for (; begin <= last && (e[0] | e[1] | e[2]) < 0; ++begin) step();
    if (begin > last) return {begin, last, at};
    for (std::size_t k = 0; k < 3; ++k) at[k] = e[k] - edges[k].bias;
    std::int64_t end = begin;
    do {
        step();
        ++end;
    } while (end <= last && (e[0] | e[1] | e[2]) >= 0);
    return {begin, end - 1, at};
}

/// What is interpolated over a triangle: r, g, b, a in 0 .. 255, then u, v.
using Attributes = std::array<float, 6>;

Attributes attributes_of(const RenderVertex& v) {
    return {static_cast<float>(v.color.r),
            static_cast<float>(v.color.g),
            static_cast<float>(v.color.b),
            static_cast<float>(v.color.a),
            v.uv.x,
            v.uv.y};
}

using Texel = std::array<float, 4>;

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
    Texel texel;
    for (std::size_t i = 0; i < 4; ++i) {
        const float upper = p00[i] + (p10[i] - p00[i]) * fx;
        const float lower = p01[i] + (p11[i] - p01[i]) * fx;
        texel[i] = upper + (lower - upper) * fy;
    }
    return texel;
}

/// The texel that holds a place.
Texel sample_nearest(const Image& texture, float u, float v) {
    const auto index = [](float share, int size) {
        return std::clamp(static_cast<int>(share * static_cast<float>(size)), 0, size - 1);
    };
    const std::uint8_t* p = texel_at(texture, index(u, texture.size.width), index(v, texture.size.height));
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
            static_cast<float>(p[3])};
}

/// Component i of what a color, 0 .. 255 and premultiplied, makes of what lies under it.
template <BlendMode kBlend>
float blended(float under, const Texel& color, std::size_t i) {
    constexpr std::size_t kAlpha = 3;
    const float uncovered = 1 - color[kAlpha] * (1.0f / 255);
    switch (kBlend) {
        case BlendMode::Alpha:
            return color[i] + under * uncovered;
        case BlendMode::Add:
            return i == kAlpha ? under : under + color[i];
        case BlendMode::Multiply:
            return i == kAlpha ? under : under * (color[i] * (1.0f / 255) + uncovered);
        case BlendMode::Screen:
            return color[i] + under * (1 - color[i] * (1.0f / 255));
        case BlendMode::Replace:
            return color[i];
    }
    return under;
}

template <BlendMode kBlend>
void blend_pixel(std::uint8_t* pixel, const Texel& color) {
    std::array<float, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = blended<kBlend>(pixel[i], color, i) + 0.5f;
    for (std::size_t i = 0; i < 4; ++i) {
        const float clamped = result[i] > 0 ? result[i] : 0;
        pixel[i] = static_cast<std::uint8_t>(static_cast<int>(clamped < 255 ? clamped : 255));
    }
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
void for_each_span(const Triangle& t, const Draw& draw) {
    std::array<std::int64_t, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = t.edge[k].at(t.first_column, t.first_row);
    for (std::int64_t y = t.first_row; y <= t.last_row; ++y) {
        const Span span = find_span(t.edge, at, t.first_column, t.last_column);
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
        for (std::int64_t x = span.first; x <= span.last; ++x, pixel += 4) {
            pixel[0] = color.r;
            pixel[1] = color.g;
            pixel[2] = color.b;
            pixel[3] = 255;
        }
    });
}

/// Colors that change over the triangle, and blend with what lies under it. `sample_texture(u, v)` gives what
/// they are multiplied by; where there is no texture it is not called.
template <BlendMode kBlend, bool kIsTextured, class Sample>
void shade_triangle(const Triangle& t, const Sample& sample_texture, Image& target) {
    constexpr std::size_t kUsed = kIsTextured ? 6 : 4;
    const std::array<Attributes, 3> values = {attributes_of(*t.corner[0]), attributes_of(*t.corner[1]),
                                              attributes_of(*t.corner[2])};
    const double reciprocal_area = 1.0 / static_cast<double>(t.area);
    const auto interpolate = [&](const std::array<double, 3>& weights) {
        Attributes result{};
        for (std::size_t i = 0; i < kUsed; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * static_cast<double>(values[k][i]);
            result[i] = static_cast<float>(sum * reciprocal_area);
        }
        return result;
    };
    const Attributes step =
        interpolate({static_cast<double>(t.edge[0].step_x), static_cast<double>(t.edge[1].step_x),
                     static_cast<double>(t.edge[2].step_x)});
    for_each_span(t, [&](std::int64_t y, const Span& span) {
        const Attributes start =
            interpolate({static_cast<double>(span.at_first[0]), static_cast<double>(span.at_first[1]),
                         static_cast<double>(span.at_first[2])});
        std::uint8_t* pixel = pixel_of(target, span.first, y);
        const auto count = static_cast<int>(span.last - span.first);
        for (int x = 0; x <= count; ++x, pixel += 4) {
            const auto distance = static_cast<float>(x);
            Texel color;
            for (std::size_t i = 0; i < 4; ++i) color[i] = start[i] + step[i] * distance;
            if constexpr (kIsTextured) {
                const Texel texel =
                    sample_texture(start[4] + step[4] * distance, start[5] + step[5] * distance);
                for (std::size_t i = 0; i < 4; ++i) color[i] *= texel[i] * (1.0f / 255);
            }
            blend_pixel<kBlend>(pixel, color);
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
    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) return;
    if (area < 0) {
        std::swap(corner[1], corner[2]);
        std::swap(p[1], p[2]);
        area = -area;
    }
    const auto [min_x, max_x] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [min_y, max_y] = std::minmax({p[0].y, p[1].y, p[2].y});
    const Triangle t{
        .corner = corner,
        .edge = {Edge(p[1], p[2]), Edge(p[2], p[0]), Edge(p[0], p[1])},
        .area = area,
        .first_column = std::max<std::int64_t>(clip.x, first_pixel(min_x)),
        .last_column = std::min<std::int64_t>(clip.x + clip.width - 1, last_pixel(max_x)),
        .first_row = std::max<std::int64_t>(clip.y, first_pixel(min_y)),
        .last_row = std::min<std::int64_t>(clip.y + clip.height - 1, last_pixel(max_y)),
    };
    // Many of the triangles that smooth edges are so thin that they hold the middle of no pixel.
    if (t.first_column > t.last_column || t.first_row > t.last_row) return;

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
