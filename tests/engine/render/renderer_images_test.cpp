// Images drawn into memory, and image assets.
#include <catch2/catch.hpp>

#include <cairn/engine/log.h>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

/// 4 x 2 pixels: red, green, blue, white above black, yellow, cyan, magenta.
Image palette() {
    Image image{{4, 2}, {}};
    for (const unsigned color :
         {0xff0000u, 0x00ff00u, 0x0000ffu, 0xffffffu, 0u, 0xffff00u, 0x00ffffu, 0xff00ffu})
        for (const unsigned byte : {color >> 16, color >> 8 & 255, color & 255, 255u})
            image.rgba.push_back(static_cast<std::uint8_t>(byte));
    return image;
}

struct Images : Drawing {
    Images() {
        put_png("palette.png", palette());
        auto loaded = renderer->load_texture("palette.png");
        REQUIRE(loaded);
        texture = *loaded;
        renderer->begin_frame({0.5f, 0.5f, 0.5f, 1});
    }
    TextureId texture;
};

}  // namespace

TEST_CASE_METHOD(Images,
                 "an image whose folder is forgotten is read anew, and its old handle shows what it did") {
    put_png("mine/one.png", palette());
    const TextureId before = *renderer->load_texture("mine/one.png");
    put_png("mine/one.png", {{1, 1}, {1, 2, 3, 255}});
    CHECK(*renderer->load_texture("mine/one.png") == before);
    renderer->forget_files("mine");
    const TextureId after = *renderer->load_texture("mine/one.png");
    CHECK(renderer->texture_size(after) == Size{1, 1});
    CHECK(renderer->texture_size(before) == Size{4, 2});
    CHECK(*renderer->load_texture("palette.png") == texture);
    renderer->destroy_texture(before);
    CHECK(*renderer->load_texture("mine/one.png") == after);
}

TEST_CASE_METHOD(Images, "an image in its own size is shown pixel by pixel") {
    renderer->draw_image(texture, {.position = {10, 20}});
    const Image image = capture();
    const Image expected = palette();
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) CHECK(rgb(image, 10 + x, 20 + y) == rgb(expected, x, y));
    CHECK(rgb(image, 9, 20) == 0x808080u);
    CHECK(rgb(image, 14, 21) == 0x808080u);
}

TEST_CASE_METHOD(Images, "a source rectangle shows a part without its neighbours") {
    renderer->draw_image(texture, {.position = {10, 10}, .scale = {10, 10}, .source = Rect{1, 0, 1, 1}});
    const Image image = capture();
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x) REQUIRE(rgb(image, x, y) == 0x00ff00u);
    CHECK(rgb(image, 20, 15) == 0x808080u);
}

TEST_CASE_METHOD(Images, "rotation turns around the origin, clockwise on the screen") {
    // A quarter turn around the image's top left: its columns become rows to the left of x = 30.
    renderer->draw_image(texture, {.position = {30, 10}, .rotation_rad = 3.14159265f / 2});
    const Image image = capture();
    CHECK(rgb(image, 29, 10) == 0xff0000u);
    CHECK(rgb(image, 29, 11) == 0x00ff00u);
    CHECK(rgb(image, 28, 11) == 0xffff00u);
    CHECK(rgb(image, 29, 13) == 0xffffffu);
}

TEST_CASE_METHOD(Images, "origin, mirroring and tint") {
    renderer->draw_image(texture,
                         {.position = {30, 10}, .scale = {-1, 1}, .origin = {4, 0}, .tint = {1, 0, 1, 1}});
    const Image image = capture();
    CHECK(rgb(image, 30, 10) == 0xff00ffu);  // white by magenta
    CHECK(rgb(image, 31, 10) == 0x0000ffu);
    CHECK(rgb(image, 33, 10) == 0xff0000u);
}

TEST_CASE_METHOD(Images, "a polygon can be filled with an image") {
    const std::vector<Vec2> box = {{10, 10}, {30, 10}, {30, 20}, {10, 20}};
    renderer->fill_convex_polygon(
        box, texture, Affine2::scaling({1 / 20.0f, 1 / 10.0f}) * Affine2::translation({-10, -10}));
    const Image image = capture();
    // The middles of the eight texels.
    CHECK(image.pixel(12, 12)[0] > 240);
    CHECK(rgb(image, 10, 10) == 0xff0000u);
    CHECK(rgb(image, 29, 10) == 0xffffffu);
    CHECK(rgb(image, 29, 19) == 0xff00ffu);
    CHECK(rgb(image, 10, 19) == 0x000000u);
}

TEST_CASE_METHOD(Images, "the same path is the same texture until it is destroyed") {
    CHECK(*renderer->load_texture("palette.png") == texture);
    CHECK(renderer->texture_size(texture) == Size{4, 2});
    renderer->destroy_texture(texture);
    CHECK_FALSE(renderer->is_valid(texture));
    CHECK(renderer->texture_size(texture) == Size{});
    const auto again = renderer->load_texture("palette.png");
    REQUIRE(again);
    CHECK(*again != texture);
}

