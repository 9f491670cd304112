// Levels: what a file may say, what is said of its faults, and what reloading keeps.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "level/reader.h"
#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"
#include "support/source_path.h"

namespace cairn::scripting::test {
namespace {

using Catch::Matchers::Contains;

const char* const kYard = R"({
    name = "Yard",
    gravity_y = -5,
    camera = { x = 1, y = 2, height = 12 },
    bounds = { left = -10, bottom = 0, right = 10, top = 8 },
    data = { par = 3 },
    materials = { ice = { friction = 0.02, density = 0.9 } },
    templates = { crate = { shape = "box", width = 1, height = 1, material = "ice", data = { kind = "crate" } } },
    bodies = {
        { name = "ground", type = "static", shape = "chain", points = { { 20, 0 }, { -20, 0 } } },
        { name = "first", template = "crate", x = 0, y = 0.5 },
        { template = "crate", x = 3, y = 0.5, width = 2 },
        { name = "hammer", x = 6, y = 2, shapes = {
            { shape = "box", width = 2, height = 0.2 },
            { shape = "circle", x = 1, radius = 0.3, material = "ice" },
        } },
    },
    triggers = { { name = "goal", shape = "box", x = 0, y = 1, width = 3, height = 2 } },
    prefabs = { { name = "rope", prefab = "rope", x = 10, y = 5, to_x = 12, to_y = 5 } },
    joints = {
        { name = "hinge", joint = "revolute", body_b = "hammer", x = 6, y = 2 },
        { joint = "weld", body_a = "rope.1", body_b = "first", x = 10, y = 5 },
    },
    spawns = { { name = "player", x = -3, y = 1, angle = 0.5 } },
})";

TEST_CASE("a level makes what it says, under its names") {
    LuaBench bench(GameFiles{{"yard.lua", kYard}});
    REQUIRE(
        bench.run(
            "world = cairn.physics.new_world{} level = cairn.level.load('yard.lua') level:build(world)") ==
        "");
    CHECK(bench.value("level:name()") == "Yard");
    CHECK(bench.value("select(2, world:gravity())") == "-5.0");
    CHECK(bench.value("#level:bodies()") == "4");
    CHECK(bench.value("level:body('first'):position()") == "0.0");
    CHECK(bench.value("level:body('first'):mass()") == bench.value("0.9 // 1 + level:body('first'):mass()"));
    CHECK(bench.value("math.abs(level:body('first'):mass() - 0.9) < 1e-6") == "true");
    CHECK(bench.value("level:body('first'):shapes()[1]:friction() < 0.021") == "true");
    CHECK(bench.value("level:body('first').data.kind .. level:body('first').data.name .. "
                      "level:body('first').data.material") == "cratefirstice");
    CHECK(bench.value("#level:body('hammer'):shapes()") == "2");
    CHECK(bench.value("level:joint('hinge'):kind()") == "revolute");
    CHECK(bench.value("level:joint('hinge'):body_a() == world:ground()") == "true");
    CHECK(bench.value("level:prefab('rope'):kind()") == "rope");
    CHECK(bench.value("select(3, level:spawn('player'))") == "0.5");
    CHECK(bench.value("select(3, level:camera())") == "12.0");
    CHECK(bench.value("select(4, level:bounds())") == "8.0");
    CHECK(bench.value("level:data().par") == "3");
    CHECK(bench.value("#level:table().bodies") == "4");
}

TEST_CASE("a trigger notices who comes") {
    LuaBench bench(GameFiles{{"yard.lua", kYard}});
    REQUIRE(bench.run(
                "world = cairn.physics.new_world{} level = cairn.level.load('yard.lua') level:build(world)\n"
                "world:step(1 / 60)\n"
                "for kind, sensor, visitor in world:sensor_events() do\n"
                "  if kind == 'begin' and sensor == level:trigger('goal') then seen, count = visitor, (count "
                "or 0) + 1 end\n"
                "end") == "");
    CHECK(bench.value("seen == level:body('first')") == "true");
    CHECK(bench.value("count") == "1");
}

