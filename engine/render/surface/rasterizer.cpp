// The colors of the software rasterizer. Invariant: what is added up over a whole triangle is a double.
#include "render/surface/rasterizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace cairn::engine {
namespace {

/// r, g, b, a in 0 .. 255, side by side: the compiler does four at a time.
using Texel [[gnu::vector_size(16)]] = float;
using Pair [[gnu::vector_size(16)]] = double;
using Words [[gnu::vector_size(16)]] = std::int32_t;
using Bytes [[gnu::vector_size(4)]] = std::uint8_t;
static_assert(sizeof(Texel) == 4 * sizeof(float));

/// A texel in doubles: halves of the size that every processor has registers for.
struct ExactTexel {
    Pair rg;
    Pair ba;

    friend ExactTexel operator+(const ExactTexel& a, const ExactTexel& b) {
        return {a.rg + b.rg, a.ba + b.ba};
    }
    friend ExactTexel operator-(const ExactTexel& a, const ExactTexel& b) {
        return {a.rg - b.rg, a.ba - b.ba};
    }
    friend ExactTexel operator*(const ExactTexel& a, double factor) { return {a.rg * factor, a.ba * factor}; }
};

ExactTexel exact_texel(Rgba8 c) {
    return {Pair{static_cast<double>(c.r), static_cast<double>(c.g)},
            Pair{static_cast<double>(c.b), static_cast<double>(c.a)}};
}

Texel rounded(const ExactTexel& t) {
    return Texel{static_cast<float>(t.rg[0]), static_cast<float>(t.rg[1]), static_cast<float>(t.ba[0]),
                 static_cast<float>(t.ba[1])};
}

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

/// A triangle with positive area.
struct Triangle {
    std::array<const RenderVertex*, 3> vertex;
    Corners place;
    std::int64_t doubled_area;
};

/// What changes evenly over a triangle, counted from corner 0. It is the same for each part of the triangle,
/// so that a picture does not depend on the parts that it is drawn in.
template <class Value>
struct Plane {
    Value at_corner;
    Value step_x;  ///< to the next pixel
    Value step_y;

    Plane(const Triangle& t, const std::array<Value, 3>& values) : at_corner(values[0]) {
        const double share = kSubpixels / static_cast<double>(t.doubled_area);
        const Value to_b = (values[1] - values[0]) * share;
        const Value to_c = (values[2] - values[0]) * share;
        step_x = to_b * between(t.place[0].y, t.place[2].y) + to_c * between(t.place[1].y, t.place[0].y);
        step_y = to_b * between(t.place[2].x, t.place[0].x) + to_c * between(t.place[0].x, t.place[1].x);
    }

    /// So many pixels from the corner.
    [[nodiscard]] Value at(double x, double y) const { return at_corner + (step_x * x + step_y * y); }

  private:
    static double between(std::int32_t from, std::int32_t to) {
        return static_cast<double>(to) - static_cast<double>(from);
    }
};

std::uint8_t* pixel_of(Image& target, const Span& span) {
    return target.rgba.data() + 4 * (static_cast<std::size_t>(span.row) * target.size.width + span.first);
}

/// One opaque color.
void fill_spans(std::span<const Span> spans, Rgba8 color, Image& target) {
    for (const Span& span : spans) {
        std::uint8_t* pixel = pixel_of(target, span);
        for (int x = span.first; x <= span.last; ++x, pixel += sizeof color)
            std::memcpy(pixel, &color, sizeof color);
    }
}

/// The colors and the places in the texture of a triangle without a texture, and of one with it.
template <bool kIsTextured>
struct Shading {
    Plane<ExactTexel> color;

    explicit Shading(const Triangle& t)
        : color(t, {exact_texel(t.vertex[0]->color), exact_texel(t.vertex[1]->color),
                    exact_texel(t.vertex[2]->color)}) {}
};
template <>
struct Shading<true> : Shading<false> {
    Plane<double> u;
    Plane<double> v;

