// The fonts that are loaded: their file, and a face for each pixel size that is in use.
// Invariant: a font's nominal face, which measures, is open as long as the font; the faces that draw are
// opened when needed, and at most kMaxFaces of them are kept.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <cairn/engine/files.h>
#include <cairn/engine/handle.h>

#include "assets/sdl/font_face.h"
#include "base/handle_table.h"

namespace cairn::engine {

class FontStore {
  public:
    /// The sizes a font can be asked for, and drawn at.
    static constexpr int kMinPixels = 4;
    static constexpr int kMaxPixels = 256;

    Result<FontId> load(const Files& files, std::string_view path, float size);
    /// Paths that begin so are read anew from here on.
    void forget_files(std::string_view prefix);
    bool is_valid(FontId font) const { return fonts_.find(font) != nullptr; }
    /// The face for measuring; null for a null or stale handle.
    const FontFace* nominal(FontId font) const;
    int nominal_pixels(FontId font) const;
    /// The face for drawing at another size. The pointer is good until the next call.
    const FontFace* at_pixels(FontId font, int pixels);

  private:
    /// A zoom that changes with every frame must not open faces without end.
    static constexpr std::size_t kMaxFaces = 32;

    struct Font {
        std::string path;
        std::shared_ptr<const std::vector<std::byte>> file;  ///< outlives the face, which reads from it
        int pixels;
        FontFace face;
    };

    std::map<std::string, std::shared_ptr<const std::vector<std::byte>>, std::less<>> files_;
    HandleTable<FontId, Font> fonts_;
    std::map<std::pair<std::string, int>, FontId> by_path_;
    std::map<std::pair<std::uint32_t, int>, FontFace> drawing_faces_;  ///< by font index and pixels
};

}  // namespace cairn::engine
