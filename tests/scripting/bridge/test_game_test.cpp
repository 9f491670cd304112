#include <catch2/catch.hpp>

#include <cairn/scripting/test_game.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

int status_of(const std::string& test_code, const std::string& main_code = "") {
    const GameFolder folder({{"main.lua", main_code}, {"tests/one.lua", test_code}});
    return test_game(folder.source());
}

TEST_CASE("tests pass or fail by the errors that they raise") {
    CHECK(status_of("cairn.test.test('fine', function() end)") == 0);
    CHECK(status_of("cairn.test.test('bad', function() error('no') end)") == 1);
    CHECK(status_of("cairn.test.test('fine', function() end) cairn.test.test('bad', function() "
                    "cairn.test.expect(false) end)") == 1);
    CHECK(status_of("syntax error") == 1);
    CHECK(status_of("") == 1);
}

TEST_CASE("errors of the game's callbacks fail the test that runs them") {
    const std::string run = "cairn.test.test('runs', function() cairn.test.start{} cairn.test.run(3) end)";
    CHECK(status_of(run, "function cairn.update() end") == 0);
    CHECK(status_of(run, "function cairn.update() error('broken') end") == 1);
    CHECK(status_of(run, "error('broken')") == 1);
    CHECK(status_of("cairn.test.test('x', function() cairn.test.run(1) end)") == 1);
}

TEST_CASE("nonsense in any argument of the functions for tests raises an error that names them") {
    CHECK(status_of(R"(
local test = cairn.test
local nonsense = { true, "text", {}, { 1, "a" }, print, 0/0, 1/0, -1, 1e300, math.mininteger, cairn.random.visual,
    coroutine.create(print) }
local called = 0
local function call(name, f, ...)
    called = called + 1
    local fine, message = pcall(f, ...)
    -- What is expected and does not hold fails in words of its own.
    if fine or name:find("^expect") then return end
    test.expect(tostring(message):find("cairn%.test%." .. name .. "[: ]"), name .. ": " .. tostring(message))
end
test.test("nonsense", function()
    test.start{}
    for name, f in cairn.sorted_pairs(test) do
        for _, value in ipairs(nonsense) do
            call(name, f, value)
            call(name, f, nil, value)
            call(name, f, nil, nil, value)
        end
    end
    test.expect(called >= 3 * #nonsense * 28)
end)
)") == 0);
}

TEST_CASE("a test types text, character by character") {
    const std::string main = "typed = {} function cairn.text_input(text) typed[#typed + 1] = text end";
    CHECK(status_of(R"(
cairn.test.test("types", function()
    cairn.test.start{}
    cairn.test.type_text("Ann \u{e4}\u{20ac}")
    cairn.test.run(1)
    cairn.test.expect_equal(table.concat(typed, "|"), "A|n|n| |\u{e4}|\u{20ac}")
    cairn.test.expect_error(function() cairn.test.type_text("a\n") end, "cairn.test.type_text: text is")
end))",
                    main) == 0);
}

TEST_CASE("a mouse button that there is not is answered with all that there are") {
    CHECK(status_of(R"(
cairn.test.test("buttons", function()
    cairn.test.start{}
    for _, name in ipairs{ "left", "middle", "right", "x1", "x2" } do cairn.test.mouse_press(1, 1, name) end
    cairn.test.expect_error(function() cairn.test.mouse_press(1, 1, "lft") end,
        'button is "lft"; expected "left", "middle", "right", "x1" or "x2"')
end))") == 0);
}

TEST_CASE("a recording made by a test plays again to the same end") {
    CHECK(status_of(R"(
local test = cairn.test
test.test("record", function()
    test.start{ seed = 9 }
    test.press("a")
    test.run(3)
    test.mouse_press(5, 6)
    test.run(2)
    local text = test.recording()
    test.expect(text:find("seed 9\n") and text:find("1 key_pressed a\n") and text:find("4 mouse_pressed left 5 6\n"), text)
    cairn.files.write("save/x.replay", text)
    local hash = test.state_hash()
    test.expect(text:find("hash " .. hash, 1, true) ~= nil)
end)
)",
                    "function cairn.key_pressed() cairn.random.uniform() end") == 0);
}

TEST_CASE("replays in the game's folder are played in a state of their own") {
    const std::string main = "function cairn.key_pressed(key) cairn.result{ outcome = key } end";
    const std::string head = "cairn-replay 1\ngame bench\nseed 1\nsize 1280 720\nframes 3\n";
    const std::string test =
        "cairn.test.test('r', function() cairn.test.expect_equal(cairn.test.play_replay('r.replay').outcome, "
        "'z') "
        "cairn.test.expect_equal(cairn.test.result(), nil) end)";
    const auto status = [&](const std::string& replay) {
        const GameFolder folder({{"main.lua", main}, {"tests/one.lua", test}, {"r.replay", replay}});
        return test_game(folder.source());
    };
    CHECK(status(head + "events\n2 key_pressed z\n") == 0);
    CHECK(status(head + "events\n2 key_pressed y\n") == 1);
    CHECK(status(head + "hash 0000000000000000\nevents\n2 key_pressed z\n") == 1);
}

}  // namespace
}  // namespace cairn::scripting::test