    explicit Shading(const Triangle& t)
        : Shading<false>(t),
          u(t, {t.vertex[0]->uv.x, t.vertex[1]->uv.x, t.vertex[2]->uv.x}),
          v(t, {t.vertex[0]->uv.y, t.vertex[1]->uv.y, t.vertex[2]->uv.y}) {}
};

/// Colors that change, and blend with what lies under them. `sample_texture(u, v)` gives what they are
/// multiplied by; where there is no texture it is not called.
template <BlendMode kBlend, bool kIsTextured, class Sample>
void shade_spans(std::span<const Span> spans, const Triangle& t, const Sample& sample_texture,
                 Image& target) {
    const Shading<kIsTextured> shading(t);
    const Texel color_step = rounded(shading.color.step_x);
    const auto pixels_from = [](int pixel, std::int32_t place) {
        return (static_cast<double>(pixel) + 0.5) - static_cast<double>(place) / kSubpixels;
    };
    for (const Span& span : spans) {
        const double from_x = pixels_from(span.first, t.place[0].x);
        const double from_y = pixels_from(span.row, t.place[0].y);
        const Texel start = rounded(shading.color.at(from_x, from_y));
        Vec2 uv;
        Vec2 uv_step;
        if constexpr (kIsTextured) {
            uv = {static_cast<float>(shading.u.at(from_x, from_y)),
                  static_cast<float>(shading.v.at(from_x, from_y))};
            uv_step = {static_cast<float>(shading.u.step_x), static_cast<float>(shading.v.step_x)};
        }
        std::uint8_t* pixel = pixel_of(target, span);
        const int count = span.last - span.first;
        for (int x = 0; x <= count; ++x, pixel += 4) {
            const auto distance = static_cast<float>(x);
            Texel color = start + color_step * distance;
            if constexpr (kIsTextured)
                color *=
                    sample_texture(uv.x + uv_step.x * distance, uv.y + uv_step.y * distance) * (1.0f / 255);
            store_texel(pixel, blended<kBlend>(load_texel(pixel), color));
        }
    }
}

template <BlendMode kBlend>
void shade_spans(std::span<const Span> spans, const Triangle& t, const Paint& paint, Image& target) {
    if (paint.texture == nullptr) {
        shade_spans<kBlend, false>(
            spans, t, [](float, float) { return Texel{}; }, target);
    } else if (paint.filter == TextureFilter::Nearest) {
        const auto nearest = [&](float u, float v) { return sample_nearest(*paint.texture, u, v); };
        shade_spans<kBlend, true>(spans, t, nearest, target);
    } else {
        const auto linear = [&](float u, float v) { return sample(*paint.texture, u, v); };
        shade_spans<kBlend, true>(spans, t, linear, target);
    }
}

void draw_spans(std::span<const Span> spans, const Triangle& t, const Paint& paint, Image& target) {
    switch (paint.blend) {
        case BlendMode::Alpha: {
            const Rgba8 color = t.vertex[0]->color;
            if (paint.texture == nullptr && color.a == 255 && color == t.vertex[1]->color &&
                color == t.vertex[2]->color)
                return fill_spans(spans, color, target);
            return shade_spans<BlendMode::Alpha>(spans, t, paint, target);
        }
        case BlendMode::Add:
            return shade_spans<BlendMode::Add>(spans, t, paint, target);
        case BlendMode::Multiply:
            return shade_spans<BlendMode::Multiply>(spans, t, paint, target);
        case BlendMode::Screen:
            return shade_spans<BlendMode::Screen>(spans, t, paint, target);
        case BlendMode::Replace:
            return shade_spans<BlendMode::Replace>(spans, t, paint, target);
    }
}

}  // namespace

void rasterize_triangle(const std::array<const RenderVertex*, 3>& vertices, const Corners& corners,
                        const Paint& paint, const PixelRect& clip, Image& target) {
    const PixelBox box = pixels_near(corners, clip);
    if (box.is_empty()) return;
    Triangle t{vertices, corners, doubled_area(corners)};
    if (t.doubled_area == 0) return;
    if (t.doubled_area < 0) {
        std::swap(t.vertex[1], t.vertex[2]);
        std::swap(t.place[1], t.place[2]);
        t.doubled_area = -t.doubled_area;
    }
    std::array<Span, kMaxSpans> spans;
    for (int row = box.first_row; row <= box.last_row; row += kMaxSpans) {
        PixelBox part = box;
        part.first_row = row;
        part.last_row = std::min(box.last_row, row + kMaxSpans - 1);
        const std::size_t count = find_spans(t.place, part, spans);
        if (count > 0) draw_spans({spans.data(), count}, t, paint, target);
    }
}

}  // namespace cairn::engine
