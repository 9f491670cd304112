// Problem 24: the slope of a pile that a column of hexagons falls into. There is no formula for it: an engine
// is compared with itself, at 32 substeps or iterations and steps of 1/240 s. A pile is chaotic, so each
// setting runs from many starts that differ by a micrometre, and means are compared. Such starts go down much
// alike: what piles do in general, docs/adr/029-both-points-at-once.md tells.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "accuracy/problem.h"
#include "random.h"

namespace cairn::lab {
namespace {

using physics::Polygon;
using physics::ShapeDef;

constexpr double kRadius_m = 0.25;
constexpr int kAcross = 4;
constexpr int kUp = 10;

std::vector<BodyRef> add_column(Rig& rig, std::uint64_t seed) {
    const ShapeDef gravel{.material = {.friction = 0.5f}};
    rig.add_ground(0, gravel);
    std::array<Vec2, 6> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle = static_cast<double>(i) * std::numbers::pi / 3;
        corners[i] = {static_cast<float>(kRadius_m * std::cos(angle)),
                      static_cast<float>(kRadius_m * std::sin(angle))};
    }
    measure::Random random(seed);
    std::vector<BodyRef> stones;
    for (int row = 0; row < kUp; ++row) {
        for (int column = 0; column < kAcross; ++column) {
            const double x = 2.05 * kRadius_m * (column + 0.5 * (row % 2) - 0.5 * kAcross);
            const double y = kRadius_m + 1.8 * kRadius_m * row;
            stones.push_back(
                rig.add({.position_m = {x + random.real(-1e-6, 1e-6), y + random.real(-1e-6, 1e-6)}},
                        Polygon{.points_m = corners}, gravel));
        }
    }
    return stones;
}

// Of a triangle of height h and half width w, the centre is h / 3 up, and the mean distance from the middle w
// / 3.
double slope_after(const Setting& setting, std::uint64_t seed) {
    const auto rig = rig_of(setting);
    const std::vector<BodyRef> stones = add_column(*rig, seed);
    rig->run(5, setting.dt_s);
    double height = 0, middle = 0, width = 0;
    for (const BodyRef stone : stones) {
        const Position p = rig->motion(stone).position_m;
        height += p.y - 0.87 * kRadius_m;  // above what lies on the ground
        middle += p.x;
    }
    middle /= static_cast<double>(stones.size());
    for (const BodyRef stone : stones) width += std::fabs(rig->motion(stone).position_m.x - middle);
    return height / width;
}

struct Ensemble {
    double mean = 0;
    double half_width = 0;  // of the 95 % interval of the mean
};

Ensemble ensemble_of(const Setting& setting) {
    const int runs = setting.quick ? 6 : 64;
    double sum = 0, squares = 0;
    for (int i = 0; i < runs; ++i) {
        const double slope = slope_after(setting, static_cast<std::uint64_t>(i) + 1);
        sum += slope;
        squares += slope * slope;
    }
    const double mean = sum / runs;
    const double variance = std::max(0.0, (squares - runs * mean * mean) / (runs - 1));
    return {mean, 1.96 * std::sqrt(variance / runs)};
}

// It takes longer than all else, and is the same for all settings of an engine.
const Ensemble& reference_of(const Setting& setting) {
    static std::map<std::string, Ensemble> known;
    const auto [found, is_new] = known.try_emplace(std::string(setting.kind.name));
    if (is_new) {
        Setting fine = setting;
        fine.effort = 32;
        fine.dt_s = 1.0f / 240;
        found->second = ensemble_of(fine);
    }
    return found->second;
}

std::vector<double> pile_errors(const Setting& setting) {
    const Ensemble exact = reference_of(setting), found = ensemble_of(setting);
    return {std::fabs(found.mean / exact.mean - 1),
            std::hypot(found.half_width, exact.half_width) / exact.mean};
}

}  // namespace

void add_piles(std::vector<Problem>& problems) {
    problems.push_back({.number = 24,
                        .name = "pile",
                        .metrics = {{"slope", "of the slope"}, {"confidence", "of the slope", false}},
                        .errors = pile_errors,
                        .timed_s = 2,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_column(rig, 1), nullptr; }});
}

}  // namespace cairn::lab
