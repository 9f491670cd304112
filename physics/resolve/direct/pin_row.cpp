// The passes over a row of pins, with whatever SIMD there is: a pass works on as many numbers at once as a
// register holds, and on the rest one by one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "resolve/direct/pin_row.cpp"
#include "resolve/direct/pin_row.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Wide = hn::CappedTag<double, 4>;
using One = hn::CappedTag<double, 1>;

// Calls work(tag, i) for all, where the tag says how many from i on.
template <class Work>
HWY_INLINE void for_each(std::size_t first, std::size_t last, const Work& work) {
    const std::size_t at_once = hn::Lanes(Wide());
    std::size_t i = first;
    for (; i + at_once <= last; i += at_once) work(Wide(), i);
    for (; i < last; ++i) work(One(), i);
}

template <class D>
HWY_INLINE hn::Vec<D> get(D d, const Values& values, std::size_t i) {
    return hn::LoadU(d, values.data() + i);
}
template <class D>
HWY_INLINE void put(D d, hn::Vec<D> v, Values& values, std::size_t i) {
    hn::StoreU(v, d, values.data() + i);
}

// By series, to the last digit where a body turns as little as in most steps.
void set_rotations(PinRow& row, std::size_t first, std::size_t last) {
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto n = [d](double x) HWY_ATTR { return hn::Set(d, x); };
        const auto x = get(d, row.turned, i);
        const auto z = x * x;
        auto sine = n(1.0 / 6227020800);
        for (const double c : {-1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6, 1.0})
            sine = n(c) + z * sine;
        auto cosine = n(-1.0 / 87178291200);
        for (const double c : {1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5, 1.0})
            cosine = n(c) + z * cosine;
        put(d, x * sine, row.sine, i);
        put(d, cosine, row.cosine, i);
    });
}

void advance_bodies(PinRow& row, double h_s, std::size_t first, std::size_t last) {
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto h = hn::Set(d, h_s);
        put(d, get(d, row.moved_x, i) + h * get(d, row.before.x, i), row.moved_x, i);
        put(d, get(d, row.moved_y, i) + h * get(d, row.before.y, i), row.moved_y, i);
        put(d, get(d, row.turned, i) + h * get(d, row.before.w, i), row.turned, i);
    });
}

void kick_bodies(PinRow& row, std::size_t first, std::size_t last) {
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        put(d, get(d, row.before.x, i) + get(d, row.kick.x, i), row.before.x, i);
        put(d, get(d, row.before.y, i) + get(d, row.kick.y, i), row.before.y, i);
        put(d, get(d, row.before.w, i) + get(d, row.kick.w, i), row.before.w, i);
    });
}

double find_fastest_spin(const PinRow& row, std::size_t first, std::size_t last) {
    double fastest = 0;
    auto fastest_of_many = hn::Zero(Wide());
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto spin = hn::Abs(get(d, row.before.w, i));
        if constexpr (hn::MaxLanes(decltype(d)()) == 1) {
            const double single = hn::GetLane(spin);
            if (single > fastest) fastest = single;
        } else {
            fastest_of_many = hn::IfThenElse(spin > fastest_of_many, spin, fastest_of_many);
        }
    });
    const double many = hn::GetLane(hn::MaxOfLanes(Wide(), fastest_of_many));
    return many > fastest ? many : fastest;
}

