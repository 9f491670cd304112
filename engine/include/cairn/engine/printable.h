// Texts that anybody may have given, for messages: a terminal obeys control characters, and shows nothing of
// what is no UTF-8. Invariant: what is shown as it is are whole characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <cairn/engine/utf8.h>

namespace cairn::engine {

struct ShownCharacter {
    std::string_view bytes;
    bool is_printable;  ///< no control character, and no byte that is none of UTF-8
};

/// Takes the first character off a text, which must not be empty.
inline ShownCharacter take_shown(std::string_view& text) {
    const std::string_view before = text;
    const char32_t c = take_character(text);
    const std::string_view bytes = before.substr(0, before.size() - text.size());
    const bool is_broken = bytes.size() == 1 && static_cast<unsigned char>(bytes[0]) >= 0x80;
    return {bytes, !is_broken && c >= 0x20 && !(c >= 0x7f && c < 0xa0)};
}

/// Gives `append` the text in parts, with decimal escapes for what is not printable; ends of lines and tabs
/// stay.
template <class Append>
void give_printable(std::string_view text, const Append& append) {
    while (!text.empty()) {
        const ShownCharacter c = take_shown(text);
        if (c.is_printable || c.bytes == "\n" || c.bytes == "\t") {
            append(c.bytes);
            continue;
        }
        for (const char byte : c.bytes) {
            const int code = static_cast<unsigned char>(byte);
            const char escape[] = {'\\', static_cast<char>('0' + code / 100),
                                   static_cast<char>('0' + code / 10 % 10),
                                   static_cast<char>('0' + code % 10)};
            append(std::string_view(escape, sizeof escape));
        }
    }
}

/// All of it.
std::string printable(std::string_view text);

/// The beginning of a text: as many whole characters as that many bytes hold.
inline std::string_view beginning_of(std::string_view text, std::size_t most_bytes) {
    std::string_view rest = text;
    std::size_t length = 0;
    while (!rest.empty()) {
        const std::size_t next = length + take_shown(rest).bytes.size();
        if (next > most_bytes) break;
        length = next;
    }
    return text.substr(0, length);
}

}  // namespace cairn::engine
