// Numbers that make no sense, arguments too many, names that are none: of every binding, from its
// description.
#include <catch2/catch.hpp>

#include <cairn/scripting/reference.h>

#include "bind/callbacks.h"
#include "bind/module.h"
#include "bind/range.h"
#include "scripting/support/drawing.h"
#include "scripting/support/good_calls.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Calls `visit(module, function, receiver)` for all but those of cairn.test, which is only there in tests of
/// games.
template <class Visit>
void for_each_binding(const Visit& visit) {
    for (const Module* module : all_modules()) {
        if (std::string(module->name) == "cairn.test") continue;
        for (const Function& function : module->functions)
            visit(*module, function, module->is_type ? good_receiver(module->name) : module->name);
    }
}

std::string call(const Module& module, const Function& function, const std::string& receiver,
                 const std::vector<std::string>& arguments) {
    std::string text = "local r = " + receiver + " r" + (module.is_type ? ":" : ".") + function.name + '(';
    for (std::size_t i = 0; i < arguments.size(); ++i) text += (i > 0 ? ", " : "") + arguments[i];
    return text + ')';
}

TEST_CASE("a range holds its ends or not, and says so") {
    CHECK(kShare.contains(0));
    CHECK(kShare.contains(1));
    CHECK_FALSE(kShare.contains(1.0000001));
    CHECK_FALSE(kShare.contains(-1e-300));
    CHECK_FALSE(kPositive.contains(0));
    CHECK_FALSE(kPositive.contains(1e-300));  // 0 in a float
    CHECK(kPositive.contains(1e-30));
    CHECK(kNotNegative.contains(0));
    CHECK_FALSE(kNotNegative.contains(std::numeric_limits<double>::infinity()));
    CHECK(kNotNegativeOrInfinite.contains(std::numeric_limits<double>::infinity()));
    CHECK_FALSE(kNotNegativeOrInfinite.contains(std::numeric_limits<double>::quiet_NaN()));
    CHECK(to_text(kShare) == "from 0 to 1");
    CHECK(to_text(kStepTime) == "above 0 and at most 1");
    CHECK(to_text(kNotNegative) == "at least 0");
    CHECK(to_text(Range{}) == "");
}

TEST_CASE(
    "a number beyond the range of its parameter is an error that names both, and the reference has it") {
    const std::string reference = reference_markdown();
    std::size_t ranges = 0;
    for_each_binding([&](const Module& module, const Function& function, const std::string& receiver) {
        const auto parameters = parse_parameters(function.parameters);
        const std::size_t first = module.is_type ? 1 : 0;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const Range* range = function.parameter_ranges[first + i];
            if (range == nullptr) continue;
            ++ranges;
            INFO(full_name(module, function) << ' ' << parameters[i].name);
            CHECK(reference.find(std::string(parameters[i].name) + ' ' + to_text(*range)) !=
                  std::string::npos);
            const bool is_integer = function.parameter_types[first + i] == "integer";
            std::vector<double> wrong;
            if (range->has_low()) wrong.push_back(range->excludes_low ? range->low : range->low - 1);
            if (range->has_high()) wrong.push_back(range->high + 1);
            REQUIRE(!wrong.empty());
            LuaBench bench(kGoodFiles);
            REQUIRE(bench.run(kGood) == "");
            for (const double number : wrong) {
                std::vector<std::string> arguments;
                for (std::size_t k = 0; k < parameters.size(); ++k)
                    arguments.push_back(good_value(function.parameter_types[first + k]));
                char text[40];
                std::snprintf(text, sizeof text, is_integer ? "%.0f" : "%.17g", number);
                arguments[i] = text;
                const std::string message = bench.run(call(module, function, receiver, arguments));
                INFO(message);
                CHECK(message.find(full_name(module, function) + ": " + std::string(parameters[i].name) +
                                   " is ") != std::string::npos);
                CHECK(message.find(to_text(*range)) != std::string::npos);
            }
        }
    });
    CHECK(ranges > 80);
}