// Four sums at any width, so that all add in the same order.
double sum_energies(const PinRow& row, const PinRow::Speeds& a, const PinRow::Speeds& b, std::size_t first,
                    std::size_t last) {
    constexpr std::size_t kSums = 4;
    const auto of = [&](auto d, std::size_t i) HWY_ATTR {
        return get(d, row.mass, i) * (get(d, a.x, i) * get(d, b.x, i) + get(d, a.y, i) * get(d, b.y, i)) +
               get(d, row.inertia, i) * (get(d, a.w, i) * get(d, b.w, i));
    };
    const Wide wide;
    double sums[kSums] = {};
    std::size_t k = first;
    for (; k + kSums <= last; k += kSums) {
        for (std::size_t i = 0; i < kSums; i += hn::Lanes(wide))
            hn::StoreU(hn::LoadU(wide, sums + i) + of(wide, k + i), wide, sums + i);
    }
    for (; k < last; ++k) sums[0] += hn::GetLane(of(One(), k));
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

bool are_impulses_within(const PinRow& row, double impulse) {
    bool within = true;
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto most = hn::Set(d, impulse);
        const auto x = hn::Abs(get(d, row.impulse_x, i)) <= most;
        const auto y = hn::Abs(get(d, row.impulse_y, i)) <= most;
        within = within && hn::AllTrue(d, hn::And(x, y));
    });
    return within;
}

template <class D>
HWY_INLINE hn::Vec<D> inertia_needed(D d, const PinRow& row, std::size_t i, double h_s,
                                     double fastest_rad_s) {
    const auto own = get(d, row.own_inertia, i);
    const auto more = hn::Set(d, h_s) * get(d, row.levers, i) - (own + own);
    const auto needed = own + hn::IfThenElse(more > hn::Zero(d), more, hn::Zero(d));
    const auto now = get(d, row.inertia, i);
    const auto least = hn::IfThenElse(now < needed, now, needed);
    return hn::IfThenElse(hn::Abs(get(d, row.before.w, i)) > hn::Set(d, fastest_rad_s), least, needed);
}

void choose_inertias(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last) {
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto needed = inertia_needed(d, row, i, h_s, fastest_rad_s);
        put(d, get(d, row.inertia, i), row.inertia_before, i);
        put(d, needed, row.inertia, i);
    });
}

bool enlarge_inertias(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last) {
    bool any = false;
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto needed = inertia_needed(d, row, i, h_s, fastest_rad_s);
        const auto now = get(d, row.inertia, i);
        const auto grows = needed > now + now;
        if (hn::AllFalse(d, grows)) return;
        put(d, hn::IfThenElse(grows, needed, now), row.inertia, i);
        any = true;
    });
    return any;
}

void settle_inertias(PinRow& row, std::size_t first, std::size_t last) {
    for_each(first, last, [&](auto d, std::size_t i) HWY_ATTR {
        const auto inertia = get(d, row.inertia, i);
        const auto before = get(d, row.inertia_before, i);
        const auto w = get(d, row.before.w, i);
        const auto turns = get(d, row.inverse_own_inertia, i) > hn::Zero(d);
        const auto inverse = hn::IfThenElseZero(turns, hn::Set(d, 1.0) / inertia);
        put(d, inverse, row.inverse_inertia, i);
        put(d, get(d, row.twist, i) * inverse, row.kick.w, i);
        const auto grew = inertia > before;
        put(d, hn::IfThenElse(grew, w * (before / inertia), w), row.before.w, i);
        put(d, hn::IfThenElse(grew, inertia, before), row.inertia_before, i);
    });
}

