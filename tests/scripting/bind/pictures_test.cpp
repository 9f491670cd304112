// Canvases, quads, atlases, batches and nine-patches from Lua, and the transforms of points.
#include <catch2/catch.hpp>
#include <cmath>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Blocks of 8 x 8 pixels: red, green, blue, white above black, yellow, cyan, magenta.
std::string palette_png() {
    constexpr unsigned kColors[] = {0xff0000u, 0x00ff00u, 0x0000ffu, 0xffffffu,
                                    0u,        0xffff00u, 0x00ffffu, 0xff00ffu};
    engine::Image image{{32, 16}, {}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const unsigned color = kColors[4 * (y / 8) + x / 8];
            for (const unsigned byte : {color >> 16, color >> 8 & 255, color & 255, 255u})
                image.rgba.push_back(static_cast<std::uint8_t>(byte));
        }
    const auto png = engine::encode_png(image);
    REQUIRE(png);
    return {reinterpret_cast<const char*>(png->data()), png->size()};
}

GameFiles game_files() {
    return {{"conf.lua", "{ width = 200, height = 100 }"},
            {"palette.png", palette_png()},
            {"sheet.json", R"({"frames": {"red": {"frame": {"x": 0, "y": 0, "w": 8, "h": 8}},
                "magenta": {"frame": {"x": 24, "y": 8, "w": 8, "h": 8}}}, "meta": {"image": "palette.png"}})"}};
}

struct Pictures : LuaBench {
    Pictures() : LuaBench(game_files(), MachineKind::HeadlessDrawing) {
        REQUIRE(run("g = cairn.graphics image = g.new_image('palette.png')") == "");
    }
};

}  // namespace

TEST_CASE("a picture that is cut short is the same error without a window as with one") {
    std::string cut = palette_png();
    cut.resize(cut.size() - 20);
    for (const MachineKind kind : {MachineKind::Headless, MachineKind::HeadlessDrawing}) {
        LuaBench bench({{"cut.png", cut}}, kind);
        CHECK(bench.run("cairn.graphics.new_image('cut.png')") ==
              "test.lua:1: cairn.graphics.new_image: image 'cut.png': is damaged: it ends too early");
    }
}

TEST_CASE_METHOD(Pictures, "a quad is a part of its image, and can be a part of a quad") {
    REQUIRE(run("yellow = g.new_quad(g.new_quad(image, 8, 0, 24, 16), 0, 8, 8, 8)") == "");
    CHECK(value("table.concat({ yellow:region() }, ' ')") == "8.0 8.0 8.0 8.0");
    const engine::Image picture =
        picture_of(*this, "g.draw(yellow, 10, 10, 0, 2.5) g.draw_sized(yellow, 100, 50, 20, 20)");
    is_color(picture, 20, 20, 255, 255, 0);
    is_color(picture, 100, 50, 255, 255, 0);
    is_color(picture, 35, 20, 0, 0, 0);
    CHECK(
        run("g.new_quad(image, 24, 0, 16, 1)") ==
        "test.lua:1: cairn.graphics.new_quad: x, y, width, height is 24, 0, 16, 1; it must have an area and "
        "lie inside "
        "the image, which has 32 x 16 pixels");
    CHECK(run("g.new_quad(image, 0, 0, 0/0, 1)").find("width is nan; expected a finite number") !=
          std::string::npos);
}

TEST_CASE_METHOD(Pictures, "an atlas gives its parts by name, and names the nearest for a wrong one") {
    REQUIRE(run("atlas = g.new_atlas('sheet.json')") == "");
    CHECK(value("table.concat(atlas:names(), ' ')") == "red magenta");
    const engine::Image picture = picture_of(*this, "g.draw_sized(atlas:quad('magenta'), 50, 50, 40, 40)");
    is_color(picture, 50, 50, 255, 0, 255);
    CHECK(run("atlas:quad('magnta')") ==
          "test.lua:1: Atlas:quad: name is \"magnta\": the atlas has no such picture; did "
          "you mean \"magenta\"? (red, magenta)");
    CHECK(run("g.new_atlas('none.json')").find("atlas 'none.json' cannot be loaded") != std::string::npos);
}

