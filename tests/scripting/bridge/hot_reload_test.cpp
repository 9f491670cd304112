// Saving files while a game runs, without a window: the same calls as the loop around a game makes.
#include "bridge/hot_reload.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "bridge/error_screen.h"
#include "engine/support/standard_error.h"
#include "lua/sandbox.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;

/// A game that runs, and its folder.
struct Running {
    explicit Running(const GameFiles& files, MachineKind kind = MachineKind::Headless) : folder(files) {
        auto made = make_machine(folder.source(), kind);
        REQUIRE(made);
        machine = *std::move(made);
        game = std::make_unique<Game>(machine->services(), GameOptions{});
        const auto error = game->load("main.lua", {});
        if (error) FAIL(error->message);
        reload = std::make_unique<HotReload>(folder.source(), *machine, std::vector<std::string>{});
        REQUIRE_FALSE(look());
    }

    /// Saves a file; its time differs from the one before, however coarse the file system's clock is.
    void save(const std::string& name, const std::string& text) {
        const fs::path path = fs::path(folder.path()) / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(++saves));
    }
    /// Half a second of frames.
    bool look() {
        bool has_changes = false;
        for (int frame = 0; frame < 30; ++frame) {
            now_s += 1.0 / 60;
            has_changes = reload->has_changes(now_s) || has_changes;
        }
        return has_changes;
    }
    std::string value(const std::string& expression) {
        lua_State* L = game->lua();
        REQUIRE_FALSE(load_text(L, "return " + expression, "test.lua"));
        REQUIRE_FALSE(protected_call(L, 0, 1));
        push_text(L, -1);
        std::string text = lua_tostring(L, -1);
        lua_pop(L, 2);
        return text;
    }

    GameFolder folder;
    std::unique_ptr<Machine> machine;
    std::unique_ptr<Game> game;
    std::unique_ptr<HotReload> reload;
    double now_s = 0;
    int saves = 0;
};

TEST_CASE("a watch tells of each save once, of new files, and of none that is still being written") {
    GameFolder folder(GameFiles{{"a.lua", "1"}, {"sub/b.lua", "1"}, {".git/c", "1"}});
    FileWatch watch(folder.path());
    double now_s = 0;
    const auto look = [&] { return watch.changes(now_s += FileWatch::kPeriod_s); };
    const auto save = [&](const char* name, const char* text) {
        std::ofstream(fs::path(folder.path()) / name) << text;
    };
    CHECK(look().empty());
    save("sub/b.lua", "22");
    CHECK(look().empty());  // it might go on changing
    save("sub/b.lua", "333");
    CHECK(look().empty());
    CHECK(look() == std::vector<std::string>{"sub/b.lua"});
    CHECK(look().empty());
    save(".git/c", "22");
    save("new.lua", "1");
    std::vector<std::string> told;
    for (int i = 0; i < 12; ++i) {
        for (const std::string& path : look()) told.push_back(path);
    }
    CHECK(told == std::vector<std::string>{"new.lua"});
    fs::remove(fs::path(folder.path()) / "a.lua");
    CHECK(look().empty());
    CHECK(look().empty());
    save("a.lua", "back");
    look();
    CHECK(look() == std::vector<std::string>{"a.lua"});
    // Between two looks nothing is asked of the file system.
    save("a.lua", "again");
    CHECK(watch.changes(now_s).empty());
}

const char* const kLevel = "{ bodies = { { name = 'crate', shape = 'circle', radius = 1, y = 9 }, %s } }";
std::string level_with(const std::string& more) {
    std::string text = kLevel;
    return text.replace(text.find("%s"), 2, more);
}

TEST_CASE("a saved level changes in the running world, and a fault leaves the game as it was") {
    Running run(
        {{"levels/one.lua", level_with("")},
         {"main.lua",
          "world = cairn.physics.new_world{} level = cairn.level.load 'levels/one.lua' level:build(world)\n"
          "crate = level:body('crate') starts = (starts or 0) + 1\n"
          "function cairn.level_reloaded(l) told = l == level end\n"
          "function cairn.update(dt) world:step(dt) end"}});
    for (int i = 0; i < 10; ++i) REQUIRE_FALSE(run.game->update({}));
    run.save("levels/one.lua", level_with("{ shape = 'box', width = 1, height = 1 }"));
    REQUIRE(run.look());
    auto outcome = run.reload->take_in(*run.game);
    CHECK_FALSE(outcome.error);
    CHECK_FALSE(outcome.wants_restart);
    CHECK(run.value("world:body_count() .. tostring(told) .. starts") == "2true1");
    CHECK(run.value("crate:is_valid() and select(2, crate:position()) < 9") == "true");
    CHECK_FALSE(run.look());

    run.save("levels/one.lua", level_with("{ shape = 'bix' }"));
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    REQUIRE(outcome.error);
    CHECK_THAT(outcome.error->message, Contains("did you mean \"box\"?"));
    CHECK(outcome.keeps_the_game);
    CHECK(run.value("world:body_count()") == "2");

    run.save("levels/one.lua", level_with(""));
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    CHECK_FALSE(outcome.error);
    CHECK(run.value("world:body_count()") == "1");
}

