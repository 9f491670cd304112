// Canvases, blend modes and premultiplied colors, drawn into memory.
#include <catch2/catch.hpp>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

constexpr Color kRed = {1, 0, 0, 1};
constexpr Color kHalfRed = {1, 0, 0, 0.5f};

struct Canvases : Drawing {
    Canvases() {
        auto made = renderer->create_canvas({16, 12});
        REQUIRE(made);
        canvas = *made;
        renderer->begin_frame({0, 0, 1, 1});
    }
    void begin(std::optional<Color> clear = Color{0, 0, 0, 0}) {
        REQUIRE(renderer->begin_canvas(canvas, clear));
    }
    void end() { REQUIRE(renderer->end_canvas()); }
    TextureId canvas;
};

bool is_near(unsigned actual, unsigned expected) {
    INFO(std::hex << actual << " against " << expected);
    for (const unsigned shift : {0u, 8u, 16u}) {
        const int difference =
            static_cast<int>(actual >> shift & 255) - static_cast<int>(expected >> shift & 255);
        CHECK(std::abs(difference) <= 1);
    }
    return true;
}

}  // namespace

TEST_CASE_METHOD(Canvases, "what is drawn into a canvas shows when the canvas is drawn, and not before") {
    begin();
    renderer->fill_rectangle({0, 0, 8, 12}, kRed);
    end();
    CHECK(rgb(capture(), 4, 4) == 0x0000ffu);
    renderer->draw_image(canvas, {.position = {20, 10}});
    const Image image = capture();
    CHECK(rgb(image, 24, 14) == 0xff0000u);
    CHECK(rgb(image, 32, 14) == 0x0000ffu);  // transparent there
    CHECK(rgb(image, 4, 4) == 0x0000ffu);
}

TEST_CASE_METHOD(Canvases, "a picture drawn by way of a canvas is the picture drawn at once") {
    // Translucent over transparent, twice: a canvas that kept straight alpha would darken it.
    const auto paint = [&](Vec2 at) {
        renderer->fill_rectangle({at.x + 2, at.y + 2, 8, 8}, kHalfRed);
        renderer->fill_rectangle({at.x + 4, at.y + 4, 8, 8}, {0, 1, 0, 0.25f});
    };
    begin();
    paint({0, 0});
    end();
    renderer->draw_image(canvas, {.position = {40, 0}});
    paint({0, 0});
    const Image image = capture();
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 16; ++x) is_near(rgb(image, 40 + x, y), rgb(image, x, y));
}

TEST_CASE_METHOD(Canvases, "a tint fades a canvas as it fades an image") {
    begin();
    renderer->fill_rectangle({0, 0, 16, 12}, kRed);
    end();
    renderer->draw_image(canvas, {.position = {0, 0}, .tint = {1, 1, 1, 0.5f}});
    is_near(rgb(capture(), 5, 5), 0x800080u);  // half red over blue
}

TEST_CASE_METHOD(Canvases, "a canvas keeps its picture from frame to frame, until it is cleared") {
    begin();
    renderer->fill_rectangle({0, 0, 16, 12}, kRed);
    end();
    renderer->end_frame();
    renderer->begin_frame({0, 0, 1, 1});
    begin(std::nullopt);
    end();
    renderer->draw_image(canvas, {});
    CHECK(rgb(capture(), 5, 5) == 0xff0000u);
    begin();
    end();
    renderer->begin_frame({0, 0, 1, 1});
    renderer->draw_image(canvas, {});
    CHECK(rgb(capture(), 5, 5) == 0x0000ffu);
}

TEST_CASE_METHOD(Canvases,
                 "transforms, scissor and blend mode of a canvas are its own, and those before come back") {
    renderer->translate({30, 20});
    renderer->set_scissor(Rect{30, 20, 4, 4});
    renderer->set_blend_mode(BlendMode::Add);
    begin();
    CHECK(renderer->target_size() == Size{16, 12});
    CHECK(renderer->transform() == Affine2{});
    renderer->fill_rectangle({0, 0, 16, 12}, kRed);
    end();
    CHECK(renderer->target_size() == Size{64, 48});
    renderer->draw_image(canvas, {});
    const Image image = capture();
    CHECK(rgb(image, 32, 22) == 0xff00ffu);  // red added to blue
    CHECK(rgb(image, 36, 22) == 0x0000ffu);  // cut off
}

