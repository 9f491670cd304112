#include "debug/time_control.h"

#include <catch2/catch.hpp>

namespace cairn::scripting::test {
namespace {

using engine::Key;

TEST_CASE("at first a game goes on in real time") {
    TimeControl time;
    CHECK(time.game_time_s(0.5) == 0.5);
    CHECK(time.label().empty());
    CHECK_FALSE(time.press(Key::F5));
    CHECK_FALSE(time.press(Key::Space));
}

TEST_CASE("a pause lets no time pass, and each step is given out once") {
    TimeControl time;
    REQUIRE(time.press(Key::F7));
    REQUIRE(time.press(Key::F7));
    CHECK(time.is_paused());
    CHECK(time.game_time_s(0.5) == 0);
    CHECK(time.take_steps() == 2);
    CHECK(time.take_steps() == 0);
    CHECK(time.label() == "paused");
    REQUIRE(time.press(Key::F6));
    CHECK_FALSE(time.is_paused());
    CHECK(time.game_time_s(0.5) == 0.5);
}

TEST_CASE("time goes back while the key is held, and then the game waits") {
    TimeControl time;
    REQUIRE(time.press(Key::F4));
    CHECK(time.goes_back());
    CHECK(time.game_time_s(0.5) == 0.5);  // the past goes by at the same speed
    CHECK(time.label() == "going back");
    time.release(Key::F6);
    CHECK(time.goes_back());
    time.release(Key::F4);
    CHECK_FALSE(time.goes_back());
    CHECK(time.is_paused());
    time.press(Key::F6);
    time.release(Key::F4);  // of a press that nobody saw
    CHECK_FALSE(time.is_paused());
}

TEST_CASE("speeds double and halve within bounds, and come back to one exactly") {
    TimeControl time;
    time.press(Key::F8);
    time.press(Key::F8);
    CHECK(time.game_time_s(1) == 0.25);
    CHECK(time.label() == "speed 1/4");
    for (int i = 0; i < 10; ++i) time.press(Key::F8);
    CHECK(time.speed() == 1.0 / 16);
    for (int i = 0; i < 4; ++i) time.press(Key::F9);
    CHECK(time.speed() == 1);
    for (int i = 0; i < 10; ++i) time.press(Key::F9);
    CHECK(time.speed() == 4);
    time.press(Key::F6);
    CHECK(time.label() == "paused, speed 4");
}

}  // namespace
}  // namespace cairn::scripting::test
