// Shapes drawn into memory, read back at exact places.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

constexpr Color kBlack = {0, 0, 0, 1};
constexpr Color kRed = {1, 0, 0, 1};
constexpr Color kWhite = {1, 1, 1, 1};

/// The sum of the red channel in units of whole pixels: on black, the area that is covered.
double red_area(const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i] / 255.0;
    return sum;
}

}  // namespace

TEST_CASE_METHOD(Drawing, "a rectangle at whole pixels is exactly its pixels") {
    renderer->begin_frame({0, 0, 1, 1});
    renderer->fill_rectangle({10, 12, 20, 8}, kRed);
    const Image image = capture();
    renderer->end_frame();
    bool exact = true;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool inside = x >= 10 && x < 30 && y >= 12 && y < 20;
            exact =
                exact && rgb(image, x, y) == (inside ? 0xff0000u : 0x0000ffu) && image.pixel(x, y)[3] == 255;
        }
    CHECK(exact);
}

TEST_CASE_METHOD(Drawing, "an edge between two pixels is anti-aliased by its coverage") {
    renderer->begin_frame(kBlack);
    renderer->fill_rectangle({10.25f, 10, 20, 20}, kWhite);
    const Image image = capture();
    CHECK(rgb(image, 9, 20) == 0x000000u);
    CHECK(image.pixel(10, 20)[0] == Approx(0.75 * 255).margin(2));  // three quarters of the pixel are inside
    CHECK(rgb(image, 11, 20) == 0xffffffu);
    CHECK(rgb(image, 29, 20) == 0xffffffu);
    CHECK(image.pixel(30, 20)[0] == Approx(0.25 * 255).margin(2));
    CHECK(rgb(image, 31, 20) == 0x000000u);
}

TEST_CASE_METHOD(Drawing, "a circle covers its area in pixels and has a soft rim") {
    renderer->begin_frame(kBlack);
    renderer->fill_circle({31.3f, 24.6f}, 15, kRed);
    const Image image = capture();
    CHECK(red_area(image) == Approx(3.14159265 * 15 * 15).epsilon(0.005));
    int partial = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        if (image.rgba[i] > 0 && image.rgba[i] < 255) ++partial;
    CHECK(partial > 60);   // about one per pixel of the circumference, 94
    CHECK(partial < 190);  // and no wider than two
    CHECK(rgb(image, 31, 24) == 0xff0000u);
}

TEST_CASE_METHOD(Drawing, "translucent shapes have no seams between their triangles") {
    renderer->begin_frame(kBlack);
    renderer->fill_circle({32, 24}, 20, {1, 1, 1, 0.5f});
    const Image image = capture();
    for (int y = 14; y < 34; ++y)
        for (int x = 22; x < 42; ++x) REQUIRE(rgb(image, x, y) == 0x808080u);
}

TEST_CASE_METHOD(Drawing, "transforms nest, and what is drawn goes through the newest first") {
    renderer->begin_frame(kBlack);
    REQUIRE(renderer->push_transform());
    renderer->translate({20, 10});
    REQUIRE(renderer->push_transform());
    renderer->scale({4, 2});
    renderer->fill_rectangle({1, 1, 2, 3}, kRed);  // 24..32, 12..18
    REQUIRE(renderer->pop_transform());
    renderer->rotate(3.14159265f / 2);
    renderer->fill_rectangle({20, -6, 5, 4}, kWhite);  // turned: x 22..26, y 30..35
    REQUIRE(renderer->pop_transform());
    renderer->fill_rectangle({0, 0, 2, 2}, kRed);
    const Image image = capture();
    CHECK(rgb(image, 24, 12) == 0xff0000u);
    CHECK(rgb(image, 31, 17) == 0xff0000u);
    CHECK(rgb(image, 32, 17) == 0u);
    CHECK(rgb(image, 23, 31) == 0xffffffu);
    CHECK(rgb(image, 24, 33) == 0xffffffu);
    CHECK(rgb(image, 28, 31) == 0u);
    CHECK(rgb(image, 1, 1) == 0xff0000u);
}

TEST_CASE_METHOD(Drawing, "a line's width follows the transform") {
    renderer->begin_frame(kBlack);
    REQUIRE(renderer->push_transform());
    renderer->scale({4, 4});
    renderer->draw_line({2, 6}, {14, 6}, 1, kRed, LineCap::Butt);  // 48 x 4 pixels
    const Image image = capture();
    CHECK(rgb(image, 30, 22) == 0xff0000u);
    CHECK(rgb(image, 30, 25) == 0xff0000u);
    CHECK(rgb(image, 30, 21) == 0u);
    CHECK(rgb(image, 30, 26) == 0u);
    CHECK(red_area(image) == Approx(48 * 4).margin(1));
}

TEST_CASE_METHOD(Drawing, "outlines lie around the true edge and leave the inside alone") {
    renderer->begin_frame(kBlack);
    renderer->outline_rectangle({10, 10, 30, 20}, 4, kRed);
    const Image image = capture();
    CHECK(rgb(image, 8, 20) == 0xff0000u);
    CHECK(rgb(image, 11, 20) == 0xff0000u);
    CHECK(rgb(image, 12, 20) == 0u);
    CHECK(rgb(image, 7, 20) == 0u);
    CHECK(rgb(image, 8, 8) == 0xff0000u);  // the corner is mitred
}

