// Virtual files: what can be seen, what is refused, and that saving replaces a file in one stroke.
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <cairn/engine/files.h>

#include "engine/support/file_size_limit.h"
#include "engine/support/temporary_folder.h"

using namespace cairn::engine;

namespace {

std::unique_ptr<Files> make_files(const FilesDef& def = {}) {
    auto files = Files::create(def);
    REQUIRE(files);
    return std::move(*files);
}

template <typename T>
std::string error_of(const Result<T>& result) {
    return result ? "" : result.error().message;
}

}  // namespace

TEST_CASE("a path that could leave its mount is refused with the rule that it breaks") {
    const auto reason = [](std::string_view path) { return error_of(check_virtual_path(path)); };
    CHECK_THAT(reason("../secret"), Catch::Contains("'../secret'") && Catch::Contains("'..'"));
    CHECK_THAT(reason("a/../b"), Catch::Contains("'a/../b'"));
    CHECK_THAT(reason("a/.."), Catch::Contains("'..'"));
    CHECK_THAT(reason("./a"), Catch::Contains("'.'"));
    CHECK_THAT(reason("/etc/passwd"), Catch::Contains("absolute"));
    CHECK_THAT(reason("a\\b"), Catch::Contains("'/'"));
    CHECK_THAT(reason("C:/a"), Catch::Contains("':'"));
    CHECK_THAT(reason(std::string_view("a\0b", 3)), Catch::Contains("NUL") && Catch::Contains("a\\0b"));
    CHECK_THAT(reason("a\nb"), Catch::Contains("control"));
    CHECK_THAT(reason("a//b"), Catch::Contains("'//'"));
    CHECK_THAT(reason("a/"), Catch::Contains("end in '/'"));
    CHECK_THAT(reason(std::string(2000, 'a')), Catch::Contains("1024"));
    for (const char* good :
         {"", "a", "main.lua", "levels/level 01.lua", "a.b/..c/d..", "\xc3\xa4/\xe2\x82\xac.png"})
        CHECK(check_virtual_path(good));
}

TEST_CASE("a file counts as asked for when it was read, looked for or listed, be it there or not") {
    TemporaryFolder game;
    game.put("read.lua", "1");
    game.put("data/one.json", "1");
    game.put("other/two.json", "1");
    const auto files = make_files();
    REQUIRE(files->mount(game.path().string()));
    CHECK_FALSE(files->was_asked_for("read.lua"));
    CHECK(files->read_text("read.lua"));
    CHECK_FALSE(files->read_bytes("gone.lua"));
    CHECK_FALSE(files->exists("maybe.lua"));
    CHECK(files->list("data"));
    for (const char* path : {"read.lua", "gone.lua", "maybe.lua", "data/one.json", "data/new.json"})
        CHECK(files->was_asked_for(path));
    for (const char* path : {"new.lua", "other/two.json", "data/below/new.json", "rea"})
        CHECK_FALSE(files->was_asked_for(path));
    CHECK(files->asked_for() ==
          std::set<std::string, std::less<>>{"read.lua", "gone.lua", "maybe.lua", "data"});
}

TEST_CASE("files of a mounted folder are read, listed and told apart from folders") {
    TemporaryFolder game;
    game.put("main.lua", "print 'hello'");
    game.put("levels/b.lua", "");
    game.put("levels/a.lua", std::string_view("x\0y", 3));
    const auto files = make_files();
    REQUIRE(files->mount(game.path().string()));

    CHECK(*files->read_text("main.lua") == "print 'hello'");
    CHECK(files->read_text("levels/a.lua")->size() == 3);
    CHECK(files->read_bytes("levels/b.lua")->empty());
    CHECK(*files->list("levels") == std::vector<std::string>{"a.lua", "b.lua"});
    CHECK(*files->list("") == std::vector<std::string>{"levels", "main.lua"});
    CHECK(*files->kind("levels") == FileKind::Folder);
    CHECK(*files->kind("main.lua") == FileKind::File);
    CHECK(files->exists("main.lua"));
    CHECK_FALSE(files->exists("nosuch.lua"));
    CHECK(*files->native_path("levels/a.lua") == (game.path() / "levels/a.lua").string());
}

