// Many bodies at once: as one by one, or none.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("bodies added at once are those added one by one") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
        one, many = cairn.physics.new_world{}, cairn.physics.new_world{}
        one:add_box{ type = "static", y = -1, width = 9, height = 1 }
        one:add_circle{ y = 2, radius = 0.5, restitution = 0.5 }
        one:new_body{ x = 3 }
        list = many:add_bodies{
            { shape = "box", type = "static", y = -1, width = 9, height = 1 },
            { shape = "circle", y = 2, radius = 0.5, restitution = 0.5, data = { name = "ball" } },
            { x = 3 },
        }
        for _ = 1, 60 do one:step(1 / 60) many:step(1 / 60) end
    )") == "");
    CHECK(bench.value("one:state_hash() == many:state_hash()") == "true");
    CHECK(bench.value("#list") == "3");
    CHECK(bench.value("list[2].data.name") == "ball");
    CHECK(bench.value("#many:add_bodies{}") == "0");
}

TEST_CASE("with one bad description nothing is added, and the error names its place") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}") == "");
    const auto message = [&](const std::string& bad) {
        return bench.run("w:add_bodies{ { shape = 'circle', radius = 1 }, {}, " + bad + " }");
    };
    CHECK(message("{ shape = 'circle' }") ==
          "test.lua:1: World:add_bodies: bodies[3]: radius is missing; it must be a number");
    CHECK(message("{ shape = 'circle', radius = 1, fricton = 1 }") ==
          "test.lua:1: World:add_bodies: bodies[3]: unknown field \"fricton\"; did you mean \"friction\"?");
    CHECK(
        message("{ shape = 'sircle', radius = 1 }")
            .find(
                "World:add_bodies: bodies[3]: shape = \"sircle\": no such shape; did you mean \"circle\"?") !=
        std::string::npos);
    CHECK(message("{ shape = 3 }").find("bodies[3]: shape = 3: no such shape") != std::string::npos);
    CHECK(message("7") == "test.lua:1: World:add_bodies: bodies[3] is 7; expected a table");
    CHECK(bench.value("w:body_count()") == "0");
}

TEST_CASE("bodies of a list are destroyed, or none") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = w:add_bodies{ {}, {}, {}, {} }\n"
                      "other = cairn.physics.new_world{}:new_body{}") == "");
    CHECK(bench.run("w:destroy_bodies{ l[1], 5 }") ==
          "test.lua:1: World:destroy_bodies: bodies[2] is 5; expected a Body");
    CHECK(bench.run("w:destroy_bodies{ l[1], l[2], l[1] }") ==
          "test.lua:1: World:destroy_bodies: bodies[3] stands in the list twice");
    CHECK(bench.run("w:destroy_bodies{ l[1], other }") ==
          "test.lua:1: World:destroy_bodies: bodies[2] belongs to another world");
    CHECK(bench.value("w:body_count()") == "4");
    REQUIRE(bench.run("w:destroy_bodies{ l[1], l[3] }") == "");
    CHECK(bench.value("w:body_count()") == "2");
    CHECK(bench.value("l[1]:is_valid() or l[3]:is_valid()") == "false");
    CHECK(bench.value("l[2]:is_valid() and l[4]:is_valid()") == "true");
    CHECK(bench.run("w:destroy_bodies{ l[2], l[1] }").find("bodies[2]: the body has been destroyed") !=
          std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
