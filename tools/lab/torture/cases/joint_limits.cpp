// Cases 32 and 34: limits against motors beyond all measure, and a train of gears.
#include <algorithm>
#include <cmath>

#include "torture/case.h"

namespace cairn::lab {
namespace {

using physics::BodyId;
using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::JointId;
using physics::ShapeDef;
using physics::World;

const ShapeDef kMeetsNothing{.filter = {.categories = 2, .mask = 0}};

BodyId id(BodyRef body) {
    return BodyId::from_bits(body.bits);
}

void limits(Trial& trial) {
    Rig& rig = trial.rig({.enable_sleep = false});
    World& world = *rig.engine().cairn_world();
    const BodyRef ground = rig.add_body({.type = BodyType::Static});
    const BodyRef bar = rig.add({.position_m = {0.5, 0}}, Box{0.5f, 0.05f}, kMeetsNothing);
    const BodyRef slide = rig.add({.position_m = {0, 5}}, Box{0.5f, 0.5f}, kMeetsNothing);

    trial.require("lower_above_upper_is_an_error",
                  !world.create_joint(physics::RevoluteJointDef{.body_a = id(ground),
                                                                .body_b = id(bar),
                                                                .enable_limit = true,
                                                                .lower_rad = 1,
                                                                .upper_rad = -1}) &&
                      !world.create_joint(physics::PrismaticJointDef{.body_a = id(ground),
                                                                     .body_b = id(slide),
                                                                     .enable_limit = true,
                                                                     .lower_m = 1,
                                                                     .upper_m = -1}));
    constexpr float kUpper = 0.5f;  // rad and m
    const JointId turning = world
                                .create_joint(physics::RevoluteJointDef{.body_a = id(ground),
                                                                        .body_b = id(bar),
                                                                        .local_anchor_b_m = {-0.5f, 0},
                                                                        .enable_limit = true,
                                                                        .lower_rad = -kUpper,
                                                                        .upper_rad = kUpper,
                                                                        .enable_motor = true,
                                                                        .motor_speed_rad_s = 100,
                                                                        .max_motor_torque_nm = 1e6f})
                                .value();
    const JointId sliding = world
                                .create_joint(physics::PrismaticJointDef{.body_a = id(ground),
                                                                         .body_b = id(slide),
                                                                         .local_anchor_a_m = {0, 5},
                                                                         .enable_limit = true,
                                                                         .lower_m = -kUpper,
                                                                         .upper_m = kUpper,
                                                                         .enable_motor = true,
                                                                         .motor_speed_m_s = 100,
                                                                         .max_motor_force_n = 1e6f})
                                .value();
    rig.begin_books();
    rig.allow_work(2e6 * kUpper);  // of both motors, up to the limits
    double beyond_rad = 0, beyond_m = 0;
    rig.run(10, kStep_s, [&](double t) {
        if (t < 1) return;  // they have arrived
        beyond_rad = std::max(beyond_rad, static_cast<double>(world.joint(turning)->joint_angle() - kUpper));
        beyond_m = std::max(beyond_m, static_cast<double>(world.joint(sliding)->translation() - kUpper));
    });
    trial.at_most("beyond_limit_rad", beyond_rad, 0.01);
    trial.at_most("beyond_limit_m", beyond_m, 0.005);
    trial.at_least("angle_rad", world.joint(turning)->joint_angle(), static_cast<double>(kUpper) - 0.01);
}

// Ten wheels in a row, each meshed with the next: neighbours turn opposite ways at equal speeds.
void gear_train(Trial& trial) {
    constexpr int kWheels = 10;
    constexpr double kSpeed_rad_s = 5;
    Rig& rig = trial.rig({.enable_sleep = false});
    World& world = *rig.engine().cairn_world();
    const BodyRef ground = rig.add_body({.type = BodyType::Static});
    std::vector<JointId> axles;
    for (int i = 0; i < kWheels; ++i) {
        const BodyRef wheel = rig.add({.position_m = {1.0 * i, 0}}, Circle{{}, 0.5f}, kMeetsNothing);
        axles.push_back(
            world
                .create_joint(physics::RevoluteJointDef{.body_a = id(ground),
                                                        .body_b = id(wheel),
                                                        .local_anchor_a_m = {static_cast<float>(i), 0},
                                                        .enable_motor = i == 0,
                                                        .motor_speed_rad_s = static_cast<float>(kSpeed_rad_s),
                                                        .max_motor_torque_nm = 1000})
                .value());
        if (i > 0) {
            world
                .create_joint(physics::GearJointDef{
                    .joint_1 = axles[axles.size() - 2], .joint_2 = axles.back(), .ratio = 1})
                .value();
        }
    }
    rig.begin_books();
    rig.allow_work(1e3);  // of the motor: the wheels take 11 J
    rig.run(10);
    double worst = 0;
    const double first = world.joint(axles.front())->joint_angle();
    for (int i = 0; i < kWheels; ++i) {
        const double angle = world.joint(axles[static_cast<std::size_t>(i)])->joint_angle();
        worst = std::max(worst, std::fabs(angle / (i % 2 == 0 ? first : -first) - 1));
    }
    trial.at_most("ratio_error", worst, 0.001);
    trial.at_least("turned_rad", first, 0.9 * 10 * kSpeed_rad_s);
}

}  // namespace

void add_joint_limits(std::vector<Case>& cases) {
    cases.push_back({"32", "lower above upper; motors of 10^6 against limits", false, limits});
    cases.push_back({"34", "train of ten gears", false, gear_train});
}

}  // namespace cairn::lab