TEST_CASE_METHOD(Images, "drawing with a stale handle draws nothing and says so once") {
    renderer->destroy_texture(texture);
    std::vector<std::string> logged;
    const LogSink before = set_log_sink([&](LogLevel, std::string_view text) { logged.emplace_back(text); });
    renderer->draw_image(texture, {.position = {10, 10}});
    renderer->draw_image(texture, {.position = {10, 10}});
    set_log_sink(before);
    REQUIRE(logged.size() == 1);
    CHECK_THAT(logged[0], Catch::Contains("draw_image") && Catch::Contains("texture"));
    CHECK(rgb(capture(), 11, 11) == 0x808080u);
}

TEST_CASE(
    "a missing or damaged image is an error that names the path and the reason, with and without pixels") {
    for (const bool with_pixels : {true, false}) {
        Drawing d({8, 8}, with_pixels);
        d.folder.put("broken.png", "\x89PNG\r\n\x1a\n and then nothing");
        d.folder.put("text.png", "hello");
        CHECK_THAT(d.renderer->load_texture("nosuch.png").error().message,
                   Catch::Contains("'nosuch.png'") && Catch::Contains("not found"));
        CHECK_THAT(d.renderer->load_texture("broken.png").error().message,
                   Catch::Contains("'broken.png'") && Catch::Contains("damaged"));
        CHECK_THAT(d.renderer->load_texture("text.png").error().message, Catch::Contains("'text.png'"));
        CHECK_FALSE(d.renderer->create_texture({}));
    }
}

TEST_CASE("the null renderer knows the sizes of images") {
    Drawing d({8, 8}, false);
    d.put_png("palette.png", palette());
    const auto texture = d.renderer->load_texture("palette.png");
    REQUIRE(texture);
    CHECK(d.renderer->texture_size(*texture) == Size{4, 2});
}

TEST_CASE_METHOD(Images, "a nine-patch keeps its corners and stretches the rest") {
    // 3 x 3 pixels of nine colors; the borders are one pixel each, drawn twice as large.
    Image nine{{3, 3}, {}};
    for (int i = 0; i < 9; ++i)
        nine.rgba.insert(nine.rgba.end(), {std::uint8_t(20 * i), std::uint8_t(250 - 20 * i), 7, 255});
    const auto patch = renderer->create_texture(nine);
    REQUIRE(patch);
    renderer->draw_nine_patch(
        *patch, {.area = {10, 10, 30, 20}, .left = 1, .top = 1, .right = 1, .bottom = 1, .scale = 2});
    const Image image = capture();
    // The outermost pixels of each corner; filters mix further in.
    CHECK(rgb(image, 10, 10) == rgb(nine, 0, 0));
    CHECK(rgb(image, 39, 10) == rgb(nine, 2, 0));
    CHECK(rgb(image, 10, 29) == rgb(nine, 0, 2));
    CHECK(rgb(image, 39, 29) == rgb(nine, 2, 2));
    const auto red = [&](int x, int y) { return static_cast<int>(image.pixel(x, y)[0]); };
    CHECK(std::abs(red(25, 20) - 80) <= 4);  // the middle
    CHECK(std::abs(red(25, 10) - 20) <= 4);  // the middle of the upper side
    CHECK(rgb(image, 9, 20) == 0x808080u);
    CHECK(rgb(image, 40, 20) == 0x808080u);
}

TEST_CASE_METHOD(Images, "a nine-patch smaller than its borders shrinks them") {
    renderer->draw_nine_patch(texture,
                              {.area = {10, 10, 2, 2}, .left = 2, .top = 1, .right = 2, .bottom = 1});
    const Image image = capture();
    CHECK(rgb(image, 10, 10) != 0x808080u);
    CHECK(rgb(image, 12, 10) == 0x808080u);
    CHECK(rgb(image, 9, 10) == 0x808080u);
}

TEST_CASE_METHOD(Images, "the same path with another filter is another texture") {
    const auto nearest = renderer->load_texture("palette.png", TextureFilter::Nearest);
    REQUIRE(nearest);
    CHECK(*nearest != texture);
    CHECK(*renderer->load_texture("palette.png", TextureFilter::Nearest) == *nearest);
    renderer->draw_image(*nearest, {.position = {4, 4}, .scale = {7, 7}});
    const Image image = capture();
    const Image expected = palette();
    for (int y = 0; y < 14; ++y)
        for (int x = 0; x < 28; ++x) REQUIRE(rgb(image, 4 + x, 4 + y) == rgb(expected, x / 7, y / 7));
    renderer->destroy_texture(*nearest);
    CHECK(renderer->is_valid(texture));
    CHECK(*renderer->load_texture("palette.png") == texture);
}
