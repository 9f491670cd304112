#include <cairn/engine/printable.h>

namespace cairn::engine {

std::string printable(std::string_view text) {
    std::string out;
    give_printable(text, [&](std::string_view part) { out.append(part); });
    return out;
}

}  // namespace cairn::engine
