// Ranges in words.
#include "bind/range.h"

#include <cstdio>

namespace cairn::scripting {
namespace {

std::string short_number(double value) {
    constexpr double kReadable = 1e10;
    const bool is_whole = std::fabs(value) < kReadable && value == std::trunc(value);
    char text[32];
    std::snprintf(text, sizeof text, is_whole ? "%.0f" : "%.7g", value);
    return text;
}

}  // namespace

std::string to_text(const Range& range) {
    if (range.has_low() && range.has_high() && !range.excludes_low)
        return "from " + short_number(range.low) + " to " + short_number(range.high);
    std::string text;
    if (range.has_low()) text = (range.excludes_low ? "above " : "at least ") + short_number(range.low);
    if (range.has_high()) text += (text.empty() ? "at most " : " and at most ") + short_number(range.high);
    return text;
}

}  // namespace cairn::scripting
