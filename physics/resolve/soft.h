// A constraint that gives like a damped spring, described by frequency and damping ratio so that it behaves
// the same for every mass.
//
// Implicit Euler on m x'' + c x' + k x = 0 with k = m w^2 and c = 2 m z w gives for the impulse of one
// substep h
//     lambda = -m (mass_scale (Jv + bias_rate C)) - impulse_scale lambda_accumulated
// with a1 = 2 z + h w, a2 = h w a1, a3 = 1/(1 + a2), bias_rate = w/a1, mass_scale = a2 a3, impulse_scale =
// a3. Source: Catto, "Soft Constraints", GDC 2011; "Solver2D", 2024.
#pragma once

#include <cairn/physics/math.h>

namespace cairn::physics {

struct Softness {
    float bias_rate = 0;  // 1/s
    float mass_scale = 1;
    float impulse_scale = 0;

    bool operator==(const Softness&) const = default;
};

inline constexpr Softness kRigid{0, 1, 0};

inline Softness make_soft(float frequency_hz, float damping_ratio, float h_s) {
    if (frequency_hz == 0) return kRigid;
    const float w = 2 * kPi * frequency_hz;
    const float a1 = 2 * damping_ratio + h_s * w;
    const float a2 = h_s * w * a1;
    const float a3 = 1 / (1 + a2);
    return {w / a1, a2 * a3, a3};
}

/// Whether a pass corrects positions too. Biased passes push overlap apart; relaxing takes the velocity which
/// that added out again.
enum class Pass { Biased, Relax };

}  // namespace cairn::physics
