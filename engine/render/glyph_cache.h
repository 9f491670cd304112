// Pictures of characters, packed into a few textures.
// Invariant: at most kMaxPages textures are in use. When they are full, all is thrown away and built up again
// from what the next texts need, which costs one slow frame and no bookkeeping.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include <cairn/engine/handle.h>

#include "assets/sdl/font_face.h"
#include "render/batch.h"

namespace cairn::engine {

class GlyphCache {
  public:
    GlyphCache(RenderBackend& backend, Batch& batch) : backend_(backend), batch_(batch) {}

    struct Entry {
        BackendTexture texture = 0;
        Rect uv;
        int left = 0;  ///< of the picture, from the pen
        int top = 0;   ///< of the picture, from the line's top
        Size size;     ///< of the picture in pixels; without area for blanks
    };

    /// Absent when the character cannot be drawn: the reason is logged.
    std::optional<Entry> find(FontId font, int pixels, const FontFace& face, char32_t character);

  private:
    static constexpr int kPageSide = 1024;
    static constexpr std::size_t kMaxPages = 4;

    /// Fills a page with rows ("shelves") from the top; a row is as high as the highest picture in it.
    struct Page {
        BackendTexture texture = 0;
        int shelf_top = 0;
        int shelf_height = 0;
        int shelf_used = 0;
    };
    struct Place {
        BackendTexture texture;
        int x;
        int y;
    };

    std::optional<Place> place_on(Page& page, Size size);
    std::optional<Place> find_place(Size size);
    void clear();

    RenderBackend& backend_;
    Batch& batch_;
    std::vector<Page> pages_;
    std::map<std::tuple<std::uint32_t, int, char32_t>, Entry> entries_;  ///< by font index, pixels, character
};

}  // namespace cairn::engine
