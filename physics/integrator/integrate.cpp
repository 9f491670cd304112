// Time integration of bodies.
#include "integrator/integrate.h"

#include <utility>

#include "base/dithered_rounding.h"

namespace cairn::physics {
namespace {

float decay(float damping_1_s, float time_s) {
    if (damping_1_s == 0) return 1;
    return static_cast<float>(deterministic::exp(static_cast<double>(-damping_1_s * time_s)));
}

// The same, where the dampings that follow one another are mostly the last two, as of the limbs of ragdolls.
class Decays {
  public:
    explicit Decays(float time_s) : time_s_(time_s) {}
    float of(float damping_1_s) {
        if (damping_1_s == last_.damping_1_s) return last_.kept;
        std::swap(last_, other_);
        if (damping_1_s != last_.damping_1_s) last_ = {damping_1_s, decay(damping_1_s, time_s_)};
        return last_.kept;
    }

  private:
    struct Known {
        float damping_1_s = 0;
        float kept = 1;
    };

    float time_s_;
    Known last_;
    Known other_;
};

// Of all columns, the inverse mass too: m - m + m is m to the bit.
VelocityRow sum(const VelocityRow& a, const VelocityRow& b) {
    return {{a.v.x + b.v.x, a.v.y + b.v.y}, a.w + b.w, a.inverse_mass + b.inverse_mass};
}

VelocityRow difference(const VelocityRow& a, const VelocityRow& b) {
    return {{a.v.x - b.v.x, a.v.y - b.v.y}, a.w - b.w, a.inverse_mass - b.inverse_mass};
}

VelocityRow product(const VelocityRow& a, const VelocityRow& b) {
    return {{a.v.x * b.v.x, a.v.y * b.v.y}, a.w * b.w, a.inverse_mass * b.inverse_mass};
}

// In double, and rounded once.
float flown(float v, float acceleration, double kept, float time_s, double threshold) {
    const double gained = static_cast<double>(time_s) * static_cast<double>(acceleration);
    return rounded_at(kept * (static_cast<double>(v) + gained), threshold);
}

// The stride lets all that acts do so evenly; a kick at the start takes the body further by half of what it
// gains.
void kick_at_start(Motions& motions, int i, const Drive& drive, Vec2 gravity_m_s2, float dt_s) {
    const Vec2 falling = without_locked(drive.gravity_scale * gravity_m_s2, motions.locked_axes(i));
    const Vec2 forced = drive.acceleration - falling;
    if (forced != Vec2{} && motions.velocity[i].inverse_mass > 0)
        motions.pose[i].d += 0.5f * dt_s * dt_s * forced;
}

float turned(const VelocityRow& row, const Drive& drive, float k, float time_s) {
    const float faster = k > 0 ? time_s * drive.angular_acceleration / k : 0;
    return decay(drive.angular_damping, time_s) * (row.w + faster);
}

}  // namespace

Vec2 freely_moving(Vec2 velocity, const Drive& drive, float h_s, int substeps) {
    const float kept = decay(drive.linear_damping, h_s);
    const Vec2 kick = h_s * drive.acceleration;
    for (int i = 0; i < substeps; ++i) velocity = kept * (velocity + kick);
    return velocity;
}

void prepare_kicks(Motions& motions, std::span<const Drive> drives, float h_s, int first, int last) {
    Decays moves(h_s);
    Decays turns(h_s);
    for (int i = first; i < last; ++i) {
        VelocityRow& kick = motions.kick[i];
        kick = {};
        if (!motions.kept.empty()) motions.kept[i] = {{1, 1}, 1, 1};
        if (motions.mover[i] == MovedBy::Flight) continue;
        const Drive& drive = drives[i];
        // Structures of joints take the other half when they have moved.
        const float kick_s = motions.mover[i] == MovedBy::Direct ? 0.5f * h_s : h_s;
        const float k = motions.pose[i].k;
        kick.v = kick_s * drive.acceleration;
        kick.w = k > 0 ? kick_s * drive.angular_acceleration / k : 0;
        if (motions.kept.empty()) continue;
        const float kept = moves.of(drive.linear_damping);
        motions.kept[i] = {{kept, kept}, turns.of(drive.angular_damping), 1};
    }
}

// The impulses that contacts gave in the last substep are what its constraints added to the velocity, less
// what joints did; contacts keep their normals and arms within a step, so their sum per body can be applied
// without visiting them (those of what sweeps do not, and are left out as joints are). All four columns, so
// that each row is one SIMD operation.
void integrate_velocities(Motions& motions, bool afresh, int first, int last) {
    const bool damped = !motions.kept.empty();
    const bool some_stand = !motions.standing.empty();
    // Written rows could be the vectors themselves, as far as compilers know.
    VelocityRow* const velocity = motions.velocity.data();
    VelocityRow* const without_contacts = motions.without_contacts.data();
    const VelocityRow* const kick = motions.kick.data();
    const VelocityRow* const kept = motions.kept.data();
    const std::uint8_t* const standing = motions.standing.data();
    for (int i = first; i < last; ++i) {
        // What stands is pulled and held alike, as in the first substep.
        if (some_stand && stands(standing[i])) continue;
        const VelocityRow row = velocity[i];
        const VelocityRow without = without_contacts[i];
        VelocityRow next = sum(row, kick[i]);
        if (damped) next = product(kept[i], next);
        without_contacts[i] = next;
        velocity[i] = afresh ? next : sum(next, difference(row, without));
    }
}

// What no joint moves keeps its bits: how rows are cut into batches, of which the others are none, must not
// show.
void begin_joints(Motions& motions, int first, int last) {
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] <= MovedBy::Substeps) continue;
        motions.without_contacts[i] = difference(motions.without_contacts[i], motions.velocity[i]);
    }
}

