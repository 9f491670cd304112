// The camera from Lua: following, bounds, zoom, shake, and what is drawn between two updates.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const GameFiles kSmall = {{"conf.lua", "{ width = 200, height = 100 }"}};

double number(LuaBench& bench, const std::string& expression) {
    return std::stod(bench.value(expression));
}

}  // namespace

TEST_CASE("a camera follows, within its bounds") {
    LuaBench bench(kSmall);
    REQUIRE(bench.run("c = cairn.camera.new{ height = 10, follow_rate = 10 } c:set_bounds(-20, -5, 20, 50) "
                      "c:follow(30, 30) for i = 1, 300 do c:update(1 / 60) end") == "");
    CHECK(number(bench, "(c:position())") == 10);  // 20 m wide, so 10 m from the edge
    CHECK(number(bench, "select(2, c:position())") == Approx(30).margin(1e-3));
    CHECK(bench.value("table.concat({ c:visible_area() }, ' ', 1, 1)") == "0.0");
    REQUIRE(bench.run("c:follow() c:set_bounds() c:set_position(100, 0) c:update(1 / 60)") == "");
    CHECK(number(bench, "(c:position())") == 100);
}

TEST_CASE("zooming at the mouse keeps the place under it") {
    LuaBench bench(kSmall);
    REQUIRE(
        bench.run("c = cairn.camera.new{ x = 3, y = 4, height = 10, zoom = 2 } x, y = c:to_world(150, 20) "
                  "c:zoom_at(150, 20, 3) u, v = c:to_world(150, 20)") == "");
    CHECK(number(bench, "math.abs(x - u) + math.abs(y - v)") < 1e-4);
    CHECK(bench.value("c:zoom() .. ' ' .. c:height()") == "6.0 10.0");
    CHECK(number(bench, "(function() local l, b, r, t = c:visible_area() return t - b end)()") ==
          Approx(10 / 6.0));
}

TEST_CASE("a picture between two updates shows the camera between its places") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(
        bench.run("c = cairn.camera.new{ height = 10, follow_rate = 1e6 } c:follow(0, 0) c:update(1 / 60) "
                  "c:follow(10, 0) c:update(1 / 60) function cairn.draw() c:attach() x = cairn.graphics."
                  "transform_point(0, 0) c:detach() end") == "");
    bench.machine().renderer->begin_frame({});
    REQUIRE_FALSE(bench.game().draw(0.5));
    CHECK(number(bench, "x") == Approx(100 - 5 * 10).margin(0.1));
    REQUIRE_FALSE(bench.game().draw(1));
    CHECK(number(bench, "x") == Approx(100 - 10 * 10).margin(0.1));
    bench.machine().renderer->end_frame();
}

TEST_CASE("a shake moves the picture and not the position") {
    LuaBench bench(kSmall);
    REQUIRE(bench.run(
                "c = cairn.camera.new{ height = 10 } c:shake(1) moved = 0 for i = 1, 60 do c:update(1 / 60) "
                "local x, y = c:to_screen(0, 0) moved = math.max(moved, math.abs(x - 100)) end") == "");
    CHECK(number(bench, "moved") > 0.5);
    CHECK(number(bench, "moved") <= 4);  // 0.04 heights
    CHECK(bench.value("c:position()") == "0.0");
    CHECK(bench.value("(c:to_screen(0, 0))") == "100.0");
}

TEST_CASE("wrong arguments of cameras say the rule") {
    LuaBench bench(kSmall);
    REQUIRE(bench.run("c = cairn.camera.new{}") == "");
    CHECK(bench.run("c:set_zoom(0)") ==
          "test.lua:1: Camera:set_zoom: zoom is 0; expected a number above 0 and at most 1000000");
    CHECK(bench.run("c:set_bounds(1, 2, 3)").find("left, bottom, right and top") != std::string::npos);
    CHECK(bench.run("c:set_bounds(3, 0, 1, 1)").find("left is 3 and right is 1; expected left <= right") !=
          std::string::npos);
    CHECK(bench.run("c:follow(1)").find("x and y are expected") != std::string::npos);
    CHECK(bench.run("c:update(0)").find("above 0 and at most 1 s") != std::string::npos);
    CHECK(bench.run("c:shake(-1)").find("at least 0") != std::string::npos);
    CHECK(bench.run("cairn.camera.new{ zoom = -1 }").find("zoom = -1: must be above 0") != std::string::npos);
}

}  // namespace cairn::scripting::test
