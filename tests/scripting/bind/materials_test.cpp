// Materials by name: the shape has their numbers, whatever way it was made.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using Catch::Matchers::Contains;

struct Materials : LuaBench {
    Materials() {
        REQUIRE(
            run("cairn.physics.define_material('wood', { density = 0.5, friction = 0.25, restitution = 0.75, "
                "rolling_resistance = 0.125, surface_speed = 2, material_kind = 7 })\n"
                "cairn.physics.define_material('plain', {})\n"
                "world = cairn.physics.new_world{}\n"
                "function told(shape)\n"
                "  local m = shape:material()\n"
                "  return ('%g %g %g %g %g %d'):format(shape:density(), m.friction, m.restitution, "
                "m.rolling_resistance, m.surface_speed, m.material_kind)\n"
                "end\n"
                "function of(body) return told(body:shapes()[1]) end") == "");
    }
};

TEST_CASE_METHOD(
    Materials,
    "a shape of a material has all that the material says, and what stands beside it goes before") {
    const char* const wood = "0.5 0.25 0.75 0.125 2 7";
    CHECK(value("of(world:add_box{ width = 2, height = 1, material = 'wood' })") == wood);
    CHECK(value("world:add_box{ width = 2, height = 1, material = 'wood' }:mass()") == "1.0");
    CHECK(value("of(world:add_circle{ radius = 1, material = 'wood' })") == wood);
    CHECK(
        value(
            "of(world:add_bodies{ { shape = 'capsule', length = 1, radius = 1, material = 'wood' } }[1])") ==
        wood);
    REQUIRE(run("body = world:new_body{} body:add_polygon{ points = { {0, 0}, {1, 0}, {0, 1} }, material = "
                "'wood' }") == "");
    CHECK(value("of(body)") == wood);
    CHECK(value("of(world:add_box{ width = 2, height = 1, material = 'wood', density = 3, friction = 0, "
                "restitution "
                "= 0, rolling_resistance = 0, surface_speed = 0, material_kind = 0 })") == "3 0 0 0 0 0");
    CHECK(value("of(world:add_box{ width = 2, height = 1, material = 'wood', friction = 0.5 })") ==
          "0.5 0.5 0.75 0.125 2 7");
    // Without a word about it a material is as a shape without one.
    CHECK(value("of(world:add_box{ width = 2, height = 1, material = 'plain' })") ==
          value("of(world:add_box{ width = 2, height = 1 })"));
}

TEST_CASE_METHOD(Materials, "chains and the surfaces of shapes that are there take materials too") {
    REQUIRE(run("ground, chain = world:add_chain{ points = { {4, 0}, {2, 0}, {0, 0}, {-2, 0} }, material = "
                "'wood' }") == "");
    CHECK(value("('%g %g %g %g %d'):format(chain:material(1))") == "0.25 0.75 0.125 2 7");
    REQUIRE(run("chain:set_material(2, { material = 'plain', restitution = 0.5 })") == "");
    CHECK(value("('%.1f %g %g %g %d'):format(chain:material(2))") == "0.6 0.5 0 0 0");
    REQUIRE(run("box = world:add_box{ width = 1, height = 1, density = 4 }\n"
                "box:shapes()[1]:set_material{ material = 'wood', friction = 0.5 }") == "");
    CHECK(value("of(box)") == "4 0.5 0.75 0.125 2 7");  // a surface has no density
}

TEST_CASE_METHOD(Materials, "prefabs take materials, and what stands beside one goes before") {
    const auto of = [&](const std::string& prefab, const std::string& fields) {
        return value("of(cairn.prefab." + prefab + "(world, {" + fields + "}):bodies()[1])");
    };
    for (const char* prefab : {"vehicle", "ragdoll", "brick_wall", "blob"}) {
        INFO(prefab);
        CHECK(of(prefab, "material = 'wood'") == "0.5 0.25 0.75 0.125 2 7");
        CHECK(of(prefab,
                 "material = 'wood', density = 3, friction = 0, restitution = 0.5, rolling_resistance = 1, "
                 "surface_speed = 4, material_kind = 1") == "3 0 0.5 1 4 1");
        CHECK(of(prefab, "material = 'wood', friction = 0.5") == "0.5 0.5 0.75 0.125 2 7");
    }
    for (const char* prefab : {"chain", "rope", "bridge", "pendulum", "windmill", "elevator", "gear_train",
                               "vehicle", "ragdoll"}) {
        INFO(prefab);
        REQUIRE(run("n = 0 for _, body in ipairs(cairn.prefab." + std::string(prefab) +
                    "(world, { material = 'wood' }):bodies()) do for _, shape in ipairs(body:shapes()) do "
                    "if told(shape) == '0.5 0.25 0.75 0.125 2 7' then n = n + 1 end end end") == "");
        CHECK(value("n > 0") == "true");
    }
    CHECK_THAT(run("cairn.prefab.rope(world, { material = 'wod' })"),
               Contains("material = \"wod\": no such material; did you mean \"wood\"?"));
    CHECK_THAT(run("cairn.prefab.pulley_lift(world, { material = 'wood' })"),
               Contains("unknown field \"material\""));
}

