// Cases 18 and 19b: steps of other lengths than 1/60 s, and steps that change all the time.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};
constexpr int kBoxes = 30;
constexpr int kLinks = 100;

// Case 5 as it is after 10 s.
std::vector<Position> stack_after(Trial& trial, float dt_s) {
    Rig& rig = trial.rig();
    rig.add_ground();
    std::vector<BodyRef> boxes;
    for (int i = 0; i < kBoxes; ++i) boxes.push_back(rig.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f}));
    rig.run(10, dt_s);
    std::vector<Position> places;
    for (const BodyRef box : boxes) places.push_back(rig.motion(box).position_m);
    return places;
}

// Case 10.
Position ball_after(Trial& trial, float dt_s) {
    Rig& rig = trial.rig({.enable_sleep = false});
    BodyRef last = rig.add_body({.type = BodyType::Static});
    for (int i = 0; i < kLinks; ++i) {
        const BodyRef link = rig.add({.position_m = {0, -0.5 * i - 0.25}}, Box{0.05f, 0.25f}, kMeetsNothing);
        rig.pin(last, link, {0, -0.5 * i});
        last = link;
    }
    ShapeDef heavy = kMeetsNothing;
    heavy.density_kg_m2 = static_cast<float>(1e4 * 0.05 / std::numbers::pi);
    const BodyRef ball = rig.add({.position_m = {0, -0.5 * kLinks - 1}}, Circle{{}, 1}, heavy);
    rig.pin(last, ball, {0, -0.5 * kLinks});
    rig.run(10, dt_s);
    return rig.motion(ball).position_m;
}

void same_rest_state(Trial& trial) {
    const std::vector<Position> stack = stack_after(trial, kStep_s);
    const Position ball = ball_after(trial, kStep_s);
    double stack_differs = 0, ball_differs = 0;
    for (const float rate_hz : {15.0f, 30.0f, 120.0f, 240.0f, 1000.0f}) {
        const std::vector<Position> other = stack_after(trial, 1 / rate_hz);
        for (std::size_t i = 0; i < stack.size(); ++i) {
            stack_differs = std::max(stack_differs, distance(stack[i], other[i]));
        }
        const double apart = distance(ball, ball_after(trial, 1 / rate_hz));
        if (!(apart <= ball_differs)) ball_differs = apart;
    }
    trial.at_most("stack_differs_m", stack_differs, 2 * slop_m(1));
    trial.at_most("chain_differs_m", ball_differs, 2 * slop_m(1));
}

// A stack, a pendulum and a spring with a load, in one world.
void alternating_steps(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    rig.add_ground();
    std::vector<BodyRef> boxes;
    for (int i = 0; i < 10; ++i) boxes.push_back(rig.add({.position_m = {0, i + 0.5}}, Box{0.5f, 0.5f}));
    const BodyRef hook = rig.add_body({.type = BodyType::Static, .position_m = {10, 10}});
    const BodyRef bob = rig.add({.position_m = {12, 10}}, Circle{{}, 0.25f}, kMeetsNothing);
    rig.pin(hook, bob, {10, 10});
    const BodyRef load = rig.add({.position_m = {10, 7}}, Circle{{}, 0.25f}, kMeetsNothing);
    rig.spring(hook, load, {10, 10}, {10, 7}, 2, 1, 0);
    double fastest_box = 0;
    for (int i = 0; i < 10 * 60; ++i) {
        rig.step(i % 2 == 0 ? 1.0f / 30 : 1.0f / 240);
        for (const BodyRef box : boxes) fastest_box = std::max(fastest_box, speed(rig.motion(box)));
    }
    // The books of G tell whether energy was added; the stack must not even tremble.
    trial.at_most("fastest_box_m_s", fastest_box, 0.05);
    trial.at_most("stack_sideways_m", std::fabs(rig.motion(boxes.back()).center_m.x), 0.01);
}

}  // namespace

void add_time_steps(std::vector<Case>& cases) {
    cases.push_back({"18", "cases 5 and 10 at steps of 1/15 to 1/1000 s", true, same_rest_state});
    cases.push_back({"19b", "steps of 1/30 and 1/240 s by turns", true, alternating_steps});
}

}  // namespace cairn::lab
