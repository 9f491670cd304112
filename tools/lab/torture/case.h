// A torture case: a scene that is hard on an engine, and what must be true of it. Invariant: a case says the
// same about every engine, and nothing in it is chosen for one.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rig.h"

namespace cairn::lab {

inline constexpr double kNoLimit = std::numeric_limits<double>::quiet_NaN();

/// One number that a case found, and what it had to be.
struct Figure {
    std::string name;  ///< with its unit, as of every public name: drop_m
    double value = 0;
    double limit = kNoLimit;
    bool at_most = true;
    [[nodiscard]] bool holds() const;
};

/// What one run of a case found.
struct Findings {
    std::vector<Figure> figures;
    double energy_excess = 0;
    bool finite = true;
    std::uint64_t digest = 0;
    double cpu_s = 0;
};

/// One run of a case on one engine.
class Trial {
  public:
    Trial(const EngineKind& kind, int threads) : kind_(kind), threads_(threads) {}

    /// A new world; the one before is closed, and its reference must not be used any more.
    Rig& rig(const WorldSetting& setting = {});

    // What must hold. A value that is not a number does not hold.
    void at_most(std::string name, double value, double limit);
    void at_least(std::string name, double value, double limit);
    void require(std::string name, bool holds);  ///< 1 or 0 among the figures
    void note(std::string name, double value);   ///< nothing hangs on it

    [[nodiscard]] bool is_cairn() const;
    Findings finish();

  private:
    void close();

    EngineKind kind_;
    int threads_;
    std::unique_ptr<Rig> rig_;
    Findings findings_;
};

struct Case {
    std::string number;  ///< as in the specification: "19b"
    std::string name;
    bool for_every_engine = true;  ///< made of what every 2D engine has
    std::function<void(Trial&)> run;
};

/// In the order of their numbers.
std::span<const Case> all_cases();

// Families, in cases/. Each adds its own.
void add_heavy_on_light(std::vector<Case>& cases);
void add_stacks(std::vector<Case>& cases);
void add_chains(std::vector<Case>& cases);
void add_rigid_joints(std::vector<Case>& cases);
void add_joint_limits(std::vector<Case>& cases);
void add_springs(std::vector<Case>& cases);
void add_time_steps(std::vector<Case>& cases);
void add_sizes_and_places(std::vector<Case>& cases);
void add_fast_motion(std::vector<Case>& cases);
void add_overlaps(std::vector<Case>& cases);
void add_bad_input(std::vector<Case>& cases);
void add_extreme_materials(std::vector<Case>& cases);
void add_sleepers(std::vector<Case>& cases);

/// "Slop" of the criteria: the smaller of 5 mm and 1 % of the size.
double slop_m(double size_m);

}  // namespace cairn::lab
