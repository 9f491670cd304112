#include "bridge/conf.h"

#include <catch2/catch.hpp>

namespace cairn::scripting {
namespace {

TEST_CASE("a game without conf.lua is called as its folder") {
    const Conf conf = default_conf("my game");
    CHECK(conf.title == "my game");
    CHECK(conf.identity == "my_game");
    CHECK(conf.size == engine::Size{1280, 720});
}

TEST_CASE("conf.lua is read as data") {
    const auto conf = parse_conf(
        "return { title = 'T', identity = 'id', width = 640, height = 360, resizable = false, "
        "background = { 0, 0.5, 1 } }",
        "conf.lua", "x");
    REQUIRE(conf);
    CHECK(conf->title == "T");
    CHECK(conf->identity == "id");
    CHECK(conf->size == engine::Size{640, 360});
    CHECK_FALSE(conf->is_resizable);
    CHECK(conf->background == engine::Color{0, 0.5f, 1, 1});
    CHECK(conf->updates_per_second == 60);
}

TEST_CASE("conf.lua says all that a window can be made with") {
    const auto conf = parse_conf(
        "return { width = 320, height = 180, window_width = 1280, window_height = 720, fullscreen = true, "
        "high_dpi = false, vsync = false }",
        "conf.lua", "x");
    REQUIRE(conf);
    const engine::WindowDef window = conf->window();
    CHECK(window.size == engine::Size{320, 180});
    CHECK(window.window_size == engine::Size{1280, 720});
    CHECK(window.is_fullscreen);
    CHECK_FALSE(window.is_high_dpi);
    CHECK_FALSE(window.has_vsync);
    CHECK(window.is_resizable);
    CHECK(window.scaling == engine::WindowScaling::Fit);
    const auto following = parse_conf("return { scaling = 'follow' }", "conf.lua", "x");
    REQUIRE(following);
    CHECK(following->window().scaling == engine::WindowScaling::Follow);
    CHECK_FALSE(following->window().window_size);
}

TEST_CASE("slips in conf.lua are named with line and rule") {
    const auto error_of = [](const char* text) {
        const auto conf = parse_conf(text, "conf.lua", "x");
        return conf ? std::string() : conf.error().message;
    };
    CHECK(error_of("return {\n  widht = 3 }")
              .find("conf.lua:2: widht: unknown field; did you mean \"width\"?") == 0);
    CHECK(error_of("return { width = 0 }") == "conf.lua:1: width = 0: must be at least 1");
    CHECK(error_of("return { width = 1e9 }").find("must be an integer") != std::string::npos);
    CHECK(error_of("return { background = { 1, 2 } }").find("conf.lua:1: background") == 0);
    CHECK(error_of("return { scaling = 'folow' }").find("did you mean \"follow\"?") != std::string::npos);
    CHECK(error_of("return { window_height = 9000 }") ==
          "conf.lua:1: window_height = 9000: must be at most 8192");
    CHECK(error_of("return { scaling = 'follow', window_width = 5 }")
              .find("conf.lua:1: window_width = 5: is without meaning when scaling = \"follow\"") == 0);
    CHECK(error_of("return { updates_per_second = 9 }") ==
          "conf.lua:1: updates_per_second = 9: must be at least 10");
    CHECK(error_of("return { updates_per_second = 241 }") ==
          "conf.lua:1: updates_per_second = 241: must be at most 240");
    CHECK(error_of("return { title = os.getenv('HOME') }").find("this file is data") != std::string::npos);
}

TEST_CASE("a check of conf.lua tells what its fields say together in the same run as their own slips") {
    const std::vector<std::string> faults = faults_of_conf(
        "return {\n  scaling = 'follow',\n  window_width = 5, window_height = 0,\n  title = 7,\n}",
        "conf.lua");
    REQUIRE(faults.size() == 4);
    CHECK(faults[0] == "conf.lua:3: window_height = 0: must be at least 1");
    CHECK(faults[1] == "conf.lua:4: title = 7: must be a string, is an integer");
    CHECK(faults[2].find("conf.lua:3: window_width = 5: is without meaning") == 0);
    CHECK(faults[3].find("conf.lua:3: window_height = 0: is without meaning") == 0);
    const std::vector<std::string> mixed = faults_of_conf(
        "return {\n  title = os.getenv('HOME'),\n  width = 2 * 640,\n  hight = 5,\n}", "conf.lua");
    REQUIRE(mixed.size() == 3);
    CHECK(mixed[0].find("conf.lua:2:11: \"os\" is a name") == 0);
    CHECK(mixed[1].find("conf.lua:3:13: expected , or }") == 0);
    CHECK(mixed[2].find("conf.lua:4: hight: unknown field; did you mean \"height\"?") == 0);
}

TEST_CASE("a byte order mark before conf.lua is skipped") {
    const auto conf = parse_conf("\xef\xbb\xbfreturn { title = \"T\" }", "conf.lua", "game");
    REQUIRE(conf);
    CHECK(conf->title == "T");
}

TEST_CASE("an identity that cannot name a folder is a fault with its place") {
    const std::string rule =
        ": names the save folder, so it must be at most 64 letters, digits, '-', '_' or '.', and not start "
        "with '.'";
    for (const std::string identity : {"a/b:c", ".hidden", "a b"}) {
        const std::string fault = "conf.lua:2: identity = \"" + identity + "\"" + rule;
        const std::string text = "{\n identity = \"" + identity + "\" }";
        CHECK(faults_of_conf(text, "conf.lua") == std::vector<std::string>{fault});
        const auto conf = parse_conf(text, "conf.lua", "game");
        REQUIRE_FALSE(conf);
        CHECK(conf.error().message == fault);
    }
}

}  // namespace
}  // namespace cairn::scripting
