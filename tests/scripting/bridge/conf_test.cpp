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
    CHECK(error_of("return { title = os.getenv('HOME') }").find("this file is data") != std::string::npos);
}

TEST_CASE("a byte order mark before conf.lua is skipped") {
    const auto conf = parse_conf("\xef\xbb\xbfreturn { title = \"T\" }", "conf.lua", "game");
    REQUIRE(conf);
    CHECK(conf->title == "T");
}

}  // namespace
}  // namespace cairn::scripting
