// What numbers a parameter or a field may be. Invariant: a range is written once, where the parameter or the
// field is described; the check, its message and the reference come from there.
#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace cairn::scripting {

/// From `low` to `high`; unless widened, finite numbers. NaN lies in no range.
struct Range {
    double low = std::numeric_limits<double>::lowest();
    double high = std::numeric_limits<double>::max();
    bool excludes_low = false;

    [[nodiscard]] constexpr bool contains(double value) const {
        // Most numbers are kept in floats: what is above 0 must be so there.
        const double least = excludes_low ? low + std::numeric_limits<float>::min() : low;
        return value >= least && !(excludes_low && value <= low) && value <= high;
    }
    [[nodiscard]] constexpr bool has_low() const { return low > std::numeric_limits<double>::lowest(); }
    [[nodiscard]] constexpr bool has_high() const { return high < std::numeric_limits<double>::max(); }
    [[nodiscard]] constexpr bool is_finite() const { return high <= std::numeric_limits<double>::max(); }

    friend bool operator==(const Range&, const Range&) = default;
};

/// "from 0 to 1", "above 0 and at most 2000000", "at least 0"; empty where it only says that numbers are
/// finite.
std::string to_text(const Range& range);

/// Whether a number that is kept in a float would become infinite there.
inline bool is_beyond_float(double value) {
    return std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max()) && !std::isinf(value);
}
inline constexpr const char* kWithinFloat = "between -3.4e38 and 3.4e38";

// ---- Ranges of many things

inline constexpr Range kShare{0, 1};
inline constexpr Range kNotNegative{0};
inline constexpr Range kNotNegativeOrInfinite{0, std::numeric_limits<double>::infinity()};
inline constexpr Range kPositive{0, std::numeric_limits<double>::max(), true};
/// s, of an update or a step.
inline constexpr Range kStepTime{0, 1, true};

}  // namespace cairn::scripting
