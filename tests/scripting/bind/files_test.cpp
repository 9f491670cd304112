#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>

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
    CHECK(bench.run("cairn.files.read('save/none')").find("not found") != std::string::npos);
    CHECK(bench.machine().files->save_folder() != "");
    CHECK_FALSE(std::filesystem::exists(bench.machine().files->save_folder() + "/b.txt"));
}

TEST_CASE(
    "what a run that plays its save folder has written is there for all that reads files, and the disk is "
    "not") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    // What a player has saved.
    const std::filesystem::path saved = bench.machine().files->save_folder();
    std::filesystem::create_directories(saved);
    std::ofstream(saved / "old.lua") << "return 7";
    std::string bytes;
    for (const char c : std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\5\0\0\0\4\x8\2\0\0\0", 29)) {
        char text[8];
        std::snprintf(text, sizeof text, "\\x%02x", static_cast<unsigned char>(c));
        bytes += text;
    }
    REQUIRE(bench.run("cairn.files.write('save/mine.lua', 'return { bodies = { { shape = \"circle\", radius "
                      "= 1 } } }') "
                      "cairn.files.write('save/tool.lua', 'return 42') "
                      "cairn.files.write('save/image.png', '" +
                      bytes + "' .. ('\\0'):rep(44) .. 'IEND' .. ('\\0'):rep(4))") == "");
    CHECK(bench.value("#cairn.level.check('save/mine.lua')") == "0");
    CHECK(bench.value("require('save.tool')") == "42");
    CHECK(bench.value("table.concat({ cairn.graphics.new_image('save/image.png'):size() }, ' ')") == "5 4");
    CHECK(bench.value("table.concat(cairn.files.list(''), ' ')").find("save") != std::string::npos);
    CHECK_THAT(bench.run("require('save.old')"), Catch::Contains("not found"));
    CHECK(bench.value("cairn.files.exists('save/old.lua')") == "false");
    CHECK_THAT(bench.run("cairn.level.load('save/old.lua')"), Catch::Contains("there is no such file"));
}

TEST_CASE("a run that plays its save folder leaves those before it and after it alone") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    REQUIRE(bench.run("cairn.files.write('save/a', 'outer')") == "");
    {
        Game inner(bench.machine().services(), {.plays_saves = true});
        CHECK_FALSE(bench.machine().files->exists("save/a"));
        REQUIRE(bench.machine().files->write("save/a", std::string_view("inner")));
    }
    CHECK(bench.value("cairn.files.read('save/a')") == "outer");
}

TEST_CASE("a real run writes to the save folder") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.files.write('save/one.txt', 'kept')") == "");
    CHECK(bench.value("cairn.files.read('save/one.txt')") == "kept");
    CHECK(std::filesystem::exists(bench.machine().files->save_folder() + "/one.txt"));
}

TEST_CASE("data that could not be read back is refused, and what was saved stays") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    REQUIRE(bench.run("cairn.files.write_data('save/a.lua', { best = 1, least = math.mininteger })") == "");
    const auto refusal = [&](const std::string& table) {
        return bench.run("cairn.files.write_data('save/a.lua', " + table + ")");
    };
    CHECK(refusal("{ best = 1/0 }").find("t.best is infinite; numbers in a file must be finite") !=
          std::string::npos);
    CHECK(refusal("{ 1, { x = -math.huge } }").find("t[2].x is -infinite") != std::string::npos);
    CHECK(refusal("{ 0/0 }").find("t[1] is not a number") != std::string::npos);
    CHECK(bench.value("cairn.files.read_data('save/a.lua').best") == "1");
    CHECK(bench.value("cairn.files.read_data('save/a.lua').least == math.mininteger") == "true");
    CHECK(bench.value("math.type(cairn.files.read_data('save/a.lua').least)") == "integer");
}

