// Following, bounds, zoom and shake of cameras.
#include <catch2/catch.hpp>
#include <cmath>

#include <cairn/engine/camera_rig.h>

using namespace cairn::engine;

namespace {

constexpr float kStep = 1.0f / 60;
constexpr Size kScreen = {200, 100};  // twice as wide as high

CameraRig rig_of(CameraRigDef def = {}) {
    return CameraRig(def, kScreen);
}

}  // namespace

TEST_CASE("a camera that follows approaches its target exponentially and never passes it") {
    CameraRig rig = rig_of({.follow_rate_1_s = 4});
    rig.follow(Vec2{10, -5});
    float before = 10;
    for (int i = 0; i < 60; ++i) {
        rig.update(kStep);
        const float rest = 10 - rig.camera().position_m.x;
        CHECK(rest > 0);
        CHECK(rest < before);
        before = rest;
    }
    // e^-4 of the way is left; the implicit step is a little slower.
    CHECK(before == Approx(10 * std::exp(-4.0)).epsilon(0.2));
    CHECK(rig.camera().position_m.y == Approx(-5 * (1 - before / 10)));
    for (int i = 0; i < 600; ++i) rig.update(kStep);
    CHECK(rig.camera().position_m.x == Approx(10).margin(1e-3));
}

TEST_CASE("a step of any length does not pass the target") {
    CameraRig rig = rig_of({.follow_rate_1_s = 100});
    rig.follow(Vec2{1, 0});
    rig.update(10);
    CHECK(rig.camera().position_m.x > 0.99f);
    CHECK(rig.camera().position_m.x <= 1);
}

TEST_CASE("inside the dead zone the camera rests, outside it keeps the target at its edge") {
    CameraRig rig = rig_of({.follow_rate_1_s = 50, .dead_zone_m = {4, 2}});
    rig.follow(Vec2{1.9f, -0.9f});
    rig.update(kStep);
    CHECK(rig.camera().position_m == Vec2{0, 0});
    rig.follow(Vec2{5, 0.5f});
    for (int i = 0; i < 300; ++i) rig.update(kStep);
    CHECK(rig.camera().position_m.x == Approx(3).margin(1e-3));
    CHECK(rig.camera().position_m.y == 0);
}

TEST_CASE("nothing outside of the bounds is shown, and small bounds are centred") {
    CameraRig rig = rig_of();  // shows 20 x 10 m
    rig.set_bounds(CameraBounds{{-15, 0}, {40, 8}});
    rig.set_position_m({-100, 100});
    CHECK(rig.camera().position_m == Vec2{-5, 4});
    rig.set_position_m({100, 0});
    CHECK(rig.camera().position_m == Vec2{30, 4});
    rig.follow(Vec2{1000, 0});
    for (int i = 0; i < 100; ++i) {
        rig.update(kStep);
        REQUIRE(rig.camera().to_world({200, 50}).x <= 40.001f);
    }
    rig.set_zoom(2);  // 10 x 5 m
    rig.set_position_m({100, 100});
    CHECK(rig.camera().position_m == Vec2{35, 5.5f});
    rig.set_bounds(std::nullopt);
    rig.set_position_m({100, 100});
    CHECK(rig.camera().position_m == Vec2{100, 100});
}

TEST_CASE("zooming at a point keeps that point of the world where it is") {
    CameraRig rig = rig_of();
    rig.set_position_m({3, 4});
    const Vec2 mouse = {150, 20};
    const Vec2 held = rig.camera().to_world(mouse);
    for (const float factor : {1.5f, 0.25f, 4.0f}) {
        rig.zoom_at(mouse, factor);
        const Vec2 now = rig.camera().to_world(mouse);
        CHECK(now.x == Approx(held.x).margin(1e-4));
        CHECK(now.y == Approx(held.y).margin(1e-4));
    }
    CHECK(rig.zoom() == Approx(1.5f));
    CHECK(rig.camera().view_height_m() == Approx(10 / 1.5f));
    CHECK(rig.view_height_m() == 10);
}

TEST_CASE("a shake stays within its reach, moves both ways, fades, and is the same every time") {
    const auto run = [] {
        CameraRig rig = rig_of({.shake_share = 0.1f});
        rig.shake(0.7f);
        rig.shake(0.7f);  // together no more than 1
        std::vector<Vec2> offsets;
        for (int i = 0; i < 60; ++i) {
            rig.update(kStep);
            offsets.push_back(rig.camera().shake_m);
        }
        return offsets;
    };
    const std::vector<Vec2> offsets = run();
    float left = 0, right = 0;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const float strength = std::max(0.0f, 1 - 1.25f * static_cast<float>(i + 1) * kStep);
        CHECK(std::abs(offsets[i].x) <= strength * strength * 1.0f + 1e-5f);  // 0.1 of 10 m
        CHECK(std::abs(offsets[i].y) <= strength * strength * 1.0f + 1e-5f);
        left = std::min(left, offsets[i].x);
        right = std::max(right, offsets[i].x);
    }
    CHECK(left < -0.05f);
    CHECK(right > 0.05f);
    CHECK(offsets.back() == Vec2{});
    CHECK(run() == offsets);
}

TEST_CASE("a picture between two updates shows the camera between its two places") {
    CameraRig rig = rig_of();
    rig.follow(Vec2{10, 0});
    rig.update(kStep);
    const float first = rig.camera().position_m.x;
    rig.update(kStep);
    const float second = rig.camera().position_m.x;
    CHECK(rig.camera_at(0).position_m.x == Approx(first));
    CHECK(rig.camera_at(0.25f).position_m.x == Approx(first + 0.25f * (second - first)));
    CHECK(rig.camera_at(1).position_m.x == Approx(second));
    rig.set_position_m({-7, 0});  // a jump is not smoothed
    CHECK(rig.camera_at(0.5f).position_m.x == -7);
}
