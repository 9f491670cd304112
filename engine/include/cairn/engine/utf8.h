// Reads UTF-8 one character at a time.
// Invariant: every byte is consumed exactly once; what is not valid UTF-8 gives U+FFFD, one per bad byte.
// Source: The Unicode Standard 15, table 3-7 (well-formed UTF-8 byte sequences).
#pragma once

#include <string_view>

namespace cairn::engine {

/// Takes the first character off `text`, which must not be empty.
char32_t take_character(std::string_view& text);

}  // namespace cairn::engine
