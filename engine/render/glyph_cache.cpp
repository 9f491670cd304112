// The packing of characters into textures. Invariant: pictures are a pixel apart, and what lies between them
// is transparent, so that linear filtering does not mix neighbours.
#include "render/glyph_cache.h"

#include <algorithm>

#include <cairn/engine/log.h>

namespace cairn::engine {
namespace {

Image blank_page(int side) {
    Image image{{side, side}, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(side) * side, 0);
    return image;
}

}  // namespace

std::optional<GlyphCache::Entry> GlyphCache::find(FontId font, int pixels, const FontFace& face,
                                                  char32_t character) {
    const std::tuple key{font.index, pixels, character};
    if (const auto known = entries_.find(key); known != entries_.end()) return known->second;

    const Result<FontFace::Glyph> glyph = face.rasterize(character);
    if (!glyph) {
        log(LogLevel::Error, glyph.error().message);
        return std::nullopt;
    }
    Entry entry;
    entry.left = glyph->left;
    entry.top = glyph->top;
    entry.size = glyph->image.size;
    if (entry.size.width > 0) {
        const std::optional<Place> place = find_place(entry.size);
        if (!place) return std::nullopt;
        backend_.update_texture(place->texture, place->x, place->y, glyph->image);
        constexpr float kTexel = 1.0f / kPageSide;
        entry.texture = place->texture;
        entry.uv = {static_cast<float>(place->x) * kTexel, static_cast<float>(place->y) * kTexel,
                    static_cast<float>(entry.size.width) * kTexel,
                    static_cast<float>(entry.size.height) * kTexel};
    }
    entries_[key] = entry;
    return entry;
}

std::optional<GlyphCache::Place> GlyphCache::place_on(Page& page, Size size) {
    constexpr int kGap = 1;
    if (page.shelf_used + size.width + kGap > kPageSide) {
        page.shelf_top += page.shelf_height;
        page.shelf_height = 0;
        page.shelf_used = 0;
    }
    if (size.width + kGap > kPageSide || page.shelf_top + size.height + kGap > kPageSide) return std::nullopt;
    const Place place{page.texture, page.shelf_used, page.shelf_top};
    page.shelf_used += size.width + kGap;
    page.shelf_height = std::max(page.shelf_height, size.height + kGap);
    return place;
}

std::optional<GlyphCache::Place> GlyphCache::find_place(Size size) {
    if (!pages_.empty())
        if (const std::optional<Place> place = place_on(pages_.back(), size)) return place;
    if (pages_.size() == kMaxPages) clear();
    const Result<BackendTexture> texture =
        backend_.create_texture(blank_page(kPageSide), TextureFilter::Linear);
    if (!texture) {
        log(LogLevel::Error, texture.error().message);
        return std::nullopt;
    }
    pages_.emplace_back().texture = *texture;
    return place_on(pages_.back(), size);
}

void GlyphCache::clear() {
    batch_.flush();  // its triangles still show the pictures that go
    for (const Page& page : pages_) backend_.destroy_texture(page.texture);
    pages_.clear();
    entries_.clear();
}

}  // namespace cairn::engine