TEST_CASE("numbers that make no sense are refused") {
    LuaBench bench;
    REQUIRE(bench.run("c = cairn.camera.new{}  w = cairn.physics.new_world{}  r = cairn.random") == "");
    const std::pair<const char*, const char*> calls[] = {
        {"r.chance(7)", "cairn.random.chance: probability is 7; expected a number from 0 to 1"},
        {"r.visual:chance(-0.1)", "Random:chance: probability is -0.1; expected a number from 0 to 1"},
        {"r.normal(0, -1)", "cairn.random.normal: deviation is -1; expected a number, at least 0"},
        {"r.integer(3, 1)", "cairn.random.integer: low is 3 and high is 1; expected low <= high"},
        {"w:step(1e300)", "World:step: dt is 1e+300; expected a number above 0 and at most 1 s"},
        {"w:set_gravity(0, -1e300)", "y is -1e+300; expected a number between -3.4e38 and 3.4e38"},
        {"w:add_circle{ radius = 1, friction = 1e300 }",
         "friction = 1e+300: must be between -3.4e38 and 3.4e38"},
        {"cairn.input.rumble(1, 5, 1)", "cairn.input.rumble: strength is 5; expected a number from 0 to 1"},
        {"cairn.input.rumble(1, 1, 1, -1)", "cairn.input.rumble: low is -1; expected a number from 0 to 1"},
        {"cairn.audio.set_volume('sfx', 1.5)", "volume is 1.5; expected a number from 0 to 1"},
        {"c:set_bounds(-math.huge, 0, 1, 1)", "Camera:set_bounds: left is -inf; expected a finite number"},
        {"c:set_bounds(0, 0, 1, math.huge)", "Camera:set_bounds: top is inf; expected a finite number"},
        {"c:set_bounds(2, 0, 1, 1)", "left is 2 and right is 1; expected left <= right"},
        {"c:set_bounds(0, 3, 1, 1)", "bottom is 3 and top is 1; expected bottom <= top"},
        {"c:set_bounds(nil, 3, 1, 1)", "left, bottom, right and top are expected, or no argument at all"},
        {"c:follow(nil, 1)", "x and y are expected, or no argument at all"},
    };
    for (const auto& [code, message] : calls) {
        INFO(code);
        CHECK_THAT(bench.run(code), Catch::Contains(message));
    }
    // What makes sense, at the ends too.
    CHECK(bench.run("assert(r.chance(1)) assert(not r.chance(0)) r.normal(0, 0) c:set_bounds(1, 1, 1, 1) "
                    "c:set_bounds() c:follow() w:step(1)") == "");
}

TEST_CASE("shapes that make no sense are refused, and dents are filled") {
    LuaBench drawing({}, MachineKind::HeadlessDrawing);
    CHECK_THAT(draw_error(drawing, "cairn.graphics.circle('fill', 9, 9, -3)"),
               Catch::Contains("cairn.graphics.circle: radius is -3; expected a number, at least 0"));
    CHECK_THAT(draw_error(drawing, "cairn.graphics.line(1, 2, 3, 1/0)"),
               Catch::Contains("expected a finite number"));
    CHECK_THAT(
        draw_error(drawing, "cairn.graphics.polygon('line', { 1, 2, 3, 1e300, 5, 6 })"),
        Catch::Contains("the list's member 4 is 1e+300; expected a number between -3.4e38 and 3.4e38"));
    CHECK_THAT(draw_error(drawing, "cairn.graphics.polygon('fill', { 0, 0, 20, 20, 20, 0, 0, 20 })"),
               Catch::Contains(
                   "cairn.graphics.polygon: the side from corner 1 to 2 crosses that from corner 3 to 4"));
    // An arrow head: its dent stays as it was.
    const engine::Image image =
        picture_of(drawing, "cairn.graphics.polygon('fill', { 10, 10, 50, 30, 10, 50, 30, 30 })");
    is_color(image, 20, 30, 0, 0, 0);
    is_color(image, 40, 30, 255, 255, 255);
    is_color(image, 20, 17, 255, 255, 255);
    is_color(image, 20, 43, 255, 255, 255);
}

// ---- Arguments too many