void end_joints(Motions& motions, int first, int last) {
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] <= MovedBy::Substeps) continue;
        motions.without_contacts[i] = sum(motions.without_contacts[i], motions.velocity[i]);
    }
}

void integrate_positions(Motions& motions, float h_s) {
    integrate_positions(motions, h_s, 0, motions.size());
}

void integrate_positions(Motions& motions, float h_s, int first, int last) {
    const bool some_stand = !motions.standing.empty();
    const VelocityRow* const velocity = motions.velocity.data();
    PoseRow* const pose = motions.pose.data();
    const MovedBy* const mover = motions.mover.data();
    const std::uint8_t* const standing = motions.standing.data();
    for (int i = first; i < last; ++i) {
        if (some_stand && stands(standing[i])) continue;
        if (mover[i] == MovedBy::Flight || mover[i] == MovedBy::Direct) continue;
        const VelocityRow row = velocity[i];
        PoseRow& at = pose[i];
        // All four columns, so that each row is one SIMD operation: k + 0 is k.
        at = {{at.d.x + h_s * row.v.x, at.d.y + h_s * row.v.y},
              at.theta + h_s * row.w,
              at.k + 0 * row.inverse_mass};
        if (mover[i] == MovedBy::Turning) motions.turned[i] = Rotation::from_small_angle(motions.angle(i));
    }
}

void fly_freely(Motions& motions, std::span<const Drive> drives, Vec2 gravity_m_s2, float dt_s,
                std::uint64_t step) {
    fly_freely(motions, drives, gravity_m_s2, dt_s, step, 0, motions.size());
}

void fly_freely(Motions& motions, std::span<const Drive> drives, Vec2 gravity_m_s2, float dt_s,
                std::uint64_t step, int first, int last) {
    const double threshold = rounding_threshold(step);
    for (int i = first; i < last; ++i) {
        if (motions.mover[i] != MovedBy::Flight) continue;
        const VelocityRow before = motions.velocity[i];
        const Drive& drive = drives[i];
        const double kept = decay(drive.linear_damping, dt_s);
        VelocityRow& after = motions.velocity[i];
        after.v.x = flown(before.v.x, drive.acceleration.x, kept, dt_s, threshold);
        after.v.y = flown(before.v.y, drive.acceleration.y, kept, dt_s, threshold);
        after.w = turned(before, drive, motions.pose[i].k, dt_s);
        motions.pose[i].d = 0.5f * dt_s * (before.v + after.v);
        motions.pose[i].theta = 0.5f * dt_s * (before.w + after.w);
        kick_at_start(motions, i, drive, gravity_m_s2, dt_s);
    }
}

}  // namespace cairn::physics
