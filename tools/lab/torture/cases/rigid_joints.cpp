// Cases 30 and 31: joints without length, and joints that say the same several times.
#include <algorithm>
#include <array>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyId;
using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::JointDef;
using physics::ShapeDef;

const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

// Two bodies whose centres coincide, joined at them by each kind that a world accepts there.
void coincident_anchors(Trial& trial) {
    const std::array<JointDef, 8> joints{
        physics::DistanceJointDef{.length_m = 0},
        physics::DistanceJointDef{
            .length_m = 0.1f, .enable_spring = true, .frequency_hz = 30, .damping_ratio = 0.5f},
        physics::DistanceJointDef{.length_m = 1},
        physics::RevoluteJointDef{},
        physics::PrismaticJointDef{},
        physics::WeldJointDef{},
        physics::MotorJointDef{.linear_frequency_hz = 5, .max_force_n = 100, .max_torque_nm = 100},
        physics::PulleyJointDef{.wheel_a_m = {0, 0}, .wheel_b_m = {0, 0}, .length_m = 1},
    };
    int refused = 0;
    double fastest = 0;
    for (JointDef def : joints) {
        Rig& rig = trial.rig({.enable_sleep = false});
        const BodyRef a = rig.add({}, Box{0.5f, 0.5f}, kMeetsNothing);
        const BodyRef b = rig.add({}, Box{0.25f, 0.5f}, kMeetsNothing);
        const BodyRef held = rig.add_body({.type = BodyType::Static});
        rig.pin(held, a, {0, 0});
        std::visit(
            [&](auto& joint) {
                if constexpr (requires { joint.body_a; }) {
                    joint.body_a = BodyId::from_bits(a.bits);
                    joint.body_b = BodyId::from_bits(b.bits);
                }
            },
            def);
        if (!rig.engine().cairn_world()->create_joint(def)) ++refused;
        // Energy that a stretched joint held is unknown to the books: a joint of 1 m pushes from 0.
        rig.begin_books();
        rig.allow_work(1e3);
        rig.run(10, kStep_s, [&](double) { fastest = std::max(fastest, rig.max_speed_m_s()); });
    }
    trial.note("refused_with_an_error", refused);
    trial.at_most("fastest_m_s", fastest, 150);  // 10 s of free fall give 100
}

void parallel_welds(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const BodyRef wall = rig.add_body({.type = BodyType::Static});
    const BodyRef beam = rig.add({.position_m = {0.5, 0}}, Box{0.5f, 0.5f}, kMeetsNothing);
    for (int i = 0; i < 10; ++i) rig.weld(wall, beam, {0, 0.1 * i - 0.45});
    double drift = 0, force = 0;
    rig.run(10, kStep_s, [&](double) {
        drift = std::max(drift, distance(rig.motion(beam).position_m, {0.5, 0}));
        if (physics::World* const world = rig.engine().cairn_world(); world != nullptr) {
            for (const physics::JointId joint : world->body(BodyId::from_bits(beam.bits))->joints()) {
                const double now = length(world->joint(joint)->reaction_force());
                if (!(now <= force)) force = now;
            }
        }
    });
    trial.at_most("weld_drift_m", drift, 0.001);
    trial.at_most("weld_force_n", force, 1e3);  // the beam weighs 10 N
}

// A parallelogram on two pins in the ground, each pin made twice. It swings: the crossbar stays level, and
// the length of its cranks stays.
void four_bar_twice(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    const BodyRef ground = rig.add_body({.type = BodyType::Static});
    const BodyRef left = rig.add({.position_m = {-1, -0.5}}, Box{0.05f, 0.5f}, kMeetsNothing);
    const BodyRef right = rig.add({.position_m = {1, -0.5}}, Box{0.05f, 0.5f}, kMeetsNothing);
    const BodyRef bar =
        rig.add({.position_m = {0, -1}, .linear_velocity_m_s = {1, 0}}, Box{1, 0.05f}, kMeetsNothing);
    for (int i = 0; i < 2; ++i) {
        rig.pin(ground, left, {-1, 0});
        rig.pin(ground, right, {1, 0});
        rig.pin(left, bar, {-1, -1});
        rig.pin(right, bar, {1, -1});
    }
    double error = 0, tilt = 0;
    rig.run(10, kStep_s, [&](double) {
        error = std::max(error, rig.joint_error_m());
        tilt = std::max(tilt, std::fabs(rig.motion(bar).s));
    });
    trial.at_most("four_bar_error_m", error, 0.001);
    trial.at_most("four_bar_tilt_rad", tilt, 0.001);
}

void redundant_loops(Trial& trial) {
    parallel_welds(trial);
    four_bar_twice(trial);
}

}  // namespace

void add_rigid_joints(std::vector<Case>& cases) {
    cases.push_back({"30", "joints of coincident anchors and without length", false, coincident_anchors});
    cases.push_back({"31", "ten parallel welds, a four-bar made twice", true, redundant_loops});
}

}  // namespace cairn::lab
