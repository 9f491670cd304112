// cairn.tilemap: places in both frames, tiles, objects, rectangles for bodies, and the picture.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Two tiles of 8 x 8 pixels: red, and one that is green above and blue below.
std::string tiles_png() {
    engine::Image image{{16, 8}, {}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) {
            const bool red = x < 8;
            const bool green = !red && y < 4;
            image.rgba.insert(image.rgba.end(), {std::uint8_t(red ? 255 : 0), std::uint8_t(green ? 255 : 0),
                                                 std::uint8_t(!red && !green ? 255 : 0), 255});
        }
    const auto png = engine::encode_png(image);
    return {reinterpret_cast<const char*>(png->data()), png->size()};
}

struct Maps : LuaBench {
    Maps()
        : LuaBench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 4, "height": 3, "tilewidth": 8, "tileheight": 8,
        "properties": [{"name": "title", "type": "string", "value": "Test"}],
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 8, "tileheight": 8, "tilecount": 2, "columns": 2,
            "image": "tiles.png", "tiles": [{"id": 0, "properties": [{"name": "solid", "type": "bool", "value": true}]}]}],
        "layers": [{"type": "tilelayer", "name": "ground", "data": [0, 0, 0, 2,  1, 1, 0, 2,  1, 1, 1, 1]},
            {"type": "objectgroup", "name": "things", "objects": [{"id": 1, "name": "start", "type": "spawn", "x": 8, "y": 0,
            "width": 8, "height": 8, "properties": [{"name": "lives", "type": "int", "value": 3}]},
            {"id": 2, "x": 0, "y": 24, "polygon": [{"x": 0, "y": 0}, {"x": 8, "y": 0}, {"x": 8, "y": -8}]}]}]})"}},
                   MachineKind::HeadlessDrawing) {
        REQUIRE(run("screen = cairn.tilemap.load('map.tmj') world = cairn.tilemap.load('map.tmj', { scale = "
                    "1 / 8, y_up = "
                    "true })") == "");
    }
};

}  // namespace

TEST_CASE_METHOD(Maps, "the same place has its coordinates in each frame") {
    CHECK(value("table.concat({ screen:size() }, ' ')") == "32.0 24.0");
    CHECK(value("table.concat({ world:size() }, ' ')") == "4.0 3.0");
    CHECK(value("table.concat({ world:cells() }, ' ') .. ' ' .. table.concat({ world:cell_size() }, ' ')") ==
          "4 3 1.0 1.0");
    CHECK(value("table.concat({ screen:cell_center(1, 3) }, ' ')") == "4.0 20.0");
    CHECK(value("table.concat({ world:cell_center(1, 3) }, ' ')") == "0.5 0.5");
    CHECK(value("table.concat({ screen:cell_at(25, 1) }, ' ')") == "4 1");
    CHECK(value("table.concat({ world:cell_at(3.1, 2.9) }, ' ')") == "4 1");
    CHECK(value("table.concat({ world:cell_at(-0.1, 3.1) }, ' ')") == "0 0");
}

TEST_CASE_METHOD(Maps, "tiles are asked for and put, and what is solid is covered by few rectangles") {
    CHECK(
        value("screen:tile('ground', 1, 2) .. screen:tile('ground', 3, 2) .. screen:tile('ground', 9, 9)") ==
        "100");
    CHECK(value("screen:tile_properties(1).solid") == "true");
    CHECK(value("screen:properties().title .. ' ' .. table.concat(screen:layers(), ' ')") ==
          "Test ground things");
    REQUIRE(run("function text(list) local t = {} for i, r in ipairs(list) do t[i] = ('%g,%g "
                "%gx%g'):format(r.x, r.y, "
                "r.width, r.height) end return table.concat(t, '; ') end") == "");
    CHECK(value("text(world:solids('ground', 'solid'))") == "1,1.5 2x1; 2,0.5 4x1");
    REQUIRE(run("w = cairn.physics.new_world{} ground = w:new_body{ type = 'static' } for _, rect in "
                "ipairs(world:solids('ground')) do ground:add_box(rect) end") == "");
    CHECK(value("w:body_at(0.5, 1.5) == ground and w:body_at(2.5, 1.5) == nil and w:body_at(3.5, 2.5) == "
                "ground") == "true");
    REQUIRE(run("world:set_tile('ground', 3, 2, 1)") == "");
    CHECK(value("text(world:solids('ground', 'solid'))") == "1.5,1.5 3x1; 2,0.5 4x1");
}

