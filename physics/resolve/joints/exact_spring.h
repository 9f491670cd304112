// A spring whose frequency and damping ratio are those that were asked for, at any substep.
#pragma once

namespace cairn::physics {

/// The impulse of a substep h is -m (d1 Jv+ + d0 Jv_before + stiffness_per_s q), m the effective mass, Jv+
/// the speed after the impulse, Jv_before that at the end of the last substep, q how far from rest.
struct ExactSpring {
    float d1 = 0;
    float d0 = 0;
    float stiffness_per_s = 0;  // W^2 / h, with W = w h
    bool damped = false;
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

}  // namespace cairn::physics
