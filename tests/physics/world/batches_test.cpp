// Worlds of so many islands that they are solved in batches.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr int kHeaps = 750;
constexpr int kBodies = 12;  // of each
constexpr int kSteps = 150;

// Boxes and discs that fall on each other, others for each heap.
std::vector<BodyId> add_heap(World& world, int number) {
    Random random(static_cast<unsigned>(number));
    const double x = 8.0 * (number % 20);
    const double y = 20.0 * (number / 20);
    add(world, {.type = BodyType::Static, .position_m = {x, y - 0.5}}, Box{3, 0.5f});
    std::vector<BodyId> bodies;
    for (int i = 0; i < kBodies; ++i) {
        const BodyDef body{.position_m = {x + random.real(-0.6, 0.6), y + 0.6 + 1.1 * i},
                           .angle_rad = random.real(-0.5, 0.5)};
        const ShapeDef shape{
            .material = {.friction = random.real_f(0.1, 0.8), .restitution = random.real_f(0, 0.3)}};
        bodies.push_back(random.chance(0.5) ? add(world, body, Box{0.5f, 0.3f}, shape)
                                            : add(world, body, Circle{{}, 0.4f}, shape));
    }
    return bodies;
}

}  // namespace

TEST_CASE("many heaps fall, come to rest and wake alike on any number of threads") {
    const auto run = [](int threads) {
        World world(WorldDef{.threads = threads});
        std::vector<BodyId> heads;
        for (int i = 0; i < kHeaps; ++i) heads.push_back(add_heap(world, i).back());
        std::vector<std::uint64_t> hashes;
        for (int step = 0; step < kSteps; ++step) {
            // Some are pushed off again when many have come to rest.
            if (step % 50 == 49) {
                for (int i = step % 3; i < kHeaps; i += 5)
                    world.body(heads[static_cast<std::size_t>(i)])
                        .value()
                        .apply_impulse_to_center({0.4f, 0.4f})
                        .value();
            }
            step_times(world, 1);
            hashes.push_back(world.state_hash());
        }
        CHECK(world.counts().awake_bodies > 0);
        CHECK(world.counts().awake_bodies < kHeaps * kBodies);
        return hashes;
    };
    const std::vector<std::uint64_t> alone = run(1);
    CHECK(run(3) == alone);
}

TEST_CASE("snapshots of many heaps, restored in turn, go on as they did") {
    World world(WorldDef{});
    for (int i = 0; i < kHeaps; ++i) add_heap(world, i);
    struct Moment {
        Snapshot snapshot;
        std::uint64_t hash_after = 0;
    };
    std::vector<Moment> moments;
    for (int i = 0; i < 4; ++i) {
        step_times(world, 12);
        moments.push_back({world.snapshot().value()});
        step_times(world, 2);
        moments.back().hash_after = world.state_hash();
    }
    for (int round = 0; round < 3; ++round) {
        for (const Moment& moment : moments) {
            world.restore(moment.snapshot.bytes()).value();
            step_times(world, 2);
            REQUIRE(world.state_hash() == moment.hash_after);
        }
    }
}

TEST_CASE("a world that was one takes another snapshot of the same bodies for another") {
    const WorldDef restless{.enable_sleep = false};
    World source(restless);
    std::vector<BodyId> tops;
    for (int stack = 0; stack < kHeaps; ++stack) {
        const double x = 3.0 * stack;
        add(source, {.type = BodyType::Static, .position_m = {x, -0.5}}, Box{1, 0.5f});
        for (int i = 0; i < kBodies; ++i)
            tops.push_back(add(source, {.position_m = {x, 0.5 + i}}, Box{0.5f, 0.5f}));
    }
    step_times(source, 20);
    const Snapshot low = source.snapshot().value();
    // Every third box on top is put on the stack beside it.
    for (std::size_t i = kBodies - 1; i + kBodies < tops.size(); i += 3 * kBodies) {
        source.body(tops[i])
            .value()
            .set_transform({3.0 * static_cast<double>(i / kBodies + 1), kBodies + 0.5}, 0)
            .value();
    }
    step_times(source, 60);
    const Snapshot high = source.snapshot().value();
    step_times(source, 1);

    World world(restless);
    world.restore(low.bytes()).value();
    step_times(world, 1);
    world.restore(high.bytes()).value();
    step_times(world, 1);
    CHECK(world.state_hash() == source.state_hash());
}

}  // namespace cairn::physics
