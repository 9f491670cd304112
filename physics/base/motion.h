// What the solver reads and changes of bodies during one step, in rows made for SIMD: 16 bytes of velocity
// and 16 of pose. Invariant: row 0 is the world itself: infinite mass, never moves; all static bodies are it.
// Angular quantities are scaled by sqrt(I), and arms by k = sqrt(1/I): then an impulse p at arm r' = k (r x
// n) changes the scaled angular velocity by r' p, and neither mass nor inertia stands in a constraint. Bodies
// that turn and cannot be turned have k = 1, and kernels do not write them; a body that moves but never turns
// has k = 0.
#pragma once

#include <cstdint>
#include <vector>

#include <cairn/physics/math.h>

#include "base/ample.h"

namespace cairn::physics {

struct alignas(16) VelocityRow {
    Vec2 v;       // m/s, of the centre of mass
    float w = 0;  // rad/s times sqrt(I)
    float inverse_mass = 0;
};

struct alignas(16) PoseRow {
    Vec2 d;           // m, moved since the start of the step
    float theta = 0;  // rad times sqrt(I), turned since then
    float k = 1;      // sqrt(1/I)
};

inline constexpr int kWorldRow = 0;

/// Who moves a body in this step.
enum class MovedBy : std::uint8_t {
    Flight,    // nothing acts on it but forces: one exact stride
    Substeps,  // contacts in lanes act on it
    Jointed,   // joints in lanes as well
    Turning,   // the same, and scalar code needs its turn as a rotation
    Direct,    // the structure of joints that it is part of
};

/// What Motions::standing says of a row (base/standing.h).
inline constexpr std::uint8_t kMoves = 0;
inline constexpr std::uint8_t kStands = 1;
inline constexpr std::uint8_t kMovesAnyway = 2;
inline constexpr std::uint8_t kRests = 4 | kStands;

inline bool stands(std::uint8_t standing) {
    return (standing & kStands) != 0;
}

/// Axes along which a body does not move, as bits.
inline constexpr std::uint8_t kLockedX = 1;
inline constexpr std::uint8_t kLockedY = 2;

/// One body in plain units, as scalar code works on it.
struct Motion {
    Vec2 v;
    float w = 0;  // rad/s
    Vec2 dp;      // m
    Rotation dq;
    float inverse_mass = 0;
    float inverse_inertia = 0;
    std::uint8_t locked = 0;
};

inline Vec2 without_locked(Vec2 v, std::uint8_t locked) {
    if (locked & kLockedX) v.x = 0;
    if (locked & kLockedY) v.y = 0;
    return v;
}

/// What an impulse through the centre of mass adds to the velocity.
inline Vec2 velocity_change(const Motion& body, Vec2 impulse) {
    return without_locked(body.inverse_mass * impulse, body.locked);
}

/// The inverse mass that an impulse along the axis (of length 1) feels.
inline float inverse_mass_along(const Motion& body, Vec2 axis) {
    if (body.locked == 0) return body.inverse_mass;
    return body.inverse_mass * length_squared(without_locked(axis, body.locked));
}

/// The share of what two bodies could do without locks, below which they count as locked altogether. A body
/// that can give way only by turning about a tiny arm would be whirled up by any impulse; at this share the
/// arm is a tenth of its radius of gyration.
inline constexpr float kLeastMobility = 0.01f;

/// 1/K for the inverse effective mass K of a constraint; 0 when nothing can give way.
inline float effective_mass(const Motion& a, const Motion& b, float k) {
    const bool locked = (a.locked | b.locked) != 0;
    const float least = locked ? kLeastMobility * (a.inverse_mass + b.inverse_mass) : 0;
    return k > least ? 1 / k : 0;
}

struct Motions {
    std::vector<VelocityRow> velocity;
    std::vector<PoseRow> pose;
    // Velocity of this substep without what contacts added to it. Where joints act too, it is kept less the
    // velocity itself from before their passes until after them (integrator/integrate.h).
    std::vector<VelocityRow> without_contacts;
    // What forces do to the velocity in a substep, and the share of it that damping leaves: empty while
    // nothing is damped (integrator/integrate.h).
    std::vector<VelocityRow> kick;
    std::vector<VelocityRow> kept;
    std::vector<Rotation> turned;  // angle of the pose, kept for turning bodies
    std::vector<float> inverse_inertia;
    std::vector<float>
        rim;  // k times the reach of the body's shapes: times w, the speed of its farthest point
    std::vector<MovedBy> mover;
    // From the second substep on: which rows stand (base/standing.h), as the world's always does. Empty where
    // too few are still.
    std::vector<std::uint8_t> standing;
    // Beside them: how much of what the first substep does to the row's velocity is rounding, m/s of its
    // farthest point; less than 0 where a force acts, so that all of it counts (world/standing.cpp).
    std::vector<float> rounding_m_s;
    std::vector<std::uint8_t> locked;  // axes of each row; empty while no body has any
    bool some_turn_far = false;        // in a step, so that separations are not linear in their angles

