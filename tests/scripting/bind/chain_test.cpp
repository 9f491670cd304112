// Chains, sensors, one-way shapes, belts and locked axes from Lua.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using Catch::Matchers::Contains;

TEST_CASE("things stand on a chain, and it can be edited while they do") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}\n"
                      "body, chain = w:add_chain{ type = 'static', points = { { 10, 0 }, { 0, 0 }, { -10, 0 "
                      "} }, friction = 0.4 }\n"
                      "ball = w:add_circle{ x = 2, y = 0.5, radius = 0.5 }\n"
                      "for i = 1, 60 do w:step(1 / 60) end") == "");
    CHECK(bench.value("math.abs(select(2, ball:position()) - 0.5) < 0.01") == "true");
    CHECK(bench.value("chain:point_count() .. ' ' .. tostring(chain:is_closed())") == "3 false");
    CHECK(bench.value("chain:body() == body") == "true");
    CHECK(bench.value("chain:point(1)") == "10.0");
    CHECK(bench.value("chain:index_of(chain:segment(2))") == "2");
    CHECK(bench.value("chain:index_of(ball:shapes()[1])") == "nil");
    CHECK(bench.value("math.abs(chain:material(1) - 0.4) < 1e-6") == "true");
    REQUIRE(bench.run("chain:set_material(2, { friction = 0.9, surface_speed = 2 }) chain:insert_points(4, { "
                      "{ -20, 0 } })") == "");
    CHECK(bench.value("select(4, chain:material(2))") == "2.0");
    CHECK(bench.value("chain:point_count()") == "4");
    REQUIRE(bench.run("chain:set_point(2, 0, -3) for i = 1, 60 do w:step(1 / 60) end") == "");
    CHECK(bench.value("select(2, ball:position()) < 0") == "true");
    REQUIRE(bench.run("chain:remove_points(4, 1) chain:set_ends(nil, nil, -20, 0)") == "");
    CHECK_THAT(bench.run("chain:point(4)"), Contains("index is 4; expected 1 to 3"));
    CHECK_THAT(bench.run("chain:segment(3)"), Contains("segment is 3; expected 1 to 2"));
    CHECK_THAT(bench.run("chain:set_point(0, 1, 1)"), Contains("expected 1 to 3"));
    CHECK_THAT(bench.run("chain:insert_points(1, { { 1 } })"),
               Contains("points[1] is {1, nil}; expected {x, y}"));
    REQUIRE(bench.run("chain:destroy()") == "");
    CHECK(bench.value("chain:is_valid()") == "false");
    CHECK_THAT(bench.run("chain:point(1)"), Contains("this chain was destroyed"));
    CHECK_THAT(bench.run("w:add_chain{ points = { { 0, 0 } } }"), Contains("World:add_chain: "));
    CHECK_THAT(bench.run("w:add_chain{ points = { { 0, 0 }, { 1, 0 } }, before_x = 1 }"),
               Contains("belong together"));
}

TEST_CASE("a sensor notices who comes and who goes, and stops nobody") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{ gravity_y = 0 }\n"
                      "gate = w:add_box{ type = 'static', x = 2, width = 1, height = 4, sensor = true }\n"
                      "ball = w:add_circle{ radius = 0.25, linear_velocity_x = 4 }\n"
                      "seen = {}\n"
                      "for i = 1, 90 do w:step(1 / 60)\n"
                      "  for kind, sensor, visitor, s, v in w:sensor_events() do\n"
                      "    seen[#seen + 1] = kind\n"
                      "    assert(sensor == gate and visitor == ball and s == gate:shapes()[1] and v == "
                      "ball:shapes()[1])\n"
                      "    if kind == 'begin' then inside = #s:overlaps() end\n"
                      "  end\n"
                      "end") == "");
    CHECK(bench.value("table.concat(seen, ' ')") == "begin end");
    CHECK(bench.value("inside") == "1");
    CHECK(bench.value("ball:position() > 5") == "true");
    CHECK(bench.value("gate:shapes()[1]:is_sensor()") == "true");
    CHECK_THAT(bench.run("ball:shapes()[1]:overlaps()"), Contains("Shape:overlaps: "));
}

TEST_CASE("what is one-way lets through from behind and carries from in front") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}\n"
                      "plank = w:add_box{ type = 'static', y = 2, width = 4, height = 0.2, one_way_y = 1 }\n"
                      "ball = w:add_circle{ radius = 0.25, linear_velocity_y = 10 }\n"
                      "for i = 1, 180 do w:step(1 / 60) end") == "");
    CHECK(bench.value("math.abs(select(2, ball:position()) - 2.35) < 0.02") == "true");
    CHECK(bench.value("select(2, plank:shapes()[1]:one_way())") == "1.0");
    REQUIRE(bench.run("plank:shapes()[1]:set_one_way(0, -1) for i = 1, 60 do w:step(1 / 60) end") == "");
    CHECK(bench.value("select(2, ball:position()) < 2") == "true");
}

TEST_CASE("a belt carries, locked axes stay, a segment holds from both sides") {
    LuaBench bench;
    REQUIRE(
        bench.run("w = cairn.physics.new_world{ joint_solver = 'direct', threads = 2 }\n"
                  "belt = w:add_box{ type = 'static', width = 60, height = 1, surface_speed = 2 }\n"
                  "crate = w:add_box{ y = 1, width = 1, height = 1 }\n"
                  "beam = w:add_box{ y = 9, width = 1, height = 1, lock_y = true, lock_rotation = true }\n"
                  "shelf = w:add_segment{ type = 'static', x1 = 20, y1 = 3, x2 = 24, y2 = 3 }\n"
                  "on = w:add_circle{ x = 22, y = 3.25, radius = 0.25 }\n"
                  "for i = 1, 240 do w:step(1 / 60) end") == "");
    CHECK(bench.value("math.abs(crate:linear_velocity() - 2) < 0.01") == "true");
    CHECK(bench.value("math.abs(select(2, beam:position()) - 9) < 1e-9") == "true");
    CHECK(bench.value("select(2, beam:locks())") == "true");
    CHECK(bench.value("math.abs(select(2, on:position()) - 3.25) < 0.01") == "true");
    CHECK(bench.value("shelf:shapes()[1]:kind()") == "segment");
    REQUIRE(bench.run("beam:set_locks(false, false, false) for i = 1, 30 do w:step(1 / 60) end "
                      "crate:shapes()[1]:set_material{ friction = 0, rolling_resistance = 0.1 }") == "");
    CHECK(bench.value("select(2, beam:position()) < 8.5") == "true");
    CHECK(bench.value("math.abs(crate:shapes()[1]:material().rolling_resistance - 0.1) < 1e-6") == "true");
    CHECK_THAT(bench.run("w:add_circle{ radius = 1, material_kind = 64 }"),
               Contains("material_kind = 64: must be from 0 to 63"));
    CHECK_THAT(bench.run("cairn.physics.new_world{ joint_solver = 'drect' }"),
               Contains("no such joint solver; did you mean \"direct\"?"));
    CHECK_THAT(bench.run("cairn.physics.new_world{ threads = 0 }"),
               Contains("threads = 0: must be from 1 to 64"));
}

}  // namespace
}  // namespace cairn::scripting::test