double place_pins(PinRow& row) {
    double greatest = 0;
    auto greatest_of_many = hn::Zero(Wide());
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto rotate = [d](const Values& cosines, const Values& sines, std::size_t body,
                                const Values& xs, const Values& ys, std::size_t joint, auto& x, auto& y)
                                HWY_ATTR {
                                    const auto c = get(d, cosines, body);
                                    const auto s = get(d, sines, body);
                                    const auto x0 = get(d, xs, joint);
                                    const auto y0 = get(d, ys, joint);
                                    x = c * x0 - s * y0;
                                    y = s * x0 + c * y0;
                                };
        hn::Vec<decltype(d)> bx, by, ax, ay;
        rotate(row.cosine, row.sine, i, row.start.before_x, row.start.before_y, i, bx, by);
        rotate(row.cosine, row.sine, i + 1, row.start.after_x, row.start.after_y, i, ax, ay);
        put(d, bx, row.arms.before_x, i);
        put(d, by, row.arms.before_y, i);
        put(d, ax, row.arms.after_x, i);
        put(d, ay, row.arms.after_y, i);
        const auto x =
            (get(d, row.moved_x, i + 1) - get(d, row.moved_x, i)) + get(d, row.offset_x, i) + (ax - bx);
        const auto y =
            (get(d, row.moved_y, i + 1) - get(d, row.moved_y, i)) + get(d, row.offset_y, i) + (ay - by);
        put(d, x, row.error_x, i);
        put(d, y, row.error_y, i);
        const auto size_x = hn::Abs(x);
        const auto size_y = hn::Abs(y);
        const auto error = hn::IfThenElse(size_x > size_y, size_x, size_y);
        if constexpr (hn::MaxLanes(decltype(d)()) == 1) {
            const double single = hn::GetLane(error);
            if (single > greatest) greatest = single;
        } else {
            greatest_of_many = hn::IfThenElse(error > greatest_of_many, error, greatest_of_many);
        }
    });
    const double many = hn::GetLane(hn::MaxOfLanes(Wide(), greatest_of_many));
    return many > greatest ? many : greatest;
}

void assemble_factors(const PinRow& row, double give, ChainFactors& factors) {
    const PinRow::Arms& arms = row.factored;
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto linear = get(d, row.inverse_mass, i) + get(d, row.inverse_mass, i + 1);
        const auto before = get(d, row.inverse_inertia, i);
        const auto after = get(d, row.inverse_inertia, i + 1);
        const auto bx = get(d, arms.before_x, i);
        const auto by = get(d, arms.before_y, i);
        const auto ax = get(d, arms.after_x, i);
        const auto ay = get(d, arms.after_y, i);
        const auto more = hn::Set(d, 1 + give);
        put(d, more * (linear + before * (by * by) + after * (ay * ay)), factors.xx, i);
        put(d, hn::Neg(before * (bx * by) + after * (ax * ay)), factors.xy, i);
        put(d, more * (linear + before * (bx * bx) + after * (ax * ax)), factors.yy, i);
    });
    for_each(0, row.joints() - 1, [&](auto d, std::size_t i) HWY_ATTR {
        const auto linear = get(d, row.inverse_mass, i + 1);
        const auto shared = get(d, row.inverse_inertia, i + 1);
        const auto bx = get(d, arms.before_x, i + 1);
        const auto by = get(d, arms.before_y, i + 1);
        const auto ax = get(d, arms.after_x, i);
        const auto ay = get(d, arms.after_y, i);
        put(d, hn::Neg(linear + shared * (ay * by)), factors.a, i);
        put(d, shared * (ay * bx), factors.b, i);
        put(d, shared * (ax * by), factors.c, i);
        put(d, hn::Neg(linear + shared * (ax * bx)), factors.d, i);
    });
}

void set_aims(PinRow& row, double rate, double fastest_m_s) {
    const PinRow::Arms& arms = row.factored;
    const PinRow::Speeds& v = row.before;
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto most = hn::Set(d, fastest_m_s);
        const auto closing = [&](const Values& errors) HWY_ATTR {
            const auto speed = hn::Set(d, rate) * get(d, errors, i);
            const auto capped = hn::IfThenElse(speed > most, most, speed);
            return hn::IfThenElse(capped < hn::Neg(most), hn::Neg(most), capped);
        };
        const auto w_before = get(d, v.w, i);
        const auto w_after = get(d, v.w, i + 1);
        const auto x = (get(d, v.x, i + 1) - w_after * get(d, arms.after_y, i)) -
                       (get(d, v.x, i) - w_before * get(d, arms.before_y, i));
        const auto y = (get(d, v.y, i + 1) + w_after * get(d, arms.after_x, i)) -
                       (get(d, v.y, i) + w_before * get(d, arms.before_x, i));
        put(d, hn::Neg(closing(row.error_x) + x), row.impulse_x, i);
        put(d, hn::Neg(closing(row.error_y) + y), row.impulse_y, i);
    });
}