TEST_CASE_METHOD(Maps, "objects come with their middle, points and properties") {
    REQUIRE(run("start = world:objects('things')[1] slope = world:objects()[2]") == "");
    CHECK(value("('%s %s %s %g %g %g %g %d'):format(start.name, start.class, start.shape, start.x, start.y, "
                "start.width, "
                "start.height, start.properties.lives)") == "start spawn rectangle 1.5 2.5 1 1 3");
    CHECK(value("slope.shape .. ' ' .. #slope.points .. ' ' .. slope.points[3][1] .. ' ' .. "
                "slope.points[3][2]") == "polygon 3 1.0 1.0");
}

TEST_CASE_METHOD(Maps, "the map is drawn upright in each frame") {
    REQUIRE(run("camera = cairn.camera.new{ x = 2, y = 1.5, height = 10 }") == "");
    const engine::Image image =
        picture_of(*this, "screen:draw() camera:attach() world:draw('ground') camera:detach()");
    is_color(image, 4, 12, 255, 0, 0);
    is_color(image, 4, 4, 0, 0, 0);
    is_color(image, 28, 2, 0, 255, 0);
    is_color(image, 28, 6, 0, 0, 255);
    // 10 pixels a metre; the map lies from 80 to 120 and from 35 to 65.
    is_color(image, 85, 50, 255, 0, 0);
    is_color(image, 85, 40, 0, 0, 0);
    is_color(image, 115, 37, 0, 255, 0);
    is_color(image, 115, 43, 0, 0, 255);
    is_color(image, 125, 50, 0, 0, 0);
    CHECK(machine().renderer->stats().draw_calls == 1);
}

TEST_CASE("pixels of the transparent color are not seen, in tiles and in image layers") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 8, "tileheight": 8, "tilecount": 2, "columns": 2,
            "image": "tiles.png", "transparentcolor": "#00ff00"}],
        "layers": [{"type": "tilelayer", "name": "ground", "data": [1, 2]},
            {"type": "imagelayer", "name": "flag", "image": "tiles.png", "transparentcolor": "#ff0000"},
            {"type": "imagelayer", "name": "whole", "image": "tiles.png"}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj')") == "");
    const engine::Image tiles = picture_of(bench, "map:draw('ground')");
    is_color(tiles, 4, 2, 255, 0, 0);
    is_color(tiles, 12, 2, 0, 0, 0);
    is_color(tiles, 12, 6, 0, 0, 255);
    const engine::Image flag = picture_of(bench, "map:draw('flag')");
    is_color(flag, 4, 2, 0, 0, 0);
    is_color(flag, 12, 2, 0, 255, 0);
    const engine::Image whole = picture_of(bench, "map:draw('whole')");
    is_color(whole, 4, 2, 255, 0, 0);
    is_color(whole, 12, 2, 0, 255, 0);
}

