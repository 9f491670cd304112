// The colors of the software rasterizer. Invariant: what is added up over a whole triangle is a double.
#include "render/surface/rasterizer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "render/surface/textured_rows.h"

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

/// From corner 0 of a triangle to the middle of a pixel.
struct Way {
    double x;
    double y;

    Way(const Triangle& t, int column, int row)
        : x(pixels_from(column, t.place[0].x)), y(pixels_from(row, t.place[0].y)) {}

  private:
    static double pixels_from(int pixel, std::int32_t place) {
        return (static_cast<double>(pixel) + 0.5) - static_cast<double>(place) / kSubpixels;
    }
};

Plane<ExactTexel> plane_of_colors(const Triangle& t) {
    return {
        t,
        {exact_texel(t.vertex[0]->color), exact_texel(t.vertex[1]->color), exact_texel(t.vertex[2]->color)}};
}

/// Colors that change, and blend with what lies under them.
template <BlendMode kBlend>
void shade_plain(std::span<const Span> spans, const Triangle& t, Image& target) {
    const Plane<ExactTexel> colors = plane_of_colors(t);
    const Texel color_step = rounded(colors.step_x);
    for (const Span& span : spans) {
        const Way way(t, span.first, span.row);
        const Texel start = rounded(colors.at(way.x, way.y));
        std::uint8_t* pixel = pixel_of(target, span);
        const int count = span.last - span.first;
        for (int x = 0; x <= count; ++x, pixel += 4)
            store_texel(pixel,
                        blended<kBlend>(load_texel(pixel), start + color_step * static_cast<float>(x)));
    }
}

FloatColor float_color(const Texel& t) {
    return {t[0], t[1], t[2], t[3]};
}

void shade_textured(std::span<const Span> spans, const Triangle& t, const Paint& paint, Image& target) {
    const auto& [a, b, c] = t.vertex;
    const Plane<ExactTexel> colors = plane_of_colors(t);
    const Plane<double> u(t, {a->uv.x, b->uv.x, c->uv.x});
    const Plane<double> v(t, {a->uv.y, b->uv.y, c->uv.y});
    const RowSteps steps{{static_cast<float>(u.step_x), static_cast<float>(v.step_x)},
                         float_color(rounded(colors.step_x))};
    std::array<TexturedRow, kMaxSpans> rows;
    std::size_t count = 0;
    for (const Span& span : spans) {
        const Way way(t, span.first, span.row);
        rows[count++] = {pixel_of(target, span),
                         span.last - span.first + 1,
                         {static_cast<float>(u.at(way.x, way.y)), static_cast<float>(v.at(way.x, way.y))},
                         float_color(rounded(colors.at(way.x, way.y)))};
    }
    shade_textured_rows({rows.data(), count}, steps, paint);
}

void draw_spans(std::span<const Span> spans, const Triangle& t, const Paint& paint, Image& target) {
    if (paint.texture != nullptr) return shade_textured(spans, t, paint, target);
    switch (paint.blend) {
        case BlendMode::Alpha: {
            const Rgba8 color = t.vertex[0]->color;
            if (color.a == 255 && color == t.vertex[1]->color && color == t.vertex[2]->color)
                return fill_spans(spans, color, target);
            return shade_plain<BlendMode::Alpha>(spans, t, target);
        }
        case BlendMode::Add:
            return shade_plain<BlendMode::Add>(spans, t, target);
        case BlendMode::Multiply:
            return shade_plain<BlendMode::Multiply>(spans, t, target);
        case BlendMode::Screen:
            return shade_plain<BlendMode::Screen>(spans, t, target);
        case BlendMode::Replace:
            return shade_plain<BlendMode::Replace>(spans, t, target);
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