TEST_CASE_METHOD(Drawing, "light adds up and the scissor cuts") {
    renderer->begin_frame(kBlack);
    renderer->set_scissor(Rect{0, 0, 32, 48});
    renderer->set_blend_mode(BlendMode::Add);
    renderer->fill_rectangle({0, 0, 64, 48}, {0.2f, 0, 0, 1});
    renderer->fill_rectangle({0, 0, 64, 48}, {0.2f, 0.4f, 0, 1});
    renderer->set_scissor(std::nullopt);
    const Image image = capture();
    CHECK(rgb(image, 31, 40) == 0x666600u);
    CHECK(rgb(image, 32, 40) == 0u);
}

TEST_CASE_METHOD(Drawing, "a mesh has colors that run from corner to corner") {
    renderer->begin_frame(kBlack);
    const std::array<MeshVertex, 4> quad = {MeshVertex{{0, 0}, {0, 0, 0, 1}, {}},
                                            {{64, 0}, {1, 0, 0, 1}, {}},
                                            {{64, 48}, {1, 0, 0, 1}, {}},
                                            {{0, 48}, {0, 0, 0, 1}, {}}};
    const std::array<std::uint32_t, 6> indices = {0, 1, 2, 0, 2, 3};
    renderer->draw_mesh(quad, indices);
    const Image image = capture();
    for (int x = 0; x < 64; x += 9) CHECK(image.pixel(x, 30)[0] == Approx((x + 0.5) / 64 * 255).margin(1));
}

TEST_CASE_METHOD(Drawing,
                 "coordinates that are not finite draw nothing, and huge ones draw what can be seen") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    renderer->begin_frame(kBlack);
    for (const float bad : {nan, infinity, -infinity}) {
        renderer->fill_rectangle({bad, 0, 10, 10}, kRed);
        renderer->fill_rectangle({0, 0, bad, 10}, kRed);
        renderer->fill_circle({5, bad}, 3, kRed);
        renderer->fill_circle({5, 5}, bad, kRed);
        renderer->fill_capsule({bad, 0}, {5, 5}, 2, kRed);
        renderer->draw_line({0, 0}, {bad, 5}, 2, kRed);
        renderer->draw_line({0, 0}, {9, 5}, bad, kRed);
    }
    renderer->fill_circle({5, 5}, -3, kRed);
    renderer->draw_line({0, 0}, {9, 5}, 0, kRed);
    CHECK(red_area(capture()) == 0);
    renderer->fill_rectangle({-1e9f, 20, 2e9f, 2e9f}, kRed);
    const Image image = capture();
    CHECK(rgb(image, 0, 19) == 0u);
    CHECK(rgb(image, 0, 20) == 0xff0000u);
    CHECK(rgb(image, 63, 47) == 0xff0000u);
}

TEST_CASE_METHOD(Drawing, "an ellipse covers its area") {
    renderer->begin_frame(kBlack);
    renderer->fill_ellipse({31.5f, 24.2f}, {22, 9}, kRed);
    const Image image = capture();
    CHECK(red_area(image) == Approx(3.14159265 * 22 * 9).epsilon(0.005));
    CHECK(rgb(image, 12, 24) == 0xff0000u);
    CHECK(rgb(image, 31, 12) == 0u);
}

TEST_CASE_METHOD(Drawing, "a slice of a disc covers its share of the area, however wide, without seams") {
    constexpr double kPi = 3.14159265;
    for (const double turn : {0.4, 1.5, 2.8, 3.5, 5.0, 6.1, -4.0, 7.0}) {
        renderer->begin_frame(kBlack);
        renderer->fill_sector({32, 24}, 20, 0.3f, static_cast<float>(0.3 + turn), {1, 0, 0, 0.5f});
        const Image image = capture();
        INFO(turn);
        const double share = std::min(std::abs(turn) / (2 * kPi), 1.0);
        CHECK(red_area(image) == Approx(share * kPi * 20 * 20 / 2).epsilon(0.015));
        // Half of red at most: nothing is covered twice.
        int most = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) most = std::max<int>(most, image.rgba[i]);
        CHECK(most == 128);
        renderer->end_frame();
    }
}

TEST_CASE_METHOD(Drawing, "an arc covers its length times its width") {
    renderer->begin_frame(kBlack);
    renderer->draw_arc({32, 24}, 16, 1, 3.5f, 3, kRed);
    CHECK(red_area(capture()) == Approx(16 * 2.5 * 3).epsilon(0.02));
}

TEST_CASE_METHOD(Drawing, "slices, arcs and ellipses of no size or of nonsense draw nothing") {
    renderer->begin_frame(kBlack);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    renderer->fill_sector({20, 20}, 0, 0, 1, kRed);
    renderer->fill_sector({20, 20}, 5, 1, 1, kRed);
    renderer->fill_sector({20, 20}, 5, nan, 1, kRed);
    renderer->draw_arc({20, 20}, 5, 0, nan, 1, kRed);
    renderer->fill_ellipse({20, 20}, {-1, 5}, kRed);
    renderer->fill_ellipse({nan, 20}, {5, 5}, kRed);
    CHECK(red_area(capture()) == 0);
}