TEST_CASE("image layers are drawn with offset, tint, opacity, repetition and parallax") {
    // The picture is 16 pixels wide and 8 high: red, and green above blue.
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 4, "height": 3, "tilewidth": 8, "tileheight": 8, "tilesets": [],
        "layers": [{"type": "imagelayer", "name": "flag", "image": "tiles.png", "offsetx": 3, "offsety": 4},
            {"type": "imagelayer", "name": "row", "image": "tiles.png", "offsetx": 3, "offsety": 4, "repeatx": true},
            {"type": "imagelayer", "name": "wall", "image": "tiles.png", "offsetx": 3, "repeatx": true, "repeaty": true},
            {"type": "imagelayer", "name": "tinted", "image": "tiles.png", "tintcolor": "#00ff80", "opacity": 0.5},
            {"type": "imagelayer", "name": "far", "image": "tiles.png", "parallaxx": 0.5},
            {"type": "imagelayer", "name": "fixed", "image": "tiles.png", "parallaxx": 0, "parallaxy": 0},
            {"type": "imagelayer", "name": "hidden", "image": "tiles.png", "visible": false}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(
                "map = cairn.tilemap.load('map.tmj') world = cairn.tilemap.load('map.tmj', { scale = 1 / 8, "
                "y_up = true, filter = 'nearest' }) g = cairn.graphics") == "");
    CHECK(bench.value("table.concat(map:layers(), ' ')") == "flag row wall tinted far fixed hidden");
    const auto stats = [&] { return bench.machine().renderer->stats(); };

    const engine::Image flag = picture_of(bench, "map:draw('flag')");
    is_color(flag, 5, 6, 255, 0, 0);
    is_color(flag, 13, 6, 0, 255, 0);
    is_color(flag, 13, 10, 0, 0, 255);
    is_color(flag, 21, 6, 0, 0, 0);
    is_color(flag, 5, 2, 0, 0, 0);

    const engine::Image row = picture_of(bench, "map:draw('row')");
    for (const int x : {0, 16, 32, 176}) {
        is_color(row, x + 5, 6, 255, 0, 0);
        is_color(row, x + 13, 6, 0, 255, 0);
        is_color(row, x + 5, 14, 0, 0, 0);
        is_color(row, x + 5, 2, 0, 0, 0);
    }
    is_color(row, 1, 10, 0, 0, 255);
    // Each copy that the picture shows, and no others: from the one that ends at 3 to the one that begins at
    // 195.
    CHECK(stats().vertices == 14 * 4);
    CHECK(stats().draw_calls == 1);

    const engine::Image wall = picture_of(bench, "g.translate(-1000, -1000) map:draw('wall')");
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x) {
            const int u = (x + 1000 - 3) % 16, v = (y + 1000) % 8;
            const std::uint8_t* p = wall.pixel(x, y);
            if (p[u < 8 ? 0 : v < 4 ? 1 : 2] != 255) FAIL("pixel " << x << ' ' << y);
        }

    const engine::Image tinted = picture_of(bench, "g.set_color(1, 1, 0.5) map:draw('tinted')");
    is_color(tinted, 4, 4, 0, 0, 0);
    is_color(tinted, 12, 2, 0, 128, 0);
    is_color(tinted, 12, 6, 0, 0, 32);

    // The middle of the picture is (100, 50); parallax of 0.5 moves by half of it, and by half of the way.
    const auto left_of = [&](const std::string& code) {
        const engine::Image image = picture_of(bench, code);
        for (int x = 0; x < 200; ++x)
            for (int y = 0; y < 100; ++y)
                if (image.pixel(x, y)[0] > 128) return std::pair{x, y};
        return std::pair{-1, -1};
    };
    CHECK(left_of("map:draw('far')") == std::pair{50, 0});
    CHECK(left_of("g.translate(-20, -3) map:draw('far')") == std::pair{40, 0 - 0});
    CHECK(left_of("map:draw('fixed')") == std::pair{100, 50});
    CHECK(left_of("g.translate(-20, -3) map:draw('fixed')") == std::pair{100, 50});

    // 10 pixels a metre and so 1.25 to one of the map, which lies from (80, 35) to (120, 65) and whose corner
    // is 16 and 12 from the middle.
    REQUIRE(bench.run("camera = cairn.camera.new{ x = 2, y = 1.5, height = 10 }") == "");
    const auto under_camera = [](const std::string& layer) {
        return "camera:attach() world:draw('" + layer + "') camera:detach()";
    };
    const engine::Image upright = picture_of(bench, under_camera("flag"));
    is_color(upright, 84, 42, 255, 0, 0);
    is_color(upright, 98, 42, 0, 255, 0);
    is_color(upright, 98, 48, 0, 0, 255);
    CHECK(left_of(under_camera("far")) == std::pair{90, 35});
    CHECK(left_of(under_camera("fixed")) == std::pair{100, 50});
    picture_of(bench, "map:draw()");
    CHECK(stats().draw_calls == 1);
}

TEST_CASE("a small picture that is repeated and seen from far away is drawn within bounds") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 4, "height": 3, "tilewidth": 8, "tileheight": 8, "tilesets": [],
        "layers": [{"type": "imagelayer", "name": "wall", "image": "tiles.png", "repeatx": true, "repeaty": true}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj') g = cairn.graphics") == "");
    for (const char* scale : {"0.001", "1e-30", "0"}) {
        picture_of(bench, std::string("g.scale(") + scale + ") map:draw()");
        CHECK(bench.machine().renderer->stats().vertices <= 4 * 257 * 257);
    }
    picture_of(bench, "g.translate(1e12, -1e12) map:draw()");
    CHECK_THAT(draw_error(bench, "map:draw('well')"),
               Catch::Contains("layer is \"well\": no such layer; did you mean \"wall\"?"));
}

