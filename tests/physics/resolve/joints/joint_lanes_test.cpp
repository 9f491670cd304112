// Revolute joints in lanes against the scalar solver, and the upkeep of lanes.
#include "resolve/joints/joint_lanes.h"

#include <catch2/catch.hpp>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/joint_twins.h"
#include "resolve/joints/pin_loads.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kPairs = 21;  // a body a and a body b each: all of one colour

struct Twins : JointTwins {
    Twins(bool drives, bool anchored) {
        Random random(anchored ? 7 : 5);
        for (int pair = 0; pair < kPairs; ++pair) {
            add_body(random, !anchored);
            add_body(random, true);
        }
        for (int pair = 0; pair < kPairs; ++pair) join(random, pair, drives, anchored);
        begin();
    }

    void join(Random& random, int pair, bool drives, bool anchored) {
        const int a = 1 + 2 * pair;
        const int b = a + 1;
        RevoluteJointDef def{.local_anchor_a_m = random.vector(-1, 1),
                             .local_anchor_b_m = random.vector(-1, 1)};
        const float angle = turn(a, b).angle_rad();
        if (drives) {
            def.enable_limit = true;
            def.lower_rad = angle - random.real_f(-0.2, 0.2);
            def.upper_rad = def.lower_rad + random.real_f(0, 0.3);
            def.enable_motor = true;
            def.motor_speed_rad_s = 3;
            def.max_motor_torque_nm = 5;
            def.enable_spring = true;
            def.frequency_hz = random.real_f(1, 30);
            def.damping_ratio = random.real_f(0.1, 2);
            def.target_rad = 0.3f;
        }
        JointConstraint c = constraint(JointKind::Revolute, a, b, def.local_anchor_a_m, def.local_anchor_b_m);
        JointStart start;
        start.h_s = kSubstep_s;
        describe(c, def, start);
        constraints.push_back(c);

        const int bucket = joint_bucket(0, anchored ? JointBlockKind::Anchored : JointBlockKind::TwoBodies);
        const AnchorLane anchor{pair, a, b, def.local_anchor_a_m, def.local_anchor_b_m, turn(a, b)};
        seats.push_back(drives ? lanes.add_drive(bucket, anchor, drive_of(def))
                               : lanes.add_pin(bucket, anchor));
    }

    static DriveLane drive_of(const RevoluteJointDef& def) {
        DriveLane drive;
        drive.softness = softness_of(def.stiffness, kSubstep_s);
        drive.spring_frequency_rad_s = 2 * kPi * def.frequency_hz;
        drive.square = drive.spring_frequency_rad_s * kSubstep_s * drive.spring_frequency_rad_s * kSubstep_s;
        drive.spring =
            make_exact_spring(static_cast<double>(def.frequency_hz), static_cast<double>(def.damping_ratio),
                              static_cast<double>(kSubstep_s), 1);
        drive.spring_target = def.target_rad;
        drive.motor_speed = def.motor_speed_rad_s;
        drive.motor_limit = def.max_motor_torque_nm * kSubstep_s;
        drive.lower = def.lower_rad;
        drive.upper = def.upper_rad;
        return drive;
    }

    // Some bear more than their load, some less, some the opposite.
    void set_loads() {
        Random random(3);
        const Softness soft = softness_of(JointStiffness{}, kSubstep_s);
        const PinLoads loads{kSubstep_s, soft.impulse_scale / (soft.mass_scale * soft.bias_rate)};
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            const Vec2 load_n = random.vector(-9, 9);
            const Vec2 last = random.real_f(-0.5, 2) * kSubstep_s * load_n;
            JointImpulses impulse{};
            impulse[impulse_index(0, Role::HoldOrSpring)] = last.x;
            impulse[impulse_index(1, Role::HoldOrSpring)] = last.y;
            constraints[i].impulse = impulse;
            lanes.set_impulses(seats[i], impulse);
            lanes.set_load(seats[i], load_n);
            CHECK(lanes.load(seats[i]) == load_n);
            take_off_load(constraints[i], load_n, loads, swept);
        }
        lanes.take_off_loads(in_lanes, loads, tasks);
        place_joints(constraints, swept, joint_places);
    }

    void check_errors_agree() {
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            const int lane = seats[i].lane;
            const PinBlock& block = lanes.pin_block(lane / kLanes);
            const auto at = static_cast<std::size_t>(lane % kLanes);
            const Vec2 expected{joint_places[i].directions[0].q, joint_places[i].directions[1].q};
            CHECK(length(Vec2{block.error_x[at], block.error_y[at]} - expected) < 1e-5f);
        }
    }
};

}  // namespace

