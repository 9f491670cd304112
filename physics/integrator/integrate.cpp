// Time integration of bodies.
#include "integrator/integrate.h"

namespace cairn::physics {
namespace {

float decay(float damping_1_s, float time_s) {
    if (damping_1_s == 0) return 1;
    return static_cast<float>(deterministic::exp(static_cast<double>(-damping_1_s * time_s)));
}

void accelerate(Motion& body, const Drive& drive, float time_s) {
    body.v = decay(drive.linear_damping, time_s) * (body.v + time_s * drive.acceleration);
    body.w = decay(drive.angular_damping, time_s) * (body.w + time_s * drive.angular_acceleration);
}

Rotation turned(Rotation q, float angle_rad) {
    if (angle_rad == 0) return q;
    return Rotation::from_angle(static_cast<double>(angle_rad)) * q;
}

}  // namespace

void integrate_velocities(std::span<Motion> motions, std::span<const Drive> drives, float h_s) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (motions[i].constrained) accelerate(motions[i], drives[i], h_s);
    }
}

void integrate_positions(std::span<Motion> motions, float h_s) {
    for (Motion& body : motions) {
        if (!body.constrained) continue;
        body.dp += h_s * body.v;
        body.dq = turned(body.dq, h_s * body.w);
    }
}

void fly_freely(std::span<Motion> motions, std::span<const Drive> drives, float dt_s) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
        Motion& body = motions[i];
        if (body.constrained) continue;
        const Vec2 v = body.v;
        const float w = body.w;
        accelerate(body, drives[i], dt_s);
        body.dp = 0.5f * dt_s * (v + body.v);
        body.dq = turned({}, 0.5f * dt_s * (w + body.w));
    }
}

}  // namespace cairn::physics
