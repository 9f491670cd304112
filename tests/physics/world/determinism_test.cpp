// Equal histories give equal bits: twice in one program, and on every compiler and build type (goldens).
#include <catch2/catch.hpp>

#include <cairn/physics/simd.h>

#include "physics/support/scenes.h"
#include "support/golden.h"

namespace cairn::physics {
namespace {

using namespace test;

std::uint64_t hash_after(const Scene& scene, int steps, World& world) {
    scene.build(world);
    for (int step = 0; step < steps; ++step) {
        scene.act(world, step);
        world.step(kStep_s).value();
    }
    return world.state_hash();
}

}  // namespace

TEST_CASE("each scene gives the same bits twice, and those that were approved", "[golden]") {
    const std::vector<Scene> first = all_scenes();
    const std::vector<Scene> second = all_scenes();
    for (std::size_t i = 0; i < first.size(); ++i) {
        World world;
        World twin;
        const std::uint64_t hash = hash_after(first[i], 600, world);
        INFO(first[i].name);
        CHECK(hash_after(second[i], 600, twin) == hash);
        CHECK_THAT(cairn::test::hash_text(hash), cairn::test::MatchesGolden("physics-" + first[i].name));
    }
}

TEST_CASE("every SIMD level gives the same bits in each scene") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    for (std::size_t i = 0; i < all_scenes().size(); ++i) {
        std::uint64_t first = 0;
        for (const SimdLevel level : levels) {
            force_simd_level(level).value();
            World world;
            const Scene scene = all_scenes()[i];
            const std::uint64_t hash = hash_after(scene, 300, world);
            if (level == levels.front()) first = hash;
            INFO(scene.name << " at " << name(level));
            CHECK(hash == first);
        }
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("every number of threads gives the same bits in each scene") {
    for (std::size_t i = 0; i < all_scenes().size(); ++i) {
        std::uint64_t alone = 0;
        for (const int threads : {1, 2, 3, 8}) {
            World world({.threads = threads});
            const Scene scene = all_scenes()[i];
            const std::uint64_t hash = hash_after(scene, 300, world);
            if (threads == 1) alone = hash;
            INFO(scene.name << " on " << threads << " threads");
            CHECK(hash == alone);
        }
    }
}

TEST_CASE("a heap large enough for every loop to be cut has the same bits on every number of threads") {
    std::uint64_t alone = 0;
    for (const int threads : {1, 2, 5}) {
        World world({.threads = threads});
        build_pyramid(world, 60);
        const BodyId ball = add(world, {.position_m = {-60, 20}, .linear_velocity_m_s = {90, 0}},
                                Circle{{}, 2}, {.density_kg_m2 = 20});
        for (int step = 0; step < 90; ++step) world.step(kStep_s).value();
        REQUIRE(world.body(ball)->position().x > -20);  // it went through the pyramid
        if (threads == 1) alone = world.state_hash();
        INFO(threads << " threads");
        CHECK(world.state_hash() == alone);
    }
}

TEST_CASE("worlds that run in turn do not disturb each other") {
    World alone;
    const std::uint64_t expected = hash_after(all_scenes()[2], 120, alone);
    World a;
    World b;
    build_pile(a, 120, 1);
    build_pile(b, 120, 1);
    World other;
    build_chain(other, 20);
    for (int step = 0; step < 120; ++step) {
        a.step(kStep_s).value();
        other.step(kStep_s).value();
        b.step(kStep_s).value();
    }
    CHECK(a.state_hash() == expected);
    CHECK(b.state_hash() == expected);
}

TEST_CASE("queries and reading between steps change nothing") {
    World watched;
    World alone;
    build_pile(watched, 40, 3);
    build_pile(alone, 40, 3);
    for (int step = 0; step < 120; ++step) {
        static_cast<void>(watched.cast_ray({-5, 1}, {10, 0}));
        static_cast<void>(watched.shape_at({0, 1}));
        for (const BodyId id : watched.bodies()) static_cast<void>(watched.body(id)->transform());
        watched.step(kStep_s).value();
        alone.step(kStep_s).value();
    }
    CHECK(watched.state_hash() == alone.state_hash());
}

TEST_CASE("the smallest difference in a place or a velocity changes the hash") {
    const auto hash_of = [](const BodyDef& def) {
        World world;
        add(world, def, Circle{});
        return world.state_hash();
    };
    const std::uint64_t hash = hash_of({.position_m = {1, 2}});
    CHECK(hash_of({.position_m = {1, 2}}) == hash);
    CHECK(hash_of({.position_m = {std::nextafter(1.0, 2.0), 2}}) != hash);
    CHECK(hash_of({.position_m = {1, 2}, .linear_velocity_m_s = {1e-30f, 0}}) != hash);
    CHECK(hash_of({.position_m = {1, 2}, .angular_velocity_rad_s = 1e-30f}) != hash);
    CHECK(hash_of({.type = BodyType::Kinematic, .position_m = {1, 2}}) != hash);
    World world;
    const BodyId body = add(world, {.position_m = {1, 2}}, Circle{});
    world.body(body)->set_awake(false);
    CHECK(world.state_hash() != hash);
    world.body(body)->set_awake(true);
    world.body(body)->apply_force_to_center({1, 0}).value();
    CHECK(world.state_hash() != hash);
}

}  // namespace cairn::physics
