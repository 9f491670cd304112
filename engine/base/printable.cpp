#include <cstdio>

#include <cairn/engine/printable.h>

namespace cairn::engine {

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const ShownCharacter c = take_shown(text);
        if (c.is_printable || c.bytes == "\n" || c.bytes == "\t") {
            out.append(c.bytes);
            continue;
        }
        for (const char byte : c.bytes) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\%03d", static_cast<unsigned char>(byte));
            out.append(escape);
        }
    }
    return out;
}

}  // namespace cairn::engine
