// Problems 11, 12 and 13: what hangs, bends and stands, at rest.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "accuracy/problem.h"
#include "reference/statics.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::ShapeDef;

constexpr double kGravity_m_s2 = 10;
const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

// 11: twenty links of half a metre, hung up at both ends, begin where they would rest.
constexpr int kLinks = 20;
constexpr double kLink_m = 0.5;
constexpr double kLinkWidth_m = 0.1;
constexpr double kChainSpan_m = 0.7 * kLinks * kLink_m;
constexpr double kBridgeSpan_m = 0.99 * kLinks * kLink_m;

reference::HangingChain exact_chain(double span_m) {
    return reference::hanging_chain(kLinks, kLink_m, kLink_m * kLinkWidth_m * kGravity_m_s2, span_m);
}

struct Chain {
    BodyRef first_end;
    std::vector<BodyRef> links;
};

Chain add_chain(Rig& rig, double span_m) {
    const reference::HangingChain exact = exact_chain(span_m);
    Chain chain;
    chain.first_end = rig.add_body({.type = BodyType::Static});
    BodyRef last = chain.first_end;
    double x = 0, y = 0;
    for (const double angle : exact.angle_rad) {
        const double dx = kLink_m * std::cos(angle), dy = kLink_m * std::sin(angle);
        const BodyRef link = rig.add(
            {.position_m = {x + dx / 2, y + dy / 2}, .angle_rad = angle},
            Box{static_cast<float>(kLink_m / 2), static_cast<float>(kLinkWidth_m / 2)}, kMeetsNothing);
        rig.pin(last, link, {x, y});
        chain.links.push_back(link);
        last = link;
        x += dx;
        y += dy;
    }
    rig.pin(last, chain.first_end, {x, y});
    return chain;
}

// Mean over the last 5 of 10 s, of the lowest end of a link.
double sag_of(const Setting& setting, double span_m, double& tension_n) {
    const auto rig = rig_of(setting);
    const Chain chain = add_chain(*rig, span_m);
    rig->run(5, setting.dt_s);
    double sum = 0, tension = 0;
    const int steps = setting.steps(5);
    physics::World* const world = rig->engine().cairn_world();
    for (int i = 0; i < steps; ++i) {
        rig->step(setting.dt_s);
        double lowest = 0;
        for (const BodyRef link : chain.links) {
            lowest = std::min(lowest, world_point(rig->motion(link), {static_cast<float>(kLink_m / 2), 0}).y);
        }
        sum -= lowest;
        if (world != nullptr) {
            const auto end = world->body(physics::BodyId::from_bits(chain.first_end.bits));
            tension += static_cast<double>(length(world->joint(end->joints().front())->reaction_force()));
        }
    }
    tension_n = tension / steps;
    return sum / steps;
}

std::vector<double> chain_errors(const Setting& setting) {
    double tension = 0, unused = 0;
    const reference::HangingChain chain = exact_chain(kChainSpan_m), bridge = exact_chain(kBridgeSpan_m);
    const double chain_sag = sag_of(setting, kChainSpan_m, tension);
    const double bridge_sag = sag_of(setting, kBridgeSpan_m, unused);
    return {std::fabs(chain_sag / chain.sag_m - 1), std::fabs(bridge_sag / bridge.sag_m - 1),
            setting.kind.name == "cairn" ? std::fabs(tension / chain.end_tension_n - 1) : kNotTold};
}

// 12: ten links, the first welded to the wall; stiff enough that its tip comes down by 1 % of its length.
constexpr int kWelds = 10;
constexpr double kWeight_per_m = kLinkWidth_m * kGravity_m_s2;

double weld_stiffness_nm_rad() {
    const double n = kWelds, l = kLink_m;
    return kWeight_per_m * l * l * l * n * n * (n + 1) * (n + 1) / (8 * 0.01 * n * l);
}