TEST_CASE_METHOD(Maps, "what the picture does not show is not drawn") {
    picture_of(*this, "cairn.graphics.translate(-1000, 0) screen:draw()");
    CHECK(machine().renderer->stats().vertices == 0);
    picture_of(*this, "screen:draw('ground')");
    CHECK(machine().renderer->stats().vertices == 4 * 8);
}

TEST_CASE("objects that are tiles have their sizes, turn about their places, and cover what is above them") {
    const auto* order = GENERATE("topdown", "index");
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", std::string(R"({"width": 20, "height": 12, "tilewidth": 8, "tileheight": 8,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 8, "tileheight": 8, "tilecount": 2, "columns": 2,
            "image": "tiles.png"}],
        "layers": [{"type": "objectgroup", "name": "things", "draworder": ")") +
                                    order + R"(", "objects": [
            {"id": 1, "x": 10, "y": 50, "width": 20, "height": 40, "gid": 2},
            {"id": 2, "x": 60, "y": 50, "width": 20, "height": 40, "rotation": 90, "gid": 2},
            {"id": 3, "x": 120, "y": 50, "gid": 2},
            {"id": 4, "x": 140, "y": 60, "width": 16, "height": 16, "gid": 1},
            {"id": 5, "x": 140, "y": 52, "width": 16, "height": 16, "gid": 2}]}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj')") == "");
    const engine::Image image = picture_of(bench, "map:draw()");
    // Twenty wide and forty high above (10, 50): green above blue.
    is_color(image, 12, 12, 0, 255, 0);
    is_color(image, 28, 24, 0, 255, 0);
    is_color(image, 12, 36, 0, 0, 255);
    is_color(image, 28, 48, 0, 0, 255);
    is_color(image, 31, 30, 0, 0, 0);
    // Turned clockwise about (60, 50): what was above lies to the right, and what was to the right below.
    is_color(image, 62, 52, 0, 0, 255);
    is_color(image, 74, 68, 0, 0, 255);
    is_color(image, 86, 52, 0, 255, 0);
    is_color(image, 98, 68, 0, 255, 0);
    is_color(image, 70, 48, 0, 0, 0);
    is_color(image, 101, 60, 0, 0, 0);
    // In its own size, as none is said.
    is_color(image, 121, 43, 0, 255, 0);
    is_color(image, 129, 43, 0, 0, 0);
    // (150, 48) is of both of the last two.
    if (std::string(order) == "topdown") {
        is_color(image, 150, 48, 255, 0, 0);
    } else {
        is_color(image, 150, 48, 0, 0, 255);
    }
}

TEST_CASE("objects that are tiles are drawn and told where the alignment of their set puts them") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 20, "height": 12, "tilewidth": 8, "tileheight": 8,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 8, "tileheight": 8, "tilecount": 2, "columns": 2,
            "image": "tiles.png", "objectalignment": "center"}],
        "layers": [{"type": "objectgroup", "name": "things", "objects": [
            {"id": 1, "x": 40, "y": 50, "width": 20, "height": 40, "gid": 2},
            {"id": 2, "x": 100, "y": 50, "width": 20, "height": 40, "rotation": 90, "gid": 2},
            {"id": 3, "x": 160, "y": 50, "gid": 2}]}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj') told = ''\n"
                      "for _, o in ipairs(map:objects()) do "
                      "  told = told .. ('%g %g %g %g '):format(o.x, o.y, o.width, o.height) end") == "");
    CHECK(bench.value("told") == "40 50 20 40 100 50 20 40 160 50 8 8 ");
    const engine::Image image = picture_of(bench, "map:draw()");
    // Twenty wide and forty high around (40, 50): green above blue.
    is_color(image, 32, 32, 0, 255, 0);
    is_color(image, 48, 68, 0, 0, 255);
    is_color(image, 29, 50, 0, 0, 0);
    is_color(image, 40, 71, 0, 0, 0);
    // A quarter turn about its middle: green to the right.
    is_color(image, 82, 42, 0, 0, 255);
    is_color(image, 118, 58, 0, 255, 0);
    is_color(image, 100, 61, 0, 0, 0);
    is_color(image, 157, 47, 0, 255, 0);
    is_color(image, 165, 55, 0, 0, 0);
}

