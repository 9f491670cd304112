#include "lua/errors.h"

#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

ScriptError error_of(LuaBench& bench, const std::string& code) {
    lua_State* L = bench.game().lua();
    const int top = lua_gettop(L);
    if (auto error = load_text(L, code, "src/aim.lua")) return *error;
    const auto error = protected_call(L, 0, 0);
    CHECK(lua_gettop(L) == top);
    return error.value_or(ScriptError{});
}

TEST_CASE("an error begins with its place and lists the calls, innermost first") {
    LuaBench bench;
    const ScriptError error = error_of(bench,
                                       "local function inner()\n  error('no')\nend\nlocal function outer()\n"
                                       "  inner()\nend\nouter()\n");
    CHECK(error.message == "src/aim.lua:2: no");
    REQUIRE(error.traceback.size() == 4);
    CHECK(error.traceback[0] == "[built in]: in 'error'");
    CHECK(error.traceback[1].find("src/aim.lua:2: in ") == 0);
    CHECK(error.traceback[1].find("'inner'") != std::string::npos);
    CHECK(error.traceback[2].find("src/aim.lua:5: in ") == 0);
    CHECK(error.traceback[3] == "src/aim.lua:7: in the main chunk");
    CHECK(error.to_text().find("src/aim.lua:2: no\n    [built in]") == 0);
}

TEST_CASE("a syntax error names file and line") {
    LuaBench bench;
    CHECK(error_of(bench, "local x = 1\nlocal y = = 2\n").message.find("src/aim.lua:2: ") == 0);
}

TEST_CASE("errors without a place get the innermost known one") {
    LuaBench bench;
    CHECK(error_of(bench, "\nerror('plain', 0)").message == "src/aim.lua:2: plain");
    CHECK(error_of(bench, "\nerror({})").message == "src/aim.lua:2: an error value that is table was raised");
    CHECK(error_of(bench, "error(setmetatable({}, {__tostring = function() return 'own words' end}))")
              .message == "src/aim.lua:1: own words");
    CHECK(error_of(bench, "error()").message.find("src/aim.lua:1: ") == 0);
}

TEST_CASE("an error that leaves a wrapped coroutine names the place where it began, once") {
    LuaBench bench;
    CHECK(error_of(bench, "local co = coroutine.wrap(function()\n  error('no')\nend)\nco()").message ==
          "src/aim.lua:2: no");
    CHECK(error_of(bench, "local ok, e = pcall(error, 'own words')\nerror(e)").message ==
          "src/aim.lua:2: own words");
    CHECK(error_of(bench, "error('scale 3:4: too wide')").message == "src/aim.lua:1: scale 3:4: too wide");
}

TEST_CASE("a message goes on behind a NUL byte") {
    LuaBench bench;
    CHECK(error_of(bench, "error('before\\0after')").message == "src/aim.lua:1: before\\0after");
}

TEST_CASE("a byte order mark and a first line for the shell are no code, and lines keep their numbers") {
    LuaBench bench;
    CHECK(error_of(bench,
                   "\xef\xbb\xbf"
                   "x = 1")
              .message == "");
    CHECK(error_of(bench, "#!/usr/bin/env cairn run\nerror('no')").message == "src/aim.lua:2: no");
    CHECK(error_of(bench, "\xef\xbb\xbf#!/usr/bin/env cairn run\nerror('no')").message ==
          "src/aim.lua:2: no");
    CHECK(error_of(bench, "# only this").message == "");
}

TEST_CASE("an endless recursion is an error with a short traceback") {
    LuaBench bench;
    const ScriptError error = error_of(bench, "local function f() return 1 + f() end f()");
    CHECK(error.message.find("stack overflow") != std::string::npos);
    CHECK(error.traceback.size() <= 25);
    CHECK(error.traceback.back() == "...");
}

TEST_CASE("an error inside an error handler is reported and not fatal") {
    LuaBench bench;
    CHECK(error_of(bench, "error(setmetatable({}, {__tostring = function() error('again') end}))").message !=
          "");
    CHECK(bench.value("1 + 1") == "2");
}

TEST_CASE("places are read from messages") {
    const auto place = place_of("src/aim.lua:12: attempt to fail");
    REQUIRE(place);
    CHECK(place->file == "src/aim.lua");
    CHECK(place->line == 12);
    CHECK_FALSE(place_of("no place here"));
    CHECK_FALSE(place_of("a colon: but no line"));
    CHECK_FALSE(place_of("[string \"x\"]:1: from load"));
    CHECK_FALSE(place_of(""));
}

TEST_CASE("messages escape what a terminal would obey, and what is no UTF-8") {
    LuaBench bench;
    // Names and texts that a script gives: the start of an escape sequence, in one byte and as a control
    // character of UTF-8, and a byte that belongs to no character.
    const std::string bad = "x\\27[31m\\xc2\\x9b\\xff\u00fc";
    const std::string told = "x\\027[31m\\194\\155\\255\u00fc";
    for (const char* call :
         {"cairn.input.is_down('%')", "cairn.graphics.new_image('%')", "cairn.camera.new{ ['%'] = 1 }",
          "cairn.graphics['%']()", "cairn.ui.new{ back = '%' }",
          "local m = cairn.ui.new{} m:set_focus(m:add_label{ text = '%' })", "require('%')"}) {
        std::string code = call;
        code.replace(code.find('%'), 1, bad);
        const std::string message = bench.run(code);
        INFO(message);
        CHECK_THAT(message, Catch::Contains(told) || Catch::Contains("x?[31m"));
        CHECK(message.find('\x1b') == std::string::npos);
        CHECK(message.find('\x9b') == std::string::npos);
        CHECK(message.find('\xff') == std::string::npos);
    }
    // Ends of lines stay where a message has several.
    lua_State* L = bench.game().lua();
    lua_pushcfunction(L, [](lua_State* state) {
        raise(state, "one\n\ttwo\x7f");
        return 0;
    });
    const auto error = protected_call(L, 0, 0);
    REQUIRE(error);
    CHECK(error->message == "one\n\ttwo\\127");
}

}  // namespace
}  // namespace cairn::scripting::test
