// Wheel joints in lanes against the scalar solver, and in worlds.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/state/state_bytes.h"
#include "physics/support/invariants.h"
#include "physics/support/joint_twins.h"
#include "physics/support/making.h"
#include "physics/support/precise.h"
#include "world/bodies.h"
#include "world/joints.h"
#include "world/step.h"

namespace cairn::physics {
namespace {

using namespace test;

// Body a, a wheel on it, and a wheel on that one: springs that share a body, in lanes of two colours.
struct Twins : JointTwins {
    static constexpr int kTrains = 21;

    Twins(bool stiff, bool anchored, double spread_m = 0.1) {
        Random random(anchored ? 7 : 5);
        for (int train = 0; train < kTrains; ++train) {
            add_body(random, !anchored, spread_m);
            add_body(random, true, spread_m);
            add_body(random, true, spread_m);
        }
        for (int color = 0; color < 2; ++color) {
            for (int train = 0; train < kTrains; ++train) {
                const int a = 1 + 3 * train + color;
                join(random, a, a + 1, stiff, color, anchored && color == 0);
            }
        }
        begin();
    }

    void join(Random& random, int a, int b, bool stiff, int color, bool anchored) {
        WheelJointDef def{.local_anchor_a_m = random.vector(-1, 1),
                          .local_anchor_b_m = random.vector(-1, 1),
                          .local_angle_a_rad = random.real_f(-3, 3)};
        def.enable_spring = random.chance(0.8);
        def.frequency_hz = stiff ? random.real_f(40, 120) : random.real_f(1, 8);
        def.damping_ratio = random.real_f(0.1, 2);
        def.target_m = random.real_f(-0.5, 0.5);
        def.enable_motor = random.chance(0.5);
        def.motor_speed_rad_s = 3;
        def.max_motor_torque_nm = random.chance(0.2) ? kUnlimited : 5;
        JointConstraint c = constraint(JointKind::Wheel, a, b, def.local_anchor_a_m, def.local_anchor_b_m);
        JointStart start;
        start.h_s = kSubstep_s;
        const Rotation frame = Rotation::from_angle(static_cast<double>(def.local_angle_a_rad));
        start.frame_a = place(a).rotation * frame;
        const Vec2 offset = c.anchors.center_offset + c.anchors.r_b - c.anchors.r_a;
        def.enable_limit = random.chance(0.6);
        def.lower_m = dot(offset, rotate(start.frame_a, {1, 0})) - random.real_f(-0.2, 0.3);
        def.upper_m = random.chance(0.3) ? kUnlimited : def.lower_m + random.real_f(0, 0.4);
        describe(c, def, start);
        constraints.push_back(c);

        const auto kind = anchored ? JointBlockKind::Anchored : JointBlockKind::TwoBodies;
        const AnchorLane anchor{static_cast<int>(seats.size()), a,         b, def.local_anchor_a_m,
                                def.local_anchor_b_m,           turn(a, b)};
        seats.push_back(
            lanes.add_wheel(joint_bucket(color, kind), anchor, {frame.c, frame.s}, drive_of(def)));
    }

    static DriveLane drive_of(const WheelJointDef& def) {
        DriveLane drive;
        drive.softness = softness_of(def.stiffness, kSubstep_s);
        if (def.enable_spring) {
            drive.spring_frequency_rad_s = 2 * kPi * def.frequency_hz;
            const float angle = drive.spring_frequency_rad_s * kSubstep_s;
            drive.square = angle * angle;
            drive.damping = 2 * def.damping_ratio * angle;
            drive.spring =
                make_exact_spring(static_cast<double>(def.frequency_hz),
                                  static_cast<double>(def.damping_ratio), static_cast<double>(kSubstep_s), 1);
            drive.spring_target = def.target_m;
        }
        if (def.enable_motor) {
            drive.motor_speed = def.motor_speed_rad_s;
            drive.motor_limit = def.max_motor_torque_nm * kSubstep_s;
        }
        if (def.enable_limit) {
            drive.lower = def.lower_m;
            drive.upper = std::min(def.upper_m, kNoLimit);
        }
        return drive;
    }

    void check_reactions_agree() const {
        const float dt_s = 4 * kSubstep_s;
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            INFO("joint " << i);
            const JointMemory memory = lanes.memory(seats[i]);
            const Vec2 force = (1 / dt_s) * constraints[i].total_impulse;
            const float torque = constraints[i].total_angular_impulse / dt_s;
            CHECK(length(memory.reaction_force - force) < 5e-3f * (10 + length(force)));
            CHECK(std::fabs(memory.reaction_torque - torque) < 5e-3f * (1 + std::fabs(torque)));
        }
    }

