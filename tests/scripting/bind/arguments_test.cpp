// Every described binding is called with nonsense: it must raise an error that names it, or accept, and never
// crash.
#include <catch2/catch.hpp>

#include "bind/module.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Lua expressions for an object of each type.
std::string receiver(const std::string& type) {
    if (type == "World") return "cairn.physics.new_world{}";
    if (type == "Body") return "cairn.physics.new_world{}:add_circle{ radius = 1 }";
    if (type == "Shape") return "cairn.physics.new_world{}:add_circle{ radius = 1 }:shapes()[1]";
    if (type == "Chain") {
        return "select(2, cairn.physics.new_world{}:add_chain{ type = 'static', points = { { 9, 0 }, { 0, 0 "
               "}, { -9, 0 "
               "} } })";
    }
    if (type == "Level") return "cairn.level.load('level.lua')";
    if (type == "Camera") return "cairn.camera.new{}";
    if (type == "Font") return "cairn.graphics.new_font(20)";
    if (type == "Random") return "cairn.random.new(1)";
    if (type == "Timer") return "cairn.timer.after(1, print)";
    if (type == "Canvas") return "cairn.graphics.new_canvas(4, 4)";
    if (type == "Quad") return "cairn.graphics.new_quad(cairn.graphics.new_image('pixel.png'), 0, 0, 1, 1)";
    if (type == "Atlas") return "cairn.graphics.new_atlas('atlas.json')";
    if (type == "Batch") return "cairn.graphics.new_batch(cairn.graphics.new_image('pixel.png'))";
    if (type == "Tween") return "cairn.tween.to({ x = 1 }, { x = 2 }, 1)";
    if (type == "Particles") return "cairn.particles.new{}";
    if (type == "TileMap") return "cairn.tilemap.load('map.tmj')";
    if (type == "Ui") return "cairn.ui.new{}";
    if (type == "Text") return "cairn.text.new('words')";
    if (type == "Prefab") return "cairn.prefab.pendulum(cairn.physics.new_world{})";
    if (type == "Joint") {
        return "(function() local w = cairn.physics.new_world{} return w:add_distance_joint{ body_a = "
               "w:new_body{}, body_b = "
               "w:new_body{ x = 2 } } end)()";
    }
    return "cairn.graphics.new_image('pixel.png')";
}

/// A PNG of one pixel.
const std::string kPixel(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\6\0\0\0\x1f\x15\xc4\x89\0\0\0\rIDATx\x9c"
    "c\xf8\xcf\xc0\xf0\x1f\0\5\0\1\xff\x89\x99=\x1d\0\0\0\0IEND\xae"
    "B`\x82",
    70);

TEST_CASE("a description names as many parameters and results as its function has") {
    for (const Module* module : all_modules()) {
        for (const Function& function : module->functions) {
            INFO(module->name << '.' << function.name);
            const std::size_t receivers = module->is_type ? 1 : 0;
            CHECK(parse_parameters(function.parameters).size() + receivers ==
                  function.parameter_types.size());
            CHECK(parse_parameters(function.results).size() == function.result_types.size());
            if (module->is_type) CHECK(function.parameter_types[0] == module->name);
        }
    }
}

TEST_CASE("nonsense in any argument raises an error that names the binding, and never crashes") {
    const std::vector<std::string> nonsense = {"nil",
                                               "true",
                                               "'text'",
                                               "{}",
                                               "{ 1, 'a' }",
                                               "print",
                                               "0/0",
                                               "1/0",
                                               "-1",
                                               "1e300",
                                               "math.mininteger",
                                               "cairn.random.visual",
                                               "{ width = {}, nonsense = 1 }",
                                               "coroutine.create(print)"};
    for (const Module* module : all_modules()) {
        if (std::string(module->name) == "cairn.test") continue;  // only there in tests of games
        LuaBench bench(
            GameFiles{{"pixel.png", kPixel},
                      {"atlas.json", R"({"frames": {}, "meta": {"image": "pixel.png"}})"},
                      {"level.lua", "{ bodies = { { name = 'a', shape = 'circle', radius = 1 } } }"},
                      {"map.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1})"}});
        const std::string path = module->is_type ? receiver(module->name) : module->name;
        REQUIRE(bench.run("receiver = " + path) == "");
        for (const Function& function : module->functions) {
            const std::string name =
                std::string(module->name) + (module->is_type ? ":" : ".") + function.name;
            if (std::string(function.name) == "destroy") continue;  // its receiver is wanted further on
            const std::size_t count = function.parameter_types.size() - (module->is_type ? 1 : 0);
            for (std::size_t position = 0; position < count; ++position) {
                for (const std::string& value : nonsense) {
                    std::string arguments;
                    for (std::size_t i = 0; i < count; ++i)
                        arguments += (i > 0 ? ", " : "") + (i == position ? value : "nil");
                    const std::string call = std::string("receiver") + (module->is_type ? ":" : ".") +
                                             function.name + '(' + arguments + ')';
                    INFO(name << " " << call);
                    const std::string message = bench.run(call);
                    if (!message.empty()) CHECK(message.find(name + ": ") != std::string::npos);
                }
            }
            if (module->is_type) {
                for (const char* self : {"", "12", "{}", "cairn.random.visual, 1, 1", "nil"}) {
                    const std::string message =
                        bench.run(std::string("receiver.") + function.name + '(' + self + ')');
                    INFO(name << " " << self);
                    if (std::string(module->name) == "Random" &&
                        std::string(self).find("visual") != std::string::npos)
                        continue;
                    CHECK(message.find("test.lua:1: " + name + ": the receiver is ") == 0);
                }
            }
        }
    }
}