TEST_CASE_METHOD(Pictures, "a canvas is drawn into and drawn") {
    REQUIRE(run("canvas = g.new_canvas(20, 10)") == "");
    const engine::Image picture =
        picture_of(*this,
                   "g.translate(100, 0) canvas:attach(0, 0, 0, 0) g.set_color(1, 0, 0) "
                   "g.rectangle('fill', 0, 0, 10, 10) canvas:detach() g.set_color(1, 1, 1) "
                   "g.draw(canvas, 0, 20)");
    is_color(picture, 105, 25, 255, 0, 0);
    is_color(picture, 115, 25, 0, 0, 0);
    is_color(picture, 5, 5, 0, 0, 0);
    CHECK(value("table.concat({ canvas:size() }, ' ')") == "20 10");
}

TEST_CASE_METHOD(Pictures, "clear fills the canvas in use, and color and alpha reach it") {
    REQUIRE(run("canvas = g.new_canvas(20, 10)") == "");
    const engine::Image picture =
        picture_of(*this, "canvas:attach(1, 1, 1) g.clear(0, 0, 1) canvas:detach() g.draw(canvas, 0, 0)");
    is_color(picture, 19, 9, 0, 0, 255);
    is_color(picture, 21, 9, 0, 0, 0);
}

TEST_CASE_METHOD(Pictures, "a quad keeps its canvas alive, and a canvas that nobody has is freed") {
    REQUIRE(run("local canvas = g.new_canvas(8, 8) quad = g.new_quad(canvas, 0, 0, 4, 4)") == "");
    const engine::Renderer& renderer = *machine().renderer;
    lua_State* L = game().lua();
    lua_gc(L, LUA_GCCOLLECT);
    lua_getglobal(L, "quad");
    const engine::TextureId texture = Argument<QuadObject*>::get(L, -1)->texture;
    lua_pop(L, 1);
    CHECK(renderer.is_valid(texture));
    REQUIRE(run("quad = nil") == "");
    lua_gc(L, LUA_GCCOLLECT);
    CHECK_FALSE(renderer.is_valid(texture));
}

TEST_CASE_METHOD(Pictures, "a body shows an image, a canvas or a quad, and an error names it by its place") {
    REQUIRE(run("camera = cairn.camera.new{ x = 0, y = 0, height = 10 } w = cairn.physics.new_world{} "
                "canvas = g.new_canvas(4, 4) w:add_box{ x = -5, width = 2, height = 2, "
                "data = { image = g.new_quad(image, 16, 0, 16, 16) } } "
                "w:add_box{ x = 5, width = 2, height = 2, data = { image = canvas } }") == "");
    const engine::Image picture = picture_of(
        *this, "canvas:attach(1, 0.5, 0) canvas:detach() camera:attach() g.draw_world(w) camera:detach()");
    // Of the palette the right half: blue and white above cyan and magenta.
    is_color(picture, 45, 45, 0, 0, 255);
    is_color(picture, 55, 45, 255, 255, 255);
    is_color(picture, 45, 55, 0, 255, 255);
    is_color(picture, 55, 55, 255, 0, 255);
    is_color(picture, 150, 50, 255, 128, 0);
    REQUIRE(run("w:add_box{ x = 1.5, y = 2, width = 1, height = 1, data = { image = 'palette.png' } }") ==
            "");
    CHECK_THAT(draw_error(*this, "g.draw_world(w)"),
               Catch::Contains("data.image of the body at (1.5, 2) is \"palette.png\"; expected an Image, a "
                               "Canvas or a Quad"));
}

