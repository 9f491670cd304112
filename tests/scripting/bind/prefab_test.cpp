#include <catch2/catch.hpp>

#include "bind/prefab_fields.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

struct Kind {
    const char* name;
    const FieldSet* fields;
};
const Kind kKinds[] = {
    {"chain", &PrefabReader<physics::LinkChainDef>::kFields},
    {"rope", &PrefabReader<physics::RopeDef>::kFields},
    {"bridge", &PrefabReader<physics::BridgeDef>::kFields},
    {"vehicle", &PrefabReader<physics::VehicleDef>::kFields},
    {"ragdoll", &PrefabReader<physics::RagdollDef>::kFields},
    {"brick_wall", &PrefabReader<physics::BrickWallDef>::kFields},
    {"blob", &PrefabReader<physics::BlobDef>::kFields},
    {"pendulum", &PrefabReader<physics::PendulumDef>::kFields},
    {"windmill", &PrefabReader<physics::WindmillDef>::kFields},
    {"elevator", &PrefabReader<physics::ElevatorDef>::kFields},
    {"gear_train", &PrefabReader<physics::GearTrainDef>::kFields},
    {"pulley_lift", &PrefabReader<physics::PulleyLiftDef>::kFields},
};

TEST_CASE("every prefab can be made from Lua, and destroyed without a trace") {
    for (const Kind& kind : kKinds) {
        INFO(kind.name);
        LuaBench bench;
        const std::string name = kind.name;
        REQUIRE(bench.run("w = cairn.physics.new_world{} p = cairn.prefab." + name +
                          "(w) for i = 1, 30 do "
                          "w:step(1 / 60) end") == "");
        CHECK(bench.value("p:kind()") == name);
        CHECK(bench.value("#p:bodies() == w:body_count() and #p:joints() == w:joint_count()") == "true");
        CHECK(bench.value("p:bodies()[1].data ~= nil") == "true");
        REQUIRE(bench.run("p:bodies()[1]:destroy() p:destroy() p:destroy()") == "");
        CHECK(bench.value("w:body_count() + w:joint_count()") == "0");
    }
}

TEST_CASE("the defaults that the reference gives for prefabs are those that hold") {
    int given = 0;
    for (const Kind& kind : kKinds) {
        INFO(kind.name);
        std::string all;
        for (const Field* field : all_fields(*kind.fields)) {
            if (field->default_text == nullptr || *field->default_text == '\0') continue;
            all += std::string(field->name) + " = " + field->default_text + ", ";
            ++given;
        }
        const auto hash = [&](const std::string& fields) {
            LuaBench bench;
            REQUIRE(bench.run("w = cairn.physics.new_world{} w:add_box{ type = 'static', y = -5, width = 40, "
                              "height = 1, friction = 1 } p = cairn.prefab." +
                              std::string(kind.name) + "(w, {" + fields +
                              "}) if p:kind() == 'vehicle' then p:drive(3) end "
                              "for i = 1, 120 do w:step(1 / 60) end") == "");
            return bench.value("w:state_hash()");
        };
        CHECK(hash(all) == hash(""));
    }
    CHECK(given > 120);
}

TEST_CASE("a vehicle drives and brakes from Lua") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} "
                      "w:add_box{ type = 'static', y = -0.5, width = 200, height = 1 } "
                      "car = cairn.prefab.vehicle(w, { y = 1, wheels = { { x = -1, y = -0.5 }, "
                      "{ x = 0, y = -0.5, driven = false }, { x = 1, y = -0.5 } } }) "
                      "function steps(n) for i = 1, n do w:step(1 / 60) end end "
                      "car:drive(4) steps(300) vx = car:bodies()[1]:linear_velocity()") == "");
    CHECK(std::stod(bench.value("vx")) == Approx(4).epsilon(0.02));
    CHECK(bench.value("#car:bodies()") == "4");
    REQUIRE(bench.run("car:brake() steps(300) vx = car:bodies()[1]:linear_velocity()") == "");
    CHECK(std::stod(bench.value("vx")) == Approx(0).margin(0.01));
}

TEST_CASE("an elevator is sent to its floors from Lua") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} lift = cairn.prefab.elevator(w, { floors = { 0, 2 } }) "
                      "lift:send(1) for i = 1, 120 do w:step(1 / 60) end") == "");
    CHECK(bench.value("lift:is_at(1)") == "true");
    CHECK(bench.value("lift:is_at(0)") == "false");
    CHECK(bench.run("lift:send(2)") == "test.lua:1: Prefab:send: floor is 2; expected 0 to 1");
}

TEST_CASE("a rope hangs between two bodies, and data goes to all its links") {
    LuaBench bench;
    // Smaller than a link, so that the rope need not find its way out of them.
    REQUIRE(
        bench.run("w = cairn.physics.new_world{} a = w:add_box{ type = 'static', width = .1, height = .1 } "
                  "b = w:add_box{ x = 5, width = .1, height = .1, density = 100 } mark = {} "
                  "rope = cairn.prefab.rope(w, { to_x = 5, start_body = a, end_body = b, data = mark }) "
                  "for i = 1, 600 do w:step(1 / 60) end x, y = b:position()") == "");
    CHECK(bench.value("rope:bodies()[3].data == mark") == "true");
    CHECK(std::stod(bench.value("math.sqrt(x * x + y * y)")) == Approx(5).epsilon(0.02));
    CHECK(std::stod(bench.value("y")) < -4);
}

TEST_CASE("wrong prefabs are refused with field, value and rule") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} rope = cairn.prefab.rope(w, {})") == "");
    CHECK(
        bench.run("cairn.prefab.rope(w, { length = 1 })") ==
        "test.lua:1: cairn.prefab.rope: length is 1, but must be from the distance of the ends to 100 times "
        "that");
    CHECK(bench.run("cairn.prefab.rope(w, { lenght = 1 })").find("did you mean \"length\"") !=
          std::string::npos);
    CHECK(bench.run("cairn.prefab.rope(w, { links = 2.5 })").find("links = 2.5: must be an integer") !=
          std::string::npos);
    CHECK(bench.run("cairn.prefab.rope(w, { links = '4' })").find("links = \"4\": must be an integer") !=
          std::string::npos);
    CHECK(bench.run("cairn.prefab.rope(w, { links = 8 / 2 })") == "");
    CHECK(bench.run("cairn.prefab.gear_train(w, { radii = { 1, 'x' } })")
              .find("radii[2] = \"x\": must be a number") != std::string::npos);
    CHECK(bench.run("cairn.prefab.vehicle(w, { wheels = { 3 } })").find("wheels[1] = 3: must be a table") !=
          std::string::npos);
    CHECK(bench.run("rope:drive(1)") == "test.lua:1: Prefab:drive: belongs to a vehicle, and this is a rope");
    CHECK(bench.run("cairn.prefab.rop(w)").find("did you mean \"rope\"") != std::string::npos);
    CHECK(bench.run("w:destroy() rope:bodies()").find("the world of this prefab was destroyed") !=
          std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