TEST_CASE("a wrong argument is named with its value, the rule and the caller's place") {
    LuaBench bench;
    CHECK(bench.run("local w = cairn.physics.new_world{}\nw:set_gravity(1, 'down')") ==
          "test.lua:2: World:set_gravity: y is \"down\"; expected a number");
    CHECK(bench.run("cairn.timer.after(-1, print)") ==
          "test.lua:1: cairn.timer.after: seconds is -1; expected a time in seconds, at least 0");
    CHECK(bench.run("cairn.input.is_down('spcae')").find("no such key; did you mean \"space\"?") !=
          std::string::npos);
    CHECK(bench.run("local w = cairn.physics.new_world{} w.step(1)")
              .find("World:step: the receiver is 1; call it as object:step(...)") != std::string::npos);
}

TEST_CASE("numbers in text are no numbers") {
    LuaBench bench;
    CHECK(bench.run("cairn.physics.new_world{}:step('0.01')").find("expected a number") != std::string::npos);
}

TEST_CASE("a misspelt function names the nearest") {
    LuaBench bench;
    CHECK(bench.run("cairn.graphics.cicle('fill', 1, 2, 3)") ==
          "test.lua:1: cairn.graphics has no \"cicle\"; did you mean \"circle\"?");
    CHECK(bench.run("local b = cairn.physics.new_world{}:new_body{}\nb:postion()") ==
          "test.lua:2: Body has no \"postion\"; did you mean \"position\"?");
}

TEST_CASE("an unknown field names the nearest and lists all; a wrong one its value and rule") {
    LuaBench bench;
    const std::string message =
        bench.run("cairn.physics.new_world{}:add_circle{ radius = 1, fricton = 0.3 }");
    CHECK(message == "test.lua:1: World:add_circle: unknown field \"fricton\"; did you mean \"friction\"?");
    // Where there are few, all are named.
    CHECK(bench.run("cairn.physics.new_world{ gravity = 1 }")
              .find("did you mean \"gravity_x\"? (gravity_x, gravity_y, ") != std::string::npos);
    CHECK(bench.run("cairn.physics.new_world{}:add_circle{}") ==
          "test.lua:1: World:add_circle: radius is missing; it must be a number");
    CHECK(bench.run("cairn.physics.new_world{}:add_circle{ radius = {} }") ==
          "test.lua:1: World:add_circle: radius = a table: must be a number");
    CHECK(bench.run("cairn.physics.new_world{}:add_circle{ radius = 1, type = 'dinamic' }")
              .find("type = \"dinamic\": no such type; did you mean \"dynamic\"?") != std::string::npos);
    CHECK(bench.run("cairn.physics.new_world{}:add_circle{ 5 }").find("the key 1 is not a field") !=
          std::string::npos);
}

TEST_CASE("numbers out of range are refused in the author's words, before the physics sees them") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}") == "");
    const auto message = [&](const std::string& code) { return bench.run(code); };
    CHECK(message("w:add_box{ width = 0, height = 1 }") ==
          "test.lua:1: World:add_box: width = 0: must be above 0 and at most 2000000");
    CHECK(message("w:add_box{ width = 1, height = 1, radius = -1 }") ==
          "test.lua:1: World:add_box: radius = -1: must be at least 0 and at most 1000000");
    CHECK(message("w:add_box{ width = 1, height = 3e6 }") ==
          "test.lua:1: World:add_box: height = 3000000.0: must be above 0 and at most 2000000");
    CHECK(message("w:add_circle{ radius = 1/0 }") ==
          "test.lua:1: World:add_circle: radius = inf: must be above 0 and at most 1000000");
    CHECK(message("w:add_capsule{ length = 0.001, radius = 1 }") ==
          "test.lua:1: World:add_capsule: length = 0.001: must be above 0.005 and at most 2000000");
    CHECK(message("w:add_circle{ radius = 1, friction = -1 }") ==
          "test.lua:1: World:add_circle: friction = -1: must be at least 0 and finite");
    CHECK(message("w:add_circle{ radius = 1, restitution = 2 }") ==
          "test.lua:1: World:add_circle: restitution = 2: must be at least 0 and at most 1");
    for (const char* nan : {"0/0", "-(0/0)"}) {
        CHECK(message(std::string("cairn.physics.new_world{ gravity_y = ") + nan + " }") ==
              "test.lua:1: cairn.physics.new_world: gravity_y = nan: must be finite");
    }
    CHECK(bench.value("w:body_count()") == "0");
}

TEST_CASE("what the physics itself refuses comes in the author's words") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} b = w:add_circle{ radius = 1 }") == "");
    CHECK(bench.run("w:step(0)") ==
          "test.lua:1: World:step: dt is 0, but must be greater than 0 and at most 1 s");
    for (const char* nan : {"0/0", "-(0/0)"}) {
        CHECK(bench.run(std::string("w:set_gravity(") + nan + ", 0)") ==
              "test.lua:1: World:set_gravity: gravity is (nan, 0), but must be finite");
    }
    CHECK(author_words("revolute_joint.body_a and .body_b are the same body, but must be two bodies") ==
          "body_a and body_b are the same body, but must be two bodies");
    CHECK(author_words("distance_joint.min_length_m is 3, but must be at most length_m") ==
          "min_length is 3, but must be at most length");
    CHECK(author_words("the distance is 0.001, but must be greater than 0.005 m (-nan)") ==
          "the distance is 0.001, but must be greater than 0.005 m (nan)");
}

}  // namespace
}  // namespace cairn::scripting::test
