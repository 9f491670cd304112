#include "bridge/error_screen.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("the excerpt shows the lines around the error and marks its own") {
    LuaBench bench(GameFiles{{"src/a.lua", "one\ntwo\nthree\nfour\n\tfive\nsix\nseven\neight\nnine\n"}});
    const ErrorScreen screen = make_error_screen({"src/a.lua:5: no", {}}, *bench.machine().files);
    REQUIRE(screen.excerpt.size() == 7);
    CHECK(screen.excerpt[0].number == 2);
    CHECK(screen.excerpt[0].text == "two");
    CHECK(screen.excerpt[3].text == "    five");
    for (const SourceLine& line : screen.excerpt) CHECK(line.is_faulty == (line.number == 5));
    CHECK(screen.excerpt[6].text == "eight");
    CHECK(make_error_screen({"src/a.lua:1: no", {}}, *bench.machine().files).excerpt.size() == 4);
    CHECK(make_error_screen({"src/none.lua:1: no", {}}, *bench.machine().files).excerpt.empty());
    CHECK(make_error_screen({"no place", {}}, *bench.machine().files).excerpt.empty());
}

TEST_CASE("the excerpt shows what a script said when it was loaded, whatever its file says by now") {
    LuaBench bench(GameFiles{{"main.lua", "\nfunction fail()\n  error('old')\nend\nrequire 'helper'\n"},
                             {"helper.lua", "function help() local a = nil + 1 end"},
                             {"level.lua", "{\n  bodies = 5,\n}"}});
    REQUIRE_FALSE(bench.game().run_file("main.lua"));
    const auto save = [&](const char* name, const char* text) {
        const auto path = bench.machine().files->native_path(name);
        REQUIRE(path);
        std::ofstream(*path) << text;
    };
    save("main.lua", "-- new\n-- new\n-- new\n-- new\n");
    save("helper.lua", "-- new");
    const auto line_of = [&](const std::string& code, const std::string& expected_place) {
        REQUIRE_FALSE(load_text(bench.game().lua(), code, "test.lua"));
        const auto error = protected_call(bench.game().lua(), 0, 0);
        REQUIRE(error);
        CHECK(error->message.find(expected_place) == 0);
        for (const SourceLine& line : make_error_screen(*error, *bench.machine().files).excerpt) {
            if (line.is_faulty) return line.text;
        }
        return std::string();
    };
    CHECK(line_of("fail()", "main.lua:3: ") == "  error('old')");
    CHECK(line_of("help()", "helper.lua:1: ") == "function help() local a = nil + 1 end");
    // Data is as its file is; and so is a script that does not compile.
    CHECK(line_of("cairn.level.load 'level.lua'", "level.lua:2:") == "  bodies = 5,");
    save("main.lua", "\n\nlocal = 5\n");
    const auto error = bench.game().run_file("main.lua");
    REQUIRE(error);
    CHECK(make_error_screen(*error, *bench.machine().files).excerpt[2].text == "local = 5");
}

TEST_CASE("the screen is drawn, with text of several colors on a dark ground") {
    LuaBench bench(GameFiles{{"main.lua", "local x = nil\nx.y = 1\n"}}, MachineKind::HeadlessDrawing);
    const auto error = bench.game().run_file("main.lua");
    REQUIRE(error);
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({1, 1, 1, 1});
    draw_error_screen(make_error_screen(*error, *bench.machine().files), renderer);
    const auto image = renderer.capture();
    renderer.end_frame();
    REQUIRE(image);
    int dark = 0;
    int light = 0;
    for (int y = 0; y < image->size.height; ++y) {
        for (int x = 0; x < image->size.width; ++x) {
            const int brightness = image->pixel(x, y)[0] + image->pixel(x, y)[1] + image->pixel(x, y)[2];
            dark += brightness < 180 ? 1 : 0;
            light += brightness > 500 ? 1 : 0;
        }
    }
    CHECK(dark > image->size.width * image->size.height * 8 / 10);
    CHECK(light > 1000);
}

TEST_CASE("a source line that is too long ends before the edge of the panel") {
    std::string line = "error('x') --";
    for (int i = 0; i < 400; ++i) line += "é#";
    LuaBench bench(GameFiles{{"main.lua", line}}, MachineKind::HeadlessDrawing);
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({1, 1, 1, 1});
    draw_error_screen(make_error_screen({"main.lua:1: x", {}}, *bench.machine().files), renderer);
    const auto image = renderer.capture();
    renderer.end_frame();
    REQUIRE(image);
    int light_in_margin = 0;
    for (int y = 0; y < image->size.height; ++y) {
        for (int x = image->size.width * 15 / 16 + 1; x < image->size.width; ++x)
            light_in_margin += image->pixel(x, y)[0] > 150 ? 1 : 0;
    }
    CHECK(light_in_margin == 0);
}