/// What the calls of a script answer, with the errors' messages.
const char* const kTriesEverything = R"(
    local answers = {}
    local function try(f, ...)
        local fine, result = pcall(f, ...)
        if type(result) == "table" then result = "{" .. table.concat(result, " ") .. "}" end
        if not fine then result = "error" end
        answers[#answers + 1] = tostring(result)
    end
    local files = cairn.files
    try(files.exists, "save") try(files.list, "save") try(files.list, "save/none") try(files.exists, "save/none")
    try(files.write, "save/file", "text") try(files.write, "save/file/below", "x") try(files.read, "save/file/below")
    try(files.write, "save/folder/inner", "x") try(files.write, "save/folder", "x") try(files.write, "save", "x")
    try(files.read, "save/folder") try(files.exists, "save/folder") try(files.list, "save/file")
    try(files.list, "save") try(files.list, "save/folder") try(files.list, "save/") try(files.read, "save/file")
    try(files.write, "save/" .. ("n"):rep(255), "x") try(files.write, "save/" .. ("n"):rep(256), "x")
    ANSWERS = table.concat(answers, ", ")
)";

TEST_CASE("saves in memory follow the rules of the disk") {
    std::string on_disk;
    {
        LuaBench bench;
        REQUIRE(bench.run(kTriesEverything) == "");
        on_disk = bench.value("ANSWERS");
    }
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    REQUIRE(bench.run(kTriesEverything) == "");
    CHECK(bench.value("ANSWERS") == on_disk);
    CHECK(on_disk ==
          "true, {}, error, false, nil, error, error, nil, error, error, error, true, error, {file folder}, "
          "{inner}, error, text, nil, error");
    CHECK(bench.run("cairn.files.write('save/file/below', 'x')") ==
          "test.lua:1: cairn.files.write: file 'save/file/below': 'save/file' is a file, not a folder");
}

TEST_CASE("saves in memory have a limit, and what is replaced does not count") {
    LuaBench bench({}, MachineKind::Headless, {.plays_saves = true});
    REQUIRE(bench.run("half = ('x'):rep(32 << 20)") == "");
    CHECK(bench.run("for i = 1, 4 do cairn.files.write('save/a', half) end") == "");
    const std::string message = bench.run("cairn.files.write('save/b', half)");
    CHECK(message.find("'save/b': the save folder would hold 67108876 bytes") != std::string::npos);
    CHECK(message.find("at most 67108864") != std::string::npos);
    CHECK(bench.value("cairn.files.exists('save/b')") == "false");
    CHECK(bench.run("cairn.files.write('save/a', '') cairn.files.write('save/b', half)") == "");
}

TEST_CASE("saved files are removed, in memory and on disk alike") {
    for (const bool in_memory : {true, false}) {
        INFO(in_memory);
        LuaBench bench({}, MachineKind::Headless, {.plays_saves = in_memory});
        REQUIRE(
            bench.run("cairn.files.write('save/a/one.txt', 'first') cairn.files.write('save/two.txt', '')") ==
            "");
        CHECK(bench.value("cairn.files.is_folder('save/a')") == "true");
        CHECK(bench.value("cairn.files.is_folder('save/two.txt')") == "false");
        CHECK(bench.value("cairn.files.is_folder('nowhere')") == "false");
        REQUIRE(bench.run("cairn.files.remove('save/two.txt')") == "");
        CHECK(bench.value("cairn.files.exists('save/two.txt')") == "false");
        CHECK(bench.value("cairn.files.exists('save/a/one.txt')") == "true");
        CHECK(bench.run("cairn.files.remove('save/two.txt')").find("save/two.txt") != std::string::npos);
        CHECK(bench.run("cairn.files.remove('save/a')") != "");
        CHECK(bench.run("cairn.files.remove('main.lua')").find("save/") != std::string::npos);
        CHECK(bench.run("cairn.files.remove('save/../main.lua')") != "");
        CHECK(bench.value("cairn.files.read('save/a/one.txt')") == "first");
    }
}

}  // namespace
}  // namespace cairn::scripting::test