TEST_CASE("saved scripts start the game anew, unless it says what to keep") {
    const char* const plain = "runs = (runs or 0) + 1";
    Running run(GameFiles{{"main.lua", plain}});
    run.save("main.lua", "runs = (runs or 0) + 10");
    REQUIRE(run.look());
    CHECK(run.reload->take_in(*run.game).wants_restart);
    CHECK(run.value("runs") == "1");
    // What only tests and the program read is no reason.
    run.save("tests/x.lua", "");
    run.save("conf.lua", "return {}");
    CHECK_FALSE(run.look());
}

TEST_CASE("a game that says what to keep goes on with its world, by new scripts alone") {
    const auto script = [](const char* speed) {
        return std::string(
                   "local helper = require 'helper'\nlocal world, ball\n"
                   "function cairn.load() world = cairn.physics.new_world{} ball = world:add_circle{ radius "
                   "= 1 } loads = "
                   "(loads or 0) + 1 cairn.timer.every(0.1, function() ticks = (ticks or 0) + 1 end) end\n"
                   "function cairn.update(dt) world:step(dt) speed = ") +
               speed +
               " + helper end\n"
               "function cairn.before_reload() return { world = world, ball = ball } end\n"
               "function cairn.after_reload(kept) world, ball = kept.world, kept.ball end\n"
               "function height() return select(2, ball:position()) end\n"
               "function valid() return ball:is_valid() end\n";
    };
    Running run({{"main.lua", script("1") + "function cairn.key_pressed() old = true end"},
                 {"helper.lua", "return 0.5"}});
    for (int i = 0; i < 20; ++i) REQUIRE_FALSE(run.game->update({}));
    const std::string before = run.value("height()");
    const std::string ticks = run.value("ticks");
    CHECK(run.value("speed") == "1.5");

    run.save("helper.lua", "return 0.25");
    run.save("main.lua", script("2"));
    REQUIRE(run.look());
    auto outcome = run.reload->take_in(*run.game);
    if (outcome.error) FAIL(outcome.error->message);
    CHECK_FALSE(outcome.wants_restart);
    CHECK(run.value("height()") == before);
    CHECK(run.value("loads") == "1");
    CHECK(run.value("cairn.key_pressed") == "nil");
    for (int i = 0; i < 20; ++i) REQUIRE_FALSE(run.game->update({}));
    CHECK(run.value("speed") == "2.25");
    CHECK(run.value("ticks") == ticks);  // the timer went with the old scripts
    CHECK(run.value("cairn.graphics ~= nil") == "true");

    // A slip in the syntax is found before anything is given up.
    run.save("helper.lua", "return return");
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    REQUIRE(outcome.error);
    CHECK_THAT(outcome.error->message, Contains("helper.lua:1:"));
    CHECK(outcome.keeps_the_game);
    REQUIRE_FALSE(run.game->update({}));
    CHECK(run.value("speed") == "2.25");

    // An error of the new scripts themselves leaves no game, but the world for the next ones: twice, and
    // whether they fail when they run or when they take it.
    run.save("helper.lua", "error 'no'");
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    REQUIRE(outcome.error);
    CHECK_FALSE(outcome.keeps_the_game);
    const std::string low = run.value("height()");
    run.save("helper.lua", "return 0.125");
    run.save("main.lua", script("3") + "function cairn.after_reload(kept) error('no ' .. kept.word) end");
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    REQUIRE(outcome.error);
    CHECK_THAT(outcome.error->message, Contains("field 'word'"));
    CHECK(run.game->can_reload());
    run.save("main.lua", script("3"));
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game);
    if (outcome.error) FAIL(outcome.error->message);
    CHECK_FALSE(outcome.wants_restart);
    CHECK(run.value("height()") == low);
    CHECK(run.value("loads") == "1");
    REQUIRE_FALSE(run.game->update({}));
    CHECK(run.value("speed") == "3.125");

    // What was kept has been taken: the next scripts get what these say.
    run.save("main.lua", script("4"));
    REQUIRE(run.look());
    REQUIRE_FALSE(run.reload->take_in(*run.game).error);
    REQUIRE_FALSE(run.game->update({}));
    CHECK(run.value("speed") == "4.125");
    CHECK(run.value("height()") != low);
}

