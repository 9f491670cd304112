#include "lua/state.h"

#include <catch2/catch.hpp>

#include "lua/errors.h"

namespace cairn::scripting {
namespace {

TEST_CASE("a state counts the memory that its script holds") {
    State state;
    lua_State* L = state.get();
    const std::size_t before = state.used_bytes();
    REQUIRE_FALSE(load_text(L, "text = ('x'):rep(1000000)", "test.lua"));
    REQUIRE_FALSE(protected_call(L, 0, 0));
    CHECK(state.used_bytes() >= before + 1000000);
    lua_pushnil(L);
    lua_setglobal(L, "text");
    lua_gc(L, LUA_GCCOLLECT);
    CHECK(state.used_bytes() < before + 100000);
}

TEST_CASE("a script that wants more memory than the cap gets an error and the state lives on") {
    State state(4 << 20);
    lua_State* L = state.get();
    REQUIRE_FALSE(
        load_text(L, "local t = {}\nwhile true do\n    t[#t + 1] = ('x'):rep(1000) .. #t\nend", "test.lua"));
    const auto error = protected_call(L, 0, 0);
    REQUIRE(error);
    CHECK(error->message == "test.lua:3: not enough memory: the script used up what a game may have");
    CHECK(state.used_bytes() <= std::size_t{4} << 20);
    lua_gc(L, LUA_GCCOLLECT);
    REQUIRE_FALSE(load_text(L, "assert(1 + 1 == 2)", "test.lua"));
    CHECK_FALSE(protected_call(L, 0, 0));
}

TEST_CASE("a doubling string meets the cap too") {
    State state(4 << 20);
    lua_State* L = state.get();
    REQUIRE_FALSE(load_text(L, "local s = 'x' while true do s = s .. s end", "test.lua"));
    const auto error = protected_call(L, 0, 0);
    REQUIRE(error);
    CHECK(error->message.find("test.lua:1: not enough memory") == 0);
}

TEST_CASE("a coroutine that uses up the memory is told with the place that resumed it") {
    State state(4 << 20);
    lua_State* L = state.get();
    REQUIRE_FALSE(load_text(
        L, "local f = coroutine.wrap(function()\nlocal s = 'x' while true do s = s .. s end end)\nf()",
        "test.lua"));
    const auto error = protected_call(L, 0, 0);
    REQUIRE(error);
    CHECK(error->message.find("test.lua:") == 0);
    CHECK(error->message.find("not enough memory") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting
