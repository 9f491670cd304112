// Pixel by pixel: the memory rasterizer gives the same bytes on every machine, so tolerance is for the eye
// and for fonts of another version.
#include "bridge/picture_check.h"

#include <algorithm>
#include <cstdlib>

namespace cairn::scripting {

std::optional<PictureDifference> compare_pictures(const engine::Image& actual, const engine::Image& approved,
                                                  const PictureTolerance& tolerance) {
    PictureDifference difference{.picture = approved};
    std::size_t too_far = 0;
    const std::size_t pixels = approved.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        int farthest = 0;
        int brightness = 0;
        for (std::size_t k = 4 * i; k < 4 * i + 3; ++k) {
            farthest = std::max(farthest, std::abs(int{actual.rgba[k]} - int{approved.rgba[k]}));
            brightness += approved.rgba[k];
        }
        const double off = farthest / 255.0;
        difference.largest = std::max(difference.largest, off);
        const bool is_too_far = off > tolerance.color;
        if (is_too_far) ++too_far;
        const auto gray = static_cast<std::uint8_t>(170 + brightness / 9);
        std::uint8_t* out = &difference.picture.rgba[4 * i];
        out[0] = is_too_far ? 220 : gray;
        out[1] = out[2] = is_too_far ? 20 : gray;
        out[3] = 255;
    }
    difference.share = pixels > 0 ? static_cast<double>(too_far) / static_cast<double>(pixels) : 0;
    if (difference.share <= tolerance.share) return std::nullopt;
    return difference;
}

}  // namespace cairn::scripting
