// A world of one engine under examination, and books about it: energy, momentum, how far joints are open, CPU
// time, and whether all numbers are finite. Invariant: the books are kept from outside, by the same formulas
// for every engine; keeping them changes nothing in the world.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "engine.h"

namespace cairn::lab {

using measure::BodyRef;
using measure::EngineKind;
using measure::Mass;
using measure::Motion;
using measure::WorldSetting;
using physics::Position;
using physics::Vec2;

inline constexpr float kStep_s = 1.0f / 60;

/// Of one process, by CLOCK_PROCESS_CPUTIME_ID: all threads together.
double cpu_time_s();

/// Where the point of a body's frame is.
Position world_point(const Motion& motion, Vec2 local_m);
double distance(Position a, Position b);
double speed(const Motion& motion);  ///< of the centre of mass, m/s

class Rig {
  public:
    Rig(const EngineKind& kind, const WorldSetting& setting);

    // Building. Joints are given where they are in the world.
    BodyRef add_body(const physics::BodyDef& def);
    void add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def = {});
    BodyRef add(const physics::BodyDef& def, const physics::Geometry& geometry,
                const physics::ShapeDef& shape = {});
    /// Static, 2 km wide, its surface level at y = top_m.
    BodyRef add_ground(double top_m = 0, const physics::ShapeDef& shape = {});
    void pin(BodyRef a, BodyRef b, Position at_m);
    void weld(BodyRef a, BodyRef b, Position at_m, float frequency_hz = 0, float damping_ratio = 1);
    void rod(BodyRef a, BodyRef b, Position on_a_m, Position on_b_m);
    void spring(BodyRef a, BodyRef b, Position on_a_m, Position on_b_m, double rest_m, float frequency_hz,
                float damping_ratio);
    void remove(BodyRef body);

    /// From now on no books are kept, and steps cost what they cost the engine.
    void without_books() { keeps_books_ = false; }
    /// One step, and what it did goes into the books.
    void step(float dt_s = kStep_s);
    /// Steps of dt_s until about `duration_s` have passed; `after_each` gets the time since the call.
    void run(double duration_s, float dt_s = kStep_s, const std::function<void(double)>& after_each = {});

    [[nodiscard]] Motion motion(BodyRef body) const { return engine_->motion(body); }
    [[nodiscard]] measure::Engine& engine() { return *engine_; }
    [[nodiscard]] double max_penetration_m() const { return engine_->max_penetration_m(); }
    [[nodiscard]] double max_speed_m_s() const;  ///< of dynamic bodies
    [[nodiscard]] bool all_asleep() const { return engine_->awake_bodies() == 0; }
    /// Largest distance between the two points of a pin or weld.
    [[nodiscard]] double joint_error_m() const;

    /// Of dynamic bodies and springs; the potential energy is 0 where the books began.
    [[nodiscard]] double energy_j() const;
    [[nodiscard]] Vec2 momentum_kg_m_s() const;
    /// About the origin.
    [[nodiscard]] double angular_momentum_kg_m2_s() const;

    /// What acts from outside may add this much from now on.
    void allow_work(double joules) { allowed_work_j_ += joules; }
    /// The case has changed something by hand: energy is counted from here.
    void begin_books();
    /// Largest energy above what was there and was allowed, as a share of the larger of the kinetic energy
    /// and the sum of m g times the height of the scene.
    [[nodiscard]] double energy_excess() const { return energy_excess_; }
    [[nodiscard]] bool finite() const { return finite_; }
    /// Of Cairn: over states along the way and the last one; 0 of others.
    [[nodiscard]] std::uint64_t digest() const;
    [[nodiscard]] double cpu_s() const { return cpu_s_; }

  private:
    struct Part {
        BodyRef body;
        Mass mass;
        double gravity_scale = 1;
        Position start_m;    // where its potential energy is 0
        double reach_m = 0;  // no point of it is farther from its origin
        bool present = true;
        bool dynamic = false;
    };
    struct Pin {
        BodyRef a, b;
        Vec2 local_a_m, local_b_m;
    };
    struct Spring : Pin {
        double rest_m = 0;
        double stiffness_n_m = 0;
    };

    struct Energies {
        double kinetic_j = 0;
        double potential_j = 0;
        bool finite = true;  // with the motion of bodies that are not dynamic
    };

    [[nodiscard]] Part& part(BodyRef body);
    [[nodiscard]] Vec2 local(BodyRef body, Position world_m) const;
    [[nodiscard]] Energies energies() const;
    void keep_books();

    std::unique_ptr<measure::Engine> engine_;
    Vec2 gravity_m_s2_;
    std::vector<Part> parts_;
    std::vector<Pin> pins_;
    std::vector<Spring> springs_;
    bool keeps_books_ = true;
    bool books_open_ = false;
    double energy_at_start_j_ = 0;
    double allowed_work_j_ = 0;
    double weight_times_height_j_ = 0;
    double most_kinetic_j_ = 0;
    double energy_excess_ = 0;
    bool finite_ = true;
    std::uint64_t digest_ = 0;
    std::int64_t steps_ = 0;
    double cpu_s_ = 0;
};

}  // namespace cairn::lab
