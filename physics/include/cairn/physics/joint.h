// How joints are described, and the view through which they are read and changed.
//
// Every joint has a frame on each of its two bodies: an origin (the anchor) and an angle, in the coordinates
// of the body. What a joint holds, drives and limits is how frame b stands to frame a.
//
// Springs have the frequency and the damping ratio that were asked for. Those that swing by more than .9 rad
// in the longest substep of the last second (34 Hz at four substeps of 60 steps a second) are that stiff and
// no stiffer, with a damping ratio of .5 or more, where they are swept and something else acts on their
// bodies: what the joint does in other directions (but on rails), another joint, be it a slack rope, or a
// contact that is near enough to act. When that ends they stiffen e-fold in a second, or faster. As stiff as
// asked for, but damped more, are those of wheel and prismatic joints that bear on no limit while one of the
// two bodies has such contacts and no other joint holds it: suspensions on the ground. What is solved
// directly is as stiff as it is asked to be.
#pragma once

#include <cstdint>
#include <limits>
#include <variant>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>
#include <cairn/physics/result.h>

namespace cairn::physics {

struct WorldState;

inline constexpr float kUnlimited = std::numeric_limits<float>::infinity();

enum class JointKind : std::uint8_t {
    Distance,
    Revolute,
    Prismatic,
    Weld,
    Wheel,
    Motor,
    Mouse,
    Gear,
    Pulley,
    Friction,
    Filter,
};

/// How joints are solved, and contacts of bodies of very different mass.
enum class JointSolver : std::uint8_t {
    /// All joints of a structure at once, with its contacts, where sweeping would leave errors: long chains,
    /// heavy bodies on light ones, whether joined or only touching, stiff springs beside pins.
    Automatic,
    Sweeping,  ///< one after another: the cheapest; errors grow with mass ratios and lengths
    Direct,    ///< all structures at once, whatever it costs
};

/// How stiffly a joint holds what it holds rigid. Softer than the default where a structure shall give.
struct JointStiffness {
    float frequency_hz = 60;  ///< > 0; what the substeps cannot resolve is softened to what they can
    float damping_ratio = 2;  ///< >= 0
};

/// What a joint bears, as the mean over a step. Beyond it, the joint is destroyed and an event tells so.
struct JointStrength {
    float break_force_n = kUnlimited;    ///< > 0
    float break_torque_nm = kUnlimited;  ///< > 0
};

/// Keeps two points at a distance: rigidly; or as a spring; within limits in any case that they are given. A
/// rope is a spring of 0 Hz with a maximum length. A spring is as stiff, in N/m, as its frequency says of the
/// masses of its bodies, free of locks, as they stand when it is made, switched on, or given another
/// frequency or anchor; and stays so whatever way they turn.
struct DistanceJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float length_m = 1;  ///< > 5 mm; the rest length
    bool enable_spring = false;
    float frequency_hz = 1;                  ///< of the spring, >= 0; with 0 nothing but the limits acts
    float damping_ratio = 0;                 ///< >= 0; 1 is critical
    float min_spring_force_n = -kUnlimited;  ///< <= 0; the spring pushes with no more
    float max_spring_force_n = kUnlimited;   ///< >= 0; and pulls with no more
    float min_length_m = 0;                  ///< limits of a spring's length, 0 <= min <= length <= max
    float max_length_m = kUnlimited;
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = false;  ///< whether the two bodies collide with each other
    std::uint64_t user_data = 0;
};

/// Pins a point of one body to a point of another; they turn freely about it, within limits, driven by a
/// motor, drawn by a spring. Its angle counts whole turns: limits may be any number of turns apart.
struct RevoluteJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float local_angle_a_rad = 0;  ///< the joint's angle is 0 where the two frames agree
    float local_angle_b_rad = 0;
    bool enable_limit = false;
    float lower_rad = 0;  ///< lower <= upper
    float upper_rad = 0;
    bool enable_motor = false;
    float motor_speed_rad_s = 0;    ///< of b relative to a
    float max_motor_torque_nm = 0;  ///< >= 0; may be infinite
    bool enable_spring = false;
    float frequency_hz = 1;   ///< of the spring, > 0
    float damping_ratio = 0;  ///< >= 0
    float target_rad = 0;     ///< the angle that the spring draws to
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