    [[nodiscard]] int size() const { return static_cast<int>(velocity.size()); }
    [[nodiscard]] float spin(int i) const { return velocity[i].w * pose[i].k; }   // rad/s
    [[nodiscard]] float angle(int i) const { return pose[i].theta * pose[i].k; }  // rad

    /// So many rows, of which those that are new are yet to be set.
    void resize(int size);
    /// In flight, and not locked.
    void set_row(int i, Vec2 v, float w, float inverse_mass, float inverse_inertia, float reach_m = 0);
    void add(Vec2 v, float w, float inverse_mass, float inverse_inertia);
    void lock(int i, std::uint8_t axes);
    [[nodiscard]] std::uint8_t locked_axes(int i) const {
        return static_cast<std::size_t>(i) < locked.size() ? locked[i] : std::uint8_t{0};
    }

    [[nodiscard]] Motion get(int i) const {
        return {velocity[i].v,      spin(i),       pose[i].d, turned[i], velocity[i].inverse_mass,
                inverse_inertia[i], locked_axes(i)};
    }
    /// Writes the velocity back, of what can be moved: an infinite impulse times no inverse mass is NaN, and
    /// would reach all that touches the world.
    void set(int i, const Motion& m) {
        if (velocity[i].inverse_mass > 0) velocity[i].v = m.v;
        if (inverse_inertia[i] > 0) velocity[i].w = m.w / pose[i].k;
    }
};

inline void Motions::resize(int size) {
    const auto count = static_cast<std::size_t>(size);
    if (count == velocity.size()) return;
    resize_amply(velocity, count);
    resize_amply(pose, count);
    resize_amply(without_contacts, count);
    resize_amply(turned, count);
    resize_amply(inverse_inertia, count);
    resize_amply(rim, count);
    resize_amply(mover, count);
    if (locked.size() > count) locked.resize(count);
}

inline void Motions::set_row(int i, Vec2 v, float w, float inverse_mass, float inverse_inertia_of_body,
                             float reach_m) {
    float k = inverse_mass > 0 ? 0 : 1;
    if (inverse_inertia_of_body > 0) k = std::sqrt(inverse_inertia_of_body);
    velocity[i] = {v, k > 0 ? w / k : 0, inverse_mass};
    pose[i] = {{}, 0, k};
    turned[i] = {};
    inverse_inertia[i] = inverse_inertia_of_body;
    rim[i] = k * reach_m;
    mover[i] = MovedBy::Flight;
}

inline void Motions::add(Vec2 v, float w, float inverse_mass, float inverse_inertia_of_body) {
    const int i = size();
    resize(i + 1);
    set_row(i, v, w, inverse_mass, inverse_inertia_of_body);
}

inline void Motions::lock(int i, std::uint8_t axes) {
    if (axes == 0) return;
    locked.resize(velocity.size(), 0);
    locked[i] = axes;
}

/// What acts on a body besides constraints, constant over a step.
struct Drive {
    Vec2 acceleration{};             // m/s^2, gravity and forces
    float angular_acceleration = 0;  // rad/s^2
    float linear_damping = 0;        // 1/s
    float angular_damping = 0;       // 1/s
    float gravity_scale = 0;
};

}  // namespace cairn::physics
