// The camera against places that can be computed by hand.
#include <catch2/catch.hpp>

#include <cairn/engine/camera.h>

using namespace cairn::engine;

TEST_CASE("the camera's position is in the middle of the screen, and up is up") {
    Camera2D camera(10, {800, 400});
    camera.position_m = {3, 5};
    CHECK(camera.pixels_per_metre() == 40);
    CHECK(camera.view_width_m() == 20);
    CHECK(camera.to_screen({3, 5}) == Vec2{400, 200});
    CHECK(camera.to_screen({3, 10}) == Vec2{400, 0});
    CHECK(camera.to_screen({-7, 0}) == Vec2{0, 400});
}

TEST_CASE("a point goes to the screen and comes back") {
    Camera2D camera(7.3f, {1280, 720});
    camera.position_m = {-12.25f, 4.5f};
    camera.shake_m = {0.1f, -0.2f};
    for (float x = -30; x <= 30; x += 7.7f)
        for (float y = -20; y <= 20; y += 3.1f) {
            const Vec2 back = camera.to_world(camera.to_screen({x, y}));
            CHECK(back.x == Approx(x).margin(1e-4));
            CHECK(back.y == Approx(y).margin(1e-4));
        }
}

TEST_CASE("the camera's map is the same as its functions, and shake moves what is seen") {
    Camera2D camera(8, {640, 480});
    camera.position_m = {1, 2};
    const Vec2 calm = camera.to_screen({2, 2});
    camera.shake_m = {0.5f, 0};
    CHECK(camera.to_screen({2, 2}) == calm - Vec2{30, 0});
    CHECK(camera.world_to_screen().apply({2, 2}) == camera.to_screen({2, 2}));
}

TEST_CASE("a screen without area is ignored") {
    Camera2D camera(8, {640, 480});
    camera.set_screen_size({0, 480});
    CHECK(camera.screen_size() == Size{640, 480});
    camera.set_screen_size({320, 240});
    camera.set_view_height_m(4);
    CHECK(camera.pixels_per_metre() == 60);
}
