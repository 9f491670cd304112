// Particles: their number, their flight against formulas, their look over time.
#include <catch2/catch.hpp>
#include <cmath>

#include <cairn/engine/particles.h>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

constexpr float kStep = 1.0f / 60;

void run(ParticleSystem& system, int steps) {
    for (int i = 0; i < steps; ++i) system.update(kStep);
}

}  // namespace

TEST_CASE("as many are born as the rate says, and as many live as rate times lifetime") {
    ParticleSystem system({.rate_1_s = 90, .lifetime_s = {0.5f, 0.5f}}, 1);
    run(system, 60);
    CHECK(system.count() == 0);  // not started
    system.set_started(true);
    run(system, 20);
    CHECK(std::abs(system.count() - 30) <= 1);
    run(system, 100);
    CHECK(std::abs(system.count() - 45) <= 2);
    system.set_started(false);
    run(system, 31);
    CHECK(system.count() == 0);
}

TEST_CASE("no more live than may") {
    ParticleSystem system({.max_count = 10, .rate_1_s = 1e9f, .lifetime_s = {9, 9}}, 1);
    system.emit(1000, {});
    CHECK(system.count() == 10);
    system.set_started(true);
    run(system, 5);
    CHECK(system.count() == 10);
    system.clear();
    CHECK(system.count() == 0);
}

TEST_CASE("a particle falls as its acceleration says") {
    ParticleSystem system({.lifetime_s = {9, 9},
                           .speed = {4, 4},
                           .direction_rad = 0.6f,
                           .spread_rad = 0,
                           .acceleration = {1, -10}},
                          1);
    system.emit(1, {3, 5});
    run(system, 60);
    const Vec2 at = system.sprite(0, 1).position;
    // Semi-implicit steps fall h a t / 2 further than the parabola.
    const float late = kStep / 2;
    CHECK(at.x == Approx(3 + 4 * std::cos(0.6) + 0.5 + 1 * late).epsilon(1e-3));
    CHECK(at.y == Approx(5 + 4 * std::sin(0.6) - 5 - 10 * late).epsilon(1e-3));
}

TEST_CASE("damping slows down by its exponential") {
    ParticleSystem system({.lifetime_s = {9, 9}, .speed = {10, 10}, .spread_rad = 0, .damping_1_s = 2}, 1);
    system.emit(1, {});
    run(system, 120);
    // The way is v / c (1 - e^(-c t)).
    CHECK(system.sprite(0, 1).position.x == Approx(5 * (1 - std::exp(-4.0))).epsilon(0.02));
}

TEST_CASE("births keep to the area, the speeds and the spread") {
    ParticleSystem system({.lifetime_s = {1, 2},
                           .area = {4, 2},
                           .speed = {3, 6},
                           .direction_rad = 1,
                           .spread_rad = 0.5f,
                           .size_start = {2, 5}},
                          7);
    system.emit(500, {10, 20});
    std::vector<Vec2> births;
    for (int i = 0; i < 500; ++i) {
        const auto s = system.sprite(i, 1);
        births.push_back(s.position);
        CHECK(std::abs(s.position.x - 10) <= 2);
        CHECK(std::abs(s.position.y - 20) <= 1);
        CHECK(s.size >= 2);
        CHECK(s.size <= 5);
    }
    run(system, 1);
    for (int i = 0; i < 500; ++i) {
        const Vec2 v = (system.sprite(i, 1).position - births[i]) * 60;
        CHECK(length(v) >= Approx(3).margin(0.01));
        CHECK(length(v) <= Approx(6).margin(0.01));
        CHECK(std::abs(std::atan2(v.y, v.x) - 1) <= 0.251f);
    }
}

TEST_CASE("size and color follow the lifetime") {
    ParticleSystem system({.lifetime_s = {1, 1},
                           .size_start = {10, 10},
                           .size_end = {2, 2},
                           .colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}}},
                          1);
    system.emit(1, {});
    CHECK(system.sprite(0, 1).color == Color{1, 0, 0, 1});
    run(system, 15);
    CHECK(system.sprite(0, 1).size == Approx(8));
    CHECK(system.sprite(0, 1).color.r == Approx(0.5f).margin(1e-4));
    CHECK(system.sprite(0, 1).color.g == Approx(0.5f).margin(1e-4));
    run(system, 30);
    CHECK(system.sprite(0, 1).color.b == Approx(0.5f).margin(1e-4));
    CHECK(system.sprite(0, 1).color.a == Approx(0.5f).margin(1e-4));
}

TEST_CASE("a picture between two updates shows particles in between") {
    ParticleSystem system({.lifetime_s = {9, 9}, .speed = {6, 6}, .spread_rad = 0, .spin_rad_s = {3, 3}}, 1);
    system.emit(1, {});
    run(system, 10);
    CHECK(system.sprite(0, 0).position.x == Approx(0.9f));
    CHECK(system.sprite(0, 0.5f).position.x == Approx(0.95f));
    CHECK(system.sprite(0, 1).position.x == Approx(1));
    CHECK(system.sprite(0, 0).rotation_rad == Approx(3 * 9 * kStep));
}

TEST_CASE("the same seed gives the same particles, another one others") {
    const auto picture = [](std::uint64_t seed) {
        ParticleSystem system({.rate_1_s = 60, .lifetime_s = {1, 2}, .speed = {1, 9}}, seed);
        system.set_started(true);
        run(system, 90);
        std::vector<Vec2> places;
        for (int i = 0; i < system.count(); ++i) places.push_back(system.sprite(i, 1).position);
        return places;
    };
    CHECK(picture(3) == picture(3));
    CHECK(picture(3) != picture(4));
}

TEST_CASE_METHOD(Drawing, "all particles are one draw call of squares") {
    ParticleSystem system({.lifetime_s = {9, 9},
                           .area = {40, 30},
                           .size_start = {4, 4},
                           .size_end = {4, 4},
                           .colors = {{0, 1, 0, 1}}},
                          1);
    system.emit(50, {32, 24});
    renderer->begin_frame({0, 0, 0, 1});
    system.draw(*renderer, {}, std::nullopt, {1, 1, 1, 1}, 1);
    const Image image = capture();
    renderer->end_frame();
    CHECK(renderer->stats().draw_calls == 1);
    CHECK(renderer->stats().vertices == 200);
    const Vec2 at = system.sprite(49, 1).position;
    CHECK(rgb(image, static_cast<int>(at.x), static_cast<int>(at.y)) == 0x00ff00u);
}