engine::Image screen_of(const std::string& message, const std::string& source) {
    LuaBench bench(GameFiles{{"main.lua", source}}, MachineKind::HeadlessDrawing);
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({1, 1, 1, 1});
    draw_error_screen(make_error_screen({message, {}}, *bench.machine().files), renderer);
    auto image = renderer.capture();
    renderer.end_frame();
    REQUIRE(image);
    return *std::move(image);
}

TEST_CASE("the faulty part of a source line is seen however long the line is") {
    const auto line = [](int words_before, const std::string& fault, int words_behind) {
        std::string text = "local t = {";
        for (int i = 0; i < words_before; ++i) text += " \"wörd\",";
        text += fault;
        for (int i = 0; i < words_behind; ++i) text += " 7,";
        return text + " }";
    };
    // What differs in one place only looks different when that place is seen.
    const auto is_seen = [&](const std::string& message, int before, int behind) {
        return screen_of(message, line(before, " a.bxd.c,", behind)).rgba !=
               screen_of(message, line(before, " a.bwd.c,", behind)).rgba;
    };
    CHECK(is_seen("main.lua:1: no", 5, 10));
    CHECK(is_seen("main.lua:1: it ends in the fourth row of text", 40, 0));
    CHECK(is_seen("main.lua:1:27024: the column is said", 3000, 3000));
    CHECK(is_seen("main.lua:1: attempt to index a nil value (local 'a.b')", 3000, 3000));
    CHECK_FALSE(is_seen("main.lua:1: nothing says where it is", 3000, 3000));
    // Only the line of the fault has more rows than one.
    const std::string other = line(40, " a.bxd.c,", 0) + "\n" + line(0, "", 0);
    CHECK(screen_of("main.lua:2: no", other).rgba ==
          screen_of("main.lua:2: no", line(40, " a.bwd.c,", 0) + "\n" + line(0, "", 0)).rgba);
}

TEST_CASE("each way to choose at the screen means what its label says") {
    using engine::InputEvent;
    using engine::InputKind;
    constexpr engine::Size kScreen{1280, 720};
    const auto choice = [&](const InputEvent& event) { return choice_of(event, kScreen); };
    const auto key = [&](engine::Key pressed) {
        return choice({.kind = InputKind::KeyPressed, .key = pressed});
    };
    CHECK(key(engine::Key::R) == ErrorChoice::TryAgain);
    CHECK(key(engine::Key::F5) == ErrorChoice::TryAgain);
    CHECK(key(engine::Key::C) == ErrorChoice::Copy);
    CHECK(key(engine::Key::Escape) == ErrorChoice::Quit);
    CHECK(key(engine::Key::Space) == ErrorChoice::None);
    CHECK(choice({.kind = InputKind::QuitRequested}) == ErrorChoice::Quit);
    const auto pad = [&](engine::GamepadButton button) {
        return choice({.kind = InputKind::GamepadPressed, .number = 1, .gamepad_button = button});
    };
    CHECK(pad(engine::GamepadButton::A) == ErrorChoice::TryAgain);
    CHECK(pad(engine::GamepadButton::B) == ErrorChoice::Quit);
    // From left to right: three buttons, each of a color of its own against the ground between them.
    LuaBench bench({}, MachineKind::HeadlessDrawing);
    engine::Renderer& renderer = *bench.machine().renderer;
    renderer.begin_frame({1, 1, 1, 1});
    draw_error_screen({{"no", {}}, {}}, renderer);
    const auto image = renderer.capture();
    renderer.end_frame();
    REQUIRE(image);
    std::vector<ErrorChoice> choices;
    for (int x = 0; x < kScreen.width; ++x) {
        const int y = kScreen.height - 78;
        const auto here = choice({.kind = InputKind::MousePressed,
                                  .position = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}});
        const bool is_button = image->pixel(x, y)[0] > 45;
        CHECK(is_button == (here != ErrorChoice::None));
        if (choices.empty() || choices.back() != here) choices.push_back(here);
    }
    using enum ErrorChoice;
    CHECK(choices == std::vector{None, TryAgain, None, Copy, None, Quit, None});
}

}  // namespace
}  // namespace cairn::scripting::test
