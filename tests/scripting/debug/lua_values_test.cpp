#include "debug/lua_values.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const LuaValue* find(const std::vector<LuaValue>& values, const std::string& name) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const LuaValue& value) { return value.name == name; });
    return found == values.end() ? nullptr : &*found;
}

TEST_CASE("a game's globals and the locals of its callbacks are told, functions and libraries are not") {
    LuaBench bench;
    REQUIRE(bench.run("score = 12 name = 'Ann' local lives, limit = 3, 9 function helper() return limit end "
                      "local function inner() return lives end "
                      "function cairn.update() return inner(), helper() end") == "");
    const std::vector<LuaValue> values = values_of_game(bench.game().lua());
    std::string names;
    for (const LuaValue& value : values) names += value.name + ' ';
    CHECK(names == "lives name score ");
    CHECK(find(values, "lives")->text == "3");
    CHECK(find(values, "name")->text == "\"Ann\"");
}

TEST_CASE("tables have members, lists in their order") {
    LuaBench bench;
    REQUIRE(bench.run("t = { 30, 20, 10, b = { c = { d = { e = 1 } } }, a = true }") == "");
    const std::vector<LuaValue> values = values_of_game(bench.game().lua());
    const LuaValue* t = find(values, "t");
    REQUIRE(t != nullptr);
    CHECK(t->text == "a list of 3");
    REQUIRE(t->members.size() == 5);
    CHECK(t->members[0].name == "a");
    CHECK(t->members[1].name == "b");
    CHECK(t->members[2].text == "30");
    CHECK(t->members[4].text == "10");
    const LuaValue& d = t->members[1].members.at(0).members.at(0);
    CHECK(d.name == "d");
    CHECK(d.members.empty());
    CHECK(d.is_cut);
}

TEST_CASE("endless tables, traps and heaps of members end") {
    LuaBench bench;
    REQUIRE(
        bench.run("t = {} t.t = t setmetatable(t, { __index = function() error('touched') end, "
                  "__len = function() error('touched') end, __tostring = function() error('touched') end }) "
                  "many = {} for i = 1, 10000 do many[i] = i end odd = { [1.5] = 1, [true] = 2 }") == "");
    const std::vector<LuaValue> values = values_of_game(bench.game().lua());
    REQUIRE(find(values, "t") != nullptr);
    REQUIRE(find(values, "many") != nullptr);
    CHECK(find(values, "many")->members.size() == 200);
    CHECK(find(values, "many")->is_cut);
    CHECK(find(values, "odd")->members.size() == 2);
    CHECK(bench.run("assert(t.t == t)") == "");
}

}  // namespace
}  // namespace cairn::scripting::test
