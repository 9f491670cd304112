// Where the game's logical picture lies in the output, and how far it is magnified.
// Invariant: scale is positive, and the logical picture lies inside the output, centred.
#pragma once

#include <cairn/engine/geometry.h>

namespace cairn::engine {

struct Viewport {
    Size output;      ///< pixels that are really there
    Size logical;     ///< what the game sees
    float scale = 1;  ///< output pixels per logical pixel
    Vec2 offset;      ///< of the logical picture's top left, in output pixels

    Affine2 output_from_logical() const { return {scale, 0, 0, scale, offset.x, offset.y}; }
    Vec2 to_logical(Vec2 output_pixel) const { return (output_pixel - offset) * (1 / scale); }
    /// Whether some of the output lies outside of the logical picture.
    bool has_bars() const { return offset.x > 0 || offset.y > 0; }
};

/// `output` is the window's size in pixels (more than it has points on a high-DPI screen). Sizes without area
/// count as 1.
Viewport make_viewport(Size logical, Size output);

}  // namespace cairn::engine