TEST_CASE("building again starts anew, and clearing leaves nothing") {
    LuaBench bench(GameFiles{{"yard.lua", kYard}});
    REQUIRE(bench.run(
                "world = cairn.physics.new_world{} level = cairn.level.load('yard.lua') level:build(world)\n"
                "count = world:body_count() for i = 1, 30 do world:step(1 / 60) end\n"
                "level:body('first'):destroy() level:build(world)") == "");
    CHECK(bench.value("world:body_count() == count") == "true");
    CHECK(bench.value("level:body('first'):is_valid()") == "true");
    // The world's ground, which a joint asked for, is not the level's.
    REQUIRE(bench.run("level:clear()") == "");
    CHECK(bench.value("world:body_count()") == "1");
    CHECK_THAT(bench.run("level:body('first')"), Contains("the level is not built"));
    CHECK_THAT(bench.run("level:build(world) level:body('frist')"), Contains("did you mean \"first\"?"));
    REQUIRE(bench.run("world:destroy() level:clear() level:reload()") == "");
    CHECK(bench.value("level:is_built()") == "false");
}

TEST_CASE(
    "every fault of a level is in one report, with line, column, path, value, rule and the nearest name") {
    LuaBench bench(GameFiles{{"bad.lua", R"({
    gravity_y = "down",
    bodys = {},
    materials = { ice = { fricton = 0 } },
    templates = { crate = { shape = "box", width = -1, height = 1 } },
    bodies = {
        { shape = "circle", radius = -1 },
        { template = "crat", x = 0 },
        { template = "crate", x = "left" },
        { shape = "boks", width = 1 },
        { shape = "box", width = 1 },
        { shape = "polygon", points = { { 0, 0 }, { 1 } } },
        { type = "dinamic", shape = "circle", radius = 1, material = "ic" },
        { name = "a b", shape = "circle", radius = 1 },
        { x = 1 },
        7,
    },
    joints = {
        { joint = "revolut" },
        { joint = "revolute", body_b = "nobody", x = 0, y = 0 },
        { joint = "gear", joint_1 = "later", joint_2 = "later" },
        { name = "later", joint = "weld", body_b = "nobody", x = 0 },
    },
    triggers = { { name = "goal", shape = "chain" } },
    spawns = { { name = "goal", x = 1, y = 2 } },
    decorations = { { image = "none.png", x = 0, y = 0, width = 1 } },
})"}});
    REQUIRE(bench.run("faults = cairn.level.check('bad.lua') text = table.concat(faults, '\\n')") == "");
    const std::string text = bench.value("text");
    for (const char* fault : {
             "bad.lua:2:17: gravity_y = \"down\": must be a number, is a string",
             "bad.lua:3:13: bodys: unknown field; did you mean \"bodies\"?",
             "bad.lua:4:37: materials.ice.fricton = 0: unknown field; did you mean \"friction\"?",
             "bad.lua:5:52: templates.crate.width = -1: must be above 0 and at most 2000000",
             "bad.lua:7:38: bodies[1].radius = -1: must be above 0 and at most 1000000",
             "bad.lua:8:22: bodies[2].template = \"crat\": no such template; did you mean \"crate\"?",
             "bad.lua:9:35: bodies[3].x = \"left\": must be a number, is a string",
             "bad.lua:10:19: bodies[4].shape = \"boks\": no such shape; did you mean \"box\"?",
             "bad.lua:11:9: bodies[5]: \"height\" is missing; it must be a number (m)",
             "bad.lua:12:51: bodies[6].points[2]: must be { x, y }, two numbers",
             "bad.lua:13:18: bodies[7].type = \"dinamic\": no such type; did you mean \"dynamic\"?",
             "bad.lua:13:70: bodies[7].material = \"ic\": no such material; did you mean \"ice\"?",
             "bad.lua:14:18: bodies[8].name = \"a b\": must be letters, digits, _ and -, and not empty",
             "bad.lua:15:9: bodies[9]: has neither \"shape\" nor \"shapes\"",
             "bad.lua:16:9: bodies[10] = 7: must be a table",
             "bad.lua:19:19: joints[1].joint = \"revolut\": no such joint; did you mean \"revolute\"?",
             "bad.lua:20:40: joints[2].body_b = \"nobody\": no such body",
             "bad.lua:21:37: joints[3].joint_1 = \"later\": must be a joint that stands before this one",
             "bad.lua:22:9: joints[4]: \"y\" is missing; it must be a number (m)",
             "bad.lua:24:43: triggers[1].shape = \"chain\": no such shape of a trigger",
             "bad.lua:25:25: spawns[1].name = \"goal\": is the name of triggers[1] already",
             "bad.lua:26:31: decorations[1].image = \"none.png\": there is no such file",
         }) {
        CHECK_THAT(text, Contains(fault));
    }
    // Loading raises the same report.
    CHECK(bench.value("select(2, pcall(cairn.level.load, 'bad.lua')) == text") == "true");
}

TEST_CASE("what shows only when a level is built is a fault of its part") {
    LuaBench bench(GameFiles{{"flat.lua", R"({
    bodies = {
        { name = "ok", shape = "circle", radius = 1 },
        { shape = "polygon", points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } },
    },
    prefabs = { { name = "line", prefab = "rope", x = 0, y = 0, to_x = 2, to_y = 0 } },
    joints = {
        { joint = "revolute", body_a = "ok", body_b = "ok", x = 0, y = 0 },
        { joint = "weld", body_a = "line.9999", body_b = "ok", x = 0, y = 0 },
    },
})"}});
    REQUIRE(bench.run("faults = cairn.level.check('flat.lua')") == "");
    CHECK(bench.value("#faults") == "3");
    CHECK_THAT(bench.value("faults[1]"), Contains("flat.lua:4:9: bodies[2]: "));
    CHECK_THAT(bench.value("faults[2]"), Contains("flat.lua:8:9: joints[1]: "));
    CHECK_THAT(bench.value("faults[3]"), Contains("\"line.9999\": there is no such body; \"line\" has "));
    CHECK(bench.value("pcall(cairn.level.load, 'none.lua')") == "false");
}

TEST_CASE("what shows only when a level is built is told beside the faults that show before") {
    LuaBench bench(GameFiles{{"both.lua", R"({
    templates = {
        bad = { shape = "box", width = -1, height = 1 },
        mixed = { shapes = { { shape = "circle", radius = -1 }, { shape = "boks" },
                             { shape = "polygon", points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } } } },
    },
    bodies = {
        { name = "a b", shape = "polygon", points = { { 0, 0 }, { 1, 0 }, { 2, 0 } } },
        { template = "bad" },
        { template = "mixed" },
        { template = "mixed", x = 1 },
        { name = "ok", shape = "circle", radius = 1, material = "none" },
        { shape = 7, x = "left", friction = -1 },
    },
    joints = {
        { joint = "weld", body_a = "ok", body_b = "ok", x = 0, y = 0 },
        { joint = "weld", body_a = "a b", body_b = "ok", x = 0, y = 0 },
        { joint = "revolut", body_a = "nobody", body_b = "ok" },
    },
    triggers = { a = { name = "t", shape = "circle" } },
})"}});
    REQUIRE(bench.run("faults = cairn.level.check('both.lua')") == "");
    const std::vector<std::string> expected = {
        "both.lua:3:40: templates.bad.width = -1: must be above 0",
        "both.lua:4:59: templates.mixed.shapes[1].radius = -1: must be above 0",
        "both.lua:4:75: templates.mixed.shapes[2].shape = \"boks\": no such shape",
        "both.lua:8:18: bodies[1].name = \"a b\": must be letters",
        "both.lua:12:65: bodies[5].material = \"none\": no such material",
        "both.lua:13:19: bodies[6].shape = 7: must be a string, is an integer",
        "both.lua:13:26: bodies[6].x = \"left\": must be a number, is a string",
        "both.lua:13:45: bodies[6].friction = -1: must be at least 0",
        "both.lua:18:19: joints[3].joint = \"revolut\": no such joint",
        "both.lua:18:39: joints[3].body_a = \"nobody\": no such body",
        "both.lua:20:16: triggers: must be a list",
        "both.lua:20:22: triggers.a: \"radius\" is missing",
        "both.lua:8:9: bodies[1]: ",
        "both.lua:5:30: templates.mixed.shapes[3]: ",
        "both.lua:16:9: joints[1]: ",
    };
    const auto count = static_cast<std::size_t>(std::stoi(bench.value("#faults")));
    for (std::size_t i = 0; i < std::min(count, expected.size()); ++i)
        CHECK_THAT(bench.value("faults[" + std::to_string(i + 1) + "]"), Catch::StartsWith(expected[i]));
    CHECK(count == expected.size());
}

TEST_CASE("names and sums where data should be do not hide other faults, nor are they told twice") {
    LuaBench bench(GameFiles{{"names.lua", R"({
    materials = { ice = ICE },
    bodies = {
        { name = crate, shape = "circle", radius = 2 * SIZE, material = "stone" },
        { shape = circle, friction = -1, sensor = yes },
        { shape = "polygon", points = { { 0, 0 }, { W, 0 }, { W / 2, 1 } } },
        { shape = "circle", radius = -1 },
    },
    joints = { { joint = "weld", body_a = "crate", body_b = "crate", x = 0, y = 0 } },
})"}});
    REQUIRE(bench.run("faults = cairn.level.check('names.lua')") == "");
    const std::vector<std::string> expected = {"names.lua:2:25: \"ICE\" is a name",
                                               "names.lua:4:18: \"crate\" is a name",
                                               "names.lua:4:54: expected , or }",
                                               "names.lua:5:19: \"circle\" is a name",
                                               "names.lua:5:51: \"yes\" is a name",
                                               "names.lua:6:53: \"W\" is a name",
                                               "names.lua:6:63: \"W\" is a name",
                                               "names.lua:5:38: bodies[2].friction = -1: must be at least 0",
                                               "names.lua:7:38: bodies[4].radius = -1: must be above 0"};
    const auto count = static_cast<std::size_t>(std::stoi(bench.value("#faults")));
    for (std::size_t i = 0; i < std::min(count, expected.size()); ++i)
        CHECK_THAT(bench.value("faults[" + std::to_string(i + 1) + "]"), Catch::StartsWith(expected[i]));
    CHECK(count == expected.size());
}

TEST_CASE("what a level says of its places, pictures and files is checked like the rest") {
    LuaBench bench(
        GameFiles{{"notes.txt", "no picture"},
                  {"art/x.txt", ""},
                  {"more.lua", "{ includes = {}, bodies = {}, materials = { ice = {} } }"},
                  {"torn.lua", "{ materials = "},
                  {"l.lua", R"({
    includes = { "l.lua", "more.lua", "more.lua", "none.lua" },
    bounds = { left = 5, right = -5, bottom = 1, top = 1 },
    camera = { x = 1e30, y = 0, height = 1e30 },
    spawns = { { name = "here", x = 0, y = -1e30 } },
    decorations = { { image = "notes.txt", x = 0, y = 0, width = 1 }, { image = "art", x = 0, y = 0, width = 1 } },
})"},
                  {"lost.lua",
                   "{ includes = { 'torn.lua' }, bodies = { { shape = 'circle', radius = 1, material = 'x' "
                   "}, { template = 'y' } } }"}});
    const auto text_of = [&](const char* file) {
        return bench.value("table.concat(cairn.level.check('" + std::string(file) + "'), '\\n')");
    };
    const std::string text = text_of("l.lua");
    for (const char* fault : {
             "l.lua:2:18: includes[1] = \"l.lua\": is this file itself",
             "l.lua:2:39: includes[3] = \"more.lua\": is included already",
             "l.lua:2:51: includes[4] = \"none.lua\": there is no such file",
             "more.lua:1:14: includes: has no effect here: of a file that is included, materials and "
             "templates are taken",
             "more.lua:1:27: bodies: has no effect here",
             "l.lua:3:34: bounds.right = -5: must be above left, which is 5",
             "l.lua:3:56: bounds.top = 1: must be above bottom, which is 1",
             "l.lua:4:20: camera.x = 1e+30: must be from -1e+12 to 1e+12",
             "l.lua:4:42: camera.height = 1e+30: must be from 1e-06 to 1000000000",
             "l.lua:5:44: spawns[1].y = -1e+30: must be from -1e+12 to 1e+12",
             "l.lua:6:31: decorations[1].image = \"notes.txt\": must be a picture: image 'notes.txt': is "
             "neither a PNG "
             "nor a JPEG file",
             "l.lua:6:81: decorations[2].image = \"art\": is a folder, and must be a picture",
         }) {
        CHECK_THAT(text, Contains(fault));
    }
    CHECK(std::count(text.begin(), text.end(), '\n') == 11);
    // What may stand in a file that cannot be read is not missed.
    CHECK_THAT(text_of("lost.lua"), Catch::StartsWith("torn.lua:1:") && !Contains("\n"));
}

TEST_CASE("a level file is never run, and may hold anything") {
    LuaBench bench(
        GameFiles{{"run.lua", "{ name = (function() ran = true end)() }"},
                  {"deep.lua", std::string(2000, '{') + std::string(2000, '}')},
                  {"list.lua", "{ 1, 2, 3 }"},
                  {"text.lua", "\x01\x02\x03"},
                  {"self.lua", "{ includes = { 'self.lua', 7, 'none.lua' } }"},
                  {"odd.lua", "{ bodies = { [3] = {} }, materials = 5, joints = { a = 1 }, camera = {} }"}});
    CHECK_THAT(bench.run("cairn.level.load('run.lua')"), Contains("run.lua:1:10: "));
    CHECK(bench.value("ran") == "nil");
    for (const char* file : {"deep", "list", "text", "self", "odd"}) {
        CHECK(bench.value("#cairn.level.check('" + std::string(file) + ".lua') > 0") == "true");
    }
}

TEST_CASE("materials and templates can stand in a file that several levels include") {
    LuaBench bench(GameFiles{
        {"common.lua",
         "{ materials = { wood = { density = 2 } }, templates = { plank = { shape = "
         "'box', width = 2, height = 1, material = 'wood' } } }"},
        {"one.lua", "{ includes = { 'common.lua' }, bodies = { { name = 'p', template = 'plank' } } }"}});
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = cairn.level.load('one.lua') l:build(w)") == "");
    CHECK(bench.value("l:body('p'):mass()") == "4.0");
    CHECK(bench.value("table.concat(l:files(), ' ')") == "one.lua common.lua");
}

TEST_CASE("reloading keeps what says the same and makes the rest anew") {
    const auto level = [](const char* crate_width, const char* more) {
        return std::string(
                   "{ bodies = { { name = 'ground', type = 'static', shape = 'box', y = -1, width = 40, "
                   "height = 2 "
                   "},") +
               more + "{ name = 'crate', shape = 'box', y = 5, width = " + crate_width +
               ", height = 1 }, { shape = 'circle', x = 3, y = 5, radius = 0.5 }, { name = 'swing', shape = "
               "'box', x = -5, y "
               "= 5, width = 1, height = 1 } }, joints = { { joint = 'revolute', body_b = 'swing', x = -5, y "
               "= 6 } } }";
    };
    GameFiles files{{"l.lua", level("1", "")}};
    LuaBench bench(files);
    const auto save = [&](const std::string& text) {
        const auto path = bench.machine().files->native_path("l.lua");
        REQUIRE(path);
        std::ofstream(*path) << text;
    };
    REQUIRE(
        bench.run("world = cairn.physics.new_world{} level = cairn.level.load('l.lua') level:build(world)\n"
                  "crate, swing = level:body('crate'), level:body('swing')\n"
                  "for i = 1, 30 do world:step(1 / 60) end y = select(2, crate:position()) hash = "
                  "world:state_hash()") == "");
    REQUIRE(bench.run("kept, made = level:reload()") == "");
    CHECK(bench.value("kept .. ' ' .. made") == "5 0");
    CHECK(bench.value("world:state_hash() == hash") == "true");

    save(level("2", "{ shape = 'circle', x = 8, y = 5, radius = 1 },"));
    REQUIRE(bench.run("kept, made = level:reload()") == "");
    CHECK(bench.value("kept .. ' ' .. made") == "4 2");
    CHECK(bench.value("crate:is_valid()") == "false");
    CHECK(bench.value("swing:is_valid() and swing == level:body('swing')") == "true");
    CHECK(bench.value("select(2, level:body('crate'):position())") == "5.0");
    CHECK(bench.value("world:body_count()") == "6");

    // A fault changes nothing.
    save("{ bodies = { { shape = 'boks' } } }");
    CHECK_THAT(bench.run("level:reload()"), Contains("did you mean \"box\""));
    CHECK(bench.value("#level:bodies()") == "5");

    // A joint that changes takes its bodies back to where the level has them.
    std::string moved = level("2", "{ shape = 'circle', x = 8, y = 5, radius = 1 },");
    moved.replace(moved.find("x = -5, y = 6"), 13, "x = -4, y = 6");
    save(moved);
    REQUIRE(bench.run("level:reload()") == "");
    CHECK(bench.value("swing:is_valid()") == "false");
    CHECK(bench.value("world:joint_count()") == "1");
}

TEST_CASE("reloading a level that is not built reads its file and tells that nothing was kept or made") {
    LuaBench bench(
        GameFiles{{"l.lua", "{ name = 'a', bodies = { { name = 'x', shape = 'circle', radius = 1 } } }"}});
    const auto reloaded = [&] {
        REQUIRE(bench.run("kept, made = level:reload()") == "");
        return bench.value("kept .. ' ' .. made .. ' ' .. tostring(level:is_built())");
    };
    REQUIRE(bench.run("world = cairn.physics.new_world{} level = cairn.level.load 'l.lua'") == "");
    CHECK(reloaded() == "0 0 false");
    REQUIRE(bench.run("level:build(world)") == "");
    CHECK(reloaded() == "1 0 true");
    REQUIRE(bench.run("level:clear()") == "");
    CHECK(reloaded() == "0 0 false");
    REQUIRE(bench.run("level:build(world) world:destroy()") == "");
    std::ofstream(*bench.machine().files->native_path("l.lua")) << "{ name = 'b' }";
    CHECK(reloaded() == "0 0 false");
    CHECK(bench.value("level:name()") == "b");
}

TEST_CASE("the level of the documentation is a good one") {
    std::ifstream file(cairn::test::source_path("docs/examples/levels/yard.lua"));
    std::ostringstream text;
    text << file.rdbuf();
    LuaBench bench(GameFiles{{"yard.lua", text.str()}});
    CHECK(bench.value("table.concat(cairn.level.check('yard.lua'), '\\n')") == "");
    CHECK(bench.value("#cairn.level.load('yard.lua'):data().stars") == "3");
}

TEST_CASE("decorations stand in the world, each in its layer") {
    engine::Image red;
    red.size = {2, 2};
    red.rgba = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};
    const std::string file = (std::filesystem::temp_directory_path() / "cairn-decoration.png").string();
    REQUIRE(engine::save_png(red, file));
    std::ifstream stream(file, std::ios::binary);
    const std::string png((std::istreambuf_iterator<char>(stream)), {});
    std::filesystem::remove(file);
    LuaBench bench(GameFiles{{"conf.lua", "{ width = 200, height = 100 }"},
                             {"red.png", png},
                             {"l.lua",
                              "{ decorations = { { image = 'red.png', x = 5, y = 8, width = 2 }, { image = "
                              "'red.png', x = 15, y = 2, width = 4, height = 2, layer = 'front' } } }"}},
                   MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(
                "level = cairn.level.load 'l.lua' camera = cairn.camera.new{ x = 10, y = 5, height = 10 }") ==
            "");
    // Ten pixels are a metre; y points up.
    const engine::Image back = picture_of(bench, "camera:attach() level:draw() camera:detach()");
    is_color(back, 50, 20, 255, 0, 0);
    is_color(back, 50, 35, 0, 0, 0);
    is_color(back, 150, 80, 0, 0, 0);
    const engine::Image front = picture_of(bench, "camera:attach() level:draw('front') camera:detach()");
    is_color(front, 135, 85, 255, 0, 0);
    is_color(front, 150, 65, 0, 0, 0);
    is_color(front, 50, 20, 0, 0, 0);
}

