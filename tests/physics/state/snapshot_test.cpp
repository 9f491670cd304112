// A restored world goes on as the one that the snapshot was taken from: compared by the bytes of the
// snapshots of both, step for step, which is more than their hashes.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

#include "physics/state/state_bytes.h"
#include "physics/state/state_scenes.h"
#include "physics/support/allocation_counter.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kSteps = 150;

}  // namespace

TEST_CASE("restored at every step, ten scenes go on as if nothing had happened") {
    for (const Scene& scene : state_scenes()) {
        World original;
        const std::vector<Bytes> history = run(scene, original, kSteps);
        World other({.gravity_m_s2 = {3, 1}, .substeps = 2});
        for (int step = 0; step < kSteps; ++step) {
            INFO(scene.name << ", step " << step);
            other.restore(history[static_cast<std::size_t>(step)]).value();
            REQUIRE(difference(bytes_of(other), history[static_cast<std::size_t>(step)]) == "none");
            for (int next = step; next < std::min(step + 3, kSteps); ++next) {
                scene.act(other, next);
                other.step(kStep_s).value();
                INFO("after step " << next);
                REQUIRE(difference(bytes_of(other), history[static_cast<std::size_t>(next) + 1]) == "none");
            }
        }
    }
}

TEST_CASE("a restored world answers as the one did from which the snapshot was taken") {
    for (const Scene& scene : state_scenes()) {
        World original;
        World other;
        const std::vector<Bytes> history = run(scene, original, 90);
        other.restore(history.back()).value();
        INFO(scene.name);
        CHECK(other.state_hash() == original.state_hash());
        CHECK(listed(other.counts()) == listed(original.counts()));
        CHECK(other.max_penetration_m() == original.max_penetration_m());
        CHECK(other.step_count() == original.step_count());
        CHECK(other.contact_begins().size() == original.contact_begins().size());
        for (const BodyId id : original.bodies()) {
            const Body a = *original.body(id);
            const Body b = *other.body(other.own(id));
            REQUIRE(a.transform().p == b.transform().p);
            REQUIRE(a.interpolated_transform(0.5f).p == b.interpolated_transform(0.5f).p);
            REQUIRE(a.shapes().size() == b.shapes().size());
            REQUIRE(a.joints().size() == b.joints().size());
            for (const JointId joint : a.joints()) {
                const Vec2 force = original.joint(joint)->reaction_force();
                REQUIRE(other.joint(other.own(joint))->reaction_force() == force);
            }
        }
    }
}

TEST_CASE("a snapshot of one thread goes on as it did on two, and the other way round") {
    for (const Scene& scene : state_scenes()) {
        World alone;
        const std::vector<Bytes> history = run(scene, alone, 120);
        World together({.threads = 2});
        together.restore(history[60]).value();
        for (int step = 60; step < 120; ++step) {
            scene.act(together, step);
            together.step(kStep_s).value();
        }
        INFO(scene.name);
        CHECK(difference(bytes_of(together), history.back()) == "none");
        World back;
        back.restore(bytes_of(together)).value();
        CHECK(back.state_hash() == alone.state_hash());
    }
}

TEST_CASE("a net that fell in a heap goes on as it did, however its contacts and pins are divided") {
    constexpr int kColumns = 48;
    constexpr int kRows = 24;
    World original({.threads = 2});
    add_ground(original);
    std::vector<BodyId> knots;
    for (int i = 0; i < kColumns * kRows; ++i) {
        const Position at{0.5 * (i % kColumns) - 12, 0.3 + 0.5 * (i / kColumns)};
        knots.push_back(add(original, {.position_m = at, .angle_rad = 0.1 * (i % 7)}, Circle{{}, 0.22f}));
        const auto pin = [&](int other, Vec2 half) {
            original
                .create_joint(RevoluteJointDef{.body_a = knots[static_cast<std::size_t>(other)],
                                               .body_b = knots.back(),
                                               .local_anchor_a_m = half,
                                               .local_anchor_b_m = -half})
                .value();
        };
        if (i % kColumns > 0) pin(i - 1, {0.25f, 0});
        if (i >= kColumns) pin(i - kColumns, {0, 0.25f});
    }
    World other;
    for (int step = 0; step < 200; ++step) {
        original.step(kStep_s).value();
        // Before there are domains, while they are made and after, and between two divisions.
        if (step == 50 || step == 63 || step == 64 || step == 100) {
            other.restore(bytes_of(original)).value();
        } else if (step > 50) {
            other.step(kStep_s).value();
        }
    }
    CHECK(difference(bytes_of(other), bytes_of(original)) == "none");
}