BodyRef add_beam(Rig& rig) {
    BodyRef last = rig.add_body({.type = BodyType::Static});
    for (int i = 0; i < kWelds; ++i) {
        const BodyRef link = rig.add(
            {.position_m = {kLink_m * (i + 0.5), 0}},
            Box{static_cast<float>(kLink_m / 2), static_cast<float>(kLinkWidth_m / 2)}, kMeetsNothing);
        // The inertia that a weld's frequency is for: that of both bodies together.
        const double inertia = rig.engine().mass(link).inertia_kg_m2 / (i == 0 ? 1 : 2);
        const double hz = std::sqrt(weld_stiffness_nm_rad() / inertia) / (2 * std::numbers::pi);
        rig.weld(last, link, {kLink_m * i, 0}, static_cast<float>(hz), 1);
        last = link;
    }
    return last;
}

std::vector<double> cantilever_errors(const Setting& setting) {
    const auto rig = rig_of(setting);
    const BodyRef end = add_beam(*rig);
    rig->run(20, setting.dt_s);
    double sum = 0;
    const int steps = setting.steps(10);
    for (int i = 0; i < steps; ++i) {
        rig->step(setting.dt_s);
        sum += world_point(rig->motion(end), {static_cast<float>(kLink_m / 2), 0}).y;
    }
    const double exact = reference::cantilever_tip_m(kWelds, kLink_m, kWeight_per_m, weld_stiffness_nm_rad());
    return {std::fabs(sum / steps / exact - 1)};
}

// 13: ten boxes.
constexpr int kBoxes = 10;

std::vector<BodyRef> add_stack(Rig& rig) {
    rig.add_ground();
    std::vector<BodyRef> boxes;
    for (int i = 0; i < kBoxes; ++i) boxes.push_back(rig.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f}));
    return boxes;
}

std::vector<double> stack_errors(const Setting& setting) {
    const auto rig = rig_of(setting);
    const std::vector<BodyRef> boxes = add_stack(*rig);
    rig->run(10, setting.dt_s);
    // The top box tells what all levels together give way.
    const double sunk = std::fabs(kBoxes - 0.5 - rig->motion(boxes.back()).position_m.y) / kBoxes;
    std::vector<Position> before;
    for (const BodyRef box : boxes) before.push_back(rig->motion(box).position_m);
    rig->run(60, setting.dt_s);
    double creep = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        creep = std::max(creep, distance(rig->motion(boxes[i]).position_m, before[i]));
    }
    WorldSetting sleepy = setting.world();
    sleepy.enable_sleep = true;
    Rig sleeping(setting.kind, sleepy);
    sleeping.without_books();
    add_stack(sleeping);
    const int most = setting.steps(20);
    int steps = 0;
    while (steps < most && !sleeping.all_asleep()) {
        sleeping.step(setting.dt_s);
        ++steps;
    }
    // All three engines wait for half a second of rest.
    const double late_s = steps * static_cast<double>(setting.dt_s) - 0.5;
    return {sunk, creep,
            steps < most ? std::max(late_s, 0.0) / 0.5 : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace

void add_structures(std::vector<Problem>& problems) {
    problems.push_back(
        {.number = 11,
         .name = "hanging_chain",
         .metrics = {{"sag", "of the sag"}, {"bridge_sag", "of the sag"}, {"end_tension", "of the tension"}},
         .errors = chain_errors,
         .timed_s = 2,
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_chain(rig, kChainSpan_m), nullptr; }});
    problems.push_back({.number = 12,
                        .name = "cantilever",
                        .metrics = {{"tip_sag", "of the sag"}},
                        .errors = cantilever_errors,
                        .timed_s = 2,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_beam(rig), nullptr; }});
    problems.push_back({.number = 13,
                        .name = "stack",
                        .metrics = {{"sunk", "of a box, per level"},
                                    {"creep_60_s", "of a box"},
                                    {"sleeps_late", "of the time to sleep"}},
                        .errors = stack_errors,
                        .timed_s = 2,
                        .timed_scene = [](Rig& rig) -> BeforeStep { return add_stack(rig), nullptr; }});
}

}  // namespace cairn::lab
