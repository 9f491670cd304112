// A spring whose frequency and damping ratio are those that were asked for, at any substep.
#pragma once

#include <algorithm>

#include <cairn/physics/math.h>

namespace cairn::physics {

/// The impulse of a substep h is -m (d1 Jv+ + d0 Jv_before + stiffness_per_s q), m the mass that the spring
/// is made for (spring_mobility.h), Jv+ the speed after the impulse, Jv_before that at the end of the last
/// substep, q how far from rest.
struct ExactSpring {
    float d1 = 0;
    float d0 = 0;
    float stiffness_per_s = 0;  // W^2 / h, with W = w h
    bool damped = false;        // loses energy, if only as implicit Euler does
    bool crowded = false;
    bool relaxes = false;  // is solved again while relaxing, as from where the substep began
};

/// How far a spring swings in a substep, w h, from which on it is stiff: sweeps of springs and of what is
/// held feed each other in chains of twenty to one from 1.2 on, in a row of boxes pinned end to end from 1.6,
/// in a plank on a hinge from 2.1.
inline constexpr float kStiffSwing_rad = 0.9f;

/// Of the stiffest spring that is not, Hz; 34 at four substeps of 60 steps a second.
inline float most_swept_frequency(float h_s) {
    return kStiffSwing_rad / (2 * kPi * h_s);
}

/// A spring by what users say of it.
struct SpringTone {
    float frequency_hz = 0;
    float damping_ratio = 0;
};

/// The same, or if it is stiffer than it may be as stiff as that and damped by this ratio at least. With .3
/// one of 600 structures of hinges grew, whose springs should have had none.
inline constexpr float kLeastSoftenedDamping = 0.5f;
inline SpringTone softened(const SpringTone& spring, float most_hz) {
    if (spring.frequency_hz <= most_hz) return spring;
    return {most_hz, std::max(spring.damping_ratio, kLeastSoftenedDamping)};
}

/// The same, or if it is stiffer than that as stiff as asked for, and damped so much that it may be swept
/// beside the contacts of what it stands on. With the damping c = k h/b it closes the share b/(1 + b) of its
/// error in a substep, as what is held rigid does, and relaxed it finds its balance with these contacts
/// whatever k is. b falls with the square of W from where z is 1/2 (b = W/2z). With b = .9 for all, vehicles
/// of 20:1 on 1,000 Hz were thrown at 12 m/s; with .1 at least, what falls on legs of 39:1 and 10 kHz at 1.7
/// m/s rebounded at 1.4 instead of 1.2.
inline constexpr float kLeastClosing = 0.05f;  // the least b
inline SpringTone bearing_tone(const SpringTone& spring, float most_hz) {
    if (spring.frequency_hz <= most_hz) return spring;
    const float times = spring.frequency_hz / most_hz;
    const float closing = std::max(kStiffSwing_rad / (times * times), kLeastClosing);
    return {spring.frequency_hz, std::max(spring.damping_ratio, kStiffSwing_rad * times / (2 * closing))};
}

/// What the springs at one body amount to.
struct SpringLoad {
    double together_1_s2 = 0;  // the sum of w^2, each times the share of the body in J 1/M J^T
    int springs = 0;
};

/// frequency_hz > 0, damping_ratio >= 0. Springs that share bodies stiffen each other: `stiffening` is how
/// much, the sum over both bodies of k J 1/M J^T of all springs there over that of this spring alone; 1 for a
/// spring by itself.
ExactSpring make_exact_spring(double frequency_hz, double damping_ratio, double h_s, double stiffening);

/// Within a spring's steps Jv stands for the way of the last substep over h. The result is what to add to the
/// true speed Jv of one that begins at q, so that it goes as the true spring from there on; 0 when it is too
/// fast to be resolved well, or creeps.
float starting_speed(double frequency_hz, double damping_ratio, double h_s, double q, double speed);

/// The same of a spring that was made for itself alone, (w h)^2 its square.
ExactSpring calmed(ExactSpring spring, double square, double stiffening);

/// Whether the springs at a body are crowded: so stiff together that each undoes what the last one did, and
/// one sweep is far from what they come to. One by itself never is.
bool is_crowd(const SpringLoad& load, double h_s);

/// A spring with a crowded body: the same if it is soft by itself, or else implicit Euler, damped more.
/// It rests where it did when swept to the end. Crowded springs are swept apart (joint_solver.h). `damping`
/// is 2 z w h.
ExactSpring crowded(ExactSpring spring, double square, double damping);

/// A spring of the tone `bearing_tone`: implicit Euler, and relaxed.
ExactSpring bearing(ExactSpring spring, double square, double damping);

/// A spring that is solved directly: the same unless it is stiff, for itself or in a crowd, or on its way
/// there. What bears on it is not as it would be alone, and undamped ones in a ring would make energy.
ExactSpring in_structure(ExactSpring spring, double square, double damping, bool is_softened,
                         bool is_crowded);

}  // namespace cairn::physics
