// Greedy line breaking. Invariant: every character of the text is on exactly one line, except '\n', '\r' and
// the spaces at which a line was broken.
#include "render/text_layout.h"

#include <algorithm>
#include <utility>

#include <cairn/engine/utf8.h>

namespace cairn::engine {
namespace {

/// A tab is this many spaces: there are no tab stops in a text whose letters differ in width.
constexpr int kTabSpaces = 4;

class LineBreaker {
  public:
    LineBreaker(const FontFace& font, float wrap_width) : font_(font), wrap_width_(wrap_width) {}

    void add(char32_t character) {
        const int index = next_index_++;
        if (character == '\r') return;
        if (character == '\n') {
            end_line();
        } else if (character == '\t') {
            for (int i = 0; i < kTabSpaces; ++i) append(' ', index);
        } else {
            append(character, index);
            const bool too_wide = wrap_width_ > 0 && line_.width > wrap_width_;
            if (too_wide && character != ' ' && line_.characters.size() > 1) break_line();
        }
    }

    std::vector<TextLine> finish() {
        end_line();
        return std::move(lines_);
    }

  private:
    void append(char32_t character, int index) {
        if (!line_.characters.empty())
            line_.width += static_cast<float>(font_.kerning(line_.characters.back().character, character));
        line_.characters.push_back({character, line_.width, index});
        line_.width += static_cast<float>(font_.advance(character));
    }

    /// The line is too wide: what follows its last space, or else its last character, starts the next line.
    void break_line() {
        std::vector<PlacedCharacter>& characters = line_.characters;
        const auto is_space = [](const PlacedCharacter& c) { return c.character == ' '; };
        auto tail_begin = std::find_if(characters.rbegin(), characters.rend(), is_space).base();
        if (tail_begin == characters.begin()) tail_begin = characters.end() - 1;
        const std::vector<PlacedCharacter> tail(tail_begin, characters.end());
        characters.erase(tail_begin, characters.end());

        // The pen stood at the tail's start when the line ended; spaces before it do not count.
        line_.width = tail.front().x;
        while (!characters.empty() && is_space(characters.back())) {
            line_.width = characters.back().x;
            characters.pop_back();
        }
        end_line();
        for (const PlacedCharacter& c : tail) append(c.character, c.index);
    }

    void end_line() { lines_.push_back(std::exchange(line_, {})); }

    const FontFace& font_;
    float wrap_width_;
    int next_index_ = 0;
    TextLine line_;
    std::vector<TextLine> lines_;
};

}  // namespace

std::vector<TextLine> layout_text(const FontFace& font, std::string_view text, float wrap_width) {
    LineBreaker breaker(font, wrap_width);
    while (!text.empty()) breaker.add(take_character(text));
    return breaker.finish();
}

}  // namespace cairn::engine
