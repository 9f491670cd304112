// The platform slides along an upright guide. To go to a floor, the limit on that side is put there and the
// motor drives against it; the other limit follows behind, so that it stays at the floor whatever pushes.
#include <cairn/physics/prefabs/elevator.h>

#include "prefabs/builder.h"

namespace cairn::physics {
namespace {

constexpr float kAtFloor_m = 0.01f;
/// The motor is stronger than the weight of platform and load by this factor. More would press the platform
/// into the limit, which is a little soft.
constexpr float kForceReserve = 1.5f;
constexpr float kEarth_m_s2 = 10;

Result<float> height_of(const Elevator& elevator, int floor) {
    const auto count = static_cast<int>(elevator.floors_m.size());
    if (floor >= 0 && floor < count) return elevator.floors_m[static_cast<std::size_t>(floor)];
    return Error{"elevator.floor is " + std::to_string(floor) + ", but must be from 0 to " +
                 std::to_string(count - 1)};
}

}  // namespace

Result<Elevator> create_elevator(World& world, const ElevatorDef& def) {
    Builder builder(world);
    builder.require({
        check::finite("elevator.position_m", def.position_m),
        check_count("elevator.floors_m.size()", static_cast<int>(def.floors_m.size()), 1, 1000),
        check::positive("elevator.width_m", as_double(def.width_m)),
        check::positive("elevator.thickness_m", as_double(def.thickness_m)),
        check::positive("elevator.speed_m_s", as_double(def.speed_m_s)),
        check::not_negative("elevator.load_kg", as_double(def.load_kg)),
    });
    for (std::size_t i = 0; i < def.floors_m.size(); ++i) {
        const double floor_m = as_double(def.floors_m[i]);
        check::Fault fault = check::finite("elevator.floors_m", floor_m);
        if (!fault && i > 0)
            fault = check::require(def.floors_m[i] > def.floors_m[i - 1], "elevator.floors_m", floor_m,
                                   "above the floor before it");
        builder.require({fault});
        if (fault) break;  // those behind it may be no worse
    }
    Elevator elevator{.floors_m = def.floors_m, .speed_m_s = def.speed_m_s};
    const float ground_floor = builder.good() ? def.floors_m.front() : 0;
    const Position start = def.position_m + Vec2{0, ground_floor - def.thickness_m / 2};
    elevator.platform = builder.body({.position_m = start});
    builder.shape(elevator.platform, Box{def.width_m / 2, def.thickness_m / 2}, def.shape);
    PrismaticJointDef guide;
    const BodyId shaft = builder.holder({}, start);
    builder.place(guide, shaft, elevator.platform, start + Vec2{0, -ground_floor});
    guide.local_anchor_b_m = {};
    guide.local_angle_a_rad = guide.local_angle_b_rad = kPi / 2;
    guide.enable_limit = true;
    guide.lower_m = guide.upper_m = ground_floor;
    guide.enable_motor = true;
    const float mass_kg = builder.good() ? world.body(elevator.platform)->mass() + def.load_kg : 0;
    guide.max_motor_force_n = kForceReserve * std::max(length(world.gravity()), kEarth_m_s2) * mass_kg;
    elevator.guide = builder.joint(guide);
    return builder.finish(std::move(elevator));
}

Result<void> send_elevator(World& world, const Elevator& elevator, int floor) {
    const auto height = height_of(elevator, floor);
    if (!height) return height.error();
    auto guide = world.joint(elevator.guide);
    if (!guide) return guide.error();
    const float here = guide->translation();
    auto def = std::get<PrismaticJointDef>(guide->definition());
    def.lower_m = std::min(here, *height);
    def.upper_m = std::max(here, *height);
    def.motor_speed_m_s = *height >= here ? elevator.speed_m_s : -elevator.speed_m_s;
    return guide->redefine(def);
}

Result<bool> is_elevator_at(const World& world, const Elevator& elevator, int floor) {
    const auto height = height_of(elevator, floor);
    if (!height) return height.error();
    const auto guide = world.joint(elevator.guide);
    if (!guide) return guide.error();
    return std::fabs(guide->translation() - *height) < kAtFloor_m;
}

}  // namespace cairn::physics
