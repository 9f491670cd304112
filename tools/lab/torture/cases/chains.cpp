// Cases 10 to 15: chains and grids of pins under loads, and a beam of welds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

constexpr double kLink_m = 0.5;
constexpr double kLinkWidth_m = 0.1;
const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

struct Chain {
    double length_m = 0;
    BodyRef ball;
    double rest_y_m = 0;  // of the ball, if nothing gave
};

// It hangs straight down from the origin, with a ball of `ratio` times the mass of a link at its end.
Chain add_chain(Rig& rig, int links, double ratio) {
    BodyRef last = rig.add_body({.type = BodyType::Static});
    double y = 0;
    for (int i = 0; i < links; ++i) {
        const BodyRef link = rig.add(
            {.position_m = {0, y - kLink_m / 2}},
            Box{static_cast<float>(kLinkWidth_m / 2), static_cast<float>(kLink_m / 2)}, kMeetsNothing);
        rig.pin(last, link, {0, y});
        last = link;
        y -= kLink_m;
    }
    constexpr double kRadius_m = 1;
    ShapeDef heavy = kMeetsNothing;
    heavy.density_kg_m2 =
        static_cast<float>(ratio * kLink_m * kLinkWidth_m / (std::numbers::pi * kRadius_m * kRadius_m));
    const BodyRef ball =
        rig.add({.position_m = {0, y - kRadius_m}}, Circle{{}, static_cast<float>(kRadius_m)}, heavy);
    rig.pin(last, ball, {0, y});
    return {-y, ball, y - kRadius_m};
}

void hanging_chain(Trial& trial, int links, double ratio, double most_stretch) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const Chain chain = add_chain(rig, links, ratio);
    double most_m = 0;
    rig.run(10, kStep_s,
            [&](double) { most_m = std::max(most_m, chain.rest_y_m - rig.motion(chain.ball).position_m.y); });
    trial.at_most("stretch", most_m / chain.length_m, most_stretch);
    trial.note("stretch_at_end", (chain.rest_y_m - rig.motion(chain.ball).position_m.y) / chain.length_m);
    trial.note("joint_error_m", rig.joint_error_m());
}

void chain_of_20(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const Chain chain = add_chain(rig, 20, 1e6);
    double most_m = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    rig.run(10, kStep_s, [&](double t) {
        const double y = rig.motion(chain.ball).position_m.y;
        most_m = std::max(most_m, chain.rest_y_m - y);
        if (t > 5) {
            low = std::min(low, y);
            high = std::max(high, y);
        }
    });
    trial.at_most("stretch", most_m / chain.length_m, 0.01);
    trial.at_most("jitter_m", high - low, 0.001);  // in the last 5 s
}

// As in Box2D's benchmark: discs a metre apart, pinned half-way between, seven in the middle of the top row
// held. Its joints, soft at 60 Hz, were seen to open by about 20 cm in version 3.2.
void joint_grid(Trial& trial) {
    constexpr int kSide = 100;
    constexpr double kPeerError_m = 0.2;
    Rig& rig = trial.rig({.enable_sleep = false});
    std::vector<BodyRef> row_above;
    for (int row = 0; row < kSide; ++row) {
        std::vector<BodyRef> discs;
        for (int column = 0; column < kSide; ++column) {
            const bool held = row == 0 && column >= 47 && column <= 53;
            discs.push_back(rig.add({.type = held ? BodyType::Static : BodyType::Dynamic,
                                     .position_m = {1.0 * column, -1.0 * row}},
                                    Circle{{}, 0.4f}, kMeetsNothing));
            if (row > 0)
                rig.pin(row_above[static_cast<std::size_t>(column)], discs.back(), {1.0 * column, 0.5 - row});
            const bool left_held = row == 0 && column >= 48 && column <= 54;
            if (column > 0 && !(held && left_held)) {
                rig.pin(discs[static_cast<std::size_t>(column) - 1], discs.back(),
                        {column - 0.5, -1.0 * row});
            }
        }
        row_above = std::move(discs);
    }
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        rig.run(0.1);
        worst = std::max(worst, rig.joint_error_m());
    }
    trial.at_most("joint_error_m", worst, kPeerError_m / 2);
    trial.note("joint_error_at_end_m", rig.joint_error_m());
}

void weld_cantilever(Trial& trial) {
    constexpr int kLinks = 40;
    Rig& rig = trial.rig({.enable_sleep = false});
    BodyRef last = rig.add_body({.type = BodyType::Static});
    for (int i = 0; i < kLinks; ++i) {
        const BodyRef link = rig.add({.position_m = {kLink_m * (i + 0.5), 0}},
                                     Box{static_cast<float>(kLink_m / 2), 0.125f}, kMeetsNothing);
        rig.weld(last, link, {kLink_m * i, 0});
        last = link;
    }
    const double length = kLinks * kLink_m;
    double lowest = 0;
    rig.run(10, kStep_s, [&](double) {
        lowest = std::min(lowest, world_point(rig.motion(last), {static_cast<float>(kLink_m / 2), 0}).y);
    });
    trial.at_most("tip_sag", -lowest / length, 0.01);
    trial.note("tip_sag_at_end",
               -world_point(rig.motion(last), {static_cast<float>(kLink_m / 2), 0}).y / length);
}

}  // namespace

void add_chains(std::vector<Case>& cases) {
    cases.push_back({"10", "chain of 100 bears 10^4 links", true,
                     [](Trial& trial) { hanging_chain(trial, 100, 1e4, 0.005); }});
    cases.push_back({"11", "chain of 1,000 bears 10^4 links", true,
                     [](Trial& trial) { hanging_chain(trial, 1000, 1e4, 0.01); }});
    cases.push_back({"13", "chain of 20 bears 10^6 links", true, chain_of_20});
    cases.push_back({"14", "grid of 100 x 100 pinned discs", true, joint_grid});
    cases.push_back({"15", "cantilever of 40 rigid welds", true, weld_cantilever});
}

}  // namespace cairn::lab
