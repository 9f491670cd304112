// Angles of many rotations at once. Invariant: each lane does what deterministic::atan2 does with finite
// numbers, operation by operation, so the bits are those of Rotation::angle_rad at every width.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "base/angles.cpp"
#include <array>
#include <cstddef>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <span>

#include <cairn/physics/math.h>

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V = hn::Vec<D>>
V half_angle(D d, V tangent) {
    const V one = hn::Set(d, 1.0);
    return hn::Div(tangent, hn::Add(one, hn::Sqrt(hn::Add(one, hn::Mul(tangent, tangent)))));
}

// Of tangents in 0 .. 1.
template <class D, class V = hn::Vec<D>>
V atan_unit(D d, V tangent) {
    const V t = half_angle(d, half_angle(d, tangent));
    const V z = hn::Mul(t, t);
    V sum = hn::Zero(d);
    for (int k = 17; k >= 1; k -= 2) sum = hn::Sub(hn::Set(d, 1.0 / k), hn::Mul(z, sum));
    return hn::Mul(hn::Set(d, 4.0), hn::Mul(t, sum));
}

template <class D, class V = hn::Vec<D>>
V atan2(D d, V y, V x) {
    const V ax = hn::Abs(x);
    const V ay = hn::Abs(y);
    const auto is_steep = hn::Gt(ay, ax);
    const V zero = hn::Zero(d);
    const V larger = hn::IfThenElse(is_steep, ay, ax);
    const V unit = atan_unit(d, hn::Div(hn::IfThenElse(is_steep, ax, ay), larger));
    V angle = hn::IfThenElse(is_steep, hn::Sub(hn::Set(d, 1.57079632679489661923), unit), unit);
    angle = hn::IfThenElse(hn::Eq(larger, zero), zero, angle);
    // Of the sign bit, because the angle of (-0, 0) is pi.
    const auto is_left = hn::Lt(hn::CopySign(hn::Set(d, 1.0), x), zero);
    angle = hn::IfThenElse(is_left, hn::Sub(hn::Set(d, 3.14159265358979323846), angle), angle);
    return hn::CopySign(angle, y);
}

void find_angles(const Rotation* rotations, std::size_t count, float* out) {
    constexpr std::size_t kLanes = 8;
    const hn::CappedTag<double, kLanes> d;
    HWY_ALIGN std::array<double, kLanes> x{};
    HWY_ALIGN std::array<double, kLanes> y{};
    HWY_ALIGN std::array<double, kLanes> angle{};
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::size_t some = count - i < kLanes ? count - i : kLanes;
        for (std::size_t lane = 0; lane < some; ++lane) {
            x[lane] = static_cast<double>(rotations[i + lane].c);
            y[lane] = static_cast<double>(rotations[i + lane].s);
        }
        for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d))
            hn::Store(atan2(d, hn::Load(d, y.data() + lane), hn::Load(d, x.data() + lane)), d,
                      angle.data() + lane);
        for (std::size_t lane = 0; lane < some; ++lane) out[i + lane] = static_cast<float>(angle[lane]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {
namespace {

HWY_EXPORT(find_angles);

}  // namespace

void angles_rad(std::span<const Rotation> rotations, std::span<float> out) {
    HWY_DYNAMIC_DISPATCH(find_angles)(rotations.data(), rotations.size(), out.data());
}

}  // namespace cairn::physics
#endif