TEST_CASE("tiles are drawn as far from their places as their set says, which objects stretch and turn") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"},
                    {"tiles.png", tiles_png()},
                    {"map.tmj", R"({"width": 2, "height": 1, "tilewidth": 8, "tileheight": 8,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 8, "tileheight": 8, "tilecount": 2, "columns": 2,
            "image": "tiles.png", "tileoffset": {"x": 30, "y": 20}}],
        "layers": [{"type": "tilelayer", "name": "ground", "data": [0, 2]},
            {"type": "objectgroup", "name": "things", "objects": [
            {"id": 1, "x": 80, "y": 60, "width": 16, "height": 8, "gid": 2},
            {"id": 2, "x": 190, "y": 10, "width": 8, "height": 8, "rotation": 90, "gid": 2}]}]})"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj')") == "");
    const engine::Image image = picture_of(bench, "map:draw()");
    is_color(image, 12, 4, 0, 0, 0);
    is_color(image, 39, 21, 0, 255, 0);
    is_color(image, 45, 27, 0, 0, 255);
    // Twice as wide, twice as far to the right: from (140, 72) to (156, 80).
    is_color(image, 141, 73, 0, 255, 0);
    is_color(image, 155, 79, 0, 0, 255);
    is_color(image, 138, 76, 0, 0, 0);
    // Turned clockwise, right is down and down is left: from (170, 40) to (178, 48).
    is_color(image, 177, 41, 0, 255, 0);
    is_color(image, 171, 47, 0, 0, 255);
    // The place of the tile lies above the view, which the tile reaches.
    const engine::Image moved = picture_of(bench, "cairn.graphics.translate(-38, -20) map:draw()");
    is_color(moved, 1, 1, 0, 255, 0);
    is_color(moved, 7, 7, 0, 0, 255);
}

TEST_CASE("isometric maps have their places in the picture, and their solids are polygons") {
    LuaBench bench(
        {{"conf.lua", "{ width = 200, height = 100 }"},
         {"tiles.png", tiles_png()},
         {"map.tmj",
          R"({"orientation": "isometric", "width": 2, "height": 2, "tilewidth": 16, "tileheight": 8,
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 16, "tileheight": 8, "tilecount": 1, "columns": 1,
            "image": "tiles.png"}],
        "layers": [{"type": "tilelayer", "name": "ground", "data": [1, 1, 1, 0]},
            {"type": "objectgroup", "name": "things", "objects": [{"id": 1, "x": 8, "y": 0, "width": 8, "height": 8},
            {"id": 2, "x": 16, "y": 16, "width": 16, "height": 8, "gid": 1}]}]})"}},
        MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj') world = cairn.tilemap.load('map.tmj', { scale = "
                      "1 / 8, y_up = true })") == "");
    CHECK(bench.value("table.concat({ map:size() }, ' ')") == "32.0 16.0");
    CHECK(bench.value("table.concat({ map:cell_center(1, 1) }, ' ')") == "16.0 4.0");
    CHECK(bench.value("table.concat({ map:cell_center(2, 1) }, ' ')") == "24.0 8.0");
    CHECK(bench.value("table.concat({ world:cell_center(2, 1) }, ' ')") == "3.0 1.0");
    CHECK(bench.value("table.concat({ map:cell_at(17, 1) }, ' ')") == "1 1");
    CHECK(bench.value("table.concat({ map:cell_at(30, 8) }, ' ')") == "2 1");
    CHECK(bench.value("table.concat({ world:cell_at(1, 1) }, ' ')") == "1 2");
    CHECK(bench.value("table.concat({ map:cell_at(1, 1) }, ' ')") == "0 2");

    // The first row is two cells long, the second one.
    REQUIRE(bench.run("w = cairn.physics.new_world{} for _, part in ipairs(world:solids('ground')) do "
                      "part.type = 'static' w:add_polygon(part) end "
                      "function solid(x, y) return w:body_at(x, y) ~= nil end") == "");
    CHECK(bench.value("w:body_count()") == "2");
    CHECK(bench.value("solid(world:cell_center(1, 1)) and solid(world:cell_center(2, 1)) and "
                      "solid(world:cell_center(1, 2)) and not solid(world:cell_center(2, 2))") == "true");

    REQUIRE(
        bench.run("thing, tile = table.unpack(map:objects()) "
                  "corners = {} for i, p in ipairs(thing.points) do corners[i] = p[1] .. ',' .. p[2] end") ==
        "");
    CHECK(bench.value("table.concat(corners, ' ')") == "24.0,4.0 32.0,8.0 24.0,12.0 16.0,8.0");
    CHECK(bench.value("thing.x .. ' ' .. thing.y .. ' ' .. tile.x .. ' ' .. tile.y") == "24.0 8.0 16.0 12.0");

    // What is farther down covers what is behind it.
    const engine::Image image = picture_of(bench, "map:draw('ground')");
    is_color(image, 10, 2, 255, 0, 0);
    is_color(image, 20, 2, 0, 255, 0);
    is_color(image, 20, 6, 255, 0, 0);
    is_color(image, 10, 6, 0, 255, 0);
    is_color(image, 10, 10, 0, 0, 255);
    is_color(image, 30, 14, 0, 0, 0);
    const engine::Image things = picture_of(bench, "map:draw('things')");
    is_color(things, 10, 10, 255, 0, 0);
    is_color(things, 20, 14, 0, 0, 255);
    is_color(things, 20, 6, 0, 0, 0);
    picture_of(bench, "cairn.graphics.translate(-1000, 0) map:draw()");
    CHECK(bench.machine().renderer->stats().vertices == 0);
    CHECK_THAT(bench.run("cairn.level.load('map.tmj')"), Catch::Contains("made of orthogonal maps"));
}

