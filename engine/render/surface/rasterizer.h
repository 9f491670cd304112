// Draws triangles into memory.
// Invariant: triangles that share an edge cover each pixel along it exactly once, so translucent shapes have
// no seams; the pixels depend on the input only, not on the machine, so pictures can be compared byte by
// byte. Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", 1988 (edge functions, top-left
// rule).
//
// SDL's software renderer was tried first. It cuts vertices to whole pixels, which turns smooth rims into
// jagged ones, and it samples textures without filtering.
#pragma once

#include "render/backend.h"

namespace cairn::engine {

/// `texture` may be null: plain colors. All colors are premultiplied, those of the target too. `clip` lies
/// inside the target. Positions beyond 2^20 pixels are not allowed.
void rasterize_triangle(const RenderVertex& a, const RenderVertex& b, const RenderVertex& c,
                        const Image* texture, TextureFilter filter, BlendMode blend, const PixelRect& clip,
                        Image& target);

}  // namespace cairn::engine
