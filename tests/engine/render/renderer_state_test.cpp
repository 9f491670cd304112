// Frames, the stack of transforms, counters, and the agreement of the back-ends.
#include <catch2/catch.hpp>

#include <cairn/engine/camera.h>

#include "engine/support/drawing.h"

using namespace cairn::engine;

namespace {

void draw_everything(Drawing& d) {
    Renderer& r = *d.renderer;
    const FontId font = d.font(14);
    r.begin_frame({0, 0, 0, 1});
    r.fill_circle({20, 20}, 10, {});
    r.outline_capsule({10, 10}, {30, 30}, 4, 1, {});
    r.draw_text(font, "Cairn\nengine", {.position = {2, 2}});
    r.set_blend_mode(BlendMode::Add);
    r.fill_rectangle({0, 0, 9, 9}, {});
    r.end_frame();
}

}  // namespace

TEST_CASE("the null renderer counts the same work as the one that draws") {
    Drawing drawn({64, 48}, true);
    draw_everything(drawn);
    const RenderStats expected = drawn.renderer->stats();
    drawn.renderer.reset();
    drawn.files.reset();
    Drawing null({64, 48}, false);
    draw_everything(null);
    CHECK(expected.draw_calls == 3);
    CHECK(expected.triangles > 100);
    CHECK(null.renderer->stats().draw_calls == expected.draw_calls);
    CHECK(null.renderer->stats().vertices == expected.vertices);
    CHECK(null.renderer->stats().triangles == expected.triangles);
}

TEST_CASE_METHOD(Drawing, "shapes of one kind share a draw call, and shapes out of sight cost nothing") {
    renderer->begin_frame({});
    for (int i = 0; i < 100; ++i) renderer->fill_circle({static_cast<float>(i), 10}, 3, {});
    renderer->end_frame();
    CHECK(renderer->stats().draw_calls == 1);
    renderer->begin_frame({});
    renderer->fill_circle({-500, 10}, 3, {});
    renderer->draw_line({-10, 200}, {90, 200}, 4, {});
    renderer->end_frame();
    CHECK(renderer->stats().draw_calls == 0);
    CHECK(renderer->stats().vertices == 0);
}

TEST_CASE_METHOD(Drawing, "a pop without a push and a push without end are errors") {
    renderer->begin_frame({});
    CHECK_THAT(renderer->pop_transform().error().message, Catch::Contains("push"));
    int pushed = 0;
    while (renderer->push_transform()) ++pushed;
    CHECK(pushed == 64);
    CHECK(renderer->transform_depth() == 64);
    renderer->end_frame();
    CHECK(renderer->transform_depth() == 0);
}

TEST_CASE_METHOD(Drawing, "begin_frame resets transform, blend mode and scissor") {
    renderer->begin_frame({});
    renderer->translate({100, 100});
    renderer->set_scissor(Rect{0, 0, 1, 1});
    renderer->set_blend_mode(BlendMode::Add);
    renderer->end_frame();
    renderer->begin_frame({0, 0, 1, 1});
    renderer->fill_rectangle({0, 0, 64, 48}, {1, 0, 0, 1});
    CHECK(rgb(capture(), 50, 40) == 0xff0000u);
    CHECK(renderer->transform() == Affine2{});
}

TEST_CASE_METHOD(Drawing, "a camera's map draws the world the right way up") {
    Camera2D camera(4, {64, 48});  // 12 pixels per metre
    renderer->begin_frame({0, 0, 0, 1});
    renderer->apply_transform(camera.world_to_screen());
    renderer->fill_rectangle({0, 0, 1, 1}, {1, 0, 0, 1});  // right of and above the middle
    const Image image = capture();
    CHECK(rgb(image, 32, 23) == 0xff0000u);
    CHECK(rgb(image, 43, 12) == 0xff0000u);
    CHECK(rgb(image, 33, 25) == 0u);
    renderer->reset_transform();
    CHECK(renderer->transform() == Affine2{});
}

TEST_CASE("the null renderer has no picture") {
    Drawing d({8, 8}, false);
    d.renderer->begin_frame({});
    CHECK_THAT(d.renderer->capture().error().message, Catch::Contains("without drawing"));
    CHECK(d.renderer->logical_size() == Size{8, 8});
    CHECK(d.renderer->pixel_scale() == 1);
}
