// Breaks text into lines and places its characters.
// Invariant: it uses the font's measures at its nominal size only, never the output's scale, so that a text
// breaks at the same places in every window and in a headless run.
#pragma once

#include <string_view>
#include <vector>

#include "assets/sdl/font_face.h"

namespace cairn::engine {

struct PlacedCharacter {
    char32_t character = 0;
    float x = 0;    ///< of the pen, from the line's left end
    int index = 0;  ///< in the text, counted in characters, line ends too
};

struct TextLine {
    std::vector<PlacedCharacter> characters;
    float width = 0;
};

/// At least one line. Lines end at '\n' and, with a wrap_width above 0, at the last space before they get
/// wider; a word that is wider by itself is broken between two characters. Spaces at which a line is broken
/// count nowhere.
std::vector<TextLine> layout_text(const FontFace& font, std::string_view text, float wrap_width);

}  // namespace cairn::engine
