#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include <cairn/engine/log.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("a ball falls as the formula says") {
    LuaBench bench;
    REQUIRE(
        bench.run("w = cairn.physics.new_world{ gravity_y = -10 } b = w:add_circle{ y = 100, radius = 0.5 } "
                  "for i = 1, 60 do w:step(1 / 60) end x, y = b:position() vx, vy = b:linear_velocity()") ==
        "");
    CHECK(std::stod(bench.value("y")) == Approx(100 - 0.5 * 10).margin(1e-4));
    CHECK(std::stod(bench.value("vy")) == Approx(-10).margin(1e-4));
    CHECK(bench.value("w:step_count()") == "60");
}

TEST_CASE("the same scene has the same hash, another one another") {
    LuaBench bench;
    REQUIRE(
        bench.run("function hash(x) local w = cairn.physics.new_world{} w:add_box{ x = x, y = 3, width = 1, "
                  "height = 1 } "
                  "w:add_box{ type = 'static', width = 10, height = 1 } for i = 1, 100 do w:step(1 / 60) end "
                  "return w:state_hash() end") == "");
    CHECK(bench.value("hash(0.25) == hash(0.25)") == "true");
    CHECK(bench.value("hash(0.25) == hash(0.26)") == "false");
    CHECK(bench.value("#hash(0)") == "16");
}

TEST_CASE("counts and lists tell what is there") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{} a = w:add_box{ type = 'static', width = 10, height = 1 } "
            "b = w:add_box{ y = 2, width = 1, height = 1 } c = w:new_body{ type = 'kinematic', y = 9 }") ==
        "");
    CHECK(bench.value("w:body_count()") == "3");
    CHECK(bench.value("#w:bodies()") == "3");
    CHECK(bench.value("w:bodies()[1] == a and w:bodies()[2] == b and w:bodies()[3] == c") == "true");
    REQUIRE(bench.run("for i = 1, 300 do w:step(1 / 60) end") == "");
    CHECK(bench.value("w:contact_count()") == "1");
    CHECK(bench.value("b:is_awake()") == "false");
}

TEST_CASE("points and rays find bodies") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} b = w:add_box{ x = 5, width = 2, height = 2, type = "
                      "'static', categories = 2 }") == "");
    CHECK(bench.value("w:body_at(5.9, 0) == b") == "true");
    CHECK(bench.value("select(2, w:body_at(5.9, 0)) == b:shapes()[1]") == "true");
    CHECK(bench.value("w:body_at(6.1, 0)") == "nil");
    CHECK(bench.run("body, x, y, nx, ny, f = w:cast_ray(0, 0, 10, 0)") == "");
    CHECK(bench.value("body == b") == "true");
    CHECK(std::stod(bench.value("x")) == Approx(4).margin(1e-4));
    CHECK(std::stod(bench.value("nx")) == Approx(-1).margin(1e-5));
    CHECK(std::stod(bench.value("f")) == Approx(0.4).margin(1e-4));
    CHECK(bench.value("w:cast_ray(0, 0, 10, 0, 1)") == "nil");
    CHECK(bench.value("w:cast_ray(0, 0, 10, 0, 2) == b") == "true");
    CHECK(bench.value("w:cast_ray(0, 5, 10, 5)") == "nil");
}

TEST_CASE("errors of the physics arrive with the place of the call and leave the world as it was") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}") == "");
    for (const char* call :
         {"w:add_polygon{ points = { {0, 0}, {1, 0} } }", "w:add_circle{ radius = -1 }",
          "w:add_box{ width = 0/0, height = 1 }", "w:add_box{ x = 1/0, width = 1, height = 1 }",
          "w:add_circle{ radius = 1, density = -1 }", "w:add_circle{ radius = 1, data = 5 }",
          "w:add_circle{ radius = 1, restitution = 'a' }",
          "w:add_polygon{ points = { {0, 0}, {1, 'a'}, {0, 1} } }",
          "w:add_polygon{ points = { 1, 2, 3 } }"}) {
        INFO(call);
        const std::string message = bench.run(call);
        CHECK(message.find("test.lua:1: World:add_") == 0);
        CHECK(bench.value("w:body_count()") == "0");
    }
    CHECK(bench.run("w:step(-1)").find("test.lua:1: World:step: ") == 0);
    CHECK(bench.run("cairn.physics.new_world{ substeps = 1000 }")
              .find("substeps = 1000: must be from 1 to 64") != std::string::npos);
}

TEST_CASE("a destroyed world says so and frees its place among the living") {
    LuaBench bench;
    REQUIRE(
        bench.run("w = cairn.physics.new_world{} b = w:new_body{ data = { name = 'kept' } } w:destroy()") ==
        "");
    CHECK(bench.value("w:is_valid()") == "false");
    CHECK(bench.value("b:is_valid()") == "false");
    CHECK(bench.value("b.data.name") == "kept");
    CHECK(bench.run("w:step(0.1)") == "test.lua:1: World:step: this world was destroyed");
    CHECK(bench.run("b:position()") == "test.lua:1: Body:position: the world of this body was destroyed");
    CHECK(bench.run("for i = 1, 1000 do cairn.physics.new_world{}:destroy() end") == "");
    CHECK(bench.run("for i = 1, 1000 do cairn.physics.new_world{} end").find("64 worlds already") !=
          std::string::npos);
}

TEST_CASE("a body pushed to infinity is halted, listed, and named once in the log") {
    std::vector<std::string> warnings;
    const engine::LogSink before = engine::set_log_sink([&](engine::LogLevel level, std::string_view text) {
        if (level == engine::LogLevel::Warning) warnings.emplace_back(text);
    });
    {
        LuaBench bench;
        CHECK(bench.run(R"(
            local world = cairn.physics.new_world{ gravity_y = 0 }
            local victim = world:add_circle{ x = 3, y = 4, radius = 0.01 }
            local bystander = world:add_circle{ x = -3, radius = 1 }
            world:step(1/60)
            assert(#world:quarantined() == 0)
            for _ = 1, 3 do
                victim:apply_force_to_center(3e38, 0)
                world:step(1/60)
                local halted = world:quarantined()
                assert(#halted == 1 and halted[1] == victim)
                assert(victim:position() == 3 and victim:linear_velocity() == 0)
            end
            world:step(1/60)
            assert(#world:quarantined() == 0)
        )") == "");
    }
    engine::set_log_sink(before);
    CHECK(warnings ==
          std::vector<std::string>{
              "body at (3, 4) was halted: its motion became infinite, or led out of the world, which "
              "ends 1e12 m from its origin; world:quarantined() lists such bodies"});
}

}  // namespace
}  // namespace cairn::scripting::test
