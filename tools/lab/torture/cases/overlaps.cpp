// Cases 26, 35, 40 and 42: bodies that stand in each other, joints torn apart, a crush, and an explosion.
#include <algorithm>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

// How fast overlap is undone at most, of Cairn by its documentation.
double push_out_cap_m_s() {
    return physics::WorldDef{}.max_push_out_speed_m_s;
}

// 25 boxes, each overlapping its neighbours by half. Nothing else acts on them.
void overlapping_pile(Trial& trial) {
    Rig& rig = trial.rig({.gravity_m_s2 = {0, 0}, .enable_sleep = false});
    for (int i = 0; i < 25; ++i) rig.add({.position_m = {0.5 * (i % 5), 0.5 * (i / 5)}}, Box{0.5f, 0.5f});
    rig.begin_books();
    rig.allow_work(25 * 0.5 * push_out_cap_m_s() * push_out_cap_m_s());  // all of them at the cap, 1 kg each
    double fastest = 0;
    rig.run(10, kStep_s, [&](double) { fastest = std::max(fastest, rig.max_speed_m_s()); });
    trial.at_most("exit_speed_m_s", rig.max_speed_m_s(), push_out_cap_m_s());
    trial.note("fastest_m_s", fastest);
    trial.at_most("penetration_at_end_m", rig.max_penetration_m(), slop_m(1));
}

void teleport_into_wall(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    rig.add({.type = BodyType::Static, .position_m = {5.5, 2}}, Box{0.5f, 2});
    const BodyRef box = rig.add({.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    rig.run(1);
    rig.engine().set_transform(box, {4.8, 0.5}, 0);  // 0.3 m inside
    rig.begin_books();
    rig.allow_work(0.5 * push_out_cap_m_s() * push_out_cap_m_s());
    rig.run(3);
    trial.at_most("penetration_after_3_s_m", rig.max_penetration_m(), slop_m(1));
    trial.at_most("in_wall_m", rig.motion(box).position_m.x + 0.5 - 5, slop_m(1));
}

void torn_joint(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const BodyRef hook = rig.add_body({.type = BodyType::Static});
    const BodyRef bob = rig.add({.position_m = {0, -1}}, Circle{{}, 0.25f}, kMeetsNothing);
    rig.pin(hook, bob, {0, 0});
    rig.run(1);
    rig.engine().set_transform(bob, {100, 0}, 0);
    rig.begin_books();
    // A weight pulled 100 m in a moment may arrive with any energy that the joint gives it; it must end.
    rig.allow_work(1e9);
    double fastest = 0;
    rig.run(3, kStep_s, [&](double) { fastest = std::max(fastest, rig.max_speed_m_s()); });
    trial.at_most("joint_error_after_3_s_m", rig.joint_error_m(), 0.005);
    trial.note("fastest_m_s", fastest);
}

void teleports(Trial& trial) {
    teleport_into_wall(trial);
    torn_joint(trial);
}

void crush(Trial& trial) {
    constexpr double kJawSpeed_m_s = 0.5;
    Rig& rig = trial.rig();
    rig.add_ground();
    const auto jaw = [&](double x, double vx) {
        return rig.add({.type = BodyType::Kinematic,
                        .position_m = {x, 1},
                        .linear_velocity_m_s = {static_cast<float>(vx), 0}},
                       Box{0.5f, 1});
    };
    const BodyRef left = jaw(-2, kJawSpeed_m_s);
    const BodyRef right = jaw(2, -kJawSpeed_m_s);
    const BodyRef box = rig.add({.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    rig.begin_books();
    rig.allow_work(0.5 * push_out_cap_m_s() * push_out_cap_m_s() +
                   10 * 3);  // at the cap, or on top of the jaws
    double fastest = 0;
    const auto watch = [&](double) { fastest = std::max(fastest, speed(rig.motion(box))); };
    rig.run(3, kStep_s, watch);  // 1.5 m each: the gap is closed
    rig.engine().set_linear_velocity(left, {0, 0});
    rig.engine().set_linear_velocity(right, {0, 0});
    rig.run(1, kStep_s, watch);
    rig.engine().set_linear_velocity(left, {static_cast<float>(-kJawSpeed_m_s), 0});
    rig.engine().set_linear_velocity(right, {static_cast<float>(kJawSpeed_m_s), 0});
    rig.run(3, kStep_s, watch);
    rig.engine().set_linear_velocity(left, {0, 0});
    rig.engine().set_linear_velocity(right, {0, 0});
    rig.run(3, kStep_s, watch);
    trial.at_most("fastest_m_s", fastest, push_out_cap_m_s());
    trial.at_most("penetration_at_end_m", rig.max_penetration_m(), slop_m(1));
    trial.at_most("speed_at_end_m_s", speed(rig.motion(box)), 0.05);
}

void explosion(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    for (int i = 0; i < 10; ++i) rig.add({.position_m = {i - 4.5, 0.5}}, Box{0.4f, 0.5f});
    rig.run(1);
    // Per metre of outline; a box shows at most 1.3 m of its own.
    rig.engine().cairn_world()->explode({.center_m = {0, -1}, .radius_m = 20, .impulse_ns_m = 1e9f}).value();
    rig.begin_books();
    double fastest = 0;
    rig.run(9, kStep_s, [&](double) { fastest = std::max(fastest, rig.max_speed_m_s()); });
    trial.at_most("fastest_m_s", fastest, 1.3e9 / 0.8);
    trial.at_most("quarantined", static_cast<double>(rig.engine().cairn_world()->quarantined().size()), 0);
}

}  // namespace

void add_overlaps(std::vector<Case>& cases) {
    cases.push_back({"26", "25 boxes that overlap by half", true, overlapping_pile});
    cases.push_back({"35", "teleport into a wall; joint torn 100 m apart", true, teleports});
    cases.push_back({"40", "two kinematic bodies crush a third", true, crush});
    cases.push_back({"42", "explosion of 10^9 N s", false, explosion});
}

}  // namespace cairn::lab
