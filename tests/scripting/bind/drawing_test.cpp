#include "scripting/support/drawing.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const std::map<std::string, std::string> kSmall = {{"conf.lua", "{ width = 200, height = 100 }"}};

TEST_CASE("shapes on the screen are where they were put, y down") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    const engine::Image image = picture_of(
        bench,
        "local g = cairn.graphics g.set_color(1, 0, 0) g.rectangle('fill', 10, 20, 30, 40) "
        "g.set_color(0, 1, 0) g.circle('fill', 100, 50, 20) g.set_color(0, 0, 1) "
        "g.polygon('fill', { 150, 10, 190, 10, 190, 50 }) g.rectangle('fill', 150, 60, 40, 30, 10)");
    is_color(image, 25, 40, 255, 0, 0);
    is_color(image, 5, 40, 0, 0, 0);
    is_color(image, 100, 35, 0, 255, 0);
    is_color(image, 82, 33, 0, 0, 0);
    is_color(image, 185, 20, 0, 0, 255);
    is_color(image, 155, 45, 0, 0, 0);
    is_color(image, 151, 61, 0, 0, 0);  // the rounded corner
    is_color(image, 170, 75, 0, 0, 255);
}

TEST_CASE("under a camera lengths are metres and y is up") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("camera = cairn.camera.new{ x = 10, y = 5, height = 10 } w = cairn.physics.new_world{} "
                      "w:add_box{ x = 10, y = 8, width = 2, height = 2, data = { color = { 1, 0, 0 } } } "
                      "w:add_circle{ x = 15, y = 3, radius = 1, data = { visible = false } }") == "");
    CHECK(bench.run("local x, y = camera:to_screen(10, 8) assert(x == 100 and y == 20) x, y = "
                    "camera:to_world(x, y) assert(x == 10 and y == 8)") == "");
    CHECK(bench.value("camera:width()") == "20.0");
    const engine::Image image = picture_of(bench,
                                           "camera:attach() cairn.graphics.draw_world(w) camera:detach() "
                                           "cairn.graphics.rectangle('fill', 0, 0, 10, 10)");
    is_color(image, 100, 20, 255, 0, 0);
    is_color(image, 100, 80, 0, 0, 0);
    is_color(image, 150, 70, 0, 0, 0);
    is_color(image, 5, 5, 255, 255, 255);
}

TEST_CASE("five thousand bodies take one draw call, as shapes, as sprites and as both one by one") {
    LuaBench bench(kSmall);
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{} bodies, quads = {}, {} "
            "for i = 1, 5000 do local fields = { x = i % 100, y = i // 100, width = 0.5, height = 0.5, "
            "radius = 0.3, data = { color = { 1, 0, i % 2 } } } "
            "bodies[i] = i % 2 == 0 and w:add_box{ x = fields.x, y = fields.y, width = 0.5, height = 0.5, "
            "data = fields.data } or w:add_circle{ x = fields.x, y = fields.y, radius = 0.3, "
            "data = fields.data } quads[bodies[i]] = true end "
            "batch = cairn.graphics.new_batch(cairn.graphics.new_canvas(8, 8)) "
            "camera = cairn.camera.new{ x = 50, y = 25, height = 60 }") == "");
    const auto calls_of = [&](const std::string& drawing) {
        REQUIRE(bench.run("function cairn.draw() camera:attach() " + drawing + " camera:detach() end") == "");
        engine::Renderer& renderer = *bench.machine().renderer;
        renderer.begin_frame({0, 0, 0, 1});
        REQUIRE_FALSE(bench.game().draw(1));
        renderer.end_frame();
        CHECK(renderer.stats().triangles >= 2 * 5000);
        return renderer.stats().draw_calls;
    };
    CHECK(calls_of("cairn.graphics.draw_world(w)") == 1);
    CHECK(calls_of("batch:clear() batch:add_bodies(w, quads, 0.1) batch:draw()") == 1);
    CHECK(calls_of("for _, body in ipairs(bodies) do local x, y = body:position() "
                   "cairn.graphics.circle('fill', x, y, 0.3) end") == 1);
}

TEST_CASE("state starts anew with each picture") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    picture_of(bench,
               "cairn.graphics.set_color(1, 0, 0) cairn.graphics.push() cairn.graphics.translate(50, 0)");
    const engine::Image image = picture_of(bench, "cairn.graphics.rectangle('fill', 0, 0, 10, 10)");
    is_color(image, 5, 5, 255, 255, 255);
    is_color(image, 55, 5, 0, 0, 0);
}

