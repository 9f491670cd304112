// Bodies smaller than the slop: they behave as large ones do, seen from nearer.
#include "world/tiny_contacts.h"

#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// Three columns of five boxes that fall on each other from a tenth of their size.
std::vector<BodyId> add_pile(World& world, float size_m, const Material& material) {
    const double s = static_cast<double>(size_m);
    add(world, {.type = BodyType::Static, .position_m = {0, -s}}, Box{50 * size_m, size_m},
        {.material = material});
    std::vector<BodyId> boxes;
    for (int column = -1; column <= 1; ++column) {
        for (int i = 0; i < 5; ++i) {
            boxes.push_back(add(world, {.position_m = {1.5 * s * column, 0.6 * s + 1.1 * s * i}},
                                Box{size_m / 2, size_m / 2}, {.material = material}));
        }
    }
    return boxes;
}

}  // namespace

TEST_CASE("a pile of boxes of a millimetre or less stands, comes to rest and sleeps") {
    for (const float size_m : {0.006f, 0.003f, 0.001f, 0.0005f}) {
        World world;
        const std::vector<BodyId> boxes = add_pile(world, size_m, {});
        run_for(world, 5);
        INFO("size " << size_m);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const double level = static_cast<double>(i % 5) + 0.5;
            CHECK(world.body(boxes[i])->position().y / static_cast<double>(size_m) ==
                  Approx(level).margin(0.1));
            CHECK_FALSE(world.body(boxes[i])->is_awake());
        }
    }
}

TEST_CASE("a pile of 1 mm falls as one of 64 mm does under 64 times the gravity") {
    // Rolling resistance lets the large one be solved one by one as well, so that nothing differs but the
    // unit.
    const Material material{.rolling_resistance = 1e-6f};
    World tiny({.enable_sleep = false});
    World large({.gravity_m_s2 = {0, -640}, .enable_sleep = false});
    const std::vector<BodyId> tiny_boxes = add_pile(tiny, 0.001f, material);
    const std::vector<BodyId> large_boxes = add_pile(large, 0.064f, material);
    for (int i = 0; i < 120; ++i) {
        tiny.step(kStep_s).value();
        large.step(kStep_s).value();
        INFO("step " << i);
        for (std::size_t k = 0; k < tiny_boxes.size(); ++k) {
            const Position small = tiny.body(tiny_boxes[k])->position();
            const Position big = large.body(large_boxes[k])->position();
            REQUIRE(64 * small.x == Approx(big.x).margin(1e-4 * 0.064));
            REQUIRE(64 * small.y == Approx(big.y).margin(1e-4 * 0.064));
        }
    }
}

TEST_CASE("a world with tiny bodies goes on from a snapshot bit for bit") {
    World world;
    add_pile(world, 0.001f, {});
    step_times(world, 5);
    const Snapshot bytes = world.snapshot().value();
    step_times(world, 20);
    World other;
    other.restore(bytes.bytes()).value();
    step_times(other, 20);
    CHECK(other.state_hash() == world.state_hash());
}

TEST_CASE("the unit is 1 for what is no smaller than the slop, and else brings it to 25 to 50 mm") {
    CHECK(length_unit(100) == 1);
    CHECK(length_unit(kTinyExtent_m) == 1);
    for (float extent_m = 1e-7f; extent_m < kTinyExtent_m; extent_m *= 1.1f) {
        const float seen_m = extent_m / length_unit(extent_m);
        INFO(extent_m);
        CHECK(seen_m >= 0.025f);
        CHECK(seen_m < 0.05f);
    }
    CHECK(length_unit(0) > 0);
}

}  // namespace cairn::physics
