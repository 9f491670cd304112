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

TEST_CASE("a tile placed as an object is a box where the alignment of its set puts it, in its size") {
    // One cell is 1 m, the map 4 m high: the middle of the tile of 16 pixels is at (32, 16), which is (2, 3).
    std::string map = map_with(R"(<object id="1" name="crate" gid="1" type="body" x="32" y="16"/>)");
    const std::string columns = "columns=\"1\"";
    map.insert(map.find(columns), "objectalignment=\"center\" ");
    LuaBench bench(GameFiles{{"map.tmx", map}});
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = cairn.level.load('map.tmx') l:build(w)") == "");
    CHECK(bench.value("table.concat({ l:body('crate'):position() }, ' ')") == "2.0 3.0");
    for (const char* inside : {"1.55, 2.55", "2.45, 3.45"})
        CHECK(bench.value("w:body_at(" + std::string(inside) + ") ~= nil") == "true");
    for (const char* outside : {"1.45, 3", "2.55, 3", "2, 2.45", "2, 3.55"})
        CHECK(bench.value("w:body_at(" + std::string(outside) + ")") == "nil");
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
    CHECK(bench.value("faults[1]") ==
          "map.tmx:5: object 1 \"sign\" in layer \"things\": is a text of class \"body\", but a body must "
          "have a "
          "form: a tile, a rectangle, an ellipse, a polygon or a line");
    CHECK_THAT(bench.value("faults[2]"),
               Catch::StartsWith("map.tmx:6: object 2 in layer \"things\": is a point of class \"body\""));
    CHECK_THAT(
        bench.value("faults[3]"),
        Catch::StartsWith("map.tmx:9: object 5 in layer \"things\": class = \"crat\": no such class or "
                          "template (body, trigger, "));
}

