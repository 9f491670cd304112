// Which pixels a triangle covers: those whose middles lie inside.
// Invariant: coverage is decided in integers, in 1/256 of a pixel, so triangles that share an edge cover each
// pixel along it exactly once. Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", 1988
// (edge functions, top-left rule).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "render/backend.h"

namespace cairn::engine {

constexpr std::int32_t kSubpixels = 256;

/// In 1/256 of a pixel.
struct FixedPoint {
    std::int32_t x;
    std::int32_t y;
};
using Corners = std::array<FixedPoint, 3>;

/// Rounds halves away from 0. Positions beyond 2^20 pixels are not allowed.
inline FixedPoint to_fixed(Vec2 position) {
    // As std::lround, but inline: 24 bits and a half are exact in a double.
    const auto rounded = [](double v) { return static_cast<std::int32_t>(v + std::copysign(0.5, v)); };
    return {rounded(static_cast<double>(position.x) * kSubpixels),
            rounded(static_cast<double>(position.y) * kSubpixels)};
}

/// Twice the area, above 0 for corners in the order of the rasterizer.
inline std::int64_t doubled_area(const Corners& p) {
    const auto side = [](std::int32_t from, std::int32_t to) { return static_cast<std::int64_t>(to) - from; };
    return side(p[0].x, p[1].x) * side(p[0].y, p[2].y) - side(p[0].y, p[1].y) * side(p[0].x, p[2].x);
}

/// Pixels of whole rows and columns, both ends included.
struct PixelBox {
    int first_column;
    int last_column;
    int first_row;
    int last_row;

    [[nodiscard]] bool is_empty() const { return first_column > last_column || first_row > last_row; }
};

/// Those inside of the clip that a triangle may cover. Many of the triangles that smooth edges are so thin
/// that there are none.
PixelBox pixels_near(const Corners& corners, const PixelRect& clip);

/// The pixels of a row inside of a triangle, both ends included.
struct Span {
    int row;
    int first;
    int last;
};
constexpr int kMaxSpans = 32;

/// Writes the spans of a triangle with positive area in a box of at most kMaxSpans rows, and returns how many
/// there are.
std::size_t find_spans(const Corners& corners, const PixelBox& box, std::span<Span, kMaxSpans> spans);

}  // namespace cairn::engine
