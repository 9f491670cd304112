// Cutting and breaking from Lua: the mass stays, pieces are bodies with data of their own, errors have names.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const std::string kCrate =
    "w = cairn.physics.new_world{} "
    "b = w:add_box{ y = 2, width = 2, height = 1, density = 3, data = { name = 'crate', hits = {} } } ";

TEST_CASE("a cut makes two bodies of the same mass, with copies of the data") {
    LuaBench bench;
    REQUIRE(bench.run(kCrate + "p = b:cut(0.5, 4, 0.5, 0)") == "");
    CHECK(bench.value("#p") == "2");
    CHECK(bench.value("b:is_valid()") == "false");
    CHECK(bench.value("b.data.name") == "crate");  // the body is gone, its data is not
    CHECK(std::stod(bench.value("p[1]:mass() + p[2]:mass()")) == Approx(6));
    CHECK(std::stod(bench.value("math.max(p[1]:mass(), p[2]:mass())")) == Approx(4.5));
    REQUIRE(bench.run("p[1].data.name = 'left'") == "");
    CHECK(bench.value("p[2].data.name") == "crate");
    CHECK(bench.value("p[1].data.hits == p[2].data.hits") == "true");
    CHECK(bench.value("w:body_count()") == "2");
}

TEST_CASE("shapes of pieces have copies of the data of the shape that they were cut from, again and again") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
        w = cairn.physics.new_world{}
        hammer = w:new_body{}
        handle = hammer:add_box{ width = 4, height = 0.4 }
        handle.data.part = 'wood'
        hammer:add_box{ x = 2.3, width = 0.6, height = 2, data = { part = 'iron' } }
        hammer:add_box{ x = -2.3, width = 0.6, height = 0.6 }
        function parts(pieces)
            local out = {}
            for _, piece in ipairs(pieces) do
                for _, shape in ipairs(piece:shapes()) do
                    local x = 0
                    for k, v in ipairs{ shape:points() } do if k % 2 == 1 then x = x + v / 4 end end
                    out[#out + 1] = (x > 2 and 'iron' or x > -2 and 'wood' or 'none') == (shape.data.part or 'none')
                    shape.data.touched = true
                end
            end
            return out
        end
        pieces = hammer:cut(0, 5, 0, -5)
        first = parts(pieces)
        again = {}
        for _, piece in ipairs(pieces) do
            local x = piece:world_center()
            for _, half in ipairs(piece:cut(x, 5, x, -5)) do again[#again + 1] = half end
        end
        second = parts(again)
        alone = true
        for _, ok in ipairs(first) do alone = alone and ok end
        for _, ok in ipairs(second) do alone = alone and ok end
    )") == "");
    CHECK(bench.value("#first") == "4");
    CHECK(std::stoi(bench.value("#second")) >= 6);
    CHECK(bench.value("alone") == "true");
    CHECK(bench.value("handle.data.touched") == "nil");  // copies
    // What the step breaks by itself too.
    REQUIRE(bench.run(R"(
        w = cairn.physics.new_world{ gravity_y = 0 }
        glass = w:add_box{ width = 0.3, height = 2 }
        glass:shapes()[1].data.color = 'green'
        glass:set_breakable{ strength = 2, pieces = 8 }
        w:add_circle{ x = -2, radius = 0.2, density = 20, linear_velocity_x = 10 }
        green, all = 0, 0
        for i = 1, 60 do
            w:step(1 / 60)
            for _, _, _, _, _, _, _, _, pieces in w:breaks() do
                for _, piece in ipairs(pieces) do
                    for _, shape in ipairs(piece:shapes()) do
                        all = all + 1
                        if shape.data.color == 'green' then green = green + 1 end
                    end
                end
            end
        end
    )") == "");
    CHECK(std::stoi(bench.value("all")) > 3);
    CHECK(bench.value("green == all") == "true");
}

TEST_CASE("a cut beside the body changes nothing, and what lies across a cut can be asked for") {
    LuaBench bench;
    REQUIRE(bench.run(kCrate + "p = b:cut(5, 4, 5, 0) hits = w:cuts_along(0, 4, 0, 0)") == "");
    CHECK(bench.value("#p") == "0");
    CHECK(bench.value("b:is_valid()") == "true");
    CHECK(bench.value("#hits") == "1");
    CHECK(bench.value("hits[1].body == b and hits[1].pieces") == "2");
    CHECK(std::stod(bench.value("hits[1].y1")) == Approx(2.5));
    CHECK(std::stod(bench.value("hits[1].y2")) == Approx(1.5));
    CHECK(bench.value("#w:cuts_along(0, 4, 0, 0, 2)") == "0");  // of another category
}

TEST_CASE("a fracture makes pieces of the same mass, the same ones for the same seed") {
    LuaBench bench;
    const std::string how =
        " p = b:fracture{ pieces = 8, seed = 5, pattern = 'radial', x = 0.9, y = 2 } "
        "mass = 0 for _, piece in ipairs(p) do mass = mass + piece:mass() end ";
    REQUIRE(bench.run(kCrate + how + "hash = w:state_hash()") == "");
    CHECK(std::stoi(bench.value("#p")) > 3);
    CHECK(std::stod(bench.value("mass")) == Approx(6));
    REQUIRE(bench.run("first = hash " + kCrate + how) == "");
    CHECK(bench.value("w:state_hash() == first") == "true");
}

TEST_CASE("a breakable body breaks under a blow, and the step tells of it") {
    LuaBench bench;
    const std::string scene =
        "w = cairn.physics.new_world{ gravity_y = 0 } "
        "glass = w:add_box{ width = 0.3, height = 2, data = { kind = 'glass' } } "
        "glass:set_breakable{ strength = 2, pieces = 8, automatic = AUTO } "
        "stone = w:add_circle{ x = -2, radius = 0.2, density = 20, linear_velocity_x = SPEED } told = 0 "
        "for i = 1, 60 do w:step(1 / 60) "
        "for body, other, impulse, x, y, nx, ny, speed, pieces in w:breaks() do told = told + 1 "
        "same = body == glass and other == stone count = #pieces kind = count > 0 and pieces[1].data.kind "
        "hard = impulse > 2 fast = speed end end";
    const auto run = [&](const std::string& automatic, const std::string& speed) {
        std::string script = scene;
        script.replace(script.find("AUTO"), 4, automatic);
        script.replace(script.find("SPEED"), 5, speed);
        REQUIRE(bench.run(script) == "");
    };
    run("true", "10");
    CHECK(bench.value("told") == "1");
    CHECK(bench.value("same and hard") == "true");
    CHECK(std::stoi(bench.value("count")) > 3);
    CHECK(bench.value("kind") == "glass");
    CHECK(std::stod(bench.value("fast")) == Approx(10).epsilon(0.01));
    CHECK(bench.value("glass:is_valid()") == "false");

    run("false", "10");  // the script has the last word
    CHECK(bench.value("count") == "0");
    CHECK(bench.value("glass:is_breakable()") == "true");
    REQUIRE(bench.run("p = glass:fracture{} glass = p[1]") == "");
    CHECK(std::stoi(bench.value("#p")) > 3);

    run("true", "0.1");
    CHECK(bench.value("told") == "0");
    REQUIRE(bench.run("glass:clear_breakable()") == "");
    CHECK(bench.value("glass:is_breakable()") == "false");
}

TEST_CASE("wrong fractures are refused with field, value and rule") {
    LuaBench bench;
    REQUIRE(bench.run(kCrate) == "");
    CHECK(bench.run("b:set_breakable{ patern = 'radial' }").find("did you mean \"pattern\"?") !=
          std::string::npos);
    CHECK(bench.run("b:set_breakable{ pattern = 'radal' }").find("did you mean \"radial\"?") !=
          std::string::npos);
    CHECK(bench.run("b:fracture{ pieces = 1 }") ==
          "test.lua:1: Body:fracture: pieces = 1: must be from 2 to 256");
    CHECK(bench.run("b:set_breakable{ strength = 0 }").find("strength = 0") != std::string::npos);
    CHECK(bench.run("b:set_breakable{ generations = 17 }").find("must be from 1 to 16") != std::string::npos);
    CHECK(bench.run("b:cut(0, 0, 0 / 0, 1)") != "");
    CHECK(bench.value("b:is_valid() and w:body_count()") == "1");
}

}  // namespace
}  // namespace cairn::scripting::test
