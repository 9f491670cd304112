#include "bind/data_values.h"

#include <catch2/catch.hpp>

#include "data/table_writer.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("data passes from Lua to text and back unchanged") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.files.write_data('save/best.lua', { stars = { 3, 1 }, name = 'a \"b\"', [7] = "
                      "0.1, on = true }) "
                      "t = cairn.files.read_data('save/best.lua')") == "");
    CHECK(bench.value("t.stars[1] .. t.stars[2] .. t.name .. tostring(t[7]) .. tostring(t.on)") ==
          "31a \"b\"0.1true");
    CHECK(bench.value("math.type(t.stars[1])") == "integer");
}

TEST_CASE("what is no data is named by its place") {
    LuaBench bench;
    lua_State* L = bench.game().lua();
    const auto error_of = [&](const char* expression) {
        lua_settop(L, 0);
        REQUIRE(luaL_dostring(L, (std::string("return ") + expression).c_str()) == LUA_OK);
        const auto value = to_value(L, 1);
        CHECK(lua_gettop(L) == 1);
        return value ? std::string() : value.error().message;
    };
    CHECK(error_of("{ a = { 1, print } }") ==
          "t.a[2] is a function; data is numbers, strings, booleans and tables");
    CHECK(error_of("{ [1.5] = 1 }") == "t has the key 1.5; keys of data are strings and integers");
    CHECK(error_of("(function() local t = {} t.t = t return t end)()").find("nested too deep") !=
          std::string::npos);
    CHECK(error_of("{ cairn.random.visual }").find("t[1] is a Random") == 0);
    CHECK(error_of("{ 1, { 2 } }").empty());
}

}  // namespace
}  // namespace cairn::scripting::test
