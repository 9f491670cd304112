#include "text.h"

#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace cairn::measure {

std::string format(const char* pattern, ...) {
    char text[1001];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

double rounded(double value) {
    return std::strtod(format("%.6g", value).c_str(), nullptr);
}

physics::Result<int> number_of(const char* option, const std::string& text, int low, int high) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number < low || number > high) {
        return physics::Error{std::string(option) + " is \"" + text + "\", but must be a whole number from " +
                              std::to_string(low) + " to " + std::to_string(high)};
    }
    return number;
}

}  // namespace cairn::measure