TEST_CASE("hexagonal maps are drawn, and each solid cell is a polygon") {
    LuaBench bench(
        {{"conf.lua", "{ width = 200, height = 100 }"},
         {"tiles.png", tiles_png()},
         {"map.tmj",
          R"({"orientation": "hexagonal", "width": 2, "height": 2, "tilewidth": 16, "tileheight": 8,
        "hexsidelength": 4, "staggeraxis": "y", "staggerindex": "odd",
        "tilesets": [{"firstgid": 1, "name": "t", "tilewidth": 16, "tileheight": 8, "tilecount": 1, "columns": 1,
            "image": "tiles.png"}],
        "layers": [{"type": "tilelayer", "name": "ground", "data": [1, 0, 1, 0]}]})"}},
        MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("map = cairn.tilemap.load('map.tmj') world = cairn.tilemap.load('map.tmj', { scale = "
                      "1 / 8, y_up = true })") == "");
    CHECK(bench.value("table.concat({ map:size() }, ' ')") == "40.0 14.0");
    CHECK(bench.value("table.concat({ map:cell_center(1, 2) }, ' ')") == "16.0 10.0");
    CHECK(bench.value("table.concat({ map:cell_at(16, 9) }, ' ')") == "1 2");
    CHECK(bench.value("table.concat({ world:cell_at(world:cell_center(2, 2)) }, ' ')") == "2 2");
    REQUIRE(bench.run("w = cairn.physics.new_world{} for _, part in ipairs(world:solids('ground')) do "
                      "part.type = 'static' w:add_polygon(part) end "
                      "function solid(x, y) return w:body_at(x, y) ~= nil end") == "");
    CHECK(bench.value("w:body_count()") == "2");
    CHECK(bench.value("solid(world:cell_center(1, 1)) and solid(world:cell_center(1, 2)) and "
                      "not solid(world:cell_center(2, 1)) and not solid(world:cell_center(2, 2))") == "true");
    // A tile fills the box around its cell: the first at (0, 0), the one below half a cell behind at (8, 6).
    const engine::Image image = picture_of(bench, "map:draw('ground')");
    is_color(image, 2, 2, 255, 0, 0);
    is_color(image, 10, 8, 255, 0, 0);
    is_color(image, 2, 12, 0, 0, 0);
    is_color(image, 34, 2, 0, 0, 0);
    picture_of(bench, "cairn.graphics.translate(-1000, 0) map:draw()");
}

TEST_CASE_METHOD(Maps, "wrong layers, tiles and files say what is wrong") {
    CHECK(run("screen:tile('grond', 1, 1)")
              .find("layer is \"grond\": no such layer of tiles; did you mean \"ground\"?") !=
          std::string::npos);
    CHECK(run("screen:objects('ground')").find("no such layer of objects") != std::string::npos);
    CHECK(run("screen:set_tile('ground', 9, 1, 1)").find("the map has 4 columns and 3 rows") !=
          std::string::npos);
    CHECK(run("screen:set_tile('ground', 1, 1, 3)").find("id is 3; expected 0, or a tile") !=
          std::string::npos);
    CHECK(run("cairn.tilemap.load('none.tmx')").find("cairn.tilemap.load: file 'none.tmx': not found") !=
          std::string::npos);
    CHECK(draw_error(*this, "screen:draw('sky')").find("layer is \"sky\"") != std::string::npos);
}

}  // namespace cairn::scripting::test