    [[nodiscard]] std::vector<float> numbers() const {
        std::vector<float> all;
        for (const VelocityRow& row : in_lanes.velocity) all.insert(all.end(), {row.v.x, row.v.y, row.w});
        for (const JointSeat& seat : seats) {
            const JointMemory memory = lanes.memory(seat);
            all.insert(all.end(), memory.impulse.begin(), memory.impulse.end());
            all.insert(all.end(), {memory.reaction_force.x, memory.reaction_force.y, memory.reaction_torque});
        }
        return all;
    }
};

// Cars on a washboard: more wheels than a block holds, and a wall for the first of them.
void build_cars(World& world, int cars = 12) {
    add_ground(world);
    for (int i = 0; i < 60; ++i)
        add(world, {.type = BodyType::Static, .position_m = {1.3 * i, 0}}, Circle{{}, 0.12f});
    add(world, {.type = BodyType::Static, .position_m = {-4, 1}}, Box{0.2f, 2});
    for (int car = 0; car < cars; ++car) {
        const double x = 4.0 * car;
        const BodyId chassis = add(world, {.position_m = {x, 1.1}}, Box{1.2f, 0.3f});
        for (const float side : {-1.0f, 1.0f}) {
            const Vec2 axle{side, -0.4f};
            const BodyId wheel = add(
                world, {.position_m = {x + static_cast<double>(side), 0.7}, .linear_velocity_m_s = {-2, 0}},
                Circle{{}, 0.35f}, {.material = {.friction = 1}});
            world
                .create_joint(WheelJointDef{.body_a = chassis,
                                            .body_b = wheel,
                                            .local_anchor_a_m = axle,
                                            .local_angle_a_rad = kPi / 2,
                                            .frequency_hz = 4,
                                            .enable_limit = car % 2 == 0,
                                            .lower_m = -0.1f,
                                            .upper_m = 0.1f,
                                            .enable_motor = side < 0,
                                            .motor_speed_rad_s = 20,
                                            .max_motor_torque_nm = 4})
                .value();
        }
    }
}

}  // namespace

