#include <catch2/catch.hpp>

#include "bind/object.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("sorted_pairs visits numbers, strings, false and true in order") {
    LuaBench bench;
    REQUIRE(bench.run(
                "order = '' for k, v in cairn.sorted_pairs{ b = 2, a = 1, [10] = 10, [2] = 2, [1.5] = 1.5, "
                "[true] = 't', "
                "[false] = 'f', B = 0 } do order = order .. tostring(k) .. '=' .. tostring(v) .. ' ' end") ==
            "");
    CHECK(bench.value("order") == "1.5=1.5 2=2 10=10 B=0 a=1 b=2 false=f true=t ");
}

TEST_CASE("sorted_pairs passes over what the loop removes and refuses keys without an order") {
    LuaBench bench;
    REQUIRE(bench.run("t = { a = 1, b = 2, c = 3 } seen = '' for k in cairn.sorted_pairs(t) do seen = seen "
                      ".. k t.b = nil end") == "");
    CHECK(bench.value("seen") == "ac");
    CHECK(bench.run("for k in cairn.sorted_pairs{ [{}] = 1 } do end").find("a key is a table") !=
          std::string::npos);
    CHECK(bench.run("for k in cairn.sorted_pairs{} do error('none') end") == "");
}

TEST_CASE("a result is reported with what is known") {
    LuaBench bench;
    CHECK_FALSE(bench.game().result());
    REQUIRE(bench.run("cairn.result{ outcome = 'lost' }") == "");
    REQUIRE(bench.game().result());
    CHECK(bench.game().result()->outcome == "lost");
    CHECK_FALSE(bench.game().result()->stars);
    REQUIRE(bench.run("cairn.result{ outcome = 'won', level = 'one', score = 10.5, stars = 3 }") == "");
    CHECK(*bench.game().result()->stars == 3);
    CHECK(*bench.game().result()->score == 10.5);
    CHECK(bench.run("cairn.result{ score = 1 }").find("outcome is missing") != std::string::npos);
}

TEST_CASE("cairn.test is only there in tests") {
    LuaBench bench;
    CHECK(bench.value("cairn.test") == "nil");
}

TEST_CASE("a field that is set on an object is refused, whatever the object") {
    LuaBench bench;
    lua_State* L = bench.game().lua();
    for (int tag = 0; tag < kObjectTagCount; ++tag) {
        // Loops have cursors, scripts do not; each body has a metatable of its own (body_test.cpp).
        if (static_cast<ObjectTag>(tag) == ObjectTag::EventCursor) continue;
        if (static_cast<ObjectTag>(tag) == ObjectTag::Body) continue;
        push_metatable(L, static_cast<ObjectTag>(tag));
        INFO(object_type_name(static_cast<ObjectTag>(tag)));
        CHECK(lua_getfield(L, -1, "__newindex") == LUA_TFUNCTION);
        lua_pop(L, 2);
    }
    REQUIRE(bench.run("w = cairn.physics.new_world{} u = cairn.ui.new{} i = cairn.graphics.new_canvas(2, 2) "
                      "k = cairn.physics.new_world{}:add_circle{ radius = 1 }") == "");
    CHECK(bench.run("w.gravity = 3") ==
          "test.lua:1: a World has no field \"gravity\" to set; keep values of your own in a table");
    CHECK(bench.run("u[2] = true") ==
          "test.lua:1: a Ui has no field 2 to set; keep values of your own in a table");
    CHECK(bench.run("cairn.random.new(1).x = 1").find("a Random has no field \"x\"") != std::string::npos);
}

TEST_CASE("a function that the script itself took away is not suggested") {
    LuaBench bench;
    CHECK(bench.run("cairn.physics.new_world = nil cairn.physics.new_world{}") ==
          "test.lua:1: cairn.physics.new_world is nil because the script has set it to nil");
    CHECK(bench.run("cairn.physics.new_wrld{}") ==
          "test.lua:1: cairn.physics has no \"new_wrld\"; did you mean \"new_world\"?");
}

}  // namespace
}  // namespace cairn::scripting::test
