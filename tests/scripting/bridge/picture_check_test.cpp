#include "bridge/picture_check.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include <cairn/scripting/test_game.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

engine::Image gray(std::uint8_t value) {
    engine::Image image{{10, 10}, std::vector<std::uint8_t>(400, value)};
    for (std::size_t i = 3; i < 400; i += 4) image.rgba[i] = 255;
    return image;
}

TEST_CASE("pictures agree up to a tolerance of color and of pixels") {
    const engine::Image approved = gray(100);
    engine::Image actual = gray(100);
    CHECK_FALSE(compare_pictures(actual, approved, {}));
    actual.rgba[4 * 33] = 110;
    CHECK_FALSE(compare_pictures(actual, approved, {.color = 0.04, .share = 0}));
    CHECK_FALSE(compare_pictures(actual, approved, {.color = 0.03, .share = 0.01}));
    const auto difference = compare_pictures(actual, approved, {.color = 0.03, .share = 0.005});
    REQUIRE(difference);
    CHECK(difference->share == Approx(0.01));
    CHECK(difference->largest == Approx(10 / 255.0));
    const auto is_red = [&](int x, int y) {
        const std::uint8_t* p = difference->picture.pixel(x, y);
        return p[0] > 200 && p[1] < 50;
    };
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) CHECK(is_red(x, y) == (x == 3 && y == 3));
    }
}

TEST_CASE("a test of a game compares what it draws with the approved picture") {
    const GameFolder folder({{"conf.lua", "{ width = 40, height = 30 }"},
                             {"main.lua",
                              "local x = 5 function cairn.key_pressed() x = 20 end "
                              "function cairn.draw() cairn.graphics.rectangle('fill', x, 5, 10, 10) end"},
                             {"tests/look.lua",
                              "cairn.test.test('looks', function() cairn.test.start{} cairn.test.run(1) "
                              "cairn.test.expect_picture('tests/pictures/start.png') end)"}});
    const std::string differences = folder.path() + "/differences";
    const auto status = [&](bool approves) {
        return test_game(folder.source(), {.approves_pictures = approves, .differences = differences});
    };
    namespace fs = std::filesystem;
    CHECK(status(false) == 1);  // there is no picture yet
    CHECK(status(true) == 0);
    CHECK(fs::exists(folder.path() + "/tests/pictures/start.png"));
    CHECK(status(false) == 0);
    CHECK_FALSE(fs::exists(differences));
    std::ofstream(folder.path() + "/main.lua")
        << "function cairn.draw() cairn.graphics.rectangle('fill', 8, 5, 10, 10) end";
    CHECK(status(false) == 1);
    CHECK(fs::exists(differences + "/start-actual.png"));
    CHECK(fs::exists(differences + "/start-difference.png"));
    std::ofstream(folder.path() + "/tests/pictures/start.png") << "no picture";
    CHECK(status(false) == 1);
}

TEST_CASE("a changed number in a corner of a large picture is a difference, unless the test allows some") {
    const auto status = [](const std::string& fields) {
        const GameFolder folder(
            {{"conf.lua", "{ width = 1280, height = 720 }"},
             {"main.lua",
              "local score = 10 function cairn.key_pressed() score = 11 end "
              "function cairn.draw() cairn.graphics.print('Score ' .. score, 8, 8) end"},
             {"tests/look.lua",
              "cairn.test.test('looks', function() cairn.test.start{} if "
              "cairn.files.exists('tests/score.png') then "
              "cairn.test.press('x') end cairn.test.run(1) cairn.test.expect_picture('tests/score.png'" +
                  fields + ") end)"}});
        const TestOptions options{.approves_pictures = false, .differences = folder.path() + "/differences"};
        TestOptions approving = options;
        approving.approves_pictures = true;
        REQUIRE(test_game(folder.source(), approving) == 0);
        return test_game(folder.source(), options);
    };
    CHECK(status("") == 1);
    CHECK(status(", { share = 0.001 }") == 0);
}

}  // namespace
}  // namespace cairn::scripting::test
