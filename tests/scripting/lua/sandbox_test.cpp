#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("libraries that reach outside are absent") {
    LuaBench bench;
    for (const char* name : {"io", "os", "package", "debug", "dofile", "loadfile", "warn", "string.dump"}) {
        INFO(name);
        CHECK(bench.value(name) == "nil");
    }
    CHECK(bench.run("load('return io')()") == "");
    CHECK(bench.value("load('return io')()") == "nil");
}

TEST_CASE("bytecode is not loaded") {
    LuaBench bench;
    CHECK(bench.value("select('#', load('\\27Lua'))") == "2");
    CHECK(bench.value("(select(2, load('\\27LuaS\\0\\25\\147')))").find("binary") != std::string::npos);
    CHECK(bench.value("load('return 1', 'x', 'b')") == "nil");
    CHECK(bench.value("load('return 1', 'x', 'bt')()") == "1");
    CHECK(bench.value("load(function() return nil end)()") == "nil");
}

TEST_CASE("load keeps its environment argument") {
    LuaBench bench;
    CHECK(bench.value("load('return x', 'c', 't', {x = 7})()") == "7");
    CHECK(bench.value("load('return print', 'c', 't', {})()") == "nil");
    CHECK(bench.value("(select(2, load('x =', '=chunk')))").find("chunk:1:") == 0);
}

TEST_CASE("finalizers are refused") {
    LuaBench bench;
    CHECK(bench.run("setmetatable({}, {__gc = function() end})").find("__gc") != std::string::npos);
    CHECK(bench.run("local m = {} local t = setmetatable({}, m) m.__gc = function() error('ran') end") == "");
    CHECK(bench.value("getmetatable(setmetatable({}, {__index = {a = 1}})).__index.a") == "1");
}

TEST_CASE("the collector can be asked but not driven") {
    LuaBench bench;
    CHECK(bench.value("type(collectgarbage('count'))") == "number");
    for (const char* mode : {"stop", "collect", "step", "generational", "incremental"}) {
        INFO(mode);
        CHECK(bench.run(std::string("collectgarbage('") + mode + "')").find("only \"count\"") !=
              std::string::npos);
    }
}

TEST_CASE("no address is shown") {
    LuaBench bench;
    CHECK(bench.value("tostring({})") == "table");
    CHECK(bench.value("tostring(print)") == "function");
    CHECK(bench.value("tostring(coroutine.create(print))") == "thread");
    CHECK(bench.value("string.format('%s %d', {}, 3)") == "table 3");
    CHECK(bench.value("string.format('%5.1f|%s|%%p', 1.25, 'a')") == "  1.2|a|%p");
    CHECK(bench.run("return string.format('%p', {})").find("%p") != std::string::npos);
    CHECK(bench.run("return string.format('%-10p', {})").find("%p") != std::string::npos);
    CHECK(bench.value("tostring(setmetatable({}, {__tostring = function() return 'mine' end}))") == "mine");
    CHECK(bench.value("tostring(cairn.physics.new_world{})") == "World");
}

TEST_CASE("metatables that everybody shares are out of reach") {
    LuaBench bench;
    CHECK(bench.value("getmetatable('')") == "false");
    CHECK(bench.value("getmetatable(cairn.physics)") == "false");
    CHECK(bench.value("getmetatable(cairn.physics.new_world{})") == "false");
    CHECK(bench.value("getmetatable(cairn.physics.new_world{}:add_circle{radius = 1})") == "false");
    CHECK(bench.value("('abc'):upper()") == "ABC");
}

TEST_CASE("mathematics is the deterministic one") {
    LuaBench bench;
    CHECK(bench.value("math.pow(2, 10)") == "1024.0");
    CHECK(bench.value("math.log(8, 2)") == "3.0");
    CHECK(bench.value("math.log(1000, 10)") == "3.0");
    CHECK(bench.value("math.abs(math.sin(math.pi / 6) - 0.5) < 1e-12") == "true");
    CHECK(bench.value("math.abs(math.atan(1, -1) - 3 * math.pi / 4) < 1e-12") == "true");
    CHECK(bench.value("math.atan(1) == math.atan(1, 1)") == "true");
}

TEST_CASE("require finds the game's own files only, once") {
    LuaBench bench(GameFiles{{"src/counter.lua", "count = (count or 0) + 1 return { name = ... }"},
                             {"empty.lua", ""},
                             {"loop.lua", "return require('loop')"},
                             {"broken.lua", "return {\n  1 +\n}"}});
    CHECK(bench.value("require('src.counter').name") == "src.counter");
    CHECK(bench.value("require('src.counter') == require('src/counter') and count") == "1");
    CHECK(bench.value("require('empty')") == "true");
    for (const char* name : {"../x", "..x", ".x", "./x", "/x", "a//b", "a..b", "x/", ""})
        CHECK_THAT(bench.run(std::string("require('") + name + "')"),
                   Catch::Contains(std::string("require: the module name \"") + name +
                                   "\" must be names with one . or / between them"));
    CHECK(bench.run("require('loop')").find("requires itself") != std::string::npos);
    CHECK(bench.run("require('broken')").find("broken.lua:3:") == 0);
    CHECK(bench.run("require('broken')").find("broken.lua:3:") == 0);
    CHECK(bench.run("require('absent')").find("no module \"absent\"") != std::string::npos);
    CHECK(bench.run("require('../main')") != "");
    CHECK(bench.run("require('/etc/passwd')") != "");
    CHECK(bench.run("require('io')").find("no module \"io\"") != std::string::npos);
    CHECK(bench.run("require(12)").find("12") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
