// Gives transparent pixels the color of their visible neighbours.
// Invariant: alpha and the colors of visible pixels stay as they are.
//
// Linear filtering mixes a sprite's edge with the color that its transparent pixels happen to have, which is
// black in most files: a dark seam around everything that is rotated or scaled.
#pragma once

#include <cairn/engine/image.h>

namespace cairn::engine {

/// Reaches one pixel, which is as far as the filter looks.
void bleed_into_transparent(Image& image);

}  // namespace cairn::engine