TEST_CASE("back and forth between snapshots, and on with more bodies than there were") {
    const Scene scene = state_scenes()[4];
    World world;
    const std::vector<Bytes> history = run(scene, world, kSteps);
    for (const int from : {120, 3, 77, 76, 0, 149}) {
        world.restore(history[static_cast<std::size_t>(from)]).value();
        for (int step = from; step < kSteps; ++step) {
            scene.act(world, step);
            world.step(kStep_s).value();
        }
        INFO("from step " << from);
        REQUIRE(difference(bytes_of(world), history.back()) == "none");
    }
}

TEST_CASE("a world that slept at the snapshot sleeps on, and wakes as it would have") {
    World world;
    build_pyramid(world, 6);
    run_for(world, 3);
    REQUIRE(world.awake_body_count() == 0);
    const Bytes asleep = bytes_of(world);
    const auto disturb = [](World& w) {
        w.body(w.bodies().back())->apply_impulse_to_center({2, 3}).value();
        run_for(w, 1);
        return bytes_of(w);
    };
    const Bytes expected = disturb(world);
    world.restore(asleep).value();
    CHECK(world.awake_body_count() == 0);
    CHECK(difference(disturb(world), expected) == "none");
}

TEST_CASE("handles name the same things after a restore, and what was made since is gone") {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 1}, .user_data = 42}, Box{});
    const Snapshot before = world.snapshot().value();
    world.destroy_body(box).value();
    const BodyId later = add(world, {.position_m = {5, 1}}, Circle{});
    const BodyId last = add(world, {.position_m = {7, 1}}, Circle{});
    world.restore(before.bytes()).value();
    CHECK(world.contains(ground));
    REQUIRE(world.contains(box));
    CHECK(world.body(box)->user_data() == 42);
    CHECK(!world.contains(later));
    CHECK(!world.contains(last));

    World other;
    other.restore(before.bytes()).value();
    CHECK(!other.contains(box));  // another world's handle
    CHECK(other.body(other.own(box))->user_data() == 42);
    CHECK(!other.own(BodyId{}));
}

TEST_CASE("the settings of the world are part of a snapshot, its threads and its filter are not") {
    World world({.gravity_m_s2 = {1, -2}, .substeps = 7});
    add(world, {}, Circle{});
    World other({.threads = 2});
    int asked = 0;
    other.set_pair_filter(
        {[](void* context, ShapeId, ShapeId) { return ++*static_cast<int*>(context), false; }, &asked});
    other.restore(world.snapshot().value().bytes()).value();
    CHECK(other.gravity() == Vec2{1, -2});
    add(other, {}, Circle{});
    other.step(kStep_s).value();
    CHECK(asked == 1);
}

TEST_CASE("saving and restoring allocate nothing once they have warmed up") {
    for (const Scene& scene : state_scenes()) {
        World world;
        run(scene, world, 60);
        Snapshot snapshot;
        for (int i = 0; i < 3; ++i) {
            world.snapshot(snapshot).value();
            world.restore(snapshot.bytes()).value();
        }
        INFO(scene.name);
        const AllocationCounter counter;
        world.snapshot(snapshot).value();
        world.restore(snapshot.bytes()).value();
        CHECK(counter.count() == 0);
    }
}

TEST_CASE("a thousand stacked boxes take less than 700 bytes each") {
    World world;
    build_pyramid(world, 44);
    run_for(world, 0.3);
    const auto bodies = static_cast<std::size_t>(world.counts().bodies);
    REQUIRE(world.awake_body_count() == 990);
    CHECK(world.snapshot()->size() < 700 * bodies);
}

TEST_CASE("bytes that are no snapshot, or a damaged one, are refused with a reason and change nothing") {
    World world;
    build_joint_zoo(world);
    run_for(world, 0.5);
    const Bytes good = bytes_of(world);
    run_for(world, 0.1);
    const Bytes now = bytes_of(world);
    const auto reason = [&](const Bytes& bytes) {
        const Result<void> restored = world.restore(bytes);
        REQUIRE(!restored);
        REQUIRE(bytes_of(world) == now);
        return restored.error().message;
    };
    CHECK(reason({}) == "the snapshot has 0 bytes, but must have at least 32");
    CHECK_THAT(reason(Bytes(100)), Catch::StartsWith("the bytes are no snapshot"));
    Bytes newer = good;
    newer[8] = std::byte{9};
    CHECK_THAT(reason(newer), Catch::StartsWith("the snapshot is of version 9, but must be of 8"));
    Bytes longer = good;
    longer.push_back({});
    CHECK_THAT(reason(longer), Catch::Contains("but says that it has"));
    for (std::size_t size = 0; size < good.size(); size += 97) {
        REQUIRE_THAT(reason(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))),
                     Catch::StartsWith("the snapshot has"));
    }
    for (std::size_t at = 32; at < good.size(); at += 61) {
        Bytes flipped = good;
        flipped[at] ^= std::byte{16};
        REQUIRE(reason(flipped) == "the snapshot is damaged: its checksum is not that of its contents");
    }
}