TEST_CASE("wheels in lanes do what the scalar solver does, with the same bits at every SIMD level") {
    const auto levels = available_simd_levels();
    for (const bool stiff : {false, true}) {
        for (const bool anchored : {false, true}) {
            std::vector<float> first;
            for (const SimdLevel level : levels) {
                force_simd_level(level).value();
                INFO(name(level) << (stiff ? ", stiff" : "") << (anchored ? ", anchored" : ""));
                Twins twins(stiff, anchored);
                CHECK(twins.has_crowded_springs == stiff);
                for (int i = 0; i < 4; ++i) twins.substep();
                twins.check_agree();
                twins.check_reactions_agree();
                if (first.empty()) first = twins.numbers();
                CHECK(twins.numbers() == first);
            }
        }
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("torn wheels in lanes are hidden as those of the scalar solver") {
    for (const bool anchored : {false, true}) {
        INFO((anchored ? "anchored" : "free"));
        Twins twins(false, anchored, 8);
        REQUIRE(twins.torn.size() > 10);
        REQUIRE(twins.torn_in_lanes.size() == twins.torn.size());
        for (const TornJoint& expected : twins.torn) {
            const auto is_it = [&](const TornJoint& j) { return j.a == expected.a && j.b == expected.b; };
            const auto found = std::ranges::find_if(twins.torn_in_lanes, is_it);
            REQUIRE(found != twins.torn_in_lanes.end());
            CHECK(length(found->apart - expected.apart) < 1e-4f);
            CHECK(length(found->axis - expected.axis) < 1e-5f);
            CHECK(length(found->r_a - expected.r_a) + length(found->r_b - expected.r_b) < 1e-5f);
        }
        for (int i = 0; i < 4; ++i) twins.substep();
        twins.check_agree();
    }
}

TEST_CASE("sweeping crowded springs leaves bodies beside them as they are to the bit") {
    const auto levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        INFO(name(level));
        Twins twins(true, false);
        for (VelocityRow& row : twins.in_lanes.velocity) {
            row.v = {-0.0f, -0.0f};
            row.w = -0.0f;
        }
        twins.lanes.sweep_crowded_springs(twins.in_lanes, false);
        int beside = 0;
        for (std::size_t i = Twins::kTrains; i < twins.constraints.size(); ++i) {
            if (twins.constraints[i].has_spring) continue;
            ++beside;
            // The last wheel of a train, on which nothing else acts.
            const auto row = static_cast<std::size_t>(twins.constraints[i].anchors.b);
            const VelocityRow& found = twins.in_lanes.velocity[row];
            CHECK((std::signbit(found.v.x) && std::signbit(found.v.y) && std::signbit(found.w)));
        }
        CHECK(beside > 0);
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE(
    "damped wheels stand in lanes from their second step on, undamped ones and those of locked axes never") {
    WorldState world(WorldDef{.gravity_m_s2 = {0, -10}}, 1);
    Stores& stores = world.stores;
    const int ground = create_body(stores, {.type = BodyType::Static});
    const auto wheel = [&](double x, bool locked, const WheelJointDef& def) {
        WheelJointDef own = def;
        own.body_a = stores.bodies.slots.id(ground);
        own.local_anchor_a_m = {static_cast<float>(x), 5};
        const int body = create_body(stores, {.position_m = {x, 5}, .locks = {.x = locked}});
        create_shape(stores, body, make_convex(Circle{{}, 0.3f}).value(), {});
        own.body_b = stores.bodies.slots.id(body);
        return create_joint(world, own);
    };
    const int damped = wheel(0, false, {});
    const int undamped = wheel(2, false, {.damping_ratio = 0});
    const int loose = wheel(4, false, {.enable_spring = false});
    const int locked = wheel(6, true, {});
    const auto is_seated = [&](int joint) {
        const JointSeat& seat = stores.joints.slots[joint].seat;
        return seat.lane != kNone && seat.kind == JointLaneKind::Wheel;
    };
    step_world(world, kStep_s);
    CHECK_FALSE(is_seated(damped));
    CHECK(is_seated(loose));
    step_world(world, kStep_s);
    CHECK(is_seated(damped));
    CHECK_FALSE(is_seated(undamped));
    CHECK_FALSE(is_seated(locked));
    check_world(world);
}

TEST_CASE("cars go the same way at every SIMD level and on every number of threads") {
    const auto levels = available_simd_levels();
    std::vector<std::uint64_t> hashes;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        World world;
        build_cars(world);
        step_times(world, 120);
        hashes.push_back(world.state_hash());
    }
    force_simd_level(levels.back()).value();
    for (const int threads : {2, 3}) {
        World world({.threads = threads});
        build_cars(world);
        step_times(world, 120);
        hashes.push_back(world.state_hash());
    }
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

TEST_CASE("restored at every step, cars go on as they did") {
    World original;
    World other;
    build_cars(original, 6);
    for (int step = 0; step < 90; ++step) {
        other.restore(bytes_of(original)).value();
        original.step(kStep_s).value();
        other.step(kStep_s).value();
        INFO("step " << step);
        REQUIRE(difference(bytes_of(other), bytes_of(original)) == "none");
    }
}

TEST_CASE(
    "what a wheel does at another length of step, and with other numbers, is what it does from then on") {
    // Sag is g / w^2 however long steps are and whatever it was before.
    World world({.joint_solver = JointSolver::Sweeping, .enable_sleep = false});
    const BodyId hook = world.create_body({.type = BodyType::Static}).value();
    const BodyId wheel = add(world, {}, Circle{{}, 0.4f});
    WheelJointDef def{.body_a = hook,
                      .body_b = wheel,
                      .local_angle_a_rad = kPi / 2,
                      .frequency_hz = 2,
                      .enable_motor = true,
                      .motor_speed_rad_s = 10,
                      .max_motor_torque_nm = 5};
    const JointId joint = world.create_joint(def).value();
    for (const auto& [frequency, dt_s] :
         {std::pair{2.0f, kStep_s}, std::pair{2.0f, 1.0f / 90}, std::pair{3.0f, 1.0f / 90}}) {
        INFO(frequency << " Hz, " << dt_s << " s");
        def.frequency_hz = frequency;
        def.motor_speed_rad_s = -def.motor_speed_rad_s;
        if (frequency != 2) world.joint(joint)->redefine(def).value();
        run_for(world, 6, dt_s);
        const double w = 2 * kPiD * d(frequency);
        CHECK(d(world.joint(joint)->translation()) == Approx(-10 / (w * w)).epsilon(1e-3));
    }
    CHECK(d(world.body(wheel)->angular_velocity()) == Approx(-10).epsilon(1e-3));
}

TEST_CASE("a wheel that goes round more than half a turn a step counts its turns") {
    for (const float speed : {50.0f, -250.0f, 500.0f}) {
        World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        const BodyId hook = world.create_body({.type = BodyType::Static}).value();
        const BodyId wheel = add(world, {.angular_velocity_rad_s = speed}, Circle{{}, 0.4f});
        const JointId joint = world.create_joint(WheelJointDef{.body_a = hook, .body_b = wheel}).value();
        run_for(world, 2);
        INFO(speed << " rad/s");
        CHECK(d(world.joint(joint)->joint_angle()) == Approx(2 * d(speed)).epsilon(1e-3));
    }
}

TEST_CASE("a wheel tells what it bears, and breaks when that is too much") {
    for (const double share : {0.9, 1.1}) {
        World world({.gravity_m_s2 = {0, -10}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        const BodyId hook = world.create_body({.type = BodyType::Static}).value();
        const BodyId wheel = add(world, {}, Circle{{}, 0.4f});
        const double weight = 10 * d(world.body(wheel)->mass());
        // Along the slope the spring bears; across it the joint.
        const JointId joint = world
                                  .create_joint(WheelJointDef{
                                      .body_a = hook,
                                      .body_b = wheel,
                                      .local_angle_a_rad = kPi / 6,
                                      .frequency_hz = 3,
                                      .damping_ratio = 1,
                                      .strength = {.break_force_n = static_cast<float>(share * weight)}})
                                  .value();
        run_for(world, 4);
        CHECK(world.contains(joint) == (share > 1));
        if (share < 1) continue;
        CHECK(d(world.joint(joint)->reaction_force().x) == Approx(0).margin(1e-3 * weight));
        CHECK(d(world.joint(joint)->reaction_force().y) == Approx(weight).epsilon(1e-3));
    }
}

TEST_CASE("stiff springs of wheels on one hub give back no more than was put in, at every SIMD level") {
    const auto levels = available_simd_levels();
    std::vector<std::uint64_t> hashes;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        const ShapeDef ghost{.filter = {.mask = 0}};
        const BodyId hub = add(world, {.angular_velocity_rad_s = 1}, Circle{{}, 0.5f}, ghost);
        for (int i = 0; i < 9; ++i) {
            const float angle = 2 * kPi * static_cast<float>(i) / 9;
            const BodyId wheel = add(world, {.linear_velocity_m_s = {0.5f, 0.1f * static_cast<float>(i)}},
                                     Circle{{}, 0.3f + 0.02f * static_cast<float>(i)}, ghost);
            world
                .create_joint(WheelJointDef{.body_a = hub,
                                            .body_b = wheel,
                                            .local_angle_a_rad = angle,
                                            .frequency_hz = 100,
                                            .damping_ratio = 0.5f})
                .value();
        }
        const double energy = world.report().kinetic_energy_j;
        for (int i = 0; i < 300; ++i) {
            world.step(kStep_s).value();
            REQUIRE(world.report().kinetic_energy_j <= 1.03 * energy);
        }
        hashes.push_back(world.state_hash());
    }
    force_simd_level(levels.back()).value();
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

// What springs on one hub do together depends on where their axes pass its centre, which changes as they
// turn. A spring of another kind, out of reach, has all springs looked at in every step.
TEST_CASE("springs of wheels that stand off their centres do what they would beside a spring out of reach") {
    const auto run_hub = [](bool with_another) {
        World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
        const ShapeDef ghost{.filter = {.mask = 0}};
        std::vector<BodyId> bodies{add(world, {}, Circle{{}, 0.5f}, ghost)};
        for (int i = 0; i < 9; ++i) {
            const float axis_rad = 2 * kPi * static_cast<float>(i) / 9;
            const Rotation beside = Rotation::from_angle(d(axis_rad) + kPiD / 2);
            const Vec2 center{-beside.c, -beside.s};
            const BodyDef def{.position_m = Position{} + center,
                              .linear_velocity_m_s = {0.1f * static_cast<float>(i), -0.2f},
                              .angular_velocity_rad_s = 2};
            bodies.push_back(
                add(world, def, Circle{{}, 0.1f}, {.density_kg_m2 = 100, .filter = {.mask = 0}}));
            world
                .create_joint(WheelJointDef{.body_a = bodies.front(),
                                            .body_b = bodies.back(),
                                            .local_anchor_b_m = -center,
                                            .local_angle_a_rad = axis_rad,
                                            .frequency_hz = 60,
                                            .damping_ratio = 0.1f})
                .value();
        }
        if (with_another) {
            const BodyId hook = world.create_body({.type = BodyType::Static, .position_m = {50, 0}}).value();
            const BodyId far = add(world, {.position_m = {51, 0}}, Circle{{}, 0.1f}, ghost);
            world
                .create_joint(DistanceJointDef{
                    .body_a = hook, .body_b = far, .length_m = 1, .enable_spring = true, .frequency_hz = 1})
                .value();
        }
        step_times(world, 300);
        std::vector<float> numbers;
        for (const BodyId id : bodies) {
            const auto body = world.body(id);
            const Vec2 v = body->linear_velocity();
            numbers.insert(numbers.end(), {v.x, v.y, body->angular_velocity()});
        }
        return numbers;
    };
    CHECK(run_hub(false) == run_hub(true));
}

}  // namespace cairn::physics