/// Lets b slide along the x axis of frame a, and not turn.
struct PrismaticJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float local_angle_a_rad = 0;  ///< of the axis
    float local_angle_b_rad = 0;
    bool enable_limit = false;
    float lower_m = 0;  ///< lower <= upper
    float upper_m = 0;
    bool enable_motor = false;
    float motor_speed_m_s = 0;    ///< of b relative to a
    float max_motor_force_n = 0;  ///< >= 0; may be infinite
    bool enable_spring = false;
    float frequency_hz = 1;   ///< > 0
    float damping_ratio = 0;  ///< >= 0
    float target_m = 0;       ///< where the spring draws to
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

/// Holds b where it stands to a: rigidly, or with springs. These are as stiff, in N/m, as their frequencies
/// say of the masses of the bodies where the frames are one.
struct WeldJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float local_angle_a_rad = 0;
    float local_angle_b_rad = 0;
    float linear_frequency_hz = 0;    ///< >= 0; 0 is rigid
    float linear_damping_ratio = 1;   ///< >= 0
    float angular_frequency_hz = 0;   ///< >= 0; 0 is rigid
    float angular_damping_ratio = 1;  ///< >= 0
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

/// A wheel b on a chassis a: its centre slides along the x axis of frame a on a spring, and it turns freely
/// or by a motor.
struct WheelJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float local_angle_a_rad = 0;  ///< of the axis of the suspension
    bool enable_spring = true;
    float frequency_hz = 2;     ///< > 0
    float damping_ratio = .7f;  ///< >= 0
    float target_m = 0;         ///< where the spring draws to
    bool enable_limit = false;
    float lower_m = 0;  ///< lower <= upper
    float upper_m = 0;
    bool enable_motor = false;
    float motor_speed_rad_s = 0;    ///< of b relative to a
    float max_motor_torque_nm = 0;  ///< >= 0; may be infinite
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = false;
    std::uint64_t user_data = 0;
};

/// Draws frame b to an offset and an angle in frame a, with a force and a torque that have caps. With a
/// frequency of 0 it drives at the velocities alone. Where both are springs, these are as stiff as those of a
/// weld at that offset and angle.
struct MotorJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float local_angle_a_rad = 0;
    float local_angle_b_rad = 0;
    Vec2 target_offset_m{};  ///< of anchor b, in frame a
    float target_angle_rad = 0;
    Vec2 linear_velocity_m_s{};        ///< with frequency 0: of anchor b, in frame a
    float angular_velocity_rad_s = 0;  ///< with frequency 0
    float linear_frequency_hz = 0;     ///< >= 0
    float linear_damping_ratio = 1;    ///< >= 0
    float angular_frequency_hz = 0;    ///< >= 0
    float angular_damping_ratio = 1;   ///< >= 0
    float max_force_n = 0;             ///< >= 0; may be infinite
    float max_torque_nm = 0;           ///< >= 0; may be infinite
    JointStrength strength{};
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

/// Draws a point of body b to a target in the frame of body a, which may be any body that does not move: the
/// hand of a player.
struct MouseJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_target_m{};    ///< in the frame of body a
    Vec2 local_anchor_b_m{};  ///< what is held
    float frequency_hz = 5;   ///< > 0
    float damping_ratio = 1;  ///< >= 0
    float max_force_n = 0;    ///< >= 0; may be infinite
    JointStrength strength{};
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

