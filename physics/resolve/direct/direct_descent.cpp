// Where principal pivoting goes round in circles: descent.
//
// With the bounds of friction given, the impulses are those that minimize
//     f(p) = p (J 1/M J^T + E) p / 2 + p (J v - w)    with low <= p <= high,
// a convex function. From any impulses within their bounds, the equations of all that are not held at a bound
// give a direction; along it, bent where a bound is met, f falls. Equations without bounds hold at each place
// of the way, by factors of their own, which stay the same: a place costs one solution, a direction one
// factorization. Wherever the way is left, the impulses keep their bounds, and f is the least so far and no
// greater than without them. (That bounds how far the equations are off, not energy: what is given up early
// in one substep may be pushed apart in the next.)
// Source: Bertsekas, "Projected Newton methods for optimization problems with simple constraints" (1982).
#include <algorithm>
#include <cmath>

#include "resolve/direct/direct_system.h"
#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

constexpr int kMaxDescents = 60;
// Of the direction.
constexpr double kShortestStep = 1.0 / 8;

}  // namespace

double DirectSystem::excess(const Bounded& b) const {
    const DirectEquation& e = equations[at(b.equation)];
    return speed(b.member, b.equation) + e.give * e.impulse - e.wanted;
}

void DirectSystem::hold(const Bounded& b, double impulse) {
    DirectEquation& e = equations[at(b.equation)];
    e.state = State::Given;
    e.impulse = impulse - e.before;
}

// Of all with bounds, for the impulses that they have: which act, and which stay at a bound.
void DirectSystem::release() {
    for (const Bounded& b : bounded_) {
        DirectEquation& e = equations[at(b.equation)];
        e.state = State::Acts;
        if (b.impulse <= e.low && (b.excess >= 0 || b.stays)) e.state = State::AtLow;
        if (b.impulse >= e.high && (b.excess <= 0 || b.stays)) e.state = State::AtHigh;
    }
}

// A part of the way to where each aims; whether f is less there.
bool DirectSystem::go(double part) {
    const auto trial = [&](const Bounded& b) {
        const DirectEquation& e = equations[at(b.equation)];
        return std::clamp(b.impulse + part * (b.aim - b.impulse), e.low, e.high);
    };
    for (const Bounded& b : bounded_) hold(b, trial(b));
    balance(unbounded_factors_);
    double change = 0;
    for (const Bounded& b : bounded_) change += (trial(b) - b.impulse) * (excess(b) + b.excess) / 2;
    if (!(change < 0)) return false;
    for (Bounded& b : bounded_) {
        b.impulse = trial(b);
        b.excess = excess(b);
    }
    return true;
}

// How far all can go towards their aims, up to the first bound.
double DirectSystem::way_to_first_bound() const {
    double way = 1;
    for (const Bounded& b : bounded_) {
        const DirectEquation& e = equations[at(b.equation)];
        if (b.aim < e.low) way = std::min(way, (e.low - b.impulse) / (b.aim - b.impulse));
        if (b.aim > e.high) way = std::min(way, (e.high - b.impulse) / (b.aim - b.impulse));
    }
    return way;
}

// Towards the aims; whether there is more to gain.
bool DirectSystem::advance() {
    bool lower = false;
    const double sure = way_to_first_bound();
    for (double part = 1; part >= kShortestStep && part > sure && !lower; part /= 2) lower = go(part);
    if (!lower && sure > 0) lower = go(sure);
    if (!lower && sure > 0) return false;
    for (Bounded& b : bounded_) {
        const DirectEquation& e = equations[at(b.equation)];
        b.stays = !lower && (b.stays || (b.impulse <= e.low && b.aim < e.low) ||
                             (b.impulse >= e.high && b.aim > e.high));
    }
    return true;
}

// Those without bounds hold for the impulses of the others as they are.
void DirectSystem::settle() {
    for (const Bounded& b : bounded_) hold(b, b.impulse);
    factor(unbounded_factors_);
    balance(unbounded_factors_);
    for (Bounded& b : bounded_) b.excess = excess(b);
}

// Pairs whose length is too great are shortened, and stay so.
bool DirectSystem::shorten_wrong() {
    bool any = false;
    for (const Place& w : wrong_) {
        if (equations[at(w.equation)].bound != Bound::Round) continue;
        change_over(w.equation);
        is_stale_ = true;
        any = true;
    }
    return any;
}

void DirectSystem::descend() {
    bounded_.clear();
    for (const Place& p : limited_) {
        const DirectEquation& e = equations[at(p.equation)];
        if (e.bound == Bound::Round || e.state == State::Given) continue;
        bounded_.push_back({p.member, p.equation, std::clamp(e.before + e.impulse, e.low, e.high)});
    }
    unbounded_factors_ = factors_;
    settle();
    for (int i = 0; i < kMaxDescents && factorizations_left_ > 0; ++i) {
        release();
        renew_factors();
        balance(factors_);
        find_wrong();
        if (wrong_.empty()) return;
        for (Bounded& b : bounded_) {
            const DirectEquation& e = equations[at(b.equation)];
            b.aim = e.state == State::Acts ? e.before + e.impulse : b.impulse;
        }
        if (shorten_wrong()) {
            settle();
        } else if (!advance()) {
            break;
        }
    }
    settle();
    // What was given up early may do more harm than no impulse at all.
    for (Bounded& b : bounded_) b.aim = equations[at(b.equation)].before;
    if (!go(1)) settle();
    release();
    renew_factors();
}

}  // namespace cairn::physics
