// Joints in lanes against the scalar solver of all kinds, which is a second implementation of the same laws.
#include "resolve/joints/joint_lanes.h"

#include <catch2/catch.hpp>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include <cairn/physics/simd.h>

#include "integrator/integrate.h"
#include "physics/support/random.h"
#include "resolve/joints/joint_solver.h"
#include "resolve/joints/kinds.h"
#include "resolve/joints/pin_loads.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kSubstep_s = 1.0f / 240;
constexpr int kPairs = 21;  // a body a and a body b each: all of one colour

// Both solvers on the same bodies.
struct Twins {
    std::vector<RevoluteJointDef> defs;
    std::vector<Place> places{Place{}};
    Motions swept;
    Motions in_lanes;
    std::vector<JointConstraint> constraints;
    JointLanes lanes;
    std::vector<JointSeat> seats;
    std::vector<JointPlace> joint_places;
    TaskPool tasks{1, nullptr};

    Twins(bool drives, bool anchored) {
        Random random(anchored ? 7 : 5);
        for (Motions* motions : {&swept, &in_lanes}) motions->add({}, 0, 0, 0);
        for (int pair = 0; pair < kPairs; ++pair) {
            add_body(random, !anchored);
            add_body(random, true);
        }
        for (int pair = 0; pair < kPairs; ++pair) join(random, pair, drives, anchored);
        std::vector<SpringLoad> loads(places.size());
        lanes.arrange();
        lanes.place(places, in_lanes, 1, 4 * kSubstep_s, tasks);
        place_joints(constraints, swept, joint_places);
        add_spring_loads(constraints, joint_places, swept, loads);
        make_springs(constraints, kSubstep_s, loads);
        lanes.settle_springs(loads, false, tasks);
    }

    void add_body(Random& random, bool pushed) {
        const Vec2 v = random.vector(-2, 2);
        const float w = random.real_f(-20, 20);
        const float inverse_mass = pushed ? random.real_f(0.1, 2) : 0;
        const float inverse_inertia = pushed ? random.real_f(0.1, 9) : 0;
        for (Motions* motions : {&swept, &in_lanes}) {
            motions->add(v, w, inverse_mass, inverse_inertia);
            motions->mover.back() = MovedBy::Turning;
        }
        const Rotation rotation = Rotation::from_angle(random.real(-3, 3));
        const Vec2 center = random.vector(-0.1, 0.1);
        places.push_back({Position{} + center, rotation, static_cast<int>(places.size())});
    }

    void join(Random& random, int pair, bool drives, bool anchored) {
        const int a = 1 + 2 * pair;
        const int b = a + 1;
        RevoluteJointDef def{.local_anchor_a_m = random.vector(-1, 1),
                             .local_anchor_b_m = random.vector(-1, 1)};
        const Rotation turn = inverse(places[static_cast<std::size_t>(a)].rotation) *
                              places[static_cast<std::size_t>(b)].rotation;
        const float angle = turn.angle_rad();
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
        defs.push_back(def);

        JointConstraint c;
        c.kind = JointKind::Revolute;
        c.rows = {a, b};
        c.anchors = {a, b, rotate(places[static_cast<std::size_t>(a)].rotation, def.local_anchor_a_m),
                     rotate(places[static_cast<std::size_t>(b)].rotation, def.local_anchor_b_m),
                     places[static_cast<std::size_t>(b)].center - places[static_cast<std::size_t>(a)].center};
        c.start_angle_rad = angle;
        JointStart start;
        start.h_s = kSubstep_s;
        describe(c, def, start);
        constraints.push_back(c);

        const int bucket = joint_bucket(0, anchored ? JointBlockKind::Anchored : JointBlockKind::TwoBodies);
        const AnchorLane anchor{pair, a, b, def.local_anchor_a_m, def.local_anchor_b_m, turn};
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

    void substep() {
        const JointPassTime time{softness_of(JointStiffness{}, kSubstep_s), 1 / kSubstep_s};
        note_spring_speeds(constraints, joint_places, swept);
        lanes.note_spring_speeds(in_lanes, tasks);
        for (Motions* motions : {&swept, &in_lanes}) {
            for (std::size_t row = 1; row < places.size(); ++row) {
                if (motions->velocity[row].inverse_mass > 0) motions->velocity[row].v += Vec2{0, -0.04f};
            }
        }
        warm_start_joints(constraints, joint_places, swept);
        lanes.warm_start(in_lanes, tasks);
        solve_joints(constraints, joint_places, swept, kSubstep_s, Pass::Biased);
        lanes.solve(in_lanes, time, tasks);
        integrate_positions(swept, kSubstep_s);
        integrate_positions(in_lanes, kSubstep_s);
        solve_joints(constraints, joint_places, swept, kSubstep_s, Pass::Relax);
        lanes.relax(in_lanes, time, tasks);
    }

    void check_agree() const {
        for (std::size_t row = 0; row < places.size(); ++row) {
            INFO("row " << row);
            const VelocityRow& expected = swept.velocity[row];
            const VelocityRow& found = in_lanes.velocity[row];
            const float room = 2e-3f * (1 + length(expected.v) + std::fabs(expected.w));
            CHECK(length(found.v - expected.v) < room);
            CHECK(std::fabs(found.w - expected.w) < room);
        }
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            INFO("joint " << i);
            const JointMemory memory = lanes.memory(seats[i]);
            for (std::size_t k = 0; k < memory.impulse.size(); ++k) {
                const float expected = constraints[i].impulse[k];
                CHECK(std::fabs(memory.impulse[k] - expected) < 2e-3f * (1 + std::fabs(expected)));
            }
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
        seats[joint] = random.chance(0.5) ? lanes.add_pin(bucket, anchors[joint])
                                          : lanes.add_drive(bucket, anchors[joint], {.motor_limit = 1});
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
        if (seat.drives) CHECK(memory.impulse[impulse_index(2, Role::Motor)] == static_cast<float>(-joint));
        if (!seat.drives) CHECK(lanes.load(seat) == Vec2{0, static_cast<float>(joint)});
    }
    std::size_t met = 0;
    std::map<std::pair<bool, int>, int> last;  // sum of rows, by pool and bucket
    lanes.for_each_block([&](const AnchorBlock& block, const PinBlock&, JointBlockKind kind) {
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
            int& before = last[{seat.drives, seat.bucket}];
            CHECK(before <= sum);
            before = sum;
        }
    });
    CHECK(met == seats.size());
    lanes.sort(places, order, [](int, int) { FAIL("they are in order already"); });
}

}  // namespace cairn::physics
