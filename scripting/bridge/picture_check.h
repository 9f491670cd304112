// Compares what a game draws with a picture that was approved.
#pragma once

#include <optional>

#include <cairn/engine/image.h>

namespace cairn::scripting {

struct PictureTolerance {
    double color = 0.03;  ///< how far each of red, green and blue may be off, 0 .. 1
    double share = 0;     ///< how much of the picture may be farther off
};

struct PictureDifference {
    double share = 0;    ///< of the pixels that are farther off than the tolerance
    double largest = 0;  ///< difference of a color, 0 .. 1
    /// The approved picture in pale gray; what differs too much in red.
    engine::Image picture;
};

/// Both of one size. Nothing when they agree.
std::optional<PictureDifference> compare_pictures(const engine::Image& actual, const engine::Image& approved,
                                                  const PictureTolerance& tolerance);

}  // namespace cairn::scripting
