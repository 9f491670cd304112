#include "bind/timers.h"

#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("times become whole updates, at least one") {
    CHECK(Timers::frames_of(0) == 1);
    CHECK(Timers::frames_of(1) == 60);
    CHECK(Timers::frames_of(0.1) == 6);
    CHECK(Timers::frames_of(0.11) == 7);
    CHECK(Timers::frames_of(1e300) == 1000000000000000u);
}

void run(LuaBench& bench, int frames) {
    for (int i = 0; i < frames; ++i) {
        const auto error = bench.game().update({});
        if (error) FAIL(error->message);
    }
}

TEST_CASE("timers run in the update that is due, in the order of their making") {
    LuaBench bench;
    REQUIRE(bench.run("log = '' local function note(text) return function() log = log .. text .. "
                      "cairn.timer.frame() .. ' ' end end "
                      "cairn.timer.after(0.1, note('b')) cairn.timer.after(0.05, note('a')) "
                      "cairn.timer.after(0.1, note('c')) "
                      "cairn.timer.every(0.05, note('e')) cairn.timer.after(0, note('z'))") == "");
    run(bench, 6);
    CHECK(bench.value("log") == "z1 a3 e3 b6 c6 e6 ");
    CHECK(bench.value("cairn.timer.time()") == "0.1");
}

TEST_CASE("with another step, seconds are as many updates as conf.lua says") {
    for (const int rate : {10, 24, 60, 120, 240}) {
        INFO(rate << " updates per second");
        LuaBench bench({{"conf.lua", "return { updates_per_second = " + std::to_string(rate) + " }"}});
        REQUIRE(bench.run("log, slide = '', { x = 0 }\n"
                          "cairn.timer.after(1, function() log = log .. cairn.timer.frame() end)\n"
                          "cairn.tween.to(slide, { x = 1 }, 2, { ease = 'linear' })\n"
                          "world = cairn.physics.new_world{} ball = world:add_circle{ y = 100, radius = 1 }\n"
                          "function cairn.update(dt) step = dt world:step(dt) end") == "");
        run(bench, 2 * rate);
        CHECK(bench.value("log") == std::to_string(rate));
        CHECK(bench.value("slide.x") == "1.0");
        CHECK(bench.value("cairn.timer.time()") == "2.0");
        CHECK(bench.value("step == 1 / " + std::to_string(rate)) == "true");
        // After 2 s of free fall from rest: 100 - 10 * 2^2 / 2, whatever the step (decision 002).
        CHECK(std::stod(bench.value("select(2, ball:position())")) == Approx(80).epsilon(1e-5));
    }
}

TEST_CASE(
    "what is called again and again keeps its mean rate, whatever the update, but for one call in each") {
    struct Case {
        const char* period_s;
        int calls_in_10_s;
    };
    const Case c = GENERATE(Case{"0.025", 400}, Case{"0.04", 250}, Case{"1 / 7", 70}, Case{"0.1", 100},
                            Case{"1 / 60", 600}, Case{"0.001", 600}, Case{"0", 600}, Case{"7", 1});
    LuaBench bench;
    REQUIRE(bench.run(std::string("calls, longest, last = 0, 0, 0 cairn.timer.every(") + c.period_s +
                      ", function() local now = cairn.timer.frame() longest = math.max(longest, now - last) "
                      "last = now calls = calls + 1 end)") == "");
    run(bench, 600);
    INFO("every " << c.period_s);
    CHECK(bench.value("calls") == std::to_string(c.calls_in_10_s));
    const double period = std::stod(bench.value(std::string(c.period_s) + " + 0.0"));
    CHECK(std::stod(bench.value("longest")) <= std::max(60 * period, 1.0) + 1);
}

TEST_CASE("timers end by cancel, by false, and after once") {
    LuaBench bench;
    REQUIRE(bench.run("n, m, k = 0, 0, 0 t = cairn.timer.every(1 / 60, function() n = n + 1 if n == 3 then "
                      "t:cancel() end end) "
                      "cairn.timer.every(1 / 60, function() m = m + 1 return m < 2 end) "
                      "local c = cairn.timer.after(1 / 60, function() k = 1 end) c:cancel() c:cancel()") ==
            "");
    run(bench, 10);
    CHECK(bench.value("n .. ' ' .. m .. ' ' .. k") == "3 2 0");
}

TEST_CASE("a timer that cancels itself and returns false ends once, and others keep their actions") {
    LuaBench bench;
    REQUIRE(bench.run("log = '' t = cairn.timer.every(1 / 60, function() t:cancel() return false end) "
                      "cairn.timer.after(2 / 60, function() "
                      "for i = 1, 4 do cairn.timer.after(1 / 60, function() log = log .. i end) end end)") ==
            "");
    run(bench, 5);
    CHECK(bench.value("log") == "1234");
}

TEST_CASE("an error in a timer is the game's error, and forgotten timers meet a cap") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.timer.after(0, function() error('late') end)") == "");
    const auto error = bench.game().update({});
    REQUIRE(error);
    CHECK(error->message == "test.lua:1: late");
    CHECK(bench.run("for i = 1, 20000 do cairn.timer.after(1, print) end")
              .find("10000 timers are waiting already") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
