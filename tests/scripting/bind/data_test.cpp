#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("a schema's own slips are named by their path") {
    LuaBench bench;
    const auto error_of = [&](const std::string& schema) {
        return bench.run("cairn.data.check({}, " + schema + ")");
    };
    CHECK(error_of("{ type = 'tabel' }")
              .find("schema.type = \"tabel\": no such type; did you mean \"table\"?") != std::string::npos);
    CHECK(error_of("{}").find("schema has no type") != std::string::npos);
    CHECK(error_of("{ type = 'table', fields = { x = { type = 'number', minimum = 1 } } }")
              .find("schema.fields.x has the unknown field \"minimum\"") != std::string::npos);
    CHECK(error_of("{ type = 'table', fields = { x = 5 } }").find("schema.fields.x is 5; expected a table") !=
          std::string::npos);
    CHECK(error_of("{ type = 'table', required = 1 }").find("schema.required is 1; expected true or false") !=
          std::string::npos);
    CHECK(error_of("(function() local s = { type = 'list' } s.items = s return s end)()")
              .find("nested too deep") != std::string::npos);
}

TEST_CASE("a file that is no data is refused with line and column, and never run") {
    LuaBench bench(GameFiles{{"level.lua", "return {\n  x = (function() ran = true end)(),\n}"}});
    CHECK(bench.run("cairn.data.load('level.lua', { type = 'table' })").find("level.lua:2:7: ") == 0);
    CHECK(bench.value("ran") == "nil");
    CHECK(bench.run("cairn.data.load('none.lua', { type = 'table' })").find("none.lua") != std::string::npos);
}

TEST_CASE("a table of any origin is checked and copied") {
    LuaBench bench;
    REQUIRE(bench.run("t = { x = 1 } c = cairn.data.check(t, { type = 'table', fields = { x = { type = "
                      "'number' }, y = { type = 'list', default = { 1, 2 } } } })") == "");
    CHECK(bench.value("c ~= t and c.x == 1 and #c.y == 2 and t.y == nil") == "true");
    CHECK(bench.run(
              "cairn.data.check({ x = 'a' }, { type = 'table', fields = { x = { type = 'number' } } })") ==
          "test.lua:1: data: x = \"a\": must be a number, is a string");
}

}  // namespace
}  // namespace cairn::scripting::test