void push_bodies(const PinRow& row, PinRow::Speeds& to) {
    const PinRow::Arms& arms = row.factored;
    // From the joint before and from the joint after, of which the ends have one.
    const auto push = [&](auto d, std::size_t k, auto has_before, auto has_after) HWY_ATTR {
        auto x = hn::Zero(d);
        auto y = hn::Zero(d);
        auto turn = hn::Zero(d);
        if constexpr (has_before()) {
            x = get(d, row.impulse_x, k - 1);
            y = get(d, row.impulse_y, k - 1);
            turn = get(d, arms.after_x, k - 1) * y - get(d, arms.after_y, k - 1) * x;
        }
        if constexpr (has_after()) {
            const auto back_x = get(d, row.impulse_x, k);
            const auto back_y = get(d, row.impulse_y, k);
            x = x - back_x;
            y = y - back_y;
            turn = turn - (get(d, arms.before_x, k) * back_y - get(d, arms.before_y, k) * back_x);
        }
        const auto inverse_mass = get(d, row.inverse_mass, k);
        put(d, get(d, to.x, k) + inverse_mass * x, to.x, k);
        put(d, get(d, to.y, k) + inverse_mass * y, to.y, k);
        put(d, get(d, to.w, k) + get(d, row.inverse_inertia, k) * turn, to.w, k);
    };
    using Yes = std::true_type;
    using No = std::false_type;
    push(One(), 0, No(), Yes());
    for_each(1, row.joints(), [&](auto d, std::size_t k) HWY_ATTR { push(d, k, Yes(), Yes()); });
    push(One(), row.joints(), Yes(), No());
}

void set_pulls(const PinRow& row, Values& pulls) {
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto x = get(d, row.impulse_x, i);
        const auto y = get(d, row.impulse_y, i);
        put(d, hn::Sqrt(x * x + y * y), pulls, i);
    });
}

void set_levers(PinRow& row) {
    const auto pull = [&](auto d, std::size_t joint)
                          HWY_ATTR { return get(d, row.pulled, joint) + get(d, row.closed, joint); };
    const std::size_t joints = row.joints();
    for_each(1, joints, [&](auto d, std::size_t k) HWY_ATTR {
        put(d, get(d, row.arm_after, k - 1) * pull(d, k - 1) + get(d, row.arm_before, k) * pull(d, k),
            row.levers, k);
    });
    row.levers[0] = row.arm_before[0] * (row.pulled[0] + row.closed[0]);
    row.levers[joints] = row.arm_after[joints - 1] * (row.pulled[joints - 1] + row.closed[joints - 1]);
}

