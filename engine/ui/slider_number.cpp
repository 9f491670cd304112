// Digits are of one width in few fonts, so both ends are measured.
#include "ui/slider_number.h"

#include <algorithm>
#include <cstdio>

namespace cairn::engine {

std::string number_text(double value, double step) {
    constexpr int kMostDigits = 6;
    int digits = 0;
    for (double unit = 1; step < 0.999 * unit && digits < kMostDigits; unit /= 10) ++digits;
    char text[400];  // the largest double has 309 digits
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

float number_width(const Renderer& renderer, FontId font, const Widget& slider) {
    constexpr float kLeast = 48;  // short numbers of several sliders stand below each other
    const auto width_of = [&](double value) {
        return renderer.measure_text(font, number_text(value, slider.step)).x;
    };
    return std::max({kLeast, width_of(slider.low), width_of(slider.high)});
}

}  // namespace cairn::engine
