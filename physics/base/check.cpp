// Wording of errors about numbers.
#include "base/check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace cairn::physics::check {
namespace {

Fault fault(const char* field, const std::string& value, const std::string& rule) {
    return Error{std::string(field) + " is " + value + ", but must be " + rule};
}

std::string pair(double x, double y) {
    return std::string("(").append(number(x)).append(", ").append(number(y)) + ")";
}

}  // namespace

std::string number(double value) {
    std::array<char, 32> text{};
    const float narrow = static_cast<float>(value);
    const auto end = static_cast<double>(narrow) == value
                         ? std::to_chars(text.data(), text.data() + text.size(), narrow).ptr
                         : std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

Fault finite(const char* field, double value) {
    if (std::isfinite(value)) return {};
    return fault(field, number(value), "finite");
}

Fault finite(const char* field, Vec2 value) {
    if (is_finite(value)) return {};
    return fault(field, pair(static_cast<double>(value.x), static_cast<double>(value.y)), "finite");
}

Fault finite(const char* field, Position value) {
    if (is_finite(value)) return {};
    return fault(field, pair(value.x, value.y), "finite");
}

Fault placed(const char* field, Position value) {
    if (auto fault = finite(field, value)) return fault;
    const double farthest = std::max(std::fabs(value.x), std::fabs(value.y));
    return require(farthest <= kFarthest_m, field, farthest, "within 1e12 m of the world's origin");
}

Fault positive(const char* field, double value) {
    if (std::isfinite(value) && value > 0) return {};
    return fault(field, number(value), "finite and greater than 0");
}

Fault not_negative(const char* field, double value) {
    if (std::isfinite(value) && value >= 0) return {};
    return fault(field, number(value), "finite and at least 0");
}

Fault within(const char* field, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    return fault(field, number(value), "from " + number(low) + " to " + number(high));
}

Fault require(bool holds, const char* field, double value, const char* rule) {
    if (holds) return {};
    return fault(field, number(value), rule);
}

Fault first_of(std::initializer_list<Fault> faults) {
    for (const Fault& f : faults) {
        if (f) return f;
    }
    return {};
}

}  // namespace cairn::physics::check
