// What cairn-bench and cairn-lab ask of a physics engine. Scenes are written once against this, in Cairn's
// own words for bodies and shapes, and run on any engine that has an adapter. Invariant: between two steps a
// call changes nothing that was not asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <cairn/physics/world.h>

namespace cairn::measure {

inline constexpr float kStep_s = 1.0f / 60;  ///< of every scene of cairn-bench

/// A body of the engine; what the number means is the engine's business.
struct BodyRef {
    std::uint64_t bits = 0;
};

struct WorldSetting {
    physics::Vec2 gravity_m_s2{0, -10};
    bool enable_sleep = true;
    int threads = 1;  ///< of Cairn
    /// How hard the engine tries: substeps of Cairn, velocity iterations of Box2D (and 3 for every 8 of them
    /// for positions, at least 1), iterations of Chipmunk. 0: EngineKind::default_effort.
    int effort = 0;
};

/// How a body moves after the last step. Velocities are those of the centre of mass.
struct Motion {
    physics::Position position_m{};  ///< of the body's origin
    physics::Position center_m{};    ///< of its mass
    double c = 1;                    ///< cosine and sine of its angle
    double s = 0;
    double vx_m_s = 0;
    double vy_m_s = 0;
    double angular_velocity_rad_s = 0;
    bool awake = true;
};

struct Mass {
    double mass_kg = 0;        ///< 0 unless the body is dynamic
    double inertia_kg_m2 = 0;  ///< about the centre of mass
};

/// What the engine holds after the last step.
struct Tally {
    int bodies = 0;
    int shapes = 0;
    int joints = 0;
    int contacts = 0;  ///< pairs of shapes that are near each other, as the engine sees it
    int touching = 0;  ///< of those, the pairs that touch
};

class Engine {
  public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual BodyRef add_body(const physics::BodyDef& def) = 0;
    virtual void add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def) = 0;
    /// Segments from point to point and back to the first, solid on the right of that way where the engine
    /// knows sides.
    virtual void add_closed_chain(BodyRef body, std::span<const physics::Vec2> points_m,
                                  physics::Material material) = 0;
    // The bodies of the definitions are not looked at. Springs of revolute joints are for engines that know
    // them. Springs have the stiffness that gives the frequency by the masses alone.
    virtual void add_revolute(BodyRef a, BodyRef b, const physics::RevoluteJointDef& def) = 0;
    virtual void add_wheel(BodyRef a, BodyRef b, const physics::WheelJointDef& def) = 0;
    virtual void add_distance(BodyRef a, BodyRef b, const physics::DistanceJointDef& def) = 0;
    virtual void add_weld(BodyRef a, BodyRef b, const physics::WeldJointDef& def) = 0;
    /// With its shapes and joints.
    virtual void remove_body(BodyRef body) = 0;
    virtual void set_transform(BodyRef body, physics::Position position_m, double angle_rad) = 0;
    virtual void set_linear_velocity(BodyRef body, physics::Vec2 velocity_m_s) = 0;
    virtual void set_angular_velocity(BodyRef body, float velocity_rad_s) = 0;
    /// At the centre of mass, during the next step.
    virtual void apply_force(BodyRef body, physics::Vec2 force_n) = 0;
    [[nodiscard]] virtual physics::Position position(BodyRef body) const = 0;
    [[nodiscard]] virtual Motion motion(BodyRef body) const = 0;
    [[nodiscard]] virtual Mass mass(BodyRef body) const = 0;

    virtual void step(float dt_s) = 0;

    [[nodiscard]] virtual int awake_bodies() const = 0;  ///< dynamic and kinematic
    [[nodiscard]] virtual Tally tally() const = 0;
    [[nodiscard]] virtual float max_penetration_m() const = 0;
    /// Of each body that is not static, in an order that stays the same.
    [[nodiscard]] virtual std::vector<physics::Vec2> velocities_m_s() const = 0;

    // What only Cairn tells.
    [[nodiscard]] virtual physics::World* cairn_world() { return nullptr; }

    /// Adds a body with one shape.
    BodyRef add(const physics::BodyDef& body, const physics::Geometry& geometry,
                const physics::ShapeDef& def = {}) {
        const BodyRef made = add_body(body);
        add_shape(made, geometry, def);
        return made;
    }
};

/// An engine that this program was built with.
struct EngineKind {
    std::string_view name;
    std::unique_ptr<Engine> (*make)(const WorldSetting& setting);
    int default_effort = 0;  ///< what WorldSetting::effort of 0 means
};

std::unique_ptr<Engine> make_cairn(const WorldSetting& setting);
EngineKind cairn();
/// Other engines that were found when this program was built, in a fixed order.
std::span<const EngineKind> peers();
/// Names of those that were not.
std::span<const std::string_view> absent_peers();

}  // namespace cairn::measure