TEST_CASE("a file that the game does not use changes nothing, whatever is in it") {
    for (const char* keeps : {"", "function cairn.before_reload() end\n"}) {
        Running run({{"main.lua", std::string(keeps) +
                                      "runs = (runs or 0) + 1 local all = cairn.files.list 'levels'\n"
                                      "old = runs == 1 and require 'old'"},
                     {"old.lua", "return true"},
                     {"levels/one.lua", "{}"}});
        run.save("new.lua", "return return");
        run.save("data/new.json", "{");
        CHECK_FALSE(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).error);
        CHECK(run.value("runs") == "1");
        // What stands in a folder that it has listed may be of use.
        run.save("levels/two.lua", "{}");
        REQUIRE(run.look());
        auto outcome = run.reload->take_in(*run.game);
        CHECK_FALSE(outcome.error);
        CHECK(outcome.wants_restart == (*keeps == '\0'));
        if (*keeps == '\0') continue;
        // The new run has not required this one.
        CHECK(run.value("runs") == "2");
        run.save("old.lua", "return return");
        REQUIRE(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).error);
        // It is of use, and so is its fault, when a script that is used requires it.
        run.save("main.lua", std::string(keeps) + "require 'new'");
        REQUIRE(run.look());
        outcome = run.reload->take_in(*run.game);
        REQUIRE(outcome.error);
        CHECK_THAT(outcome.error->message, Contains("new.lua:1:"));
        run.save("new.lua", "new = 1");
        CHECK(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).error);
        CHECK(run.value("new") == "1");
    }
}

TEST_CASE("an error while the old scripts say what to keep is shown with their text") {
    Running run(GameFiles{{"main.lua", "\n\nfunction cairn.before_reload() error 'old' end"}});
    run.save("main.lua", "-- the first\n-- and the second\n-- and the third of the new lines");
    REQUIRE(run.look());
    const auto outcome = run.reload->take_in(*run.game);
    REQUIRE(outcome.error);
    CHECK_THAT(outcome.error->message, Contains("main.lua:3: old"));
    const ErrorScreen screen = make_error_screen(*outcome.error, *run.machine->files);
    REQUIRE(screen.excerpt.size() == 3);
    CHECK(screen.excerpt[2].text == "function cairn.before_reload() error 'old' end");
}

TEST_CASE(
    "a game that an error has ended goes on with its world by mended scripts, if it says what to keep") {
    const auto script = [](const char* update, const char* before) {
        return std::string(
                   "local world, ball\n"
                   "function cairn.load() world = cairn.physics.new_world{} "
                   "ball = world:add_circle{ radius = 1 } end\n") +
               "function cairn.update(dt) world:step(dt) " + update +
               " end\nfunction cairn.before_reload() " + before +
               " return { world = world, ball = ball } end\n"
               "function cairn.after_reload(kept) world, ball = kept.world, kept.ball end\n"
               "function height() return select(2, ball:position()) end\n"
               "function cairn.key_pressed(key) keys = (keys or '') .. key error 'no key' end\n";
    };
    Running run({{"main.lua", script("if select(2, ball:position()) < -0.1 then error 'too low' end", "")}});
    std::optional<ScriptError> error;
    for (int i = 0; i < 60 && !error; ++i) error = run.game->update({});
    REQUIRE(error);
    CHECK_THAT(error->message, Contains("too low"));
    const std::string height = run.value("height()");

    // Events of an update that failed are gone with it.
    const engine::InputEvent key{.kind = engine::InputKind::KeyPressed, .key = engine::Key::A};
    CHECK(run.game->update(std::vector{key, key}));
    CHECK(run.value("keys") == "a");
    CHECK(run.game->context().events.empty());

    run.save("main.lua", script("", "error 'no way'"));
    REQUIRE(run.look());
    auto outcome = run.reload->take_in(*run.game, true);
    if (outcome.error) FAIL(outcome.error->message);
    CHECK_FALSE(outcome.wants_restart);
    CHECK(run.value("height()") == height);
    REQUIRE_FALSE(run.game->update({}));
    CHECK(run.value("height()") != height);

    // What cannot say any more what to keep starts anew.
    run.save("main.lua", script("mended = true", ""));
    REQUIRE(run.look());
    outcome = run.reload->take_in(*run.game, true);
    CHECK_FALSE(outcome.error);
    CHECK(outcome.wants_restart);
}