TEST_CASE("one argument too many is an error that says how many there may be") {
    std::size_t called = 0;
    for_each_binding([&](const Module& module, const Function& function, const std::string& receiver) {
        const std::string name = full_name(module, function);
        const auto parameters = parse_parameters(function.parameters);
        const bool takes_any =
            !parameters.empty() && (parameters.back().name == "..." || name == "cairn.graphics.line");
        if (takes_any) return;
        ++called;
        LuaBench bench(kGoodFiles);
        REQUIRE(bench.run(kGood) == "");
        INFO(name);
        const std::size_t most = parameters.size();
        const std::vector<std::string> fitting(most, "nil");
        CHECK(bench.run(call(module, function, receiver, fitting)).find(" takes ") == std::string::npos);
        REQUIRE(bench.run(kMend) == "");
        const std::vector<std::string> too_many(most + 1, "nil");
        const std::string message = bench.run(call(module, function, receiver, too_many));
        const bool is_flexible = most > 0 && !parameters.back().default_value.empty();
        CHECK(message == "test.lua:1: " + name + " takes " + (is_flexible ? "at most " : "") +
                             (most == 0 ? "no" : std::to_string(most)) + " argument" +
                             (most == 1 ? "" : "s") + ", " + std::to_string(most + 1) + " given");
    });
    CHECK(called > 450);
}

TEST_CASE("calls within calls pass their values on, as long as they fit") {
    LuaBench bench(kGoodFiles, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(kGood) == "");
    CHECK(bench.run(
              "local c = cairn.camera.new{} c:to_screen(body:position()) body:set_transform(body:transform())"
              " c:follow(body:world_center())") == "");
    CHECK(bench.run("cairn.random.chance(0.5, 1, 2)") ==
          "test.lua:1: cairn.random.chance takes 1 argument, 3 given");
    CHECK(bench.run("body:set_angle(body:transform())") ==
          "test.lua:1: Body:set_angle takes 1 argument, 3 given");
    // As many as one likes.
    CHECK(bench.run("local got cairn.scene.push({ enter = function(_, ...) got = select('#', ...) end }, 1, "
                    "nil, 3, nil) "
                    "assert(got == 4)") == "");
    CHECK(draw_error(bench, "cairn.graphics.line(1, 2, 3, 4, 5, 6, 7, 8)") == "");
    CHECK_THAT(draw_error(bench, "cairn.graphics.line({ 1, 2, 3, 4 }, 5)"),
               Catch::Contains("cairn.graphics.line takes 1 argument, 2 given"));
}

// ---- Names

TEST_CASE("every type and module tells of a name that it lacks, and the nearest that it has") {
    for (const Module* module : all_modules()) {
        const std::string type = module->name;
        if (type == "cairn.test" || type == "cairn") continue;
        LuaBench bench(kGoodFiles);
        REQUIRE(bench.run(kGood) == "");
        REQUIRE(bench.run("receiver = " + (module->is_type ? good_receiver(type) : type)) == "");
        for (const Function& function : module->functions) {
            const std::string slip = std::string(function.name) + "z";
            INFO(type << ' ' << slip);
            const std::string start = "test.lua:1: " + type + " has no \"" + slip + '"';
            CHECK(bench.run("local _ = receiver." + slip) ==
                  start + "; did you mean \"" + function.name + "\"?");
        }
    }
}

TEST_CASE("a misspelt module or function of cairn names the nearest, and all else that cairn lacks is nil") {
    LuaBench bench;
    CHECK(bench.run("cairn.graphic.circle('fill', 1, 2, 3)") ==
          "test.lua:1: cairn has no \"graphic\"; did you mean \"graphics\"?");
    CHECK(bench.run("local r = cairn.randon") ==
          "test.lua:1: cairn has no \"randon\"; did you mean \"random\"?");
    CHECK(bench.run("cairn.sorted_pair({})") ==
          "test.lua:1: cairn has no \"sorted_pair\"; did you mean \"sorted_pairs\"?");
    CHECK(bench.run("cairn.Audio.stop_all()") ==
          "test.lua:1: cairn has no \"Audio\"; did you mean \"audio\"?");
    for (const Callback& callback : callbacks())
        CHECK(bench.value(std::string("cairn.") + callback.name) == "nil");
    for (const char* name : {"test", "updat", "player", "my_levels", "x"})
        CHECK(bench.value("cairn." + std::string(name)) == "nil");
    CHECK(bench.value("cairn[1]") == "nil");
    CHECK(
        bench.run(
            "cairn.graphic = 5 assert(cairn.graphic == 5) function cairn.wheel() end assert(cairn.wheel)") ==
        "");
    CHECK(bench.run("setmetatable(cairn, nil)") != "");
}

}  // namespace
}  // namespace cairn::scripting::test
