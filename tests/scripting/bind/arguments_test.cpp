// Every described binding is called with nonsense: it must raise an error that names it, or accept, and never
// crash.
#include <catch2/catch.hpp>
#include <set>

#include "bind/fields.h"
#include "bind/module.h"
#include "scripting/support/drawing.h"
#include "scripting/support/good_calls.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

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

/// Every binding that the registry knows, but those of cairn.test, which is only there in tests of games and
/// has its nonsense in test_game_test.cpp.
std::set<std::string> all_bindings() {
    std::set<std::string> names;
    for (const Module* module : all_modules()) {
        if (std::string(module->name) == "cairn.test") continue;
        for (const Function& function : module->functions) names.insert(full_name(*module, function));
    }
    return names;
}

TEST_CASE("every function that scripts find in cairn is a binding of the registry, and none is missing") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
        names = {}
        for key, value in pairs(cairn) do
            if type(value) == "function" then names[#names + 1] = "cairn." .. key end
            if type(value) == "table" then
                for name, member in pairs(value) do
                    if type(member) == "function" then names[#names + 1] = "cairn." .. key .. "." .. name end
                end
            end
        end
        table.sort(names)
    )") == "");
    std::set<std::string> modules;
    for (const std::string& name : all_bindings()) {
        if (name.find(':') == std::string::npos) modules.insert(name);
    }
    std::string expected;
    for (const std::string& name : modules) expected += name + ' ';
    CHECK(bench.value("table.concat(names, ' ') .. ' '") == expected);
    CHECK(all_bindings().size() > 460);
}