void add_all_impulses(PinRow& row) {
    for_each(0, row.joints(), [&](auto d, std::size_t i) HWY_ATTR {
        const auto x = get(d, row.impulse_x, i);
        const auto y = get(d, row.impulse_y, i);
        put(d, get(d, row.sum_x, i) + x, row.sum_x, i);
        put(d, get(d, row.sum_y, i) + y, row.sum_y, i);
        put(d, get(d, row.total_x, i) + x, row.total_x, i);
        put(d, get(d, row.total_y, i) + y, row.total_y, i);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cmath>

#include <cairn/physics/math.h>

namespace cairn::physics {
HWY_EXPORT(set_rotations);
HWY_EXPORT(advance_bodies);
HWY_EXPORT(kick_bodies);
HWY_EXPORT(find_fastest_spin);
HWY_EXPORT(sum_energies);
HWY_EXPORT(are_impulses_within);
HWY_EXPORT(choose_inertias);
HWY_EXPORT(enlarge_inertias);
HWY_EXPORT(settle_inertias);
HWY_EXPORT(place_pins);
HWY_EXPORT(assemble_factors);
HWY_EXPORT(set_aims);
HWY_EXPORT(push_bodies);
HWY_EXPORT(set_pulls);
HWY_EXPORT(set_levers);
HWY_EXPORT(add_all_impulses);

void PinRow::resize(std::size_t joints) {
    for (Values* of_bodies : {&mass,    &inverse_mass,    &own_inertia,    &inverse_own_inertia,
                              &inertia, &inverse_inertia, &inertia_before, &levers,
                              &turned,  &cosine,          &sine,           &moved_x,
                              &moved_y, &before.x,        &before.y,       &before.w,
                              &now.x,   &now.y,           &now.w,          &kick.x,
                              &kick.y,  &kick.w,          &twist}) {
        of_bodies->resize(joints + 1);
    }
    for (Arms* of_arms : {&start, &arms}) {
        for (Values* values : {&of_arms->before_x, &of_arms->before_y, &of_arms->after_x, &of_arms->after_y})
            values->resize(joints);
    }
    for (Values* of_joints : {&offset_x, &offset_y, &error_x, &error_y, &impulse_x, &impulse_y, &sum_x,
                              &sum_y, &total_x, &total_y, &arm_before, &arm_after, &pulled, &closed}) {
        of_joints->resize(joints);
    }
}

void turn(PinRow& row, std::size_t first, std::size_t last) {
    constexpr double kSmall_rad = 0.5;  // up to which the series serve
    HWY_DYNAMIC_DISPATCH(set_rotations)(row, first, last);
    for (std::size_t i = first; i < last; ++i) {
        if (std::fabs(row.turned[i]) <= kSmall_rad) continue;
        row.sine[i] = deterministic::sin(row.turned[i]);
        row.cosine[i] = deterministic::cos(row.turned[i]);
    }
}
void advance(PinRow& row, double h_s, std::size_t first, std::size_t last) {
    HWY_DYNAMIC_DISPATCH(advance_bodies)(row, h_s, first, last);
    turn(row, first, last);
}
void kick(PinRow& row, std::size_t first, std::size_t last) {
    HWY_DYNAMIC_DISPATCH(kick_bodies)(row, first, last);
}
double fastest_spin(const PinRow& row, std::size_t first, std::size_t last) {
    return HWY_DYNAMIC_DISPATCH(find_fastest_spin)(row, first, last);
}
double energy_product(const PinRow& row, const PinRow::Speeds& a, const PinRow::Speeds& b, std::size_t first,
                      std::size_t last) {
    return HWY_DYNAMIC_DISPATCH(sum_energies)(row, a, b, first, last);
}
bool are_within(const PinRow& row, double impulse) {
    return HWY_DYNAMIC_DISPATCH(are_impulses_within)(row, impulse);
}
void choose_inertia(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last) {
    HWY_DYNAMIC_DISPATCH(choose_inertias)(row, h_s, fastest_rad_s, first, last);
}
bool enlarge_inertia(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last) {
    return HWY_DYNAMIC_DISPATCH(enlarge_inertias)(row, h_s, fastest_rad_s, first, last);
}
void settle_inertia(PinRow& row, std::size_t first, std::size_t last) {
    HWY_DYNAMIC_DISPATCH(settle_inertias)(row, first, last);
}
double place(PinRow& row) {
    return HWY_DYNAMIC_DISPATCH(place_pins)(row);
}
void assemble(const PinRow& row, double give, ChainFactors& factors) {
    HWY_DYNAMIC_DISPATCH(assemble_factors)(row, give, factors);
}
void aim(PinRow& row, double rate, double fastest_m_s) {
    HWY_DYNAMIC_DISPATCH(set_aims)(row, rate, fastest_m_s);
}
void push(const PinRow& row, PinRow::Speeds& to) {
    HWY_DYNAMIC_DISPATCH(push_bodies)(row, to);
}
void measure_pulls(const PinRow& row, Values& pulls) {
    HWY_DYNAMIC_DISPATCH(set_pulls)(row, pulls);
}
void sum_levers(PinRow& row) {
    HWY_DYNAMIC_DISPATCH(set_levers)(row);
}
void add_impulses(PinRow& row) {
    HWY_DYNAMIC_DISPATCH(add_all_impulses)(row);
}

}  // namespace cairn::physics
#endif
