// The curves, each as its slow start; the other sides are mirrored from it.
#include "bind/easing.h"

#include <cmath>

#include <cairn/physics/math.h>
#include <cairn/scripting/suggest.h>

namespace cairn::scripting {
namespace {

namespace exact = physics::deterministic;

constexpr double kPi = 3.14159265358979323846;

constexpr std::string_view kCurveNames[kEaseCurveCount] = {
    "linear", "quad", "cubic", "quart", "quint", "sine", "expo", "circ", "back", "elastic", "bounce"};
constexpr std::string_view kSideNames[] = {"in", "out", "in_out"};

/// A ball that falls to 1 and bounces three times, each time a quarter as high.
double bounce_out(double t) {
    // The parabolas meet the ground at 4/11, 8/11 and 10/11.
    constexpr double kSteepness = 7.5625;  // (11/4)^2: the first reaches 1 at 4/11
    if (t < 4 / 11.0) return kSteepness * t * t;
    const auto arc = [&](double middle, double height) {
        return kSteepness * (t - middle) * (t - middle) + height;
    };
    if (t < 8 / 11.0) return arc(6 / 11.0, 0.75);
    if (t < 10 / 11.0) return arc(9 / 11.0, 0.9375);
    return arc(10.5 / 11.0, 0.984375);
}

double ease_in(EaseCurve curve, double t) {
    switch (curve) {
        case EaseCurve::Linear:
            return t;
        case EaseCurve::Quad:
            return t * t;
        case EaseCurve::Cubic:
            return t * t * t;
        case EaseCurve::Quart:
            return t * t * t * t;
        case EaseCurve::Quint:
            return t * t * t * t * t;
        case EaseCurve::Sine:
            return 1 - exact::cos(t * kPi / 2);
        case EaseCurve::Expo:
            // Shifted so that it begins at 0 and not at 2^-10.
            return (exact::pow(2, 10 * t) - 1) / 1023;
        case EaseCurve::Circ:
            return 1 - std::sqrt(1 - t * t);
        case EaseCurve::Back: {
            constexpr double kOvershoot = 1.70158;  // a tenth of the way
            return t * t * ((kOvershoot + 1) * t - kOvershoot);
        }
        case EaseCurve::Elastic:
            return -exact::pow(2, 10 * (t - 1)) * exact::sin((t - 1.075) * (2 * kPi) / 0.3);
        case EaseCurve::Bounce:
            return 1 - bounce_out(1 - t);
    }
    return t;
}

}  // namespace

double eased(Ease ease, double t) {
    if (!(t > 0)) return 0;  // exactly, where a curve is only near it
    if (t >= 1) return 1;
    switch (ease.side) {
        case EaseSide::In:
            return ease_in(ease.curve, t);
        case EaseSide::Out:
            return 1 - ease_in(ease.curve, 1 - t);
        case EaseSide::InOut:
            return t < 0.5 ? ease_in(ease.curve, 2 * t) / 2 : 1 - ease_in(ease.curve, 2 - 2 * t) / 2;
    }
    return t;
}

const std::vector<std::string>& ease_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list = {"linear"};
        for (int curve = 1; curve < kEaseCurveCount; ++curve)
            for (const std::string_view side : kSideNames)
                list.push_back(std::string(kCurveNames[curve]) + '_' + std::string(side));
        return list;
    }();
    return names;
}

std::string no_such_ease(std::string_view name) {
    std::string text = "no such ease" + suggestion(name, ease_names()) + " (linear, or ";
    for (int curve = 1; curve < kEaseCurveCount; ++curve)
        text += (curve > 1 ? ", " : "") + std::string(kCurveNames[curve]);
    return text + " with _in, _out or _in_out)";
}

std::optional<Ease> ease_from_name(std::string_view name) {
    if (name == "linear") return Ease{EaseCurve::Linear, EaseSide::In};
    const std::size_t split = name.find('_');
    if (split == std::string_view::npos) return std::nullopt;
    for (int curve = 1; curve < kEaseCurveCount; ++curve)
        for (int side = 0; side < 3; ++side)
            if (name.substr(0, split) == kCurveNames[curve] && name.substr(split + 1) == kSideNames[side])
                return Ease{static_cast<EaseCurve>(curve), static_cast<EaseSide>(side)};
    return std::nullopt;
}

}  // namespace cairn::scripting
