// What pins bear at rest, against weights that hang from them.
#include "resolve/joints/pin_statics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace cairn::physics {
namespace {

constexpr Vec2 kGravity_m_s2{0, -10};

}  // namespace

TEST_CASE("each pin of a hanging chain bears the weight of what is below it") {
    constexpr int kLinks = 30;
    PinStatics statics;
    statics.clear();
    int last = PinStatics::kFixed;
    for (int i = 0; i < kLinks; ++i) {
        const float mass_kg = i % 2 == 0 ? 1.0f : 3.0f;
        const int link = statics.add_body(1 / mass_kg, 12 / mass_kg, kGravity_m_s2);
        statics.add_pin(last, link, last == PinStatics::kFixed ? Vec2{} : Vec2{0, -0.5f}, {0, 0.5f}, {});
        last = link;
    }
    statics.solve(1e-9);
    for (int i = 0; i < kLinks; ++i) {
        INFO("pin " << i);
        int mass_kg = 0;
        for (int below = i; below < kLinks; ++below) mass_kg += below % 2 == 0 ? 1 : 3;
        CHECK(std::fabs(statics.force(i).x) < 1e-4f);
        CHECK(statics.force(i).y == Approx(10.0 * mass_kg).epsilon(1e-6));
    }
}

TEST_CASE("a shelf on two pins loads them by its levers") {
    PinStatics statics;
    statics.clear();
    const int shelf = statics.add_body(0.5f, 0.3f, kGravity_m_s2);
    statics.add_pin(PinStatics::kFixed, shelf, {}, {-1, 0}, {});
    statics.add_pin(PinStatics::kFixed, shelf, {}, {3, 0}, {});
    statics.solve(1e-9);
    CHECK(statics.force(0).y == Approx(15).epsilon(1e-6));
    CHECK(statics.force(1).y == Approx(5).epsilon(1e-6));
    CHECK(std::fabs(statics.force(0).x + statics.force(1).x) < 1e-5f);
}

TEST_CASE("pins that are there twice share their load, and a good start takes no rounds") {
    PinStatics statics;
    std::vector<Vec2> forces(4);
    for (const bool again : {false, true}) {
        statics.clear();
        const int upper = statics.add_body(1, 2, kGravity_m_s2);
        const int lower = statics.add_body(0.25f, 2, kGravity_m_s2);
        for (std::size_t i = 0; i < 4; ++i) {
            const bool top = i < 2;
            statics.add_pin(top ? PinStatics::kFixed : upper, top ? upper : lower, {0, -0.5f}, {0, 0.5f},
                            forces[i]);
        }
        const int rounds = statics.solve(1e-6);
        CHECK((rounds == 0) == again);
        for (std::size_t i = 0; i < 4; ++i) forces[i] = statics.force(static_cast<int>(i));
        CHECK(forces[0].y == Approx(25).epsilon(1e-5));
        CHECK(forces[1].y == Approx(25).epsilon(1e-5));
        CHECK(forces[2].y == Approx(20).epsilon(1e-5));
        CHECK(forces[3].y == Approx(20).epsilon(1e-5));
    }
}

}  // namespace cairn::physics
