// Text of the tools that measure: formatted lines, numbers as they are written down and as they were typed.
#pragma once

#include <string>

#include <cairn/physics/result.h>

namespace cairn::measure {

/// As std::printf does, up to 1,000 characters.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

/// To six significant digits: more than a clock gives. NaN and infinity stay what they are.
double rounded(double value);

/// The whole number that was typed for an option, or what it must be.
physics::Result<int> number_of(const char* option, const std::string& text, int low, int high);

}  // namespace cairn::measure
