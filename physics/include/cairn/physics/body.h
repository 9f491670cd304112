// How a body is described, and the view through which it is read and changed.
#pragma once

#include <cstdint>
#include <vector>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>
#include <cairn/physics/result.h>
#include <cairn/physics/tuning.h>

namespace cairn::physics {

struct WorldState;

enum class BodyType : std::uint8_t {
    Static,     ///< never moves; infinite mass
    Kinematic,  ///< moves as its velocity says and is pushed by nothing; infinite mass
    Dynamic,    ///< moved by forces and contacts
};

/// What a dynamic body does not do, whatever acts on it: its centre of mass stays at its x or y, or it does
/// not turn. Velocities that are set along locked axes stay 0.
struct AxisLocks {
    bool x = false;
    bool y = false;
    bool rotation = false;
    friend bool operator==(const AxisLocks&, const AxisLocks&) = default;
};

struct BodyDef {
    BodyType type = BodyType::Dynamic;
    Position position_m{};  ///< within kFarthest_m of the origin
    double angle_rad = 0;
    Vec2 linear_velocity_m_s{};  ///< of the centre of mass
    float angular_velocity_rad_s = 0;
    float linear_damping_1_s = 0;   ///< c in v e^(-c t), >= 0
    float angular_damping_1_s = 0;  ///< the same for the angular velocity, >= 0
    float gravity_scale = 1;
    AxisLocks locks{};
    bool allow_sleep = true;
    /// A body may sleep when all of it has been slower than this for half a second, >= 0; at 0 it never does.
    float sleep_speed_m_s = tuning::kSleepSpeed_m_s;
    bool awake = true;
    std::uint64_t user_data = 0;
};

/// Mass, inertia about the centre of mass, and that centre in the body's frame. All 0 unless the body is
/// dynamic.
struct MassData {
    float mass_kg = 0;
    float inertia_kg_m2 = 0;
    Vec2 center_m{};
};

/// A body of a world, found with `World::body`. A view: cheap to make, meant to be used at once and not kept
/// (keep the BodyId). Using a view after its body was destroyed ends the program with a message. Setters that
/// take numbers give an error for NaN and infinity and then change nothing; setters wake the body (and what
/// it touches) when they change its motion.
class Body {
  public:
    [[nodiscard]] BodyId id() const { return id_; }
    [[nodiscard]] BodyType type() const;

    /// Place of the body's origin, m and rad, after the last step.
    [[nodiscard]] Position position() const;
    [[nodiscard]] float angle() const { return transform().q.angle_rad(); }
    [[nodiscard]] Transform transform() const;
    /// Between the last two steps: alpha 0 is before the last step, 1 after it. For drawing.
    [[nodiscard]] Transform interpolated_transform(float alpha) const;
    [[nodiscard]] Position world_center() const;
    Result<void> set_transform(Position position_m, double angle_rad);

    [[nodiscard]] Vec2 linear_velocity() const;    ///< of the centre of mass, m/s
    [[nodiscard]] float angular_velocity() const;  ///< rad/s
    [[nodiscard]] Vec2 velocity_at(Position point_m) const;
    Result<void> set_linear_velocity(Vec2 velocity_m_s);
    Result<void> set_angular_velocity(float velocity_rad_s);

    /// Forces act during the next step only. No effect on bodies that are not dynamic.
    Result<void> apply_force(Vec2 force_n, Position point_m);
    Result<void> apply_force_to_center(Vec2 force_n);
    Result<void> apply_torque(float torque_nm);
    /// Impulses change the velocity at once.
    Result<void> apply_impulse(Vec2 impulse_ns, Position point_m);
    Result<void> apply_impulse_to_center(Vec2 impulse_ns);
    Result<void> apply_angular_impulse(float impulse_nms);

    [[nodiscard]] MassData mass_data() const;
    [[nodiscard]] float mass() const { return mass_data().mass_kg; }
    [[nodiscard]] float linear_damping() const;
    [[nodiscard]] float angular_damping() const;
    [[nodiscard]] float gravity_scale() const;
    Result<void> set_linear_damping(float damping_1_s);
    Result<void> set_angular_damping(float damping_1_s);
    Result<void> set_gravity_scale(float scale);
    [[nodiscard]] AxisLocks locks() const;
    void set_locks(AxisLocks locks);  ///< what it does along axes that become locked ends at once

    [[nodiscard]] bool is_awake() const;
    /// Putting one body to sleep puts to sleep all that it touches or is jointed to. What a moving kinematic
    /// body holds or touches wakes again.
    void set_awake(bool awake);
    [[nodiscard]] bool allows_sleep() const;
    void set_allow_sleep(bool allow);
    [[nodiscard]] float sleep_speed() const;
    Result<void> set_sleep_speed(float speed_m_s);

    [[nodiscard]] std::vector<ShapeId> shapes() const;  ///< in order of creation, then sensors
    [[nodiscard]] std::vector<JointId> joints() const;
    [[nodiscard]] std::uint64_t user_data() const;
    void set_user_data(std::uint64_t data);

  private:
    friend class World;
    Body(WorldState& world, BodyId id) : world_(&world), id_(id) {}

    WorldState* world_;
    BodyId id_{};
};

}  // namespace cairn::physics
