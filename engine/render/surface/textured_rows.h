// The pixels of textured triangles, row by row, several at a time in SIMD lanes.
// Invariant: the bytes are the same at every width, because each pixel comes from the same operations on
// floats in the same order, whatever lane it is in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/surface/paint.h"

namespace cairn::engine {

/// r, g, b, a in 0 .. 255.
using FloatColor = std::array<float, 4>;

/// Pixels side by side, and what the first of them has.
struct TexturedRow {
    std::uint8_t* pixels;
    int count;
    Vec2 uv;
    FloatColor color;
};

/// What is added from each pixel to the next one.
struct RowSteps {
    Vec2 uv;
    FloatColor color;
};

/// The texture lies elsewhere than the pixels, and has an area.
void shade_textured_rows(std::span<const TexturedRow> rows, const RowSteps& steps, const Paint& paint);

}  // namespace cairn::engine
