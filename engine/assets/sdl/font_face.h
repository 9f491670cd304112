// One font at one pixel size: measures characters and turns them into pictures.
// Invariant: no window and no renderer is involved, so text has the same measure in every back-end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <cairn/engine/image.h>
#include <cairn/engine/result.h>

struct _TTF_Font;

namespace cairn::engine {

class FontFace {
  public:
    /// The file's bytes must outlive the face. `name` is for the error message.
    static Result<FontFace> open(const std::vector<std::byte>& file, int pixels, std::string_view name);

    int ascent() const;
    int line_height() const;
    bool has(char32_t character) const;
    /// How far the pen moves; a character that the font lacks moves it like the font's mark for missing ones.
    int advance(char32_t character) const;
    int kerning(char32_t left, char32_t right) const;

    /// White pixels whose alpha is the coverage; without area for blanks.
    struct Glyph {
        Image image;
        int left = 0;  ///< of the image, from the pen
        int top = 0;   ///< of the image, from the line's top
    };
    Result<Glyph> rasterize(char32_t character) const;

  private:
    struct Close {
        void operator()(_TTF_Font* font) const;
    };
    explicit FontFace(_TTF_Font* font) : font_(font) {}

    std::unique_ptr<_TTF_Font, Close> font_;
};

}  // namespace cairn::engine
