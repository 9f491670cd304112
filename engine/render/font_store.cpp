// Loading and keeping fonts. Invariant: a font's file is read once, however many sizes of it are used, and
// stays in memory because its faces read from it.
#include "render/font_store.h"

#include <algorithm>
#include <cmath>

#include <cairn/engine/log.h>

namespace cairn::engine {

Result<FontId> FontStore::load(const Files& files, std::string_view path, float size) {
    const std::string name(path);
    if (!(size >= kMinPixels && size <= kMaxPixels))
        return Error{"font '" + name + "': size " + std::to_string(size) + " must be in " +
                     std::to_string(kMinPixels) + " .. " + std::to_string(kMaxPixels)};
    const int pixels = static_cast<int>(std::lround(size));
    if (const auto known = by_path_.find({name, pixels}); known != by_path_.end()) return known->second;

    auto file = files_.find(name);
    if (file == files_.end()) {
        Result<std::vector<std::byte>> bytes = files.read_bytes(path);
        if (!bytes) return Error{"font '" + name + "' cannot be loaded: " + bytes.error().message};
        file = files_.emplace(name, std::make_shared<const std::vector<std::byte>>(std::move(*bytes))).first;
    }
    Result<FontFace> face = FontFace::open(*file->second, pixels, path);
    if (!face) {
        files_.erase(file);
        return face.error();
    }
    const FontId id = fonts_.insert({name, file->second, pixels, std::move(*face)});
    by_path_[{name, pixels}] = id;
    return id;
}

void FontStore::forget_files(std::string_view prefix) {
    std::erase_if(files_, [&](const auto& known) { return known.first.starts_with(prefix); });
    std::erase_if(by_path_, [&](const auto& known) { return known.first.first.starts_with(prefix); });
}

const FontFace* FontStore::nominal(FontId font) const {
    const Font* found = fonts_.find(font);
    return found ? &found->face : nullptr;
}

int FontStore::nominal_pixels(FontId font) const {
    const Font* found = fonts_.find(font);
    return found ? found->pixels : 0;
}

const FontFace* FontStore::at_pixels(FontId id, int pixels) {
    const Font* font = fonts_.find(id);
    if (!font) return nullptr;
    if (pixels == font->pixels) return &font->face;
    const std::pair key{id.index, pixels};
    if (const auto known = drawing_faces_.find(key); known != drawing_faces_.end()) return &known->second;
    if (drawing_faces_.size() >= kMaxFaces) drawing_faces_.clear();
    Result<FontFace> face = FontFace::open(*font->file, pixels, font->path);
    if (!face) {
        log(LogLevel::Error, face.error().message);
        return nullptr;
    }
    return &drawing_faces_.emplace(key, std::move(*face)).first->second;
}

}  // namespace cairn::engine