TEST_CASE("prefabs of a level are of its materials") {
    LuaBench bench(GameFiles{{"made.lua", R"({
    materials = { wood = { density = 0.5, friction = 0.25, rolling_resistance = 0.125, material_kind = 7 } },
    prefabs = {
        { name = "wall", prefab = "brick_wall", material = "wood", restitution = 0.5 },
        { name = "car", prefab = "vehicle", x = 20, material = "wood", density = 3 },
    },
})"},
                             {"bad.lua", R"({
    materials = { wood = {} },
    prefabs = {
        { prefab = "rope", material = "wod", frction = 1 },
        { prefab = "pulley_lift", material = "wood" },
    },
})"}});
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = cairn.level.load('made.lua') l:build(w)\n"
                      "function told(name)\n"
                      "  local body = l:prefab(name):bodies()[1] local shape = body:shapes()[1]\n"
                      "  local m = shape:material()\n"
                      "  return ('%g %g %g %g %d %s'):format(shape:density(), m.friction, m.restitution, "
                      "m.rolling_resistance, m.material_kind, body.data.material)\n"
                      "end") == "");
    CHECK(bench.value("told('wall')") == "0.5 0.25 0.5 0.125 7 wood");
    CHECK(bench.value("told('car')") == "3 0.25 0 0.125 7 wood");
    REQUIRE(bench.run("faults = cairn.level.check('bad.lua')") == "");
    INFO(bench.value("table.concat(faults, '\\n')"));
    CHECK(bench.value("#faults") == "3");
    CHECK_THAT(bench.value("faults[1]"), Contains("prefabs[1].material = \"wod\": no such material"));
    CHECK_THAT(bench.value("faults[2]"), Contains("prefabs[1].frction = 1: unknown field"));
    CHECK_THAT(bench.value("faults[3]"), Contains("prefabs[2].material = \"wood\": unknown field"));
}

TEST_CASE_METHOD(Materials, "a name can be given anew, for what is made from then on") {
    REQUIRE(run("before = world:add_circle{ radius = 1, material = 'wood' }\n"
                "cairn.physics.define_material('wood', { density = 2 })\n"
                "after = world:add_circle{ radius = 1, material = 'wood' }") == "");
    CHECK(value("of(before)") == "0.5 0.25 0.75 0.125 2 7");
    CHECK(value("after:shapes()[1]:density()") == "2.0");
    CHECK(
        value(
            "cairn.physics.materials().wood.density .. ' ' .. cairn.physics.materials().plain.restitution") ==
        "2.0 0.0");
    // What is told of it makes the same again.
    REQUIRE(run("for name, fields in pairs(cairn.physics.materials()) do cairn.physics.define_material(name, "
                "fields) "
                "end") == "");
    CHECK(value("of(world:add_circle{ radius = 1, material = 'wood' })") == value("of(after)"));
}

TEST_CASE_METHOD(Materials,
                 "an unknown material and a wrong one are told with the nearest name and the rule") {
    CHECK_THAT(
        run("world:add_circle{ radius = 1, material = 'wod' }"),
        Contains(
            "World:add_circle: material = \"wod\": no such material; did you mean \"wood\"? (plain, wood)"));
    CHECK_THAT(run("world:add_circle{ radius = 1, material = 5 }"),
               Contains("material = 5: must be a string"));
    CHECK_THAT(run("cairn.physics.define_material('ice', { friction = -1 })"),
               Contains("cairn.physics.define_material: friction = -1: must be at least 0"));
    CHECK_THAT(run("cairn.physics.define_material('ice', { fricton = 1 })"),
               Contains("did you mean \"friction\""));
    CHECK_THAT(run("cairn.physics.define_material('ice', { material_kind = 64 })"),
               Contains("must be from 0 to 63"));
    CHECK_THAT(run("cairn.physics.define_material('', {})"), Contains("expected a name, not empty"));
}

TEST_CASE("where no material has a name, the message says how one gets it") {
    CHECK_THAT(LuaBench().run("cairn.physics.new_world{}:add_circle{ radius = 1, material = 'wood' }"),
               Contains("no such material; cairn.physics.define_material gives names to materials"));
}

TEST_CASE("one file of materials serves levels and scripts") {
    LuaBench bench(
        GameFiles{{"materials.lua", "return { materials = { wood = { density = 2, friction = 0.25 } } }"},
                  {"one.lua",
                   "{ includes = { 'materials.lua' }, bodies = { { name = 'p', shape = 'box', width = 1, "
                   "height = 1, material = "
                   "'wood' } } }"}});
    REQUIRE(
        bench.run("for name, fields in pairs(require('materials').materials) do "
                  "cairn.physics.define_material(name, fields) end\n"
                  "world = cairn.physics.new_world{} level = cairn.level.load('one.lua') level:build(world)\n"
                  "scripted = world:add_box{ x = 5, width = 1, height = 1, material = 'wood' }") == "");
    CHECK(bench.value("scripted:mass() == level:body('p'):mass() and scripted:mass()") == "2.0");
    CHECK(bench.value("scripted:shapes()[1]:friction() == level:body('p'):shapes()[1]:friction()") == "true");
}

}  // namespace
}  // namespace cairn::scripting::test
