// Draws triangles into memory.
// Invariant: translucent shapes have no seams along the edges that triangles share; the pixels depend on the
// input only, not on the machine, so pictures can be compared byte by byte.
//
// SDL's software renderer was tried first. It cuts vertices to whole pixels, which turns smooth rims into
// jagged ones, and it samples textures without filtering.
#pragma once

#include <array>

#include "render/surface/paint.h"
#include "render/surface/triangle_spans.h"

namespace cairn::engine {

/// `corners` are the places of the vertices. All colors are premultiplied, those of the target too. `clip`
/// lies inside the target.
void rasterize_triangle(const std::array<const RenderVertex*, 3>& vertices, const Corners& corners,
                        const Paint& paint, const PixelRect& clip, Image& target);

}  // namespace cairn::engine