/// Keeps coordinate_1 + ratio coordinate_2 as it is when the gear is made. The coordinate of a revolute joint
/// is its angle, that of a prismatic joint its translation. The gear is destroyed with either joint. Its
/// bodies are bodies b of the two joints, and it is between them for islands and filters.
struct GearJointDef {
    JointId joint_1{};
    JointId joint_2{};
    float ratio = 1;  ///< finite, not 0; in m or 1/m between a revolute and a prismatic joint
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

/// A rope over two fixed wheels: length_a + ratio length_b is at most the length of the rope. It pulls and
/// never pushes.
struct PulleyJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    Position wheel_a_m{};  ///< in the world
    Position wheel_b_m{};
    float ratio = 1;     ///< > 0; of a block and tackle on the side of b
    float length_m = 0;  ///< >= 0; 0: what length_a + ratio length_b is when the joint is made
    JointStiffness stiffness{};
    JointStrength strength{};
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

/// Friction between b and a at the anchor, as of things that lie on a table seen from above.
struct FrictionJointDef {
    BodyId body_a{};
    BodyId body_b{};
    Vec2 local_anchor_a_m{};
    Vec2 local_anchor_b_m{};
    float max_force_n = 0;    ///< >= 0
    float max_torque_nm = 0;  ///< >= 0
    bool collide_connected = true;
    std::uint64_t user_data = 0;
};

/// Does nothing but keep two bodies from colliding.
struct FilterJointDef {
    BodyId body_a{};
    BodyId body_b{};
    std::uint64_t user_data = 0;
};

/// Any of them, in the order of JointKind.
using JointDef = std::variant<DistanceJointDef, RevoluteJointDef, PrismaticJointDef, WeldJointDef,
                              WheelJointDef, MotorJointDef, MouseJointDef, GearJointDef, PulleyJointDef,
                              FrictionJointDef, FilterJointDef>;

/// A joint of a world, found with `World::joint`. A view, as `Body` is: keep the JointId instead.
class Joint {
  public:
    [[nodiscard]] JointId id() const { return id_; }
    [[nodiscard]] JointKind kind() const;
    [[nodiscard]] BodyId body_a() const;
    [[nodiscard]] BodyId body_b() const;
    [[nodiscard]] Position anchor_a() const;  ///< in the world, m
    [[nodiscard]] Position anchor_b() const;
    /// What the joint did to body b, at its anchor, as the mean over the last step; N and N m.
    [[nodiscard]] Vec2 reaction_force() const;
    [[nodiscard]] float reaction_torque() const;
    [[nodiscard]] std::uint64_t user_data() const;
    void set_user_data(std::uint64_t data);

    /// Angle of frame b relative to frame a, rad, with its whole turns since the joint was made; it was in
    /// (-pi, pi] then. 0 for kinds that have no angle.
    [[nodiscard]] float joint_angle() const;
    /// Of anchor b along the axis of prismatic and wheel joints, m; 0 for other kinds.
    [[nodiscard]] float translation() const;
    /// Distance between the two anchors, m.
    [[nodiscard]] float current_length() const;

    /// Everything about the joint as it is now. Its length and frames are what they were given as, or were
    /// changed to.
    [[nodiscard]] const JointDef& definition() const;
    /// Changes everything but the bodies, and wakes them. An error for another kind, other bodies or a bad
    /// value; then nothing is changed.
    Result<void> redefine(const JointDef& def);

    // Shorter ways to the same. Errors name the kind when the joint has no such part.

    /// Revolute and wheel: rad/s and N m. Prismatic: m/s and N.
    Result<void> set_motor(bool enabled, float speed, float max_effort);
    /// Revolute: rad. Prismatic and wheel: m.
    Result<void> set_limits(bool enabled, float lower, float upper);
    /// Distance, revolute, prismatic, wheel.
    Result<void> set_spring(bool enabled, float frequency_hz, float damping_ratio);
    /// Where the spring draws to. Revolute: rad. Prismatic and wheel: m.
    Result<void> set_target(float target);
    /// Mouse: where to, in the world.
    Result<void> set_target(Position target_m);
    /// Distance: of rest. Pulley: of the rope.
    Result<void> set_length(float length_m);

  private:
    friend class World;
    Joint(WorldState& world, JointId id) : world_(&world), id_(id) {}

    WorldState* world_;
    JointId id_;
};

}  // namespace cairn::physics
