// Cases 20 to 22: bodies of 1 mm and of 1 km, and stacks far from the origin.
#include <algorithm>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;

// Three columns of five boxes fall on each other, from a tenth of their size or 10 cm.
void pile_of_size(Trial& trial, double size_m) {
    constexpr double kDuration_s = 10;
    constexpr int kHigh = 5;
    const double gap_m = std::min(0.1 * size_m, 0.1);
    Rig& rig = trial.rig();
    rig.add({.type = BodyType::Static, .position_m = {0, -size_m}},
            Box{static_cast<float>(50 * size_m), static_cast<float>(size_m)});
    std::vector<BodyRef> boxes;
    for (int column = -1; column <= 1; ++column) {
        for (int i = 0; i < kHigh; ++i) {
            boxes.push_back(
                rig.add({.position_m = {1.5 * size_m * column, 0.5 * size_m + gap_m + (size_m + gap_m) * i}},
                        Box{static_cast<float>(size_m / 2), static_cast<float>(size_m / 2)}));
        }
    }
    double fastest = 0;
    rig.run(kDuration_s, kStep_s, [&](double t) {
        if (t > kDuration_s - 0.5) fastest = std::max(fastest, rig.max_speed_m_s());
    });
    double sunk_m = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double level_m = size_m * (static_cast<double>(i % kHigh) + 0.5);
        sunk_m = std::max(sunk_m, level_m - rig.motion(boxes[i]).position_m.y);
    }
    // At rest: in the last half second slower than 5 cm/s, and than what free fall gives over 1 % of their
    // size.
    trial.at_most("fastest_at_end_m_s", fastest, std::min(0.05, std::sqrt(2 * 10 * 0.01 * size_m)));
    // On what is below, and not in it.
    trial.at_most("sunk_in_sizes", sunk_m / size_m, 0.5);
    trial.note("asleep", rig.all_asleep() ? 1 : 0);
}

std::vector<Position> stack_at(Trial& trial, double x_m) {
    Rig& rig = trial.rig();
    rig.add({.type = BodyType::Static, .position_m = {x_m, x_m - 1}}, Box{20, 1});
    std::vector<BodyRef> boxes;
    for (int i = 0; i < 10; ++i)
        boxes.push_back(rig.add({.position_m = {x_m, x_m + i + 0.5}}, Box{0.5f, 0.5f}));
    rig.run(10);
    std::vector<Position> places;
    for (const BodyRef box : boxes) {
        const Position p = rig.motion(box).position_m;
        places.push_back({p.x - x_m, p.y - x_m});
    }
    return places;
}

void far_stacks(Trial& trial) {
    const std::vector<Position> here = stack_at(trial, 0);
    double differs = 0;
    for (const double x_m : {2e4, 1e6, 1e7}) {
        const std::vector<Position> there = stack_at(trial, x_m);
        for (std::size_t i = 0; i < here.size(); ++i) {
            const double apart = distance(here[i], there[i]);
            if (!(apart <= differs)) differs = apart;
        }
    }
    trial.at_most("differs_m", differs, slop_m(1));
}

}  // namespace

void add_sizes_and_places(std::vector<Case>& cases) {
    cases.push_back(
        {"20", "boxes of 1 mm come to rest", true, [](Trial& trial) { pile_of_size(trial, 0.001); }});
    cases.push_back(
        {"21", "boxes of 1 km come to rest", true, [](Trial& trial) { pile_of_size(trial, 1000); }});
    cases.push_back({"22", "stack at 20 km, 10^6 m and 10^7 m from the origin", true, far_stacks});
}

}  // namespace cairn::lab