TEST_CASE_METHOD(Pictures, "what is mirrored is mirrored, with and without a camera, and stays upright") {
    // The right half of the palette: blue and white above cyan and magenta; mirrored, blue and cyan are
    // right.
    REQUIRE(run("half = g.new_quad(image, 16, 0, 16, 16) batch = g.new_batch(half) batch:add(0, 0, 0, 1, 1, "
                "8, 8) "
                "camera = cairn.camera.new{ x = 0, y = 0, height = 100 }") == "");
    const auto* drawing = GENERATE("g.draw_sized(half, 0, 0, 16, 16)", "batch:draw()",
                                   "g.draw_nine_patch(half, -8, -8, 16, 16, 1)");
    const auto* where = GENERATE("g.translate(50, 50)", "camera:attach() g.translate(-50, 0)");
    INFO(where << ' ' << drawing);
    const engine::Image picture = picture_of(*this, std::string(where) + " g.scale(-1, 1) " + drawing);
    is_color(picture, 54, 46, 0, 0, 255);
    is_color(picture, 46, 46, 255, 255, 255);
    is_color(picture, 54, 54, 0, 255, 255);
    is_color(picture, 46, 54, 255, 0, 255);
}

TEST_CASE_METHOD(Pictures, "in a canvas a camera looks at the canvas") {
    REQUIRE(run("camera = cairn.camera.new{ x = 7, y = 3, height = 10 } canvas = g.new_canvas(40, 60)") ==
            "");
    // A metre is six pixels of the canvas, whatever the window; (7, 3) is in its middle, and y is up.
    const engine::Image picture = picture_of(
        *this,
        "canvas:attach(0, 0, 1) camera:attach() g.set_color(1, 0, 0) g.rectangle('fill', 6, 3, 2, 1) "
        "camera:detach() canvas:detach() g.set_color(1, 1, 1) g.draw(canvas, 0, 0)");
    is_color(picture, 15, 27, 255, 0, 0);
    is_color(picture, 25, 25, 255, 0, 0);
    is_color(picture, 20, 32, 0, 0, 255);
    is_color(picture, 12, 27, 0, 0, 255);
    is_color(picture, 20, 22, 0, 0, 255);
}

TEST_CASE_METHOD(Pictures, "wrong uses of canvases say what is wrong") {
    CHECK(run("g.new_canvas(0, 5)") ==
          "test.lua:1: cairn.graphics.new_canvas: width is 0; expected an integer from 1 to 8192 px");
    REQUIRE(run("a = g.new_canvas(5, 5) b = g.new_canvas(5, 5)") == "");
    CHECK(run("a:attach()").find("call it inside cairn.draw") != std::string::npos);
    const auto error_of = [&](const std::string& code) { return draw_error(*this, code); };
    CHECK(error_of("a:detach()").find("not the canvas that was attached last") != std::string::npos);
    CHECK(error_of("a:attach() b:attach() a:detach()").find("attached last") != std::string::npos);
    CHECK(error_of("a:attach() a:attach()").find("being drawn into already") != std::string::npos);
    REQUIRE(
        run("part = g.new_quad(a, 0, 0, 2, 2) batch = g.new_batch(a) batch:add(0, 0) w = "
            "cairn.physics.new_world{} body = w:add_box{ width = 1, height = 1, data = { image = part } } "
            "sparks = cairn.particles.new({}, part)") == "");
    for (const char* drawing :
         {"g.draw(a, 0, 0)", "g.draw_sized(part, 0, 0, 2, 2)", "g.draw_region(a, 0, 0, 1, 1, 0, 0, 5, 5)",
          "g.draw_polygon(a, { 0, 0, 9, 0, 0, 9 }, { 0, 0, 1, 0, 0, 1 })",
          "g.draw_nine_patch(a, 0, 0, 9, 9, 1)", "batch:draw()", "sparks:draw()", "g.draw_body(body)",
          "g.mesh({ 0, 0, 1, 1, 1, 1, 0, 0, 9, 0, 1, 1, 1, 1, 1, 0, 0, 9, 1, 1, 1, 1, 0, 1 }, a)"}) {
        INFO(drawing);
        CHECK_THAT(error_of(std::string("a:attach() ") + drawing),
                   Catch::Contains("the canvas is being drawn into and cannot be drawn at the same time"));
        CHECK(error_of(std::string("b:attach() ") + drawing + " b:detach()").empty());
    }
    CHECK(error_of("g.draw_region(image, 24, 0, 16, 1, 0, 0, 5, 5)") ==
          "test.lua:1: cairn.graphics.draw_region: source_x, source_y, source_width, source_height is 24, 0, "
          "16, 1; it must lie inside the image, which has 32 x 16 pixels");
    CHECK(error_of("g.draw(3, 0, 0)") ==
          "test.lua:1: cairn.graphics.draw: image is 3; expected an Image, a Canvas or a Quad");
}