/// Whether what stands behind "Canvas:attach: " names that once more: "canvas: it is ...".
bool names_twice(const std::string& name, const std::string& message) {
    const std::size_t start = message.find(name + ": ");
    if (start == std::string::npos) return false;
    const std::size_t behind = start + name.size() + 2;
    const std::string next = message.substr(behind, message.find(": ", behind) - behind);
    std::string word;
    for (const char c : name + '.') {
        const bool is_letter = c != '.' && c != ':' && c != '_';
        if (!is_letter && !word.empty() && word == next) return true;
        word = is_letter ? word + static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c) : "";
    }
    return false;
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
    std::set<std::string> called;
    for (const Module* module : all_modules()) {
        if (std::string(module->name) == "cairn.test") continue;  // only there in tests of games
        LuaBench bench(kGoodFiles);
        const std::string path = module->is_type ? receiver(module->name) : module->name;
        REQUIRE(bench.run("receiver = " + path) == "");
        for (const Function& function : module->functions) {
            const std::string name =
                std::string(module->name) + (module->is_type ? ":" : ".") + function.name;
            called.insert(name);
            // Its receiver is wanted further on; and it takes no argument.
            if (std::string(function.name) == "destroy") continue;
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
                    CHECK_FALSE(names_twice(name, message));
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
    CHECK(called == all_bindings());
}

/// An expression that a field of a described table takes.
std::string good_field(const Field& field) {
    const std::string_view name = field.name;
    if (!field.choices.empty()) return "'" + words_of(field.choices).front() + "'";
    switch (field.type) {
        case FieldType::Number:
            return name == "x2" || name == "to_x" ? "2" : "1";
        case FieldType::Integer:
            return "2";
        case FieldType::Boolean:
            return "true";
        case FieldType::String:
            return "'text'";
        case FieldType::Table:
            return "{ 1, 2 }";
        case FieldType::Points:
            return "{ { 0, 0 }, { 2, 0 }, { 1, 1 } }";
        case FieldType::Function:
            return "print";
        case FieldType::Body:
            return name == "body_b" ? "other" : "body";
        case FieldType::Joint:
            return name == "joint_2" ? "joint_2" : "joint";
    }
    return "nil";
}

const std::vector<std::string> kNonsense = {"nil",
                                            "true",
                                            "'text'",
                                            "''",
                                            "{}",
                                            "{ 1, 'a' }",
                                            "{ { 0/0, 1/0 } }",
                                            "print",
                                            "0/0",
                                            "1/0",
                                            "-1/0",
                                            "-1",
                                            "0",
                                            "1e300",
                                            "1e-300",
                                            "0x7fffffffffffffff",
                                            "math.mininteger",
                                            "cairn.random.visual",
                                            "world",
                                            "body",
                                            "shape",
                                            "joint",
                                            "dead",
                                            "setmetatable({}, { __index = error, __len = error })"};

TEST_CASE("one wrong argument among good ones raises an error that names the binding, and never crashes") {
    for (const Module* module : all_modules()) {
        const std::string type = module->name;
        if (type == "cairn.test") continue;  // only there in tests of games
        for (const Function& function : module->functions) {
            const std::string name = type + (module->is_type ? ":" : ".") + function.name;
            const std::size_t first = module->is_type ? 1 : 0;
            const std::size_t count = function.parameter_types.size() - first;
            if (count == 0) continue;
            LuaBench bench(kGoodFiles);
            REQUIRE(bench.run(kGood) == "");
            const std::string receiver_code = module->is_type ? good_receiver(type) : type;
            for (std::size_t position = 0; position < count; ++position) {
                for (const std::string& value : kNonsense) {
                    std::string arguments;
                    for (std::size_t i = 0; i < count; ++i) {
                        arguments +=
                            (i > 0 ? ", " : "") +
                            (i == position ? value : good_value(function.parameter_types[first + i]));
                    }
                    const std::string call = "local r = " + receiver_code + " r" +
                                             (module->is_type ? ":" : ".") + function.name + '(' + arguments +
                                             ')';
                    INFO(call);
                    const std::string message = bench.run(call);
                    INFO(message);
                    // What a metamethod raises is the script's own.
                    const bool is_own = value.starts_with("setmetatable") ||
                                        message.find("bad argument #2 to 'error'") != std::string::npos;
                    if (!message.empty() && !is_own) CHECK(message.find(name + ": ") != std::string::npos);
                    CHECK_FALSE(names_twice(name, message));
                    REQUIRE(bench.run(kMend) == "");
                }
            }
        }
    }
}

TEST_CASE(
    "one wrong field among good ones raises an error that names the field or its rule, and never crashes") {
    for (const Module* module : all_modules()) {
        for (const Function& function : module->functions) {
            if (function.fields == nullptr || std::string(module->name) == "cairn.test") continue;
            const std::string name =
                std::string(module->name) + (module->is_type ? ":" : ".") + function.name;
            const std::vector<const Field*> fields = all_fields(*function.fields);
            LuaBench bench(GameFiles{
                {"pixel.png", kPixel},
                {"level.lua", "{}"},
                {"map.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1, "layers": []})"}});
            for (const Field* field : fields) {
                REQUIRE(bench.run(kGood) == "");
                for (const std::string& value : kNonsense) {
                    std::string table = "{ ";
                    for (const Field* other : fields) {
                        if (other->default_text != nullptr && other != field) continue;
                        table += std::string(other->name) + " = " +
                                 (other == field ? value : good_field(*other)) + ", ";
                    }
                    table += "}";
                    std::string arguments;
                    const std::size_t first = module->is_type ? 1 : 0;
                    for (std::size_t i = first; i < function.parameter_types.size(); ++i) {
                        const auto parameters = parse_parameters(function.parameters);
                        const bool is_table = parameters[i - first].name == "fields";
                        arguments += (i > first ? ", " : "") +
                                     (is_table ? table : good_value(function.parameter_types[i]));
                    }
                    const std::string call =
                        "local r = " +
                        (module->is_type ? good_receiver(module->name) : std::string(module->name)) + " r" +
                        (module->is_type ? ":" : ".") + function.name + '(' + arguments +
                        ") if world:is_valid() then world:step(1 / 60) end";
                    INFO(call);
                    const std::string message = bench.run(call);
                    INFO(message);
                    const bool is_own = value.starts_with("setmetatable") ||
                                        message.find("bad argument #2 to 'error'") != std::string::npos;
                    if (!message.empty() && !is_own) CHECK(message.find(name + ": ") != std::string::npos);
                    CHECK_FALSE(names_twice(name, message));
                    REQUIRE(bench.run(kMend) == "");
                }
                REQUIRE(bench.run("world:destroy()") == "");
            }
        }
    }
}

TEST_CASE("what goes wrong while drawing is told with the name of the call, once") {
    for (const Module* module : all_modules()) {
        if (std::string(module->name) == "cairn.test") continue;  // only there in tests of games
        for (const Function& function : module->functions) {
            const std::string name = full_name(*module, function);
            const std::size_t first = module->is_type ? 1 : 0;
            std::string arguments;
            for (std::size_t i = first; i < function.parameter_types.size(); ++i)
                arguments += (i > first ? ", " : "") + good_value(function.parameter_types[i]);
            LuaBench bench(kGoodFiles, MachineKind::HeadlessDrawing);
            REQUIRE(bench.run(kGood) == "");
            // So often that what has an end meets it.
            REQUIRE(bench.run("receiver = " +
                              (module->is_type ? good_receiver(module->name) : std::string(module->name)) +
                              " function call_often() for _ = 1, 200 do receiver" +
                              (module->is_type ? ":" : ".") + function.name + '(' + arguments +
                              ") end end") == "");
            const std::string message = draw_error(bench, "call_often()");
            INFO(name << ": " << message);
            if (!message.empty()) CHECK(message.find(name + ": ") != std::string::npos);
            CHECK_FALSE(names_twice(name, message));
        }
    }
}

TEST_CASE("too many arguments are no crash, and what was destroyed is an error in every method") {
    for (const Module* module : all_modules()) {
        const std::string type = module->name;
        if (type != "World" && type != "Body" && type != "Shape" && type != "Joint" && type != "Chain" &&
            type != "Prefab")
            continue;
        LuaBench bench;
        REQUIRE(bench.run("receiver = " + receiver(type) + " receiver:destroy()") == "");
        for (const Function& function : module->functions) {
            const std::string_view method = function.name;
            if (method == "is_valid" || (type == "Prefab")) continue;  // a prefab without parts is one still
            const std::string message =
                bench.run("receiver:" + std::string(method) + "(1, 2, 3, 4, 5, 6, 7, 8, 9, 10)");
            INFO(type << ':' << method);
            CHECK(message.find(type + ':' + std::string(method) + ": ") != std::string::npos);
            CHECK(message.find("destroyed") != std::string::npos);
        }
    }
}

TEST_CASE("a wrong argument is named with its value, the rule and the caller's place") {
    LuaBench bench;
    CHECK(bench.run("local w = cairn.physics.new_world{}\nw:set_gravity(1, 'down')") ==
          "test.lua:2: World:set_gravity: y is \"down\"; expected a number");
    CHECK(bench.run("cairn.timer.after(-1, print)") ==
          "test.lua:1: cairn.timer.after: seconds is -1; expected a number, at least 0 s");
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
          "test.lua:1: World:add_box: radius = -1: must be from 0 to 1000000");
    CHECK(message("w:add_box{ width = 1, height = 3e6 }") ==
          "test.lua:1: World:add_box: height = 3000000.0: must be above 0 and at most 2000000");
    CHECK(message("w:add_circle{ radius = 1/0 }") ==
          "test.lua:1: World:add_circle: radius = inf: must be above 0 and at most 1000000");
    CHECK(message("w:add_capsule{ length = 0.001, radius = 1 }") ==
          "test.lua:1: World:add_capsule: length = 0.001: must be above 0.005 and at most 2000000");
    CHECK(message("w:add_circle{ radius = 1, friction = -1 }") ==
          "test.lua:1: World:add_circle: friction = -1: must be at least 0 and finite");
    CHECK(message("w:add_circle{ radius = 1, restitution = 2 }") ==
          "test.lua:1: World:add_circle: restitution = 2: must be from 0 to 1");
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
          "test.lua:1: World:step: dt is 0; expected a number above 0 and at most 1 s");
    for (const char* nan : {"0/0", "-(0/0)"}) {
        CHECK(bench.run(std::string("w:set_gravity(") + nan + ", 0)") ==
              "test.lua:1: World:set_gravity: x is nan; expected a finite number");
    }
    CHECK(bench.run("w:set_gravity(math.huge, 0)") ==
          "test.lua:1: World:set_gravity: x is inf; expected a finite number");
    CHECK(author_words("revolute_joint.body_a and .body_b are the same body, but must be two bodies") ==
          "body_a and body_b are the same body, but must be two bodies");
    CHECK(author_words("distance_joint.min_length_m is 3, but must be at most length_m") ==
          "min_length is 3, but must be at most length");
    CHECK(author_words("the distance from chain.points_m[0] to chain.points_m[19] is 0.001, [at] [2, 3] [") ==
          "the distance from points[1] to points[20] is 0.001, [at] [2, 3] [");
    CHECK_THAT(bench.run("w:add_chain{ points = { {0, 0}, {-1, 0}, {-1, 0.001}, {-2, 0} } }"),
               Catch::Contains("the distance from points[2] to points[3] is 0.001"));
    CHECK(author_words("gear_joint.joint_2 is a distance_joint, but must be revolute or prismatic") ==
          "joint_2 is a distance joint, but must be revolute or prismatic");
    CHECK(author_words("the shape is no sensor, but must be one (ShapeDef::sensor)") ==
          "the shape is no sensor, but must be one (sensor)");
    CHECK(bench.run("b:cut(1, 2, 1, 2)") ==
          "test.lua:1: Body:cut: the length of the cut is 0, but must be greater than 0.005 m and at most "
          "1e9 m");
    CHECK(author_words("the distance is 0.001, but must be greater than 0.005 m (-nan)") ==
          "the distance is 0.001, but must be greater than 0.005 m (nan)");
}

}  // namespace
}  // namespace cairn::scripting::test
