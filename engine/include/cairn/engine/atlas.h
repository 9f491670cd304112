// Named parts of one image, as texture packers describe them.
// Invariant: names are unique, and the frames stand in the order of the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/geometry.h>
#include <cairn/engine/result.h>

namespace cairn::engine {

struct AtlasFrame {
    std::string name;
    Rect source;  ///< in pixels of the image

    friend bool operator==(const AtlasFrame&, const AtlasFrame&) = default;
};

struct Atlas {
    std::string image_path;  ///< as Files knows it
    std::vector<AtlasFrame> frames;
};

/// Reads the JSON that TexturePacker made common, in both of its forms ("hash" and "array"). The image's path
/// is relative to the file. Errors name the path, the frame and the rule.
Result<Atlas> load_atlas(const Files& files, std::string_view path);

/// Whether a JSON text is meant to be an atlas: it has "frames" and "meta", or one of them and is cut off or
/// otherwise no JSON.
bool is_atlas_text(std::string_view json);

/// Whether every frame lies inside an image of that size.
Result<void> check_atlas(const Atlas& atlas, Size image, std::string_view path);

}  // namespace cairn::engine