TEST_CASE_METHOD(Pictures, "a batch is one draw call, and shows what its sprites alone would") {
    REQUIRE(run("batch = g.new_batch(image) red = g.new_quad(image, 0, 0, 8, 8) "
                "for i = 0, 99 do batch:add(2 * (i % 100), 40, 0, 0.25, 0.25, 0, 0, red) end "
                "batch:set_color(0, 1, 0) batch:add(0, 80, 0, 1.25, 1.25)") == "");
    CHECK(value("batch:count()") == "101");
    const engine::Image picture = picture_of(*this, "batch:draw()");
    CHECK(machine().renderer->stats().draw_calls == 1);
    is_color(picture, 100, 41, 255, 0, 0);
    is_color(picture, 15, 85, 0, 255, 0);  // green by green
    is_color(picture, 5, 85, 0, 0, 0);     // red by green
    REQUIRE(run("batch:clear()") == "");
    CHECK(value("batch:count()") == "0");
    CHECK(run("batch:add(0, 0, 0, 1, 1, 0, 0, g.new_canvas(2, 2))").find("part of another image") !=
          std::string::npos);
}

TEST_CASE_METHOD(Pictures, "a batch takes the bodies of a world where they stand, upright under a camera") {
    REQUIRE(run("camera = cairn.camera.new{ height = 10 } world = cairn.physics.new_world{} "
                "a = world:add_box{ x = -5, y = 0, width = 1, height = 1 } b = world:add_box{ x = 5, y = 2, "
                "width = 1, "
                "height = 1 } c = world:add_box{ x = 0, y = 0, width = 1, height = 1 } "
                "column = g.new_quad(image, 8, 0, 8, 16) batch = g.new_batch(image)") == "");
    const engine::Image picture = picture_of(
        *this,
        "batch:clear() batch:add_bodies(world, { [a] = column, [b] = true }, 1 / 8) camera:attach() "
        "batch:draw() camera:detach()");
    CHECK(value("batch:count()") == "2");
    is_color(picture, 50, 44, 0, 255, 0);  // green is above yellow
    is_color(picture, 50, 56, 255, 255, 0);
    is_color(picture, 132, 24, 255, 0, 0);  // the whole image around (5, 2)
    is_color(picture, 100, 50, 0, 0, 0);
    CHECK(run("batch:add_bodies(world, { [a] = 3 }, 1)").find("must be Quads, or true") != std::string::npos);
}

TEST_CASE_METHOD(Pictures, "a nine-patch stands upright on the screen and under a camera") {
    REQUIRE(run("camera = cairn.camera.new{ x = 100, y = 50, height = 100 } "
                "panel = g.new_quad(image, 0, 0, 24, 16)") == "");
    const engine::Image picture =
        picture_of(*this,
                   "g.draw_nine_patch(panel, 10, 10, 40, 30, 8, 8, 8, 0, 1) camera:attach() "
                   "g.draw_nine_patch(panel, 110, 60, 40, 30, 8, 8, 8, 0, 1) camera:detach()");
    is_color(picture, 10, 10, 255, 0, 0);
    is_color(picture, 10, 38, 0, 0, 0);
    is_color(picture, 110, 10, 255, 0, 0);
    is_color(picture, 110, 38, 0, 0, 0);
    is_color(picture, 149, 10, 0, 0, 255);
    CHECK(draw_error(*this, "g.draw_nine_patch(image, 0, 0, 9, 9, 30, 0, 4, 0)").find("left + right") !=
          std::string::npos);
    CHECK(draw_error(*this, "g.draw_nine_patch(image, 0, 0, 9, 9, -1)").find("at least 0") !=
          std::string::npos);
}

