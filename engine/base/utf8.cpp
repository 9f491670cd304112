// UTF-8 decoding. Invariant: overlong forms, surrogates and values above U+10FFFF are refused.
#include <cassert>

#include <cairn/engine/utf8.h>

namespace cairn::engine {

char32_t take_character(std::string_view& text) {
    assert(!text.empty());
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    constexpr char32_t kReplacement = 0xfffd;

    const unsigned lead = byte(0);
    // Length of the sequence, the lead byte's own bits, and the least value that needs this length.
    std::size_t length = 1;
    char32_t value = lead;
    char32_t least = 0;
    if (lead >= 0xf0 && lead < 0xf8) {
        length = 4, value = lead & 0x07, least = 0x10000;
    } else if (lead >= 0xe0) {
        length = 3, value = lead & 0x0f, least = 0x800;
    } else if (lead >= 0xc0) {
        length = 2, value = lead & 0x1f, least = 0x80;
    }
    bool valid = lead < 0x80 || (lead >= 0xc0 && lead < 0xf8);
    valid = valid && length <= text.size();
    for (std::size_t i = 1; valid && i < length; ++i) {
        valid = (byte(i) & 0xc0) == 0x80;
        value = value << 6 | (byte(i) & 0x3f);
    }
    valid = valid && value >= least && value <= 0x10ffff && !(value >= 0xd800 && value < 0xe000);
    if (!valid) {
        text.remove_prefix(1);
        return kReplacement;
    }
    text.remove_prefix(length);
    return value;
}

}  // namespace cairn::engine
