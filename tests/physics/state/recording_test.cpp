// Deltas give back the bytes that they were made from; recordings give back every state.
#include <catch2/catch.hpp>

#include <cairn/physics/recording.h>

#include "physics/state/state_bytes.h"
#include "physics/state/state_scenes.h"
#include "physics/support/allocation_counter.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kSteps = 130;

// The bytes of every state, and a recording of them.
std::vector<Bytes> record(const Scene& scene, World& world, Recording& recording) {
    std::vector<Bytes> states;
    scene.build(world);
    for (int step = 0;; ++step) {
        recording.record(world).value();
        states.push_back(bytes_of(world));
        if (step == kSteps) return states;
        scene.act(world, step);
        world.step(kStep_s).value();
    }
}

}  // namespace

TEST_CASE("a delta turns one snapshot into any other, of another size or another world too") {
    World pile;
    const std::vector<Bytes> of_pile = run(state_scenes()[1], pile, 40);
    World zoo;
    const std::vector<Bytes> of_zoo = run(state_scenes()[5], zoo, 3);
    const Bytes nothing;
    Snapshot delta;
    Snapshot made;
    for (const auto& [base, target] : {std::pair(of_pile[0], of_pile[1]), std::pair(of_pile[30], of_pile[2]),
                                       std::pair(of_pile[3], of_zoo[3]), std::pair(of_zoo[1], of_pile[40]),
                                       std::pair(nothing, of_zoo[0]), std::pair(of_zoo[0], nothing)}) {
        make_delta(base, target, delta).value();
        apply_delta(base, delta.bytes(), made).value();
        REQUIRE(copy_of(made.bytes()) == target);
    }
}

TEST_CASE("a delta is small where little moved") {
    World world;
    build_pyramid(world, 12);
    run_for(world, 3);
    REQUIRE(world.awake_body_count() == 0);
    add(world, {.position_m = {-12, 1}, .linear_velocity_m_s = {-1, 0}}, Circle{});
    world.step(kStep_s).value();
    const Bytes before = bytes_of(world);
    world.step(kStep_s).value();
    Snapshot delta;
    make_delta(before, bytes_of(world), delta).value();
    CHECK(delta.size() < 400);
    CHECK(before.size() > 40 * delta.size());  // most of which tells of what did not move
}

TEST_CASE("a delta is refused when it is damaged, or of another snapshot") {
    World world;
    const std::vector<Bytes> history = run(state_scenes()[1], world, 3);
    Snapshot delta;
    Snapshot made;
    make_delta(history[0], history[1], delta).value();
    const auto reason = [&](const Bytes& base, const Bytes& bytes) {
        const Result<void> applied = apply_delta(base, bytes, made);
        REQUIRE(!applied);
        return applied.error().message;
    };
    const Bytes good = copy_of(delta.bytes());
    CHECK(reason(history[2], good) == "the delta is of another snapshot than the one that it is applied to");
    CHECK_THAT(reason(history[0], history[1]), Catch::StartsWith("the bytes are no delta"));
    CHECK_THAT(reason(history[0], Bytes(good.begin(), good.end() - 1)),
               Catch::Contains("but says that it has"));
    Random random(3);
    for (int round = 0; round < 500; ++round) {
        Bytes bytes = good;
        make_nonsense(bytes, random);
        if (apply_delta(history[0], bytes, made)) static_cast<void>(world.restore(made.bytes()));
    }
}

TEST_CASE("every state of a recording can be had again, in any order and in another world") {
    for (const std::size_t which : {1u, 4u, 7u}) {
        const Scene scene = state_scenes()[which];
        World original;
        Recording recording(20);
        const std::vector<Bytes> states = record(scene, original, recording);
        REQUIRE(recording.size() == kSteps + 1);
        World world;
        Random random(which);
        for (int round = 0; round < 60; ++round) {
            const int index = random.below(recording.size());
            recording.seek(world, index).value();
            INFO(scene.name << ", state " << index);
            REQUIRE(difference(bytes_of(world), states[static_cast<std::size_t>(index)]) == "none");
        }
        for (int index = 0; index < recording.size(); ++index) {
            recording.seek(world, index).value();
            REQUIRE(bytes_of(world) == states[static_cast<std::size_t>(index)]);
        }
        std::size_t whole = 0;
        for (const Bytes& state : states) whole += state.size();
        CHECK(recording.byte_count() < whole);
    }
}

TEST_CASE("a recording that was saved and loaded is the same, and damaged bytes are refused") {
    World original;
    Recording recording;
    const std::vector<Bytes> states = record(state_scenes()[4], original, recording);
    Snapshot file;
    recording.save(file).value();
    Recording loaded(3);
    loaded.load(file.bytes()).value();
    World world;
    REQUIRE(loaded.size() == recording.size());
    for (const int index : {130, 0, 77, 59, 60}) {
        loaded.seek(world, index).value();
        CHECK(bytes_of(world) == states[static_cast<std::size_t>(index)]);
    }
    const Bytes good = copy_of(file.bytes());
    Random random(9);
    for (int round = 0; round < 200; ++round) {
        Bytes damaged = good;
        damaged[kFrame + static_cast<std::size_t>(random.below(static_cast<int>(good.size() - kFrame)))] ^=
            std::byte{1};
        REQUIRE(!loaded.load(damaged));
    }
    CHECK_THAT(loaded.load(states[0]).error().message, Catch::StartsWith("the bytes are no recording"));
    CHECK(loaded.size() == recording.size());
    for (int round = 0; round < 200; ++round) {
        Bytes nonsense = good;
        make_nonsense(nonsense, random);
        Recording other;
        if (!other.load(nonsense)) continue;
        for (const int index : {0, 30, 90, 130}) static_cast<void>(other.seek(world, index));
    }
}

TEST_CASE("another future can be recorded from a state on") {
    World world;
    Recording recording(10);
    const std::vector<Bytes> states = record(state_scenes()[1], world, recording);
    recording.seek(world, 44).value();
    recording.cut(45).value();
    world.set_gravity({0, 5}).value();
    for (int step = 0; step < 30; ++step) {
        world.step(kStep_s).value();
        recording.record(world).value();
    }
    REQUIRE(recording.size() == 75);
    const Bytes last = bytes_of(world);
    recording.seek(world, 44).value();
    CHECK(bytes_of(world) == states[44]);
    recording.seek(world, 74).value();
    CHECK(bytes_of(world) == last);
    CHECK(recording.seek(world, 75).error().message ==
          "the index is 75, but must be one of the 75 states of the recording, from 0 on");
    CHECK(!recording.seek(world, -1));
    CHECK(!recording.cut(76));
}

TEST_CASE("a loop over a recording allocates nothing once it has warmed up") {
    World world;
    Recording recording(10);
    record(state_scenes()[0], world, recording);
    const auto sweep = [&] {
        for (int index = 0; index < recording.size(); ++index) recording.seek(world, index).value();
    };
    sweep();
    sweep();
    const AllocationCounter counter;
    sweep();
    CHECK(counter.count() == 0);
}

}  // namespace cairn::physics