// Along a side whose normal has no length nothing is far apart, and a corner that is not the one it repeats
// is seen only beside shapes of more corners.
TEST_CASE("a snapshot with a shape of which something does not follow from its points is refused") {
    World world;
    add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{.half_width_m = 3, .half_height_m = 1});
    add(world, {.position_m = {0, 0.5}}, Circle{{}, 0.5f});
    run_for(world, 0.1);
    const Bytes good = bytes_of(world);
    const float one = 1;
    int refused = 0;
    for (std::size_t at = kFrame; at + sizeof one <= good.size(); ++at) {
        if (std::memcmp(good.data() + at, &one, sizeof one) != 0) continue;
        Bytes bad = good;
        std::memset(bad.data() + at, 0, sizeof one);
        fit_checksum(bad);
        const Result<void> restored = world.restore(bad);
        if (!restored) {
            refused += restored.error().message.find("a shape has points") != std::string::npos ? 1 : 0;
            continue;
        }
        step_times(world, 3);
        CHECK(world.counts().touching <= 1);
    }
    CHECK(refused == 5);  // of the box: two corners, two normals and half the height
}

// A negative zero is no less than zero, and what is divided by it is minus infinity.
TEST_CASE("a snapshot with a body whose inner radius is a negative zero is refused") {
    constexpr float kInner_m = 0.37f;
    World world;
    add(world, {.position_m = {}}, Box{.half_width_m = 5, .half_height_m = kInner_m});
    run_for(world, 0.1);
    const Bytes good = bytes_of(world);
    int refused = 0;
    for (std::size_t at = kFrame; at + sizeof kInner_m <= good.size(); ++at) {
        if (std::memcmp(good.data() + at, &kInner_m, sizeof kInner_m) != 0) continue;
        Bytes bad = good;
        const float zero = -0.0f;
        std::memcpy(bad.data() + at, &zero, sizeof zero);
        fit_checksum(bad);
        const Result<void> restored = world.restore(bad);
        if (!restored) refused += restored.error().message.find("a mass or an extent") != std::string::npos;
    }
    CHECK(refused == 1);
}

// Rounding may leave them no inside at all, by their own sides.
TEST_CASE("slivers far from the origins of their bodies go through snapshots") {
    Random random(7);
    int made = 0;
    for (int i = 0; i < 2000; ++i) {
        const float far_m = std::pow(10.0f, random.real_f(4, 6));
        const float length_m = std::pow(10.0f, random.real_f(0, 2));
        const float width_m = length_m * std::pow(10.0f, random.real_f(-4, -2));
        const Rotation turn = Rotation::from_angle(random.real(0, 6));
        std::array<Vec2, 3> points{Vec2{}, Vec2{length_m, 0}, Vec2{length_m / 2, width_m}};
        for (Vec2& p : points) p = Vec2{far_m, far_m / 3} + rotate(turn, p);
        World world({.gravity_m_s2 = {}});
        const BodyId body = world.create_body({.angular_velocity_rad_s = 1}).value();
        if (!world.create_shape(body, Polygon{.points_m = points})) continue;  // rounding made it a line
        ++made;
        world.step(kStep_s).value();
        const Result<void> restored = World().restore(bytes_of(world));
        INFO((restored ? std::string() : restored.error().message));
        REQUIRE(restored);
    }
    CHECK(made > 1000);
}

// Joints and contacts stand where the mass of the last step put them, until the next step.
TEST_CASE("what gained or lost its mass since the last step goes through snapshots") {
    World world;
    add_ground(world);
    const BodyId light = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    const BodyId hanging = add(world, {.position_m = {5, 3}}, Circle{{}, 0.5f});
    const BodyId empty = world.create_body({.position_m = {5, 4}}).value();
    world.create_joint(RevoluteJointDef{.body_a = empty, .body_b = hanging, .local_anchor_b_m = {0, 1}})
        .value();
    const BodyId nail = add(world, {.position_m = {8, 4}}, Circle{{}, 0.25f});
    const BodyId swing = add(world, {.position_m = {8, 3}}, Circle{{}, 0.5f});
    world.create_joint(RevoluteJointDef{.body_a = swing, .body_b = nail, .local_anchor_a_m = {0, 1}}).value();
    step_times(world, 5);

    SECTION("a first shape on what a joint hangs from") {
        world.create_shape(empty, Box{0.5f, 0.25f}).value();
    }
    SECTION("no density under what rests") {
        world.shape(world.body(light)->shapes().front())->set_density(0).value();
    }
    SECTION("no density in what a joint moves") {
        world.shape(world.body(nail)->shapes().front())->set_density(0).value();
    }
    SECTION("no shapes on what a joint moves") {
        world.destroy_shape(world.body(nail)->shapes().front()).value();
    }
    World other;
    other.restore(bytes_of(world)).value();
    for (int step = 0; step < 10; ++step) {
        world.step(kStep_s).value();
        other.step(kStep_s).value();
        INFO("step " << step);
        REQUIRE(difference(bytes_of(other), bytes_of(world)) == "none");
    }
}

