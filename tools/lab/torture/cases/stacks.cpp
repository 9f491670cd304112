// Cases 5 to 8: tall and wide piles, and a house of cards, which stand as long as friction is as it should
// be.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyDef;
using physics::Box;

std::vector<BodyRef> add_stack(Rig& rig, int boxes) {
    std::vector<BodyRef> made;
    for (int i = 0; i < boxes; ++i) made.push_back(rig.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f}));
    return made;
}

double lean_m(const Rig& rig, const std::vector<BodyRef>& boxes) {
    double lean = 0;
    for (const BodyRef box : boxes) lean = std::max(lean, std::fabs(rig.motion(box).center_m.x));
    return lean;
}

void stack_of_30(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    const std::vector<BodyRef> boxes = add_stack(rig, 30);
    double lean = 0, asleep_s = kNoLimit;
    rig.run(10, kStep_s, [&](double t) {
        lean = std::max(lean, lean_m(rig, boxes));
        if (!rig.all_asleep()) {
            asleep_s = kNoLimit;
        } else if (std::isnan(asleep_s)) {
            asleep_s = t;
        }
    });
    trial.at_most("lean_m", lean, 0.01);
    trial.at_most("asleep_after_s", asleep_s, 5);
}

void tall_stacks(Trial& trial) {
    for (const int count : {100, 200}) {
        Rig& rig = trial.rig();
        rig.add_ground();
        const std::vector<BodyRef> boxes = add_stack(rig, count);
        rig.run(60);
        const double drop = count - 0.5 - rig.motion(boxes.back()).center_m.y;
        const std::string suffix = "_of_" + std::to_string(count);
        // It stands: every box is still on the one below.
        trial.at_most("lean" + suffix + "_m", lean_m(rig, boxes), 0.5);
        trial.at_most("drop" + suffix + "_m", drop, 0.5);
        trial.require("asleep" + suffix, rig.all_asleep());
    }
}

void pyramid(Trial& trial) {
    constexpr int kBase = 100;
    Rig& rig = trial.rig();
    rig.add_ground();
    BodyRef apex;
    for (int row = 0; row < kBase; ++row) {
        for (int i = 0; i < kBase - row; ++i) {
            apex = rig.add({.position_m = {i - 0.5 * (kBase - row - 1), row + 0.5}}, Box{0.5f, 0.5f});
        }
    }
    rig.run(10);
    trial.at_most("apex_drop_m", kBase - 0.5 - rig.motion(apex).center_m.y, 0.02);
}

// Pairs of cards lean on each other at 20 degrees; what they need of friction is tan(20 degrees) = 0.36.
void house_of_cards(Trial& trial) {
    constexpr int kStoreys = 4;
    constexpr double kLength_m = 1, kThickness_m = 0.02, kGap_m = 0.02;
    const double tilt = 20 * std::numbers::pi / 180;
    const double up = 0.5 * (kLength_m * std::cos(tilt) + kThickness_m * std::sin(tilt));
    const double across = 0.5 * (kLength_m * std::sin(tilt) + kThickness_m * std::cos(tilt));
    const double spacing = 4 * across + kGap_m;  // of neighbouring pairs
    const Box leaning{static_cast<float>(kThickness_m / 2), static_cast<float>(kLength_m / 2)};
    const Box lying{static_cast<float>((spacing - kGap_m / 4) / 2), static_cast<float>(kThickness_m / 2)};

    Rig& rig = trial.rig();
    rig.add_ground();
    std::vector<BodyRef> cards;
    std::vector<Position> places;
    const auto add = [&](const BodyDef& def, const Box& card) {
        cards.push_back(rig.add(def, card));
        places.push_back(def.position_m);
    };
    double floor_m = 0;
    for (int storey = 0; storey < kStoreys; ++storey) {
        const int pairs = kStoreys - storey;
        for (int i = 0; i < pairs; ++i) {
            const double middle = spacing * (i - 0.5 * (pairs - 1));
            add({.position_m = {middle - across, floor_m + up}, .angle_rad = -tilt}, leaning);
            add({.position_m = {middle + across, floor_m + up}, .angle_rad = tilt}, leaning);
        }
        for (int i = 0; i + 1 < pairs; ++i) {
            const double middle = spacing * (i - 0.5 * (pairs - 2));
            add({.position_m = {middle, floor_m + 2 * up + kThickness_m / 2}}, lying);
        }
        floor_m += 2 * up + kThickness_m;
    }
    rig.run(30);
    double farthest = 0;
    for (std::size_t i = 0; i < cards.size(); ++i) {
        farthest = std::max(farthest, distance(rig.motion(cards[i]).position_m, places[i]));
    }
    // It stands: no card has moved by a tenth of its length.
    trial.at_most("moved_m", farthest, 0.1 * kLength_m);
}

}  // namespace

void add_stacks(std::vector<Case>& cases) {
    cases.push_back({"5", "stack of 30", true, stack_of_30});
    cases.push_back({"6", "stacks of 100 and of 200 stand 60 s and sleep", true, tall_stacks});
    cases.push_back({"7", "pyramid of 100 rows", true, pyramid});
    cases.push_back({"8", "house of cards of 4 storeys stands 30 s", true, house_of_cards});
}

}  // namespace cairn::lab