TEST_CASE_METHOD(Canvases, "a frame that forgets to end its canvases leaves no trace") {
    begin();
    renderer->translate({5, 5});
    renderer->end_frame();
    renderer->begin_frame({0, 1, 0, 1});
    CHECK(renderer->current_canvas().is_null());
    renderer->fill_rectangle({0, 0, 4, 4}, kRed);
    CHECK(rgb(capture(), 1, 1) == 0xff0000u);
    CHECK(rgb(capture(), 10, 10) == 0x00ff00u);
}

TEST_CASE_METHOD(Canvases, "a canvas destroyed in use lives to the end of the frame") {
    begin();
    renderer->destroy_texture(canvas);
    CHECK(renderer->is_valid(canvas));
    end();
    renderer->end_frame();
    CHECK_FALSE(renderer->is_valid(canvas));
}

TEST_CASE("wrong uses of canvases are errors that say the rule, with and without pixels") {
    for (const bool with_pixels : {true, false}) {
        Drawing d({32, 32}, with_pixels);
        CHECK_THAT(d.renderer->create_canvas({0, 5}).error().message, Catch::Contains("0 x 5"));
        CHECK_THAT(d.renderer->create_canvas({9000, 5}).error().message, Catch::Contains("1 to 8192"));
        const TextureId canvas = *d.renderer->create_canvas({4, 4});
        const TextureId image = *d.renderer->create_texture({{1, 1}, {1, 2, 3, 255}});
        d.renderer->begin_frame({});
        CHECK_THAT(d.renderer->begin_canvas(image, {}).error().message,
                   Catch::Contains("cannot be drawn into"));
        CHECK_THAT(d.renderer->begin_canvas({}, {}).error().message, Catch::Contains("destroyed"));
        CHECK_THAT(d.renderer->end_canvas().error().message,
                   Catch::Contains("no canvas is being drawn into"));
        REQUIRE(d.renderer->begin_canvas(canvas, {}));
        CHECK_THAT(d.renderer->begin_canvas(canvas, {}).error().message, Catch::Contains("already"));
        std::vector<TextureId> more;
        for (int i = 0; i < 8; ++i) more.push_back(*d.renderer->create_canvas({4, 4}));
        for (int i = 0; i < 7; ++i) REQUIRE(d.renderer->begin_canvas(more[i], {}));
        CHECK_THAT(d.renderer->begin_canvas(more[7], {}).error().message, Catch::Contains("8 canvases"));
        d.renderer->end_frame();
    }
}

TEST_CASE("each blend mode does what its formula says") {
    // S over D, premultiplied: S = (c a, a). D is opaque.
    struct Expectation {
        BlendMode mode;
        float (*result)(float under, float color, float alpha);
    };
    const Expectation modes[] = {
        {BlendMode::Alpha, [](float d, float c, float a) { return c * a + d * (1 - a); }},
        {BlendMode::Add, [](float d, float c, float a) { return std::min(1.0f, d + c * a); }},
        {BlendMode::Multiply, [](float d, float c, float a) { return d * (1 - a) + d * c * a; }},
        {BlendMode::Screen, [](float d, float c, float a) { return 1 - (1 - d) * (1 - c * a); }},
    };
    for (const Expectation& expected : modes) {
        for (const float alpha : {0.0f, 0.25f, 1.0f}) {
            Drawing d({16, 16});
            d.renderer->begin_frame({0.2f, 0.5f, 0.8f, 1});
            d.renderer->set_blend_mode(expected.mode);
            d.renderer->fill_rectangle({0, 0, 16, 16}, {0.9f, 0.4f, 0.1f, alpha});
            const Image image = d.capture();
            const std::uint8_t* p = image.pixel(8, 8);
            const float under[] = {0.2f, 0.5f, 0.8f};
            const float color[] = {0.9f, 0.4f, 0.1f};
            INFO("mode " << static_cast<int>(expected.mode) << ", alpha " << alpha);
            for (int i = 0; i < 3; ++i) {
                const float wanted = 255 * expected.result(under[i], color[i], alpha);
                CHECK(std::abs(static_cast<float>(p[i]) - wanted) <= 1.6f);
            }
            CHECK(p[3] == 255);
        }
    }
}

