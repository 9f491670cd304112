// How values move from one end to the other in time. Invariant: every curve takes 0 to 0 and 1 to 1, and
// gives the same bits on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cairn::scripting {

enum class EaseCurve : std::uint8_t {
    Linear,
    Quad,
    Cubic,
    Quart,
    Quint,
    Sine,
    Expo,
    Circ,
    Back,
    Elastic,
    Bounce
};
inline constexpr int kEaseCurveCount = static_cast<int>(EaseCurve::Bounce) + 1;

/// Where the curve is slow.
enum class EaseSide : std::uint8_t {
    In,     ///< at the start
    Out,    ///< at the end
    InOut,  ///< at both
};

struct Ease {
    EaseCurve curve = EaseCurve::Quad;
    EaseSide side = EaseSide::Out;
};

/// Of t in 0 .. 1. Source: R. Penner, "Programming Macromedia Flash MX", 2002, chapter 7.
double eased(Ease ease, double t);

/// "linear", "quad_in", "bounce_out", "sine_in_out", ...
std::optional<Ease> ease_from_name(std::string_view name);
const std::vector<std::string>& ease_names();
/// What is wrong with a name that is none: the nearest one, and how all of them are made up, which are too
/// many to be listed.
std::string no_such_ease(std::string_view name);

}  // namespace cairn::scripting