/// The faults of a map as a level are these, each after "map.tmx:".
void expect_faults(const GameFiles& files, const std::vector<std::string>& expected,
                   const std::string& map = "map.tmx") {
    LuaBench bench(files);
    REQUIRE(bench.run("faults = cairn.level.check('" + map + "')") == "");
    INFO(bench.value("table.concat(faults, '\\n')"));
    REQUIRE(bench.value("#faults") == std::to_string(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK_THAT(bench.value("faults[" + std::to_string(i + 1) + "]"),
                   Catch::StartsWith(map + ':' + expected[i]));
}

TEST_CASE(
    "faults of a map's level name the object, its layer, its line, and the value in the editor's unit") {
    // One cell of 16 pixels is 1 m: 2000000 m are 32000000 pixels, and the half of that is a radius.
    const std::string in = " in layer \"things\": ";
    expect_faults(
        {{"map.tmx", map_with(R"(
  <object id="1" name="wide" x="16" y="16" width="-16.5" height="16"/>
  <object id="2" name="wide" x="16" y="16" width="16" height="16"/>
  <object id="3" x="0" y="0"><ellipse/></object>
  <object id="4" name="far" x="1e30" y="-1e30" width="16" height="16"/>
  <object id="5" type="camera" x="0" y="0" width="3"/>
  <object id="6" type="bounds" x="8" y="8" width="-1"/>
  <object id="7" name="rubber" x="0" y="0" width="16" height="16"><properties>
    <property name="friction" type="float" value="-1"/><property name="type" value="dinamic"/></properties></object>)")}},
        {"5: object 1 \"wide\"" + in + "width = -16.5 pixels: must be above 0 and at most 32000000 pixels",
         "6: object 2 \"wide\"" + in +
             "name = \"wide\": is the name of object 1 \"wide\" in layer \"things\" "
             "already",
         "7: object 3" + in + "width = 0 pixels: must be above 0 and at most 32000000 pixels",
         "8: object 4 \"far\"" + in + "x = 1e+30 pixels: must be from -1.6e+13 to 1.6e+13 pixels",
         "8: object 4 \"far\"" + in + "y = -1e+30 pixels: must be from -1.6e+13 to 1.6e+13 pixels",
         "9: object 5" + in + "height = 0 pixels: must be from 1.6e-05 to 1.6e+10 pixels",
         "10: object 6" + in + "width = -1 pixels: must be above 0",
         "10: object 6" + in + "height = 0 pixels: must be above 0",
         "11: object 7 \"rubber\"" + in + "property \"friction\" = -1: must be at least 0",
         "11: object 7 \"rubber\"" + in +
             "property \"type\" = \"dinamic\": no such type; did you mean "
             "\"dynamic\"?"});
}

TEST_CASE("a level that is no JSON is told by its line") {
    expect_faults({{"map.tmj", "{\n\"width\": 1,\n\"height\" 2\n}"}},
                  {"3: is not JSON: column 10: syntax error"}, "map.tmj");
}

TEST_CASE("misspelt classes, kinds, fields and names of a map get the nearest one") {
    const std::string in = " in layer \"things\": ";
    expect_faults(
        {{"map.tmx", map_with(R"(
  <object id="1" name="box" type="crat" x="0" y="0" width="16" height="16"/>
  <object id="2" type="triger" x="0" y="0" width="16" height="16"/>
  <object id="3" type="joint" x="0" y="0"><properties><property name="joint" value="revolut"/></properties></object>
  <object id="4" type="joint" x="0" y="0"><properties><property name="joint" value="revolute"/>
    <property name="body_b" value="bax"/><property name="lowr" type="float" value="3"/></properties></object>
  <object id="5" type="prefab" x="0" y="0"/>
  <object id="6" type="trigger" x="0" y="0" width="16" height="16"/>)")}},
        {"5: object 1 \"box\"" + in +
             "class = \"crat\": no such class or template (body, trigger, spawn, camera, "
             "bounds, joint, prefab)",
         "6: object 2" + in + "class = \"triger\": no such class or template; did you mean \"trigger\"?",
         "7: object 3" + in + "property \"joint\" = \"revolut\": no such joint; did you mean \"revolute\"?",
         "8: object 4" + in + "property \"lowr\" = 3: unknown field; did you mean \"lower\"?",
         "8: object 4" + in + "property \"body_b\" = \"bax\": no such body; did you mean \"box\"?",
         "10: object 5" + in + "the property \"prefab\" is missing (chain, rope,",
         "11: object 6" + in + "\"name\" is missing; it must be a string"});
}

TEST_CASE(
    "what cannot be read of a map is told beside the faults of its level, and nothing follows from it") {
    const std::string in = " in layer \"things\": ";
    expect_faults(
        {{"map.tmx", map_with(R"(
  <object id="1" name="lost" x="nan" y="0" width="16" height="-16"/>
  <object id="2" name="text" type="body" x="0" y="0"><text>Hello</text></object>
  <object id="3" type="joint" x="0" y="0"><properties><property name="joint" value="revolute"/>
    <property name="body_a" value="text"/><property name="body_b" value="lost"/></properties></object>
  <object id="4" name="line" type="trigger" x="0" y="0"><polyline points="0,0 16,0 32,4"/></object>
  <object id="5" type="prefab" x="0" y="0"><properties><property name="prefab" value="rope"/>
    <property name="to_x" type="float" value="inf"/><property name="links" type="int" value="-1"/></properties></object>
  <object id="6" name="turned" x="0" y="0" width="16" height="16" rotation="left"/>
  <object id="7" name="round" x="0" y="0" width="0" height="1e999"><ellipse/></object>)")}},
        {"5: object 1 \"lost\"" + in + "x is \"nan\", but must be a number",
         "5: object 1 \"lost\"" + in + "height = -16 pixels: must be above 0",
         "6: object 2 \"text\"" + in + "is a text of class \"body\", but a body must have a form",
         "9: object 4 \"line\"" + in + "is a line of class \"trigger\", but a trigger must be",
         "10: object 5" + in + "property \"links\" = -1: must be from 2 to 10000",
         "11: object 5" + in + "property \"to_x\" is \"inf\", but must be a number: its type is float",
         "12: object 6 \"turned\"" + in + "rotation is \"left\", but must be a number",
         "13: object 7 \"round\"" + in + "height is \"1e999\", but must be a number"});
    // Objects that could not be read at all may have any name.
    expect_faults({{"map.tmj", R"({"width": 1, "height": 1, "tilewidth": 16, "tileheight": 16, "layers": [
 {"type": "objectgroup", "name": "a", "objects": {}},
 {"type": "objectgroup", "name": "b", "objects": [
  {"id": 9, "type": "joint", "x": 0, "y": 0, "properties": [{"name": "joint", "value": "revolute"},
   {"name": "body_b", "value": "hidden"}]},
  {"id": 10, "x": 0,
   "y": 0, "width": -1, "height": 1}]}]})"}},
                  {"2: layer \"a\": objects is an object, but must be a list",
                   "6: object 10 in layer \"b\": width = -1 pixels: must be above 0"},
                  "map.tmj");
    // Nor is it known what a file that cannot be read was to include.
    expect_faults({{"map.tmx", R"(<map width="1" height="1" tilewidth="16" tileheight="16">
 <properties><property name="includes" type="float" value="nan"/></properties>
 <objectgroup name="a"><object id="1" type="crate" x="0" y="0"/></objectgroup></map>)"}},
                  {"2: property \"includes\" is \"nan\", but must be a number"});
}

TEST_CASE("what shows only when a map's level is built is told of the object or the layer too") {
    const std::string solid = R"(<?xml version="1.0"?>
<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="1" columns="1"><image source="t.png" width="16" height="16"/></tileset>
 <layer name="ground" width="1" height="1"><properties><property name="solid" type="bool" value="true"/>
  <property name="friction" type="float" value="-0.5"/></properties><data encoding="csv">1</data></layer>
 <objectgroup name="things">
  <object id="1" name="flat" x="0" y="0"><polygon points="0,0 16,0 32,0"/></object>
  <object id="2" type="prefab" name="r" x="0" y="0"><properties><property name="prefab" value="rope"/></properties></object>
  <object id="3" type="joint" x="0" y="0"><properties><property name="joint" value="revolute"/>
   <property name="body_b" value="r.300"/></properties></object>
 </objectgroup>
</map>)";
    expect_faults({{"map.tmx", solid}},
                  {"4: layer \"ground\": property \"friction\" = -0.5: must be at least 0",
                   "7: object 1 \"flat\" in layer \"things\": points lie on one line",
                   "9: object 3 in layer \"things\": property \"body_b\" = \"r.300\": there is no such body; "
                   "\"r\" has 22 bodies"});
}

}  // namespace
}  // namespace cairn::scripting::test