TEST_CASE_METHOD(Canvases, "replacing cuts a hole into a canvas") {
    begin();
    renderer->fill_rectangle({0, 0, 16, 12}, kRed);
    renderer->set_blend_mode(BlendMode::Replace);
    renderer->fill_rectangle({4, 4, 4, 4}, {0, 0, 0, 0});
    end();
    renderer->draw_image(canvas, {});
    const Image image = capture();
    CHECK(rgb(image, 6, 6) == 0x0000ffu);
    CHECK(rgb(image, 12, 6) == 0xff0000u);
}

TEST_CASE("an edge that replaces mixes by coverage, as an opaque one that covers does") {
    const auto draw = [](BlendMode mode, Color color) {
        Drawing d({32, 32});
        d.renderer->begin_frame({0.2f, 0.5f, 0.8f, 1});
        d.renderer->set_blend_mode(mode);
        d.renderer->fill_circle({10.3f, 10.6f}, 7, color);
        d.renderer->outline_circle({22, 22}, 6, 1.5f, color);
        d.renderer->draw_line({2, 30}, {28, 3}, 2, color);
        return d.capture();
    };
    const Image covered = draw(BlendMode::Alpha, {1, 0.9f, 0.1f, 1});
    CHECK(covered.rgba == draw(BlendMode::Replace, {1, 0.9f, 0.1f, 1}).rgba);
    // On the output a translucent color replaces as the opaque one that it is when multiplied by its alpha.
    const Image half = draw(BlendMode::Alpha, {0.5f, 0.45f, 0.05f, 1});
    const Image replaced = draw(BlendMode::Replace, {1, 0.9f, 0.1f, 0.5f});
    for (std::size_t i = 0; i < half.rgba.size(); ++i)
        REQUIRE(std::abs(half.rgba[i] - replaced.rgba[i]) <= 2);
}

TEST_CASE_METHOD(Canvases, "a hole in a canvas has no dark edge, and the size that it should have") {
    begin(Color{1, 0, 0, 1});
    renderer->set_blend_mode(BlendMode::Replace);
    renderer->fill_circle({8, 6}, 4, {0, 0, 0, 0});
    end();
    renderer->draw_image(canvas, {});
    const Image image = capture();
    int holes = 0;
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 16; ++x) {
            const unsigned color = rgb(image, x, y);
            CHECK((color == 0xff0000u || color == 0x0000ffu));  // the canvas, or what lies behind it
            holes += color == 0x0000ffu ? 1 : 0;
        }
    }
    CHECK(std::abs(holes - 50) <= 6);  // pi 4^2
}

TEST_CASE("the hidden color of transparent pixels does not seam a sprite's edge") {
    // A green texel between transparent red ones, magnified: nowhere may red show.
    Drawing d({32, 32});
    Image sprite{{3, 3}, {}};
    for (int i = 0; i < 9; ++i) {
        const bool middle = i == 4;
        sprite.rgba.insert(sprite.rgba.end(), {std::uint8_t(middle ? 0 : 255), std::uint8_t(middle ? 255 : 0),
                                               0, std::uint8_t(middle ? 255 : 0)});
    }
    const auto texture = d.renderer->create_texture(sprite);
    REQUIRE(texture);
    d.renderer->begin_frame({0, 0, 0, 1});
    d.renderer->draw_image(*texture, {.scale = {10, 10}});
    const Image image = d.capture();
    int green = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            CHECK(image.pixel(x, y)[0] == 0);
            green = std::max<int>(green, image.pixel(x, y)[1]);
        }
    CHECK(green > 200);
}
