// What the profiler is told, by counts that are known.
#include "debug/frame_meter.h"

#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("a meter that is off measures nothing and leaves the worlds alone") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} w:add_box{ width = 1, height = 1 } w:step(1 / 60)") ==
            "");
    FrameMeter meter;
    for (int i = 0; i < 3; ++i) meter.end_frame(bench.game().context(), 0);
    CHECK(meter.history().empty());
    CHECK(meter.mean().frame_ms == 0);
}

TEST_CASE("physics counts once for each step that was made, and stages add up to it") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} for i = 1, 50 do w:add_box{ y = 2 * i, width = 1, "
                      "height = 1 } end") == "");
    FrameMeter meter;
    meter.turn(true, bench.game().context());
    meter.end_frame(bench.game().context(), 0);
    REQUIRE(bench.run("w:step(1 / 60)") == "");
    meter.end_frame(bench.game().context(), 100);
    meter.end_frame(bench.game().context(), 350);  // without a step
    const std::vector<FrameFigures> frames = meter.history();
    REQUIRE(frames.size() == 2);
    CHECK(frames[0].physics_ms > 0);
    CHECK(frames[0].stages.total_ms() == Approx(frames[0].physics_ms));
    CHECK(frames[1].physics_ms == 0);
    CHECK(frames[0].lua_allocated == 100);
    CHECK(frames[1].lua_allocated == 250);
}

TEST_CASE("a meter that ends leaves worlds measuring whose script wants it, and only those") {
    LuaBench bench;
    REQUIRE(bench.run(
                "w1, w2 = cairn.physics.new_world{}, cairn.physics.new_world{} w1:set_profiling(true) "
                "function measured(w) for i = 1, 200 do w:add_circle{ x = 2 * i, radius = 0.5 } end "
                "local before = w:report().stages w:step(1 / 60) "
                "for name, ms in pairs(w:report().stages) do if ms ~= before[name] then return true end end "
                "return false end") == "");
    FrameMeter meter;
    meter.turn(true, bench.game().context());
    meter.end_frame(bench.game().context(), 0);
    CHECK(bench.value("measured(w2)") == "true");
    meter.turn(false, bench.game().context());
    CHECK(bench.value("measured(w1)") == "true");
    CHECK(bench.value("measured(w2)") == "false");
}

TEST_CASE("the history holds the last frames, oldest first") {
    LuaBench bench;
    FrameMeter meter;
    meter.turn(true, bench.game().context());
    std::uint64_t allocated = 0;
    for (std::uint64_t i = 0; i <= FrameMeter::kHistory + 10; ++i)
        meter.end_frame(bench.game().context(), allocated += i);
    const std::vector<FrameFigures> frames = meter.history();
    REQUIRE(frames.size() == FrameMeter::kHistory);
    for (std::size_t i = 0; i < frames.size(); ++i) CHECK(frames[i].lua_allocated == i + 11);
}

TEST_CASE("the state counts what scripts allocate, garbage too") {
    LuaBench bench;
    const auto allocated = [&] { return bench.game().state().allocated_bytes(); };
    REQUIRE(bench.run("function make() for i = 1, 1000 do local t = { i } end end make()") == "");
    const std::uint64_t before = allocated();
    REQUIRE(bench.run("make() collectgarbage()") == "");
    CHECK(allocated() - before >= 1000 * (56 + 16));  // a table, and a place in it
}

}  // namespace
}  // namespace cairn::scripting::test