TEST_CASE("pins and drives in lanes do what the scalar solver does, at every SIMD level") {
    const auto levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        for (const bool drives : {false, true}) {
            for (const bool anchored : {false, true}) {
                INFO(name(level) << (drives ? ", drives" : ", pins") << (anchored ? ", anchored" : ""));
                Twins twins(drives, anchored);
                for (int i = 0; i < 4; ++i) twins.substep();
                twins.check_agree();
            }
        }
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("pins in lanes are soft about their loads as the scalar solver's are, at every SIMD level") {
    const auto levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        for (const bool anchored : {false, true}) {
            INFO(name(level) << (anchored ? ", anchored" : ""));
            Twins twins(false, anchored);
            twins.set_loads();
            twins.check_errors_agree();
            for (int i = 0; i < 4; ++i) twins.substep();
            twins.check_agree();
        }
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("a pin that bears its load yields nothing, and otherwise to what the load misses") {
    // It is closed, and what hangs on it at its centre has just got the speed of a substep by gravity.
    for (const float share : {1.0f, 0.5f}) {
        Twins twins(false, true);
        const Softness soft = softness_of(JointStiffness{}, kSubstep_s);
        const PinLoads loads{kSubstep_s, soft.impulse_scale / (soft.mass_scale * soft.bias_rate)};
        JointConstraint& pin = twins.constraints[0];
        pin.anchors.r_a = pin.anchors.r_b = pin.anchors.center_offset = {};
        const float inverse_mass = twins.swept.get(pin.anchors.b).inverse_mass;
        const Vec2 load_n{0, 10 / inverse_mass};
        pin.impulse[impulse_index(1, Role::HoldOrSpring)] = share * kSubstep_s * load_n.y;
        take_off_load(pin, load_n, loads, twins.swept);
        twins.swept.velocity[static_cast<std::size_t>(pin.anchors.b)].v = {0, -10 * kSubstep_s};
        twins.swept.velocity[static_cast<std::size_t>(pin.anchors.b)].w = 0;
        twins.swept.velocity[static_cast<std::size_t>(pin.anchors.a)].v = {};
        twins.swept.velocity[static_cast<std::size_t>(pin.anchors.a)].w = 0;
        const std::span<JointConstraint> alone(&pin, 1);
        place_joints(alone, twins.swept, twins.joint_places);
        warm_start_joints(alone, twins.joint_places, twins.swept);
        solve_joints(alone, twins.joint_places, twins.swept, kSubstep_s, Pass::Biased);
        const float v = twins.swept.velocity[static_cast<std::size_t>(pin.anchors.b)].v.y;
        if (share == 1) CHECK(std::fabs(v) < 1e-6f);
        // One that bears half takes 1.1 times that as its load, and gives way to the rest.
        if (share != 1) CHECK(v == Approx(-soft.impulse_scale * (1 - 0.55f) * 10 * kSubstep_s).margin(1e-6));
    }
}

TEST_CASE("a lane that another takes keeps its impulses, and the rest stay dense") {
    JointLanes lanes;
    std::vector<JointSeat> seats;
    std::vector<JointPlace> joint_places;
    const int bucket = joint_bucket(3, JointBlockKind::TwoBodies);
    for (int joint = 0; joint < 20; ++joint) {
        seats.push_back(lanes.add_pin(bucket, {.joint = joint}));
        JointImpulses impulse{};
        impulse[0] = static_cast<float>(joint);
        lanes.set_impulses(seats.back(), impulse);
    }
    for (const std::size_t gone : {std::size_t{2}, std::size_t{11}, std::size_t{0}}) {
        const int moved = lanes.remove(seats[gone]);
        if (moved != kNone) seats[static_cast<std::size_t>(moved)].lane = seats[gone].lane;
        seats[gone].lane = kNone;
    }
    int kept = 0;
    for (std::size_t joint = 0; joint < seats.size(); ++joint) {
        if (seats[joint].lane == kNone) continue;
        ++kept;
        CHECK(seats[joint].lane < 17);
        CHECK(lanes.memory(seats[joint]).impulse[0] == static_cast<float>(joint));
    }
    CHECK(kept == 17);
}

TEST_CASE("joints keep what is theirs when they change domains and lanes are put in order of their rows") {
    constexpr int kBodies = 200;
    Random random(11);
    JointLanes lanes;
    std::map<int, JointSeat> seats;
    std::map<int, AnchorLane> anchors;
    LaneOrder order;
    for (int joint = 0; joint < 400; ++joint) {
        const auto kind = random.chance(0.3) ? JointBlockKind::Anchored : JointBlockKind::TwoBodies;
        const int bucket = joint_bucket(random.below(3), kind);
        anchors[joint] = {joint,
                          random.below(kBodies),
                          random.below(kBodies),
                          random.vector(-1, 1),
                          random.vector(-1, 1),
                          Rotation::from_angle(random.real(-3, 3)),
                          static_cast<float>(random.below(5)),
                          random.chance(0.2)};
        const double draw = random.real(0, 3);
        seats[joint] = draw < 1   ? lanes.add_pin(bucket, anchors[joint])
                       : draw < 2 ? lanes.add_drive(bucket, anchors[joint], {.motor_limit = 1})
                                  : lanes.add_wheel(bucket, anchors[joint], {1, 0}, {.motor_limit = 1});
        JointImpulses impulse{};
        impulse[impulse_index(0, Role::HoldOrSpring)] = static_cast<float>(joint);
        impulse[impulse_index(2, Role::Motor)] = static_cast<float>(-joint);
        lanes.set_impulses(seats[joint], impulse);
        lanes.set_load(seats[joint], {0, static_cast<float>(joint)});
        if (!random.chance(0.3)) continue;
        const int gone = std::next(seats.begin(), random.below(static_cast<int>(seats.size())))->first;
        const JointSeat seat = seats.extract(gone).mapped();
        if (const int moved = lanes.remove(seat); moved != kNone) seats[moved].lane = seat.lane;
    }
    for (auto& [joint, seat] : seats) {
        if (random.chance(0.5)) continue;
        const int lane = seat.lane;
        const int to = joint_bucket(joint_color(seat.bucket), joint_block_kind(seat.bucket),
                                    1 + random.below(kMostDomains));
        const int moved = lanes.move(seat, to);
        if (moved != kNone) seats[moved].lane = lane;
        CHECK(seat.bucket == to);
        CHECK(joint_domain(to) != kInterface);
    }
    std::vector<Place> places(kBodies);
    for (Place& place : places) place.row = random.below(kBodies);
    lanes.make_room(order);
    lanes.sort(places, order, [&](int joint, int lane) { seats[joint].lane = lane; });
    lanes.arrange();

    for (const auto& [joint, seat] : seats) {
        INFO("joint " << joint);
        const JointMemory memory = lanes.memory(seat);
        CHECK(memory.impulse[impulse_index(0, Role::HoldOrSpring)] == static_cast<float>(joint));
        const bool is_pin = seat.kind == JointLaneKind::Pin;
        if (!is_pin) CHECK(memory.impulse[impulse_index(2, Role::Motor)] == static_cast<float>(-joint));
        if (is_pin) CHECK(lanes.load(seat) == Vec2{0, static_cast<float>(joint)});
    }
    std::size_t met = 0;
    std::map<std::pair<JointLaneKind, int>, int> last;  // sum of rows, by pool and bucket
    lanes.for_each_block([&](const AnchorBlock& block, const JointRows&, JointBlockKind kind) {
        for (std::size_t lane = 0; lane < kLanes && block.joint[lane] != kNone; ++lane) {
            ++met;
            const int joint = block.joint[lane];
            const AnchorLane& a = anchors[joint];
            CHECK(block.body_a[lane] == a.body_a);
            CHECK(block.body_b[lane] == a.body_b);
            CHECK(Vec2{block.local_ax[lane], block.local_by[lane]} == Vec2{a.local_a.x, a.local_b.y});
            CHECK(Rotation{block.cosine[lane], block.sine[lane]} == a.turn);
            CHECK(block.turns[lane] == a.turns);
            CHECK((block.breakable >> lane & 1) == (a.breakable ? 1 : 0));
            const JointSeat& seat = seats.at(joint);
            CHECK(static_cast<std::size_t>(seat.lane % kLanes) == lane);
            CHECK(joint_block_kind(seat.bucket) == kind);
            const int row_b = places[static_cast<std::size_t>(a.body_b)].row;
            const int row_a = places[static_cast<std::size_t>(a.body_a)].row;
            const int sum = row_b + (kind == JointBlockKind::Anchored ? row_b : row_a);
            int& before = last[{seat.kind, seat.bucket}];
            CHECK(before <= sum);
            before = sum;
        }
    });
    CHECK(met == seats.size());
    lanes.sort(places, order, [](int, int) { FAIL("they are in order already"); });
}

}  // namespace cairn::physics
