// Springs by their poles. A spring of angular frequency w and damping ratio z has in time steps of h the
// poles e^(h w (-z +- i sqrt(1 - z^2))). Symplectic Euler, v+ = v + impulse/m and q+ = q + h v+, with an
// impulse linear in v+, v and q has two poles too; equating them and asking for the static sag of the true
// spring gives, with W = w h, Wd = W sqrt(1 - z^2):
//     a  = e^(-2 z W),    b = (1 - e^(-z W))^2 + 4 e^(-z W) sin^2(Wd/2),    s = W^2/b
//     d1 = s - 1,         d0 = 1 - a s
// Derivation: the characteristic polynomial of the recurrence is (1 + d1) x^2 - (2 + d1 - d0 - W^2) x + (1 -
// d0) after q is eliminated; at x = 1 it is W^2, and the product of its roots must be a, so (1 - d0) = a (1 +
// d1) and (1 + d1)(1 - x1)(1 - x2) = W^2 with (1 - x1)(1 - x2) = b.
//
// Springs that share bodies. Together they ask for A p = -(J v + D1^-1 (D0 Jv_before + S q)), with K = J 1/M
// J^T of all of them, A = K + D1^-1, and D1, D0, S the constants times the effective masses; one solution per
// substep is stable where each is (`calmed` sees to that). Sweeps stop before the solution. From p = 0,
// swept forth and back, they make p = -P (...) with P symmetric and 0 < P <= A^-1, however few they are: the
// error of a symmetric sweep never changes its sign. Where d0 = 0, and k is S/D1 in every spring, that is
//     M (v+ - v) = -J^T P (J v + k q),    q+ = q + h J v+,
// the oscillator of damping J^T P J and stiffness k J^T P J, whose energy does not grow if the two, the
// first halved and the second times h/4, are no more than M: J^T P J <= J^T K^-1 J <= M, and k <= 1/h. With
// impulses of the last substep as the first guess P is followed by a lag, and slow patterns of motion build
// up; swept in one direction only P is not symmetric, and drives what turns around in a loop.
#include "resolve/joints/exact_spring.h"

#include <cmath>

#include <cairn/physics/math.h>

namespace cairn::physics {
namespace {

// 1 - e^-x without cancellation, x >= 0.
double one_minus_exp(double x) {
    if (x > 0.01) return 1 - deterministic::exp(-x);
    return x * (1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5))));
}

// (1 - x1)(1 - x2) for the poles x1, x2.
double pole_distance(double angle, double ratio) {
    if (ratio < 1) {
        const double fade = one_minus_exp(ratio * angle);
        const double turn = deterministic::sin(angle * std::sqrt(1 - ratio * ratio) / 2);
        return fade * fade + 4 * (1 - fade) * turn * turn;
    }
    const double fast = ratio + std::sqrt(ratio * ratio - 1);
    return one_minus_exp(angle / fast) * one_minus_exp(angle * fast);
}

// Velocities are those of half a substep ago. Of faster springs that would be seen as energy from nowhere
// where they turn back.
constexpr double kMostStartingTurn_rad = 0.5;

// Beyond it, substeps see less than three points of a period: the poles would alias.
constexpr double kMostTurn_rad = 2;

// Squares of angles per substep. In a chain of equal bodies the first is reached at 30 Hz with four substeps
// at 60 Hz, in one of bodies that are light and heavy in turn at 21 Hz. Left to the
// common sweep, hardly damped ones grow where it is 1.1.
constexpr double kLeastCrowd = 0.6;
// Softer ones keep to their poles in any crowd: 21 Hz.
constexpr double kLeastStiff = 0.3;
// And those that are solved directly without a crowd: 46 Hz. Undamped rings with spokes of 40 Hz gained ten
// times their energy by what is left of the poles of each alone, of 47 Hz some hundred times.
constexpr double kLeastStiffInStructure = 1.4;

// Implicit Euler: energy goes, and never comes.
ExactSpring implicit(ExactSpring spring, double square, double damping) {
    spring.d1 = static_cast<float>(square + damping);
    spring.d0 = 0;
    spring.damped = true;
    return spring;
}

}  // namespace

ExactSpring make_exact_spring(double frequency_hz, double damping_ratio, double h_s, double stiffening) {
    const double angle = 2 * static_cast<double>(kPi) * frequency_hz * h_s;
    const double square = angle * angle;
    double d1 = square + 2 * damping_ratio * angle;  // implicit Euler: stable for all that cannot be resolved
    double d0 = 0;
    const bool oscillates = damping_ratio < 1;
    bool damped = true;
    if (!oscillates || angle * std::sqrt(1 - damping_ratio * damping_ratio) <= kMostTurn_rad) {
        const double s = square / pole_distance(angle, damping_ratio);
        d1 = s - 1;
        d0 = 1 - (1 - one_minus_exp(2 * damping_ratio * angle)) * s;
        damped = damping_ratio > 0;
    }
    const ExactSpring spring{static_cast<float>(d1), static_cast<float>(d0), static_cast<float>(square / h_s),
                             damped};
    return calmed(spring, square, stiffening);
}

// From where the true spring was a substep ago, q(-h) = e^(z W) (q cos Wd - (v + z w q) sin Wd / wd).
float starting_speed(double frequency_hz, double damping_ratio, double h_s, double q, double speed) {
    const double w = 2 * static_cast<double>(kPi) * frequency_hz;
    if (damping_ratio >= 1 || w * h_s > kMostStartingTurn_rad) return 0;
    const double wd = w * std::sqrt(1 - damping_ratio * damping_ratio);
    const double before = deterministic::exp(damping_ratio * w * h_s) *
                          (q * deterministic::cos(wd * h_s) -
                           (speed + damping_ratio * w * q) * deterministic::sin(wd * h_s) / wd);
    return static_cast<float>((q - before) / h_s - speed);
}

// What keeps the poles of springs that share bodies within the unit circle.
ExactSpring calmed(ExactSpring spring, double square, double stiffening) {
    const auto d1 = static_cast<double>(spring.d1);
    const auto d0 = static_cast<double>(spring.d0);
    const double excess = (square / 2 - 2 / stiffening - (d1 - d0)) / 2;
    if (excess > 0) {
        spring.d1 = static_cast<float>(d1 + excess);
        spring.d0 = static_cast<float>(d0 - excess);
    }
    return spring;
}

bool is_crowd(const SpringLoad& load, double h_s) {
    return load.springs > 1 && load.together_1_s2 * h_s * h_s > kLeastCrowd;
}

ExactSpring crowded(ExactSpring spring, double square, double damping) {
    spring.crowded = true;
    return square > kLeastStiff ? implicit(spring, square, damping) : spring;
}

ExactSpring bearing(ExactSpring spring, double square, double damping) {
    ExactSpring borne = implicit(spring, square, damping);
    borne.relaxes = true;
    return borne;
}

ExactSpring in_structure(ExactSpring spring, double square, double damping, bool is_softened,
                         bool is_crowded) {
    const double most = is_crowded ? kLeastStiff : kLeastStiffInStructure;
    return is_softened || square > most ? implicit(spring, square, damping) : spring;
}

}  // namespace cairn::physics
