// Objects of Tiled as parts of levels.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// A map of 8 x 4 cells of 16 pixels with one tile, and these objects.
std::string map_with(const std::string& objects) {
    return R"(<?xml version="1.0"?>
<map orientation="orthogonal" width="8" height="4" tilewidth="16" tileheight="16" infinite="0">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="1" columns="1"><image source="t.png" width="16" height="16"/></tileset>
 <objectgroup name="things">)" +
           objects + "</objectgroup></map>";
}

TEST_CASE("a tile placed as an object is a box with the class body, and a picture without") {
    // One cell is 1 m, the map 4 m high. Tiles stand on their position; a quarter turn clockwise about it
    // lays the third along x from 64 to 96 and along y from 32 to 48.
    LuaBench bench(GameFiles{{"map.tmx", map_with(R"(
        <object id="1" name="crate" gid="1" type="body" x="16" y="16" width="16" height="16"/>
        <object id="2" gid="1" x="48" y="16" width="16" height="16"/>
        <object id="3" name="turned" gid="1" type="body" x="64" y="32" width="16" height="32" rotation="90"/>)")}});
    REQUIRE(
        bench.run("w = cairn.physics.new_world{} l = cairn.level.load('map.tmx') l:build(w)\n"
                  "function name_at(x, y) local body = w:body_at(x, y) return body and body.data.name end") ==
        "");
    CHECK(bench.value("#l:bodies()") == "2");
    CHECK(bench.value("l:body('crate'):type()") == "static");
    for (const char* inside : {"1.05, 3.05", "1.95, 3.95"})
        CHECK(bench.value("name_at(" + std::string(inside) + ")") == "crate");
    for (const char* inside : {"4.05, 1.05", "5.95, 1.95"})
        CHECK(bench.value("name_at(" + std::string(inside) + ")") == "turned");
    for (const char* outside :
         {"0.95, 3.5", "2.05, 3.5", "1.5, 2.95", "3.95, 1.5", "6.05, 1.5", "5, 2.05", "5, 0.95"})
        CHECK(bench.value("name_at(" + std::string(outside) + ")") == "nil");
}

TEST_CASE("a text or a point of class body is a fault of the map, told beside the others") {
    LuaBench bench(GameFiles{{"map.tmx", map_with(R"(
        <object id="1" name="sign" type="body" x="0" y="0" width="16" height="16"><text>Hello</text></object>
        <object id="2" type="body" x="0" y="0"><point/></object>
        <object id="3" x="0" y="0" width="16" height="16"><text>a label</text></object>
        <object id="4" x="0" y="0"><point/></object>
        <object id="5" type="crat" x="0" y="0" width="16" height="16"/>)")}});
    REQUIRE(bench.run("faults = cairn.level.check('map.tmx')") == "");
    INFO(bench.value("table.concat(faults, '\\n')"));
    CHECK(bench.value("#faults") == "3");
    CHECK(
        bench.value("faults[1]") ==
        "map 'map.tmx': object 1 \"sign\" is a text of class \"body\", but a body must have a form: a tile, "
        "a rectangle, an ellipse, a polygon or a line");
    CHECK_THAT(bench.value("faults[2]"),
               Catch::StartsWith("map 'map.tmx': object 2 is a point of class \"body\""));
    CHECK_THAT(bench.value("faults[3]"), Catch::Contains("no such template"));
}

}  // namespace
}  // namespace cairn::scripting::test
