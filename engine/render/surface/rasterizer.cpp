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

    [[nodiscard]] bool has_inside(std::int64_t x, std::int64_t y) const { return at(x, y) + bias >= 0; }

    /// Narrows [first, last] to the pixels of row y on the inner side.
    void narrow(std::int64_t y, std::int64_t& first, std::int64_t& last) const {
        const std::int64_t start = at(0, y) + bias;
        if (step_x > 0)
            first = std::max(first, -floor_div(start, step_x));
        else if (step_x < 0)
            last = std::min(last, floor_div(start, -step_x));
        else if (start < 0)
            last = first - 1;
    }
};

/// Narrows [first, last] to the pixels of row y inside of a triangle. They lie side by side, so in the short
/// rows of small triangles, which are most, stepping to them costs less than dividing.
void narrow(const std::array<Edge, 3>& edges, std::int64_t y, std::int64_t& first, std::int64_t& last) {
    constexpr std::int64_t kShort = 8;
    if (last - first >= kShort) {
        for (const Edge& edge : edges) edge.narrow(y, first, last);
        return;
    }
    const auto is_inside = [&](std::int64_t x) {
        return edges[0].has_inside(x, y) && edges[1].has_inside(x, y) && edges[2].has_inside(x, y);
    };
    while (first <= last && !is_inside(first)) ++first;
    while (last > first && !is_inside(last)) --last;
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
    const std::uint8_t* p00 = texture.pixel(x0, y0);
    const std::uint8_t* p10 = texture.pixel(x1, y0);
    const std::uint8_t* p01 = texture.pixel(x0, y1);
    const std::uint8_t* p11 = texture.pixel(x1, y1);
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
    const std::uint8_t* p = texture.pixel(index(u, texture.size.width), index(v, texture.size.height));
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
            static_cast<float>(p[3])};
}

/// Component i of what a color, 0 .. 255 and premultiplied, makes of what lies under it.
float blended(float under, const Texel& color, std::size_t i, BlendMode blend) {
    constexpr std::size_t kAlpha = 3;
    const float uncovered = 1 - color[kAlpha] * (1.0f / 255);
    switch (blend) {
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

void blend_pixel(std::uint8_t* pixel, const Texel& color, BlendMode blend) {
    for (std::size_t i = 0; i < 4; ++i)
        pixel[i] =
            static_cast<std::uint8_t>(std::clamp(blended(pixel[i], color, i, blend) + 0.5f, 0.0f, 255.0f));
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
    // edge[i] lies opposite of corner i, so edge[i].at() / area is the weight of corner i.
    const std::array<Edge, 3> edge = {Edge(p[1], p[2]), Edge(p[2], p[0]), Edge(p[0], p[1])};

    const auto [min_x, max_x] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [min_y, max_y] = std::minmax({p[0].y, p[1].y, p[2].y});
    const std::int64_t first_column = std::max<std::int64_t>(clip.x, first_pixel(min_x));
    const std::int64_t last_column = std::min<std::int64_t>(clip.x + clip.width - 1, last_pixel(max_x));
    const std::int64_t first_row = std::max<std::int64_t>(clip.y, first_pixel(min_y));
    const std::int64_t last_row = std::min<std::int64_t>(clip.y + clip.height - 1, last_pixel(max_y));
    // Many of the triangles that smooth edges are so thin that they hold the middle of no pixel.
    if (first_column > last_column || first_row > last_row) return;

    const std::array<Attributes, 3> values = {attributes_of(*corner[0]), attributes_of(*corner[1]),
                                              attributes_of(*corner[2])};
    const auto reciprocal_area = 1.0 / static_cast<double>(area);
    const std::size_t used = texture ? values[0].size() : 4;  // without a texture, no places in it
    Attributes step{};
    bool has_step = false;
    const bool plain = !texture && a.color == b.color && b.color == c.color;

    for (std::int64_t y = first_row; y <= last_row; ++y) {
        std::int64_t first = first_column;
        std::int64_t last = last_column;
        narrow(edge, y, first, last);
        if (first > last) continue;

        std::uint8_t* pixel =
            target.rgba.data() + 4 * (static_cast<std::size_t>(y) * target.size.width + first);
        if (plain && a.color.a == 255 && blend == BlendMode::Alpha) {
            for (std::int64_t x = first; x <= last; ++x, pixel += 4) {
                pixel[0] = a.color.r;
                pixel[1] = a.color.g;
                pixel[2] = a.color.b;
                pixel[3] = 255;
            }
            continue;
        }

        if (!has_step) {
            for (std::size_t i = 0; i < used; ++i) {
                double sum = 0;
                for (std::size_t k = 0; k < 3; ++k) sum += static_cast<double>(edge[k].step_x) * values[k][i];
                step[i] = static_cast<float>(sum * reciprocal_area);
            }
            has_step = true;
        }
        Attributes start{};
        for (std::size_t i = 0; i < used; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += static_cast<double>(edge[k].at(first, y)) * values[k][i];
            start[i] = static_cast<float>(sum * reciprocal_area);
        }
        for (std::int64_t x = first; x <= last; ++x, pixel += 4) {
            const auto distance = static_cast<float>(x - first);
            Texel color;
            for (std::size_t i = 0; i < 4; ++i) color[i] = start[i] + step[i] * distance;
            if (texture) {
                const float u = start[4] + step[4] * distance;
                const float v = start[5] + step[5] * distance;
                const Texel texel = filter == TextureFilter::Nearest ? sample_nearest(*texture, u, v)
                                                                     : sample(*texture, u, v);
                for (std::size_t i = 0; i < 4; ++i) color[i] *= texel[i] * (1.0f / 255);
            }
            blend_pixel(pixel, color, blend);
        }
    }
}

}  // namespace cairn::engine
