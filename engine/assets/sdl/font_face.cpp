// Fonts by SDL2_ttf. Invariant: SDL_ttf starts with the first font that is opened and is left running:
// stopping it while a font is open is undefined, and starting it again costs more than it holds.
#include "assets/sdl/font_face.h"

#include <SDL_ttf.h>
#include <algorithm>
#include <string>

#include "assets/font_check.h"

namespace cairn::engine {
namespace {

/// SDL_ttf renders nothing for the character 0, and surrogates are no characters.
Uint32 drawable(char32_t character) {
    constexpr Uint32 kReplacement = 0xfffd;
    return character == 0 || (character >= 0xd800 && character < 0xe000) ? kReplacement : character;
}

/// Cuts a picture down to the part that is not transparent, so that the glyph cache holds no empty margins.
FontFace::Glyph trimmed(const SDL_Surface& surface) {
    const auto alpha = [&](int x, int y) {
        return static_cast<const std::uint8_t*>(
            surface.pixels)[static_cast<std::size_t>(y) * surface.pitch + 4 * x + 3];
    };
    int left = surface.w, top = surface.h, right = 0, bottom = 0;
    for (int y = 0; y < surface.h; ++y)
        for (int x = 0; x < surface.w; ++x)
            if (alpha(x, y) > 0) {
                left = std::min(left, x);
                right = std::max(right, x + 1);
                top = std::min(top, y);
                bottom = std::max(bottom, y + 1);
            }
    FontFace::Glyph glyph;
    if (left >= right) return glyph;
    glyph.left = left;
    glyph.top = top;
    glyph.image.size = {right - left, bottom - top};
    glyph.image.rgba.reserve(4 * static_cast<std::size_t>(right - left) * (bottom - top));
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) glyph.image.rgba.insert(glyph.image.rgba.end(), 4, alpha(x, y));
    return glyph;
}

}  // namespace

void FontFace::Close::operator()(_TTF_Font* font) const {
    TTF_CloseFont(font);
}

Result<FontFace> FontFace::open(const std::vector<std::byte>& file, int pixels, std::string_view name) {
    if (!TTF_WasInit() && TTF_Init() != 0)
        return Error{std::string("SDL_ttf does not start: ") + TTF_GetError()};
    if (const std::string fault = font_fault(file); !fault.empty())
        return Error{"font '" + std::string(name) + "': " + fault};
    SDL_RWops* stream = SDL_RWFromConstMem(file.data(), static_cast<int>(file.size()));
    TTF_Font* font = stream ? TTF_OpenFontRW(stream, /*freesrc=*/1, pixels) : nullptr;
    if (!font) return Error{"font '" + std::string(name) + "': is no readable font: " + TTF_GetError()};
    // Light hinting sharpens the horizontal strokes and leaves the letters' widths alone.
    TTF_SetFontHinting(font, TTF_HINTING_LIGHT);
    return FontFace(font);
}

int FontFace::ascent() const {
    return TTF_FontAscent(font_.get());
}
int FontFace::line_height() const {
    return TTF_FontLineSkip(font_.get());
}
bool FontFace::has(char32_t character) const {
    return TTF_GlyphIsProvided32(font_.get(), drawable(character)) != 0;
}

int FontFace::advance(char32_t character) const {
    int advance = 0;
    TTF_GlyphMetrics32(font_.get(), drawable(character), nullptr, nullptr, nullptr, nullptr, &advance);
    return advance;
}

int FontFace::kerning(char32_t left, char32_t right) const {
    return TTF_GetFontKerningSizeGlyphs32(font_.get(), drawable(left), drawable(right));
}

Result<FontFace::Glyph> FontFace::rasterize(char32_t character) const {
    SDL_Surface* blended = TTF_RenderGlyph32_Blended(font_.get(), drawable(character), {255, 255, 255, 255});
    if (!blended) return Glyph{};  // a blank without width, such as U+200B
    SDL_Surface* rgba = SDL_ConvertSurfaceFormat(blended, SDL_PIXELFORMAT_RGBA32, 0);
    SDL_FreeSurface(blended);
    if (!rgba) return Error{std::string("cannot draw a character: ") + SDL_GetError()};
    Glyph glyph = trimmed(*rgba);
    SDL_FreeSurface(rgba);
    // SDL_ttf starts the picture at the pen, or at the glyph's left edge where that lies before the pen.
    int min_x = 0;
    TTF_GlyphMetrics32(font_.get(), drawable(character), &min_x, nullptr, nullptr, nullptr, nullptr);
    glyph.left += std::min(min_x, 0);
    return glyph;
}

}  // namespace cairn::engine