TEST_CASE("what cannot be read gives an error that names the path") {
    TemporaryFolder game;
    game.put("folder/file", "0123456789");
    FilesDef def;
    def.max_file_bytes = 9;
    const auto files = make_files(def);
    REQUIRE(files->mount(game.path().string()));
    CHECK_THAT(error_of(files->read_text("nosuch.lua")),
               Catch::Contains("'nosuch.lua'") && Catch::Contains("not found"));
    CHECK_THAT(error_of(files->read_text("folder")),
               Catch::Contains("'folder'") && Catch::Contains("is a folder"));
    CHECK_THAT(error_of(files->read_text("folder/file")),
               Catch::Contains("10 bytes") && Catch::Contains("at most 9"));
    CHECK_THAT(error_of(files->list("folder/file")), Catch::Contains("is not a folder"));
    CHECK_THAT(error_of(files->mount("/no/such/folder")), Catch::Contains("'/no/such/folder'"));
    CHECK_FALSE(files->read_text("../" + game.path().filename().string() + "/folder/file"));
}

TEST_CASE("symbolic links out of a mount are not followed") {
    TemporaryFolder outside;
    outside.put("secret", "s");
    TemporaryFolder game;
    game.put("main.lua", "");
    std::filesystem::create_symlink(outside.path() / "secret", game.path() / "link");
    std::filesystem::create_directory_symlink(outside.path(), game.path() / "door");
    const auto files = make_files();
    REQUIRE(files->mount(game.path().string()));
    CHECK_FALSE(files->read_text("link"));
    CHECK_FALSE(files->read_text("door/secret"));
}

TEST_CASE("mounts have an order and a place") {
    TemporaryFolder game, shared, mod;
    game.put("a", "game");
    shared.put("a", "shared");
    shared.put("b", "shared");
    mod.put("a", "mod");
    const auto files = make_files();
    REQUIRE(files->mount(game.path().string()));
    REQUIRE(files->mount(shared.path().string()));
    CHECK(*files->read_text("a") == "game");
    CHECK(*files->read_text("b") == "shared");
    REQUIRE(files->mount(mod.path().string(), "", MountOrder::First));
    CHECK(*files->read_text("a") == "mod");
    REQUIRE(files->unmount(mod.path().string()));
    CHECK(*files->read_text("a") == "game");
    REQUIRE(files->mount(mod.path().string(), "mods/one"));
    CHECK(*files->read_text("mods/one/a") == "mod");
    CHECK(*files->native_path("mods/one/a") == (mod.path() / "a").string());
}

TEST_CASE("saved files survive the program and leave nothing unfinished") {
    TemporaryFolder root;
    FilesDef def;
    def.identity = "test-game";
    def.save_root = root.path().string();
    {
        const auto files = make_files(def);
        CHECK(files->save_folder() == (root.path() / "test-game").string());
        CHECK_FALSE(std::filesystem::exists(files->save_folder()));
        CHECK(*files->kind("save") == FileKind::Folder);
        CHECK(files->list("save")->empty());
        REQUIRE(files->write("save/best.lua", "first and longer"));
        REQUIRE(files->write("save/best.lua", "second"));
        REQUIRE(files->write("save/runs/one", "1"));
        CHECK(*files->read_text("save/best.lua") == "second");
        CHECK(*files->list("save") == std::vector<std::string>{"best.lua", "runs"});
    }
    const auto files = make_files(def);
    CHECK(*files->read_text("save/best.lua") == "second");
    REQUIRE(files->remove("save/best.lua"));
    CHECK_FALSE(files->exists("save/best.lua"));
    CHECK_THAT(error_of(files->remove("save/best.lua")), Catch::Contains("'save/best.lua'"));
}

TEST_CASE("a write that fails leaves the old contents") {
    TemporaryFolder root;
    FilesDef def;
    def.identity = "test-game";
    def.save_root = root.path().string();
    const auto files = make_files(def);
    REQUIRE(files->write("save/best.lua", "old"));
    // Something in the way of the unfinished file stops the write half-way, for every user, root included.
    std::filesystem::create_directory(root.path() / "test-game/best.lua.unfinished");
    CHECK_FALSE(files->write("save/best.lua", "new"));
    CHECK(*files->read_text("save/best.lua") == "old");
}

