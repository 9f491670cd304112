// How joints are described, and the view through which they are read and changed.
#pragma once

#include <cstdint>
#include <limits>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>
#include <cairn/physics/result.h>

namespace cairn::physics {

struct WorldState;

enum class JointKind : std::uint8_t { Revolute, Distance };

/// Pins a point of one body to a point of another; they turn freely about it, within limits, driven by a
/// motor.
struct RevoluteJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};         ///< in the frame of body a
    Vec2 local_anchor_b_m{};         ///< in the frame of body b
    double reference_angle_rad = 0;  ///< angle of b minus angle of a that counts as 0
    bool enable_limit = false;
    float lower_rad = 0;  ///< -pi < lower <= upper < pi
    float upper_rad = 0;
    bool enable_motor = false;
    float motor_speed_rad_s = 0;     ///< of b relative to a
    float max_motor_torque_nm = 0;   ///< >= 0; may be infinite
    bool collide_connected = false;  ///< whether the two bodies collide with each other
    std::uint64_t user_data = 0;
};

/// Keeps two points at a distance: rigidly, or as a spring between min and max length.
struct DistanceJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float length_m = 1;  ///< > 5 mm; the rest length
    bool enable_spring = false;
    float frequency_hz = 1;   ///< of the spring, > 0
    float damping_ratio = 0;  ///< >= 0; 1 is critical
    float min_length_m = 0;   ///< limits of the spring's length, 0 <= min <= length <= max
    float max_length_m = std::numeric_limits<float>::infinity();
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

/// A joint of a world, found with `World::joint`. A view, as `Body` is: keep the JointId instead.
class Joint {
  public:
    [[nodiscard]] JointId id() const { return id_; }
    [[nodiscard]] JointKind kind() const;
    [[nodiscard]] BodyId body_a() const;
    [[nodiscard]] BodyId body_b() const;
    [[nodiscard]] Position anchor_a() const;  ///< in the world, m
    [[nodiscard]] Position anchor_b() const;
    /// What the joint did to body b in the last step, N and N m.
    [[nodiscard]] Vec2 reaction_force() const;
    [[nodiscard]] float reaction_torque() const;
    [[nodiscard]] std::uint64_t user_data() const;
    void set_user_data(std::uint64_t data);

    /// Revolute: angle of b relative to a, in (-pi, pi], rad. Distance: 0.
    [[nodiscard]] float joint_angle() const;
    /// Distance between the two anchors, m.
    [[nodiscard]] float current_length() const;

    /// Errors name the kind when the joint has no such part. They wake both bodies.
    Result<void> set_motor(bool enabled, float speed_rad_s, float max_torque_nm);
    Result<void> set_limits(bool enabled, float lower_rad, float upper_rad);
    Result<void> set_length(float length_m);
    Result<void> set_spring(bool enabled, float frequency_hz, float damping_ratio);

  private:
    friend class World;
    Joint(WorldState& world, JointId id) : world_(&world), id_(id) {}

    WorldState* world_;
    JointId id_;
};

}  // namespace cairn::physics
