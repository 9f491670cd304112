#include <catch2/catch.hpp>
#include <filesystem>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("files of the game are read and listed") {
    LuaBench bench(GameFiles{{"notes/b.txt", "hello"}, {"notes/a.txt", ""}});
    CHECK(bench.value("cairn.files.read('notes/b.txt')") == "hello");
    CHECK(bench.value("table.concat(cairn.files.list('notes'), ' ')") == "a.txt b.txt");
    CHECK(bench.value("cairn.files.exists('notes/c.txt')") == "false");
    CHECK(bench.run("cairn.files.read('notes/c.txt')").find("notes/c.txt") != std::string::npos);
}

TEST_CASE("paths that lead out are refused everywhere") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    for (const char* path : {"../main.lua", "/etc/passwd", "a\\\\b", "c:/x", "save/../main.lua", "a\\0b"}) {
        INFO(path);
        CHECK(bench.run(std::string("cairn.files.read('") + path + "')") != "");
        CHECK(bench.run(std::string("cairn.files.write('") + path + "', 'x')") != "");
        CHECK(bench.value(std::string("cairn.files.exists('") + path + "')") == "false");
    }
    CHECK(bench.run("cairn.files.write('main.lua', 'x')").find("save/") != std::string::npos);
}

TEST_CASE("a run that plays its save folder keeps writes in memory") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    CHECK(bench.value("cairn.files.exists('save/a/one.txt')") == "false");
    REQUIRE(bench.run("cairn.files.write('save/a/one.txt', 'first') cairn.files.write('save/b.txt', '')") ==
            "");
    CHECK(bench.value("cairn.files.read('save/a/one.txt')") == "first");
    CHECK(bench.value("table.concat(cairn.files.list('save'), ' ')") == "a b.txt");
    CHECK(bench.run("cairn.files.read('save/none')").find("does not exist") != std::string::npos);
    CHECK(bench.machine().files->save_folder() != "");
    CHECK_FALSE(std::filesystem::exists(bench.machine().files->save_folder() + "/b.txt"));
}

TEST_CASE("a real run writes to the save folder") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.files.write('save/one.txt', 'kept')") == "");
    CHECK(bench.value("cairn.files.read('save/one.txt')") == "kept");
    CHECK(std::filesystem::exists(bench.machine().files->save_folder() + "/one.txt"));
}

}  // namespace
}  // namespace cairn::scripting::test