TEST_CASE("nothing outside of the save folder can be written") {
    TemporaryFolder root;
    TemporaryFolder game;
    game.put("main.lua", "original");
    FilesDef def;
    def.identity = "test-game";
    def.save_root = root.path().string();
    const auto files = make_files(def);
    REQUIRE(files->mount(game.path().string()));
    CHECK_THAT(error_of(files->write("main.lua", "x")),
               Catch::Contains("'main.lua'") && Catch::Contains("'save/'"));
    CHECK_FALSE(files->write("save/../main.lua", "x"));
    CHECK_FALSE(files->write("save", "x"));
    CHECK_FALSE(files->write("savegame", "x"));
    CHECK_FALSE(files->remove("main.lua"));
    CHECK(*files->read_text("main.lua") == "original");
}

TEST_CASE("a save that does not fit says how much did, and the old one stays") {
    TemporaryFolder root;
    FilesDef def;
    def.identity = "test-game";
    def.save_root = root.path().string();
    const auto files = make_files(def);
    REQUIRE(files->write("save/best.lua", "old"));
    CHECK_FALSE(files->exists("save/nosuch"));  // leaves "not found" as PhysFS's last error
    {
        const FileSizeLimit full(4096);
        const std::string message = error_of(files->write("save/best.lua", std::string(10'000, 'x')));
        CHECK_THAT(message, Catch::Contains("of 10000 bytes were written; is the disk full?") &&
                                Catch::Contains("'save/best.lua'"));
    }
    CHECK(*files->read_text("save/best.lua") == "old");
    CHECK(*files->list("save") == std::vector<std::string>{"best.lua"});
}

TEST_CASE("the longest name that file systems know can be saved, a longer one is refused") {
    TemporaryFolder root;
    FilesDef def;
    def.identity = "test-game";
    def.save_root = root.path().string();
    const auto files = make_files(def);
    for (const std::string folder : {"save/", "save/runs/"}) {
        const std::string longest = folder + std::string(255, 'n');
        REQUIRE(files->write(longest, "text"));
        CHECK(*files->read_text(longest) == "text");
        CHECK_THAT(error_of(files->write(longest + "n", "text")),
                   Catch::Contains("no longer than 255 bytes"));
    }
}

TEST_CASE("a save folder needs a name that is a plain file name") {
    for (const char* bad : {"../up", "a/b", ".hidden", "a b", "a\\b"}) {
        FilesDef def;
        def.identity = bad;
        def.save_root = "unused";
        CHECK_THAT(error_of(Files::create(def)), Catch::Contains(bad));
    }
    const auto files = make_files();
    CHECK_THAT(error_of(files->write("save/a", "x")), Catch::Contains("no identity"));
}

TEST_CASE("without a place for saves everything works but saving") {
    const auto value_of = [](const char* name) -> std::optional<std::string> {
        const char* value = std::getenv(name);
        return value ? std::optional<std::string>(value) : std::nullopt;
    };
    const auto home = value_of("HOME");
    const auto data = value_of("XDG_DATA_HOME");
    unsetenv("HOME");
    unsetenv("XDG_DATA_HOME");
    {
        TemporaryFolder game;
        game.put("main.lua", "text");
        FilesDef def;
        def.identity = "homeless";
        const auto files = make_files(def);
        REQUIRE(files->mount(game.path().string()));
        CHECK(*files->read_text("main.lua") == "text");
        CHECK_FALSE(files->exists("save/best"));
        CHECK_THAT(error_of(files->write("save/best", "1")),
                   Catch::Contains("'save/best'") && Catch::Contains("HOME"));
    }
    if (home) setenv("HOME", home->c_str(), 1);
    if (data) setenv("XDG_DATA_HOME", data->c_str(), 1);
}

TEST_CASE("the modification time changes when a file is saved again") {
    TemporaryFolder game;
    game.put("main.lua", "1");
    const auto files = make_files();
    REQUIRE(files->mount(game.path().string()));
    const auto path = game.path() / "main.lua";
    const auto before = *files->modified_ns("main.lua");
    // Set, not waited for: 5 ms later, less than PhysFS itself could tell.
    std::filesystem::last_write_time(path,
                                     std::filesystem::last_write_time(path) + std::chrono::milliseconds(5));
    CHECK(*files->modified_ns("main.lua") - before == 5'000'000);
    CHECK_FALSE(files->modified_ns("nosuch"));
}

TEST_CASE("a process has one Files at a time") {
    const auto files = make_files();
    CHECK_THAT(error_of(Files::create({})), Catch::Contains("another Files"));
}