TEST_CASE_METHOD(Pictures, "points go through the transform and back") {
    REQUIRE(run("function cairn.draw() g.push() g.translate(10, 20) g.rotate(math.pi / 2) g.scale(2) "
                "g.shear(1, 0) "
                "x, y = g.transform_point(3, 1) u, v = g.inverse_transform_point(x, y) g.origin() "
                "ox, oy = g.transform_point(3, 1) g.pop() end") == "");
    picture_of(*this, "", /*keeps_callback=*/true);
    // Shear: (4, 1); scale: (8, 2); a quarter turn: (-2, 8); moved: (8, 28).
    CHECK(run("assert(math.abs(x - 8) < 1e-4 and math.abs(y - 28) < 1e-4, x .. ' ' .. y)") == "");
    CHECK(run("assert(math.abs(u - 3) < 1e-4 and math.abs(v - 1) < 1e-4) assert(ox == 3 and oy == 1)") == "");
}

TEST_CASE_METHOD(Pictures, "ellipses, slices and blend modes reach the picture") {
    const engine::Image picture = picture_of(
        *this,
        "g.set_color(1, 0, 0) g.ellipse('fill', 50, 50, 40, 10) g.arc('fill', 150, 50, 30, 0, math.pi / 2) "
        "g.set_blend_mode('screen') g.set_color(0, 0, 1) g.rectangle('fill', 40, 40, 20, 20)");
    is_color(picture, 20, 50, 255, 0, 0);
    is_color(picture, 50, 50, 255, 0, 255);
    is_color(picture, 160, 60, 255, 0, 0);
    is_color(picture, 140, 60, 0, 0, 0);
    is_color(picture, 160, 40, 0, 0, 0);
    CHECK(draw_error(*this, "g.set_blend_mode('subtract')").find("\"multiply\"") != std::string::npos);
}

TEST_CASE_METHOD(Pictures, "pixel art keeps its pixels, in images and canvases") {
    REQUIRE(run("sharp = g.new_image('palette.png', 'nearest') small = g.new_canvas(4, 4, 'nearest')") == "");
    const engine::Image picture =
        picture_of(*this,
                   "g.draw(sharp, 0, 0, 0, 3) small:attach(0, 0, 0, 0) g.set_color(1, 0, 0) "
                   "g.rectangle('fill', 0, 0, 2, 4) small:detach() g.set_color(1, 1, 1) "
                   "g.draw(small, 100, 0, 0, 10)");
    is_color(picture, 23, 5, 255, 0, 0);
    is_color(picture, 24, 5, 0, 255, 0);
    is_color(picture, 119, 5, 255, 0, 0);
    is_color(picture, 120, 5, 0, 0, 0);
    CHECK(run("g.new_image('palette.png', 'sharp')") ==
          "test.lua:1: cairn.graphics.new_image: filter is \"sharp\"; expected \"linear\" or \"nearest\"");
}

TEST_CASE("the garbage collector knows how large things are outside of Lua: few that were dropped pile up") {
    // Of megabytes each; the list of a thousand places is of 50 kB.
    const auto* make =
        GENERATE("cairn.graphics.new_canvas(1600, 1600)", "cairn.particles.new{max_count = 60000}",
                 "full_batch()", "full_recording()", "full_list()");
    LuaBench bench;
    REQUIRE(bench.run("canvas = cairn.graphics.new_canvas(8, 8) world = cairn.physics.new_world{} "
                      "for i = 1, 1000 do world:add_circle{x = 3 * i, radius = 1} end "
                      "function full_batch() local batch = cairn.graphics.new_batch(canvas) "
                      "for i = 1, 20000 do batch:add(0, 0) end return batch end "
                      "function full_recording() local recording = cairn.physics.new_recording{ "
                      "states_between_whole_ones = 1 } "
                      "for i = 1, 20 do recording:record(world) end return recording end "
                      "function full_list() local list = cairn.physics.new_transforms() "
                      "world:read_transforms(list) return list end") == "");
    INFO(make);
    REQUIRE(bench.run(std::string("alive = setmetatable({}, { __mode = 'k' }) for i = 1, 100 do alive[") +
                      make + "] = true end count = 0 for _ in pairs(alive) do count = count + 1 end") == "");
    CHECK(std::stoi(bench.value("count")) <= 50);
}

}  // namespace cairn::scripting::test