TEST_CASE("that what was kept is lost is told, whether the new scripts do not take it or the old ones fail") {
    const std::string keeps = "function cairn.before_reload() return { level = 3 } end\n";
    const std::string takes = "function cairn.after_reload(kept) level = kept.level end\n";
    Running run({{"main.lua", keeps + takes}});
    const auto said_when_saving = [&](const std::string& script) {
        run.save("main.lua", script);
        REQUIRE(run.look());
        return written_to_standard_error([&] { run.reload->take_in(*run.game); });
    };
    CHECK(said_when_saving(keeps + takes + "--") == "");
    CHECK(run.value("level") == "3");
    CHECK_THAT(said_when_saving(keeps), Contains("warning") &&
                                            Contains("what cairn.before_reload returned, a table, is lost") &&
                                            Contains("no cairn.after_reload"));
    // Nothing is lost of nothing.
    CHECK_THAT(said_when_saving("function cairn.before_reload() end"), Contains("is lost"));
    CHECK(said_when_saving("function cairn.before_reload() error('slip') end") == "");
    CHECK_THAT(said_when_saving(""),
               Contains("because cairn.before_reload failed: it starts anew with the next save"));
}

TEST_CASE("images show what their files hold now; one that is damaged leaves the old picture") {
    const auto picture = [](int size) {
        engine::Image image;
        image.size = {size, size};
        image.rgba.assign(static_cast<std::size_t>(size * size) * 4, 255);
        const std::string path = (fs::temp_directory_path() / "cairn-hot-reload.png").string();
        REQUIRE(engine::save_png(image, path));
        std::ifstream file(path, std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(file)), {});
        fs::remove(path);
        return bytes;
    };
    for (const MachineKind kind : {MachineKind::Headless, MachineKind::HeadlessDrawing}) {
        Running run({{"a.png", picture(4)}, {"main.lua", "image = cairn.graphics.new_image 'a.png'"}}, kind);
        CHECK(run.value("image:width()") == "4");
        run.save("a.png", picture(6));
        REQUIRE(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).error);
        CHECK(run.value("image:width()") == "6");
        run.save("a.png", "torn");
        REQUIRE(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).error);
        CHECK(run.value("image:width()") == "6");
    }
}

TEST_CASE(
    "a file that the game has looked for in vain is taken in as soon as a change is, once it is there") {
    const char* const looks = "found = cairn.files.exists('a.txt') or cairn.files.exists('deep/b.lua')";
    for (const char* name : {"a.txt", "deep/b.lua"}) {
        Running run(GameFiles{{"main.lua", looks}});
        // However long ago it looked for new files: each half second is the first or the second of its
        // searches.
        for (int round = 0; round < 3; ++round) {
            run.save(name, std::to_string(round));
            CHECK(run.look());
            CHECK(run.reload->take_in(*run.game).wants_restart);
            fs::remove(fs::path(run.folder.path()) / name);
            CHECK_FALSE(run.look());
        }
        // What it has not looked for, and what lies outside, is nothing to it.
        run.save("c.txt", "1");
        CHECK_FALSE(run.look());
    }
}

TEST_CASE("what scripts read starts the game anew, whatever its ending; saves do not") {
    Running run({{"main.lua",
                  "text = cairn.files.read 'words.txt' rows = cairn.files.read 'TABLE.CSV'\n"
                  "data = cairn.files.read_data 'waves.dat' saved = cairn.files.exists 'save/best.txt'\n"
                  "all = cairn.files.list 'quotes'"},
                 {"words.txt", "one"},
                 {"TABLE.CSV", "1,2"},
                 {"waves.dat", "{}"},
                 {"save/best.txt", "1"},
                 {"other.txt", "1"},
                 {"quotes/first.txt", "1"},
                 {"quotes/second.txt~", "1"}});
    for (const char* name : {"words.txt", "TABLE.CSV", "waves.dat", "quotes/first.txt"}) {
        CAPTURE(name);
        run.save(name, "{ 1 }");
        CHECK(run.look());
        CHECK(run.reload->take_in(*run.game).wants_restart);
    }
    for (const char* name : {"save/best.txt", "other.txt", "quotes/second.txt~"}) {
        CAPTURE(name);
        run.save(name, "22");
        CHECK_FALSE(run.look());
    }
}

TEST_CASE("levels of any name, and images and sounds with capital endings, change in place") {
    Running run({{"levels/one.level", level_with("")},
                 {"main.lua",
                  "world = cairn.physics.new_world{} level = cairn.level.load 'levels/one.level' "
                  "level:build(world)"}});
    run.save("levels/one.level", level_with("{ shape = 'box', width = 1, height = 1 }"));
    REQUIRE(run.look());
    const auto outcome = run.reload->take_in(*run.game);
    CHECK_FALSE(outcome.error);
    CHECK_FALSE(outcome.wants_restart);
    CHECK(run.value("world:body_count()") == "2");
    for (const char* name : {"G.PNG", "g.Jpg", "G.WAV", "music.OGG"}) {
        CAPTURE(name);
        run.save(name, "1");
        run.look();
        run.save(name, "22");
        CHECK(run.look());
        CHECK_FALSE(run.reload->take_in(*run.game).wants_restart);
    }
}

}  // namespace
}  // namespace cairn::scripting::test
