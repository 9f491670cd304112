// A problem of the accuracy run: a scene with a known solution. Invariant: an error is relative to something
// that the problem itself gives, so that 1 % means the same everywhere; and a problem says the same about
// every engine.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "rig.h"

namespace cairn::lab {

/// One point of a sweep.
struct Setting {
    EngineKind kind;
    int effort = 0;  ///< substeps or iterations, 0: the engine's default
    float dt_s = kStep_s;
    bool quick = false;  ///< ensembles may be smaller

    [[nodiscard]] WorldSetting world(Vec2 gravity_m_s2 = {0, -10}) const {
        return {.gravity_m_s2 = gravity_m_s2, .enable_sleep = false, .effort = effort};
    }
    [[nodiscard]] int steps(double duration_s) const;
};

/// What an error is of, and what it is relative to.
struct Metric {
    std::string name;
    std::string unit;
    bool compared = true;  ///< false: told for information
};

/// What to do before each step; may be empty.
using BeforeStep = std::function<void(Rig&)>;

/// An engine that cannot tell has this in place of an error.
inline constexpr double kNotTold = -1;

struct Problem {
    int number = 0;  ///< as in the specification
    std::string name;
    std::vector<Metric> metrics;
    /// One error for each metric. Not finite: the run has failed.
    std::function<std::vector<double>(const Setting&)> errors;
    // What is timed: a scene of the problem, and how long it runs.
    double timed_s = 1;
    Vec2 timed_gravity_m_s2{0, -10};
    std::function<BeforeStep(Rig&)> timed_scene;
};

/// In the order of their numbers.
std::span<const Problem> all_problems();

// Families, in problems/. Each adds its own.
void add_flight(std::vector<Problem>& problems);
void add_bounces(std::vector<Problem>& problems);
void add_friction(std::vector<Problem>& problems);
void add_pendulums(std::vector<Problem>& problems);
void add_oscillators(std::vector<Problem>& problems);
void add_collisions(std::vector<Problem>& problems);
void add_structures(std::vector<Problem>& problems);
void add_piles(std::vector<Problem>& problems);

/// A rig for a setting, without books.
std::unique_ptr<Rig> rig_of(const Setting& setting, Vec2 gravity_m_s2 = {0, -10});

/// Where `holds` changes from false to true between low and high, to `tolerance` of their distance.
double bisect(double low, double high, double tolerance, const std::function<bool(double)>& holds);

/// The largest value of the parabola through three equally spaced samples around a maximum.
double apex(double before, double highest, double after);

/// An angle brought to (-pi, pi].
double wrapped(double angle_rad);

}  // namespace cairn::lab
