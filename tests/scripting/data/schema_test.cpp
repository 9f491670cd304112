#include "data/schema.h"

#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

// Schemas are easiest to write, and meant to be written, in Lua; so these tests go through cairn.data.load.
std::string fault_of(const std::string& schema, const std::string& data) {
    LuaBench bench(GameFiles{{"data.lua", data}});
    return bench.run("cairn.data.load('data.lua', " + schema + ")");
}

TEST_CASE("a wrong value is named with line, path, value and rule") {
    const std::string schema =
        "{ type = 'table', fields = { pieces = { type = 'list', items = { type = 'table', fields = {"
        "material = { type = 'string', what = 'material', one_of = { wood = 1, ice = 1, stone = 1 } },"
        "width = { type = 'number', above = 0, max = 20 }, count = { type = 'integer', min = 1 } } } } } }";
    CHECK(fault_of(schema, "return { pieces = {\n{ material = 'wood' },\n{ material = 'wod' } } }") ==
          "data.lua:3: pieces[2].material = \"wod\": no such material; did you mean \"wood\"? (ice, stone, "
          "wood)");
    CHECK(fault_of(schema, "{ pieces = { { width = 0 } } }") ==
          "data.lua:1: pieces[1].width = 0: must be above 0");
    CHECK(fault_of(schema, "{ pieces = { { width = 20.5 } } }") ==
          "data.lua:1: pieces[1].width = 20.5: must be at most 20");
    CHECK(fault_of(schema, "{ pieces = { { count = 0 } } }") ==
          "data.lua:1: pieces[1].count = 0: must be at least 1");
    CHECK(fault_of(schema, "{ pieces = { { count = 1.5 } } }") ==
          "data.lua:1: pieces[1].count = 1.5: must be an integer, is a number");
    CHECK(fault_of(schema, "{ pieces = { { width = '1' } } }") ==
          "data.lua:1: pieces[1].width = \"1\": must be a number, is a string");
    CHECK(fault_of(schema, "{ pieces = { { widht = 1 } } }") ==
          "data.lua:1: pieces[1].widht: unknown field; did you mean \"width\"? (count, material, width)");
    CHECK(fault_of(schema, "{ pieces = { { [\"w\\27[31m\\n\"] = 1 } } }") ==
          "data.lua:1: pieces[1].\"w\\027[31m\\n\": unknown field (count, material, width)");
    CHECK(fault_of(schema, "{ pieces = { a = 1 } }") ==
          "data.lua:1: pieces: must be a list: its keys must be 1, 2, 3, ...");
    CHECK(fault_of(schema, "{ pieces = { { width = 5, count = 2, material = 'ice' } } }") == "");
}

TEST_CASE("a missing field is named where its table stands") {
    CHECK(fault_of("{ type = 'table', fields = { p = { type = 'table', fields = { x = { type = 'number', "
                   "required = true } } } } }",
                   "{\n p = { } }") == "data.lua:2: p: \"x\" is missing; it must be a number");
    CHECK(fault_of(
              "{ type = 'table', fields = { m = { type = 'string', required = true, what = 'material' } } }",
              "{}") == "data.lua:1: the table: \"m\" is missing; it must be a string, the material");
}

TEST_CASE("lengths and rules of the game's own are checked, every fault told") {
    const std::string schema =
        "{ type = 'table', fields = { name = { type = 'string', min_length = 1, max_length = 5 }, list = { "
        "type = 'list', min_length = 2, items = { type = 'integer', check = function(v) if v % 2 == 1 "
        "then return 'must be even' end end } } } }";
    CHECK(fault_of(schema, "{ name = '' }") == "data.lua:1: name = \"\": must have at least 1 byte, has 0");
    CHECK(fault_of(schema, "{ name = 'abcdef' }").find("must have at most 5 bytes, has 6") !=
          std::string::npos);
    CHECK(fault_of(schema, "{ list = { 2 } }") == "data.lua:1: list: must have at least 2 members, has 1");
    CHECK(fault_of(schema, "{ list = { 2, 3 } }") == "data.lua:1: list[2] = 3: must be even");
    CHECK(fault_of(schema, "{ list = { 1, 3 } }") ==
          "data.lua:1: list[1] = 1: must be even\ndata.lua:1: list[2] = 3: must be even");
}

TEST_CASE("defaults are filled in, also inside lists") {
    LuaBench bench(GameFiles{{"data.lua", "{ pieces = { { x = 1 }, { x = 2, angle = 3 } } }"}});
    REQUIRE(bench.run("t = cairn.data.load('data.lua', { type = 'table', fields = { title = { type = "
                      "'string', default = 'none' }, "
                      "pieces = { type = 'list', items = { type = 'table', fields = { x = { type = 'number' "
                      "}, angle = { type = "
                      "'number', default = 0.5 } } } } } })") == "");
    CHECK(bench.value("t.title") == "none");
    CHECK(bench.value("t.pieces[1].angle") == "0.5");
    CHECK(bench.value("t.pieces[2].angle") == "3");
}

}  // namespace
}  // namespace cairn::scripting::test