TEST_CASE("an image fills a polygon by its places") {
    // Red above, blue below: made by the engine, read as a file.
    engine::Image two{{1, 8}, {}};
    for (int row = 0; row < 8; ++row) {
        const bool is_red = row < 4;
        two.rgba.insert(two.rgba.end(),
                        {std::uint8_t(is_red ? 255 : 0), 0, std::uint8_t(is_red ? 0 : 255), 255});
    }
    const auto png = engine::encode_png(two);
    REQUIRE(png);
    auto files = kSmall;
    files["two.png"] = std::string(reinterpret_cast<const char*>(png->data()), png->size());
    LuaBench bench(files, MachineKind::HeadlessDrawing);
    REQUIRE(
        bench.run("image = cairn.graphics.new_image('two.png') camera = cairn.camera.new{ height = 100 }") ==
        "");
    CHECK(bench.run("local w, h = image:size() assert(w == 1 and h == 8)") == "");
    const engine::Image image = picture_of(
        bench,
        "cairn.graphics.draw_polygon(image, { 0, 0, 40, 0, 40, 100, 0, 100 }, { 0, 0, 1, 0, 1, 1, 0, 1 }) "
        "cairn.graphics.draw_sized(image, 70, 50, 20, 100) camera:attach() cairn.graphics.draw_sized(image, "
        "20, 0, 20, 100) "
        "camera:detach()");
    for (const int x : {20, 70, 120}) {
        INFO(x);
        is_color(image, x, 5, 255, 0, 0);
        is_color(image, x, 95, 0, 0, 255);
    }
}

TEST_CASE("text has a size, and the same one headless") {
    LuaBench drawing(kSmall, MachineKind::HeadlessDrawing);
    const std::string measure = "table.concat({ cairn.graphics.new_font(20):measure('Hello') }, ' ')";
    const std::string size = drawing.value(measure);
    CHECK(size.find("error") == std::string::npos);
    const engine::Image image = picture_of(drawing, "cairn.graphics.print('MMMM', 10, 10)");
    int lit = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 100; ++x) lit += image.pixel(x, y)[0] > 128 ? 1 : 0;
    }
    CHECK(lit > 100);
}

TEST_CASE("drawing outside of cairn.draw and wrong modes are errors") {
    LuaBench bench;
    CHECK(bench.run("cairn.graphics.circle('fill', 0, 0, 1)") ==
          "test.lua:1: cairn.graphics.circle: there is no picture to draw on; call it inside cairn.draw");
    CHECK(bench.run("cairn.camera.new{}:attach()").find("call it inside cairn.draw") != std::string::npos);
    CHECK(bench.run("cairn.camera.new{ height = 0 }").find("height = 0: must be from 1e-06 to 1000000000") !=
          std::string::npos);
    CHECK(bench.run("cairn.graphics.new_image('none.png')").find("none.png") != std::string::npos);
    CHECK(draw_error(bench, "cairn.graphics.circle('full', 0, 0, 1)") ==
          "test.lua:1: cairn.graphics.circle: mode is \"full\"; expected \"fill\" or \"line\"");
    CHECK(draw_error(bench, "cairn.graphics.line(1, 2, 3)").find("got 3 numbers") != std::string::npos);
    CHECK(draw_error(bench, "cairn.graphics.polygon('fill', { 1, 2, 3, 'x' })").find("member 4 is \"x\"") !=
          std::string::npos);
    CHECK(draw_error(bench, "cairn.graphics.mesh({ 1, 2, 3 })").find("got 3 numbers") != std::string::npos);
    CHECK(draw_error(bench, "cairn.graphics.pop()").find("cairn.graphics.pop: ") != std::string::npos);
    CHECK(draw_error(bench, "cairn.camera.new{}:detach()").find("no camera is attached") !=
          std::string::npos);
    CHECK(draw_error(bench, "for i = 1, 100 do cairn.graphics.push() end").find("cairn.graphics.push: ") !=
          std::string::npos);
}

TEST_CASE("cameras, canvases and pushes end in their order, or tell which must end first") {
    LuaBench bench({}, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("g = cairn.graphics c = cairn.camera.new{} d = cairn.camera.new{} "
                      "can = g.new_canvas(8, 8)") == "");
    CHECK(draw_error(bench,
                     "c:attach() g.push() g.translate(5, 5) c:detach() x, y = g.transform_point(3, 4)") ==
          "");
    CHECK(bench.value("x .. ' ' .. y") == "3.0 4.0");
    CHECK(draw_error(bench, "g.push() c:attach() g.pop()").find("no push since the camera was attached") !=
          std::string::npos);
    CHECK(
        draw_error(bench, "c:attach() d:attach() c:detach()").find("not the camera that was attached last") !=
        std::string::npos);
    CHECK(draw_error(bench, "c:attach() can:attach() c:detach()").find("a canvas was attached since") !=
          std::string::npos);
    CHECK(
        draw_error(bench, "can:attach() c:attach() can:detach() c:detach()").find("no camera is attached") !=
        std::string::npos);
    CHECK(draw_error(bench,
                     "c:attach() can:attach() g.push() g.pop() d:attach() d:detach() can:detach() "
                     "c:detach()") == "");
}

}  // namespace
}  // namespace cairn::scripting::test
