// Time integration of bodies.
#include "integrator/integrate.h"

namespace cairn::physics {
namespace {

float decay(float damping_1_s, float time_s) {
    if (damping_1_s == 0) return 1;
    return static_cast<float>(deterministic::exp(static_cast<double>(-damping_1_s * time_s)));
}

}  // namespace

VelocityRow accelerated(const VelocityRow& row, const Drive& drive, float k, float time_s, float kick_s) {
    VelocityRow next = row;
    next.v = decay(drive.linear_damping, time_s) * (row.v + kick_s * drive.acceleration);
    const float faster = k > 0 ? kick_s * drive.angular_acceleration / k : 0;
    next.w = decay(drive.angular_damping, time_s) * (row.w + faster);
    return next;
}

// The impulses that contacts gave in the last substep are what its constraints added to the velocity, less
// what joints did; contacts keep their normals and arms within a step, so their sum per body can be applied
// without visiting them.
void integrate_velocities(Motions& motions, std::span<const Drive> drives, float h_s, bool afresh, int first,
                          int last) {
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == Mover::Flight) continue;
        VelocityRow& row = motions.velocity[i];
        VelocityRow& without = motions.without_contacts[i];
        VelocityRow guess{};
        if (!afresh) {
            guess.v = row.v - without.v;
            guess.w = row.w - without.w;
        }
        // Structures of joints take the other half when they have moved.
        const float kick_s = motions.mover[i] == Mover::Direct ? 0.5f * h_s : h_s;
        row = accelerated(row, drives[i], motions.pose[i].k, h_s, kick_s);
        without = row;
        row.v += guess.v;
        row.w += guess.w;
    }
}

void integrate_velocities(Motions& motions, std::span<const Drive> drives, float h_s, bool afresh) {
    integrate_velocities(motions, drives, h_s, afresh, 0, motions.size());
}

// All four columns, so that each row is one SIMD operation: m - m + m is m to the bit.

void begin_joints(Motions& motions, int first, int last) {
    for (int i = first; i < last; ++i) {
        const VelocityRow& row = motions.velocity[i];
        VelocityRow& without = motions.without_contacts[i];
        without.v.x -= row.v.x;
        without.v.y -= row.v.y;
        without.w -= row.w;
        without.inverse_mass -= row.inverse_mass;
    }
}

void end_joints(Motions& motions, int first, int last) {
    for (int i = first; i < last; ++i) {
        const VelocityRow& row = motions.velocity[i];
        VelocityRow& without = motions.without_contacts[i];
        without.v.x += row.v.x;
        without.v.y += row.v.y;
        without.w += row.w;
        without.inverse_mass += row.inverse_mass;
    }
}

void integrate_positions(Motions& motions, float h_s) {
    integrate_positions(motions, h_s, 0, motions.size());
}

void integrate_positions(Motions& motions, float h_s, int first, int last) {
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] == Mover::Flight || motions.mover[i] == Mover::Direct) continue;
        motions.pose[i].d += h_s * motions.velocity[i].v;
        motions.pose[i].theta += h_s * motions.velocity[i].w;
        if (motions.mover[i] == Mover::Turning)
            motions.turned[i] = Rotation::from_small_angle(motions.angle(i));
    }
}

void fly_freely(Motions& motions, std::span<const Drive> drives, float dt_s) {
    for (int i = 0; i < motions.size(); ++i) {
        if (motions.mover[i] != Mover::Flight) continue;
        const VelocityRow before = motions.velocity[i];
        motions.velocity[i] = accelerated(before, drives[i], motions.pose[i].k, dt_s, dt_s);
        motions.pose[i].d = 0.5f * dt_s * (before.v + motions.velocity[i].v);
        motions.pose[i].theta = 0.5f * dt_s * (before.w + motions.velocity[i].w);
    }
}

}  // namespace cairn::physics