// ---- Tiled

TEST_CASE("a map of Tiled is a level: solid tiles are chains, objects are bodies, triggers and spawns") {
    const char* const map = R"(<?xml version="1.0"?>
<map orientation="orthogonal" width="4" height="3" tilewidth="10" tileheight="10" infinite="0">
 <properties><property name="gravity_y" type="float" value="-4"/><property name="par" type="int" value="2"/></properties>
 <tileset firstgid="1" name="t" tilewidth="10" tileheight="10" tilecount="1" columns="1"><image source="t.png" width="10" height="10"/></tileset>
 <layer name="ground" width="4" height="3"><properties><property name="solid" type="bool" value="true"/>
  <property name="friction" type="float" value="0.25"/></properties>
  <data encoding="csv">0,0,0,0, 0,0,0,0, 1,1,1,1</data></layer>
 <objectgroup name="things">
  <object id="1" name="crate" x="10" y="5" width="10" height="10"><properties><property name="type" value="dynamic"/>
   <property name="loot" value="gold"/></properties></object>
  <object id="2" name="start" type="spawn" x="5" y="15"><point/></object>
  <object id="3" name="exit" type="trigger" x="30" y="10" width="10" height="10"/>
  <object id="4" name="bump" x="0" y="20"><polygon points="0,0 5,-5 10,0"/></object>
  <object id="5" type="camera" x="0" y="0" width="40" height="30"/>
 </objectgroup>
</map>)";
    LuaBench bench(GameFiles{{"map.tmx", map}});
    REQUIRE(bench.run("w = cairn.physics.new_world{} l = cairn.level.load('map.tmx') l:build(w)") == "");
    CHECK(bench.value("select(2, w:gravity())") == "-4.0");
    CHECK(bench.value("l:data().par") == "2");
    CHECK(bench.value("#l:bodies()") == "3");
    CHECK(bench.value("l:bodies()[1].data.layer") == "ground");
    CHECK(bench.value("l:bodies()[1]:shapes()[1]:friction()") == "0.25");
    CHECK(bench.value("table.concat({ l:body('crate'):position() }, ' ')") == "1.5 2.0");
    CHECK(bench.value("l:body('crate').data.loot .. l:body('crate'):type() .. l:body('bump'):type()") ==
          "golddynamicstatic");
    CHECK(bench.value("table.concat({ l:spawn('start') }, ' ')") == "0.5 1.5 0.0");
    CHECK(bench.value("select(3, l:camera())") == "3.0");
    REQUIRE(bench.run("for i = 1, 120 do w:step(1 / 60) end") == "");
    CHECK(bench.value("math.abs(select(2, l:body('crate'):position()) - 1.5) < 0.02") == "true");
}

}  // namespace
}  // namespace cairn::scripting::test
