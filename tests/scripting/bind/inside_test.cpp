// What a world looks like inside: data of its parts, joints, contacts, islands, boxes, shapes of events.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const char* const kPile = R"(
    w = cairn.physics.new_world{ gravity_y = -10 }
    floor = w:add_box{ type = "static", y = -0.5, width = 40, height = 1 }
    low = w:add_box{ y = 0.5, width = 1, height = 1, density = 2 }
    high = w:add_box{ y = 1.5, width = 1, height = 1 }
    apart = w:add_circle{ x = 9, y = 0.5, radius = 0.5 }
)";

}  // namespace

TEST_CASE("shapes, joints and chains have data of their own, by identity") {
    LuaBench bench;
    REQUIRE(bench.run(kPile) == "");
    REQUIRE(bench.run(R"(
        low:shapes()[1].data.name = "low"
        second = low:add_circle{ radius = 0.1, data = { name = "second" } }
        pin = w:add_revolute_joint{ body_a = low, body_b = high, x = 0, y = 1, data = { name = "pin" } }
        _, ridge = w:add_chain{ type = "static", points = { { 30, 0 }, { 20, 0 }, { 10, 0 } } }
        ridge.data.name = "ridge"
        collectgarbage("count")
    )") == "");
    CHECK(bench.value("low:shapes()[1].data.name") == "low");
    CHECK(bench.value("low:shapes()[2].data.name") == "second");
    CHECK(bench.value("high:joints()[1].data.name") == "pin");
    CHECK(bench.value("next(high:shapes()[1].data)") == "nil");
    CHECK(bench.value("ridge:segment(2):chain() == ridge") == "true");
    CHECK(bench.value("ridge:segment(2):chain().data.name") == "ridge");
    CHECK(bench.value("low:shapes()[1]:chain()") == "nil");
    REQUIRE(bench.run("pin.data = { name = 'other' }") == "");
    CHECK(bench.value("low:joints()[1].data.name") == "other");
    CHECK(bench.run("pin.data = 3") == "test.lua:1: Joint.data is 3; expected a table");
    CHECK(bench.run("second.name = 'x'") ==
          "test.lua:1: a Shape has no field \"name\" to set; keep values of your own in shape.data");
    CHECK(bench.run("pin:anglee()") == "test.lua:1: Joint has no \"anglee\"; did you mean \"angle\"?");
    REQUIRE(bench.run("pin:destroy() pin = w:add_filter_joint{ body_a = low, body_b = high }") == "");
    CHECK(bench.value("next(pin.data)") == "nil");  // of a new joint in the old one's slot
}

TEST_CASE("a world lists its joints once each, in the order of creation") {
    LuaBench bench;
    REQUIRE(bench.run(kPile) == "");
    CHECK(bench.value("#w:joints()") == "0");
    REQUIRE(bench.run(R"(
        a = w:add_weld_joint{ body_a = low, body_b = high, x = 0, y = 1 }
        b = w:add_revolute_joint{ body_a = w:ground(), body_b = apart, x = 9, y = 0.5 }
        c = w:add_filter_joint{ body_a = high, body_b = apart }
    )") == "");
    CHECK(bench.value("#w:joints() == w:joint_count()") == "true");
    CHECK(bench.value("w:joints()[1] == a and w:joints()[2] == b and w:joints()[3] == c") == "true");
}

TEST_CASE("contacts bear what rests on them") {
    LuaBench bench;
    REQUIRE(bench.run(kPile) == "");
    REQUIRE(bench.run(R"(
        for _ = 1, 60 do w:step(1 / 60) end
        function borne(list, a, b)
            local sum, count = 0, 0
            for _, c in ipairs(list) do
                if (c.body_a == a and c.body_b == b) or (c.body_a == b and c.body_b == a) then
                    count = count + 1
                    assert(c.shape_a:body() == c.body_a and c.shape_b:body() == c.body_b)
                    assert(math.abs(math.abs(c.ny) - 1) < 1e-3)
                    for _, p in ipairs(c.points) do sum = sum + p.impulse assert(math.abs(p.separation) < 0.01) end
                end
            end
            assert(count == 1)
            return sum
        end
    )") == "");
    // Weight times the step: 1 kg, and 3 kg, at 10 m/s2.
    CHECK(bench.value("math.abs(borne(w:contacts(), low, high) - 10 / 60) < 0.004") == "true");
    CHECK(bench.value("math.abs(borne(low:contacts(), low, floor) - 30 / 60) < 0.01") == "true");
    CHECK(bench.value("#w:contacts() == w:contact_count()") == "true");
    CHECK(bench.value("#high:contacts()") == "1");
    CHECK(bench.value("#low:contacts()") == "2");
    CHECK(bench.value("#w:new_body{}:contacts()") == "0");
}

TEST_CASE("bodies that lean on each other are one island, and every shape lies in its box") {
    LuaBench bench;
    REQUIRE(bench.run(kPile) == "");
    REQUIRE(bench.run(R"(
        for _ = 1, 10 do w:step(1 / 60) end
        together = 0
        for _, island in ipairs(w:islands()) do
            assert(island.awake)
            local has = {}
            for _, body in ipairs(island.bodies) do has[body] = true end
            if has[low] then together = #island.bodies assert(has[high] and not has[apart]) end
        end
        boxes = {}
        for _, box in ipairs(w:boxes()) do boxes[box.shape:body()] = box end
    )") == "");
    CHECK(bench.value("#w:islands()") == "2");
    CHECK(bench.value("together") == "2");
    CHECK(bench.value("boxes[apart].x1 <= 8.5 and boxes[apart].x2 >= 9.5 and boxes[apart].y2 >= 1") ==
          "true");
    CHECK(bench.value("boxes[apart].x1 > 8") == "true");
}

TEST_CASE("events tell their shapes when they are asked to") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
        w = cairn.physics.new_world{}
        w:add_box{ type = "static", y = -0.5, width = 40, height = 1 }
        ball = w:add_circle{ y = 3, radius = 0.5 }
        hits, plain = 0, 0
        for _ = 1, 120 do
            w:step(1 / 60)
            for kind, a, b, _, _, _, _, _, _, shape_a, shape_b in w:events("hit", true) do
                assert(shape_a:body() == a and shape_b:body() == b)
                hits = hits + 1
            end
            for _, _, _, _, _, _, _, _, _, shape in w:events("hit") do assert(shape == nil) plain = plain + 1 end
        end
    )") == "");
    CHECK(bench.value("hits > 0 and hits == plain") == "true");
}

TEST_CASE("what a body withstands can be read back") {
    LuaBench bench;
    REQUIRE(bench.run(kPile) == "");
    CHECK(bench.value("low:breakable()") == "nil");
    REQUIRE(bench.run("low:set_breakable{ strength = 5, pieces = 7, pattern = 'radial', automatic = false }\n"
                      "high:set_breakable(low:breakable())") == "");
    for (const char* body : {"low", "high"}) {
        const std::string fields = std::string(body) + ":breakable()";
        CHECK(bench.value(fields + ".strength") == "5.0");
        CHECK(bench.value(fields + ".pieces") == "7");
        CHECK(bench.value(fields + ".pattern") == "radial");
        CHECK(bench.value(fields + ".automatic") == "false");
    }
}

TEST_CASE("a way before planes ends at the gap, and slides along") {
    LuaBench bench;
    REQUIRE(
        bench.run("x, y = cairn.physics.solve_planes(2, -3, { { nx = 0, ny = 1, separation = 1 } }, 0.25)") ==
        "");
    CHECK(bench.value("x") == "2.0");
    CHECK(bench.value("y") == "-0.75");
    CHECK(bench.value("select(2, cairn.physics.solve_planes(2, -3, {}, 0.25))") == "-3.0");
    CHECK(bench.run("cairn.physics.solve_planes(2, -3, { { nx = 0, ny = 'up', separation = 1 } }, 0)") ==
          "test.lua:1: cairn.physics.solve_planes: planes[1].ny is \"up\"; expected a finite number");
}

TEST_CASE("parts of the physics can be asked for by name") {
    LuaBench bench;
    CHECK(bench.value("cairn.physics.is_built_in('joints')") == "true");
    CHECK(bench.run("cairn.physics.is_built_in('joint')").find("did you mean \"joints\"?") !=
          std::string::npos);
}

}  // namespace cairn::scripting::test