// Passes go over all eight lanes of a block. One box on the ground is in the first: behind it stand seven
// contacts, as many shapes and again as many that are none, then eight rows of numbers.
// Which rows are in batches of contacts depends on what a world remembers beside its state.
TEST_CASE("a restored world of bodies at rest goes on as it did, also beside a joint") {
    World first, second;
    BodyId rocker;
    for (World* world : {&first, &second}) {
        const BodyId ground = world->create_body({.type = BodyType::Static}).value();
        world->create_shape(ground, Box{50, 0.5f, {0, -0.5f}}).value();
        for (int i = 0; i < 8; ++i)
            add(*world, {.position_m = {3.0 + 2 * i, 0.5}, .allow_sleep = false}, Box{0.5f, 0.5f});
        const BodyId welded = add(*world, {.position_m = {-5, 3}, .allow_sleep = false}, Circle{{}, 0.2f});
        world->create_joint(WeldJointDef{.body_a = ground, .body_b = welded, .local_anchor_a_m = {-5, 3}})
            .value();
        rocker = add(*world,
                     {.position_m = {0, 0.25},
                      .angle_rad = 0.2,
                      .linear_velocity_m_s = {0.3f, 0},
                      .angular_velocity_rad_s = -1,
                      .allow_sleep = false},
                     Circle{{-0.15f, 0}, 0.2f});
        world->create_shape(rocker, Circle{{0.15f, 0}, 0.2f}).value();
    }
    for (int step = 0; step < 400; ++step) {
        if (step > 60 && step % 7 == 0) second.restore(first.snapshot().value().bytes()).value();
        if (step % 40 == 39) {
            for (World* world : {&first, &second})
                world->body(world->own(rocker))->set_angular_velocity(1.5f).value();
        }
        first.step(kStep_s).value();
        second.step(kStep_s).value();
        INFO("step " << step);
        REQUIRE(first.state_hash() == second.state_hash());
    }
}

TEST_CASE("what lies in a lane of contacts that nothing is in is refused") {
    constexpr int kLanes = 8;
    constexpr int kNobody = -1;
    World world;
    add(world, {.type = BodyType::Static, .position_m = {0, -1}}, Box{10, 1});
    add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    run_for(world, 0.1);
    const Bytes good = bytes_of(world);
    const auto word_at = [&](std::size_t at) {
        int word = 0;
        std::memcpy(&word, good.data() + at, sizeof word);
        return word;
    };
    const auto is_row = [&](std::size_t at) {
        bool row = word_at(at) >= 0;
        for (std::size_t lane = 1; lane < kLanes; ++lane)
            row = row && word_at(at + lane * sizeof(int)) == kNobody;
        return row;
    };
    constexpr std::size_t kRow = kLanes * sizeof(int);
    std::size_t block = kFrame;
    while (block + 16 * kRow < good.size() &&
           !(is_row(block) && is_row(block + kRow) && is_row(block + 2 * kRow)))
        ++block;
    REQUIRE(block + 16 * kRow < good.size());

    world.restore(good).value();
    for (std::size_t row = 0; row < 11; ++row) {
        INFO("row " << row);
        Bytes bad = good;
        const float hidden = 100;
        std::memcpy(bad.data() + block + row * kRow + kRow - sizeof hidden, &hidden, sizeof hidden);
        fit_checksum(bad);
        const Result<void> restored = world.restore(bad);
        REQUIRE(!restored);
        CHECK_THAT(restored.error().message,
                   Catch::Contains("a lane of contacts holds something, though none is in it"));
    }
}

// With a checksum that fits, only looking at the contents can find out. Whatever they say: the world refuses
// them, or it has a state in which it can go on.
TEST_CASE("contents that are nonsense under a good checksum never do harm") {
    Random random(5);
    int refused = 0;
    for (const Scene& scene : state_scenes()) {
        World source;
        const std::vector<Bytes> history = run(scene, source, 70);
        World world;
        for (int round = 0; round < 400; ++round) {
            Bytes bytes = history[static_cast<std::size_t>(random.below(70))];
            make_nonsense(bytes, random);
            if (!world.restore(bytes)) {
                ++refused;
                continue;
            }
            for (int step = 0; step < 3; ++step) world.step(kStep_s).value();
            static_cast<void>(world.state_hash());
        }
    }
    CHECK(refused > 400);
}

}  // namespace cairn::physics
