#include <catch2/catch.hpp>

#include <cairn/scripting/test_game.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

std::string png_of(engine::Size size) {
    engine::Image image{size, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(size.width) * size.height, 255);
    const auto png = engine::encode_png(image);
    REQUIRE(png);
    return {reinterpret_cast<const char*>(png->data()), png->size()};
}

int status_of(const std::string& test_code, const std::string& main_code = "") {
    const GameFolder folder({{"main.lua", main_code}, {"tests/one.lua", test_code}});
    return test_game(folder.source());
}

TEST_CASE("tests pass or fail by the errors that they raise") {
    CHECK(status_of("cairn.test.test('fine', function() end)") == 0);
    CHECK(status_of("cairn.test.test('bad', function() error('no') end)") == 1);
    CHECK(status_of("cairn.test.test('fine', function() end) cairn.test.test('bad', function() "
                    "cairn.test.expect(false) end)") == 1);
    CHECK(status_of("cairn.test.test('one', function() end) cairn.test.test('one', function() end)") == 1);
    CHECK(status_of("cairn.test.test('one', function() end) cairn.test.expect_error(function() "
                    "cairn.test.test('one', print) end, 'cairn.test.test: name is \"one\": another test')") ==
          0);
    CHECK(status_of("syntax error") == 1);
    CHECK(status_of("") == 1);
}

TEST_CASE("errors of the game's callbacks fail the test that runs them") {
    const std::string run = "cairn.test.test('runs', function() cairn.test.start{} cairn.test.run(3) end)";
    CHECK(status_of(run, "function cairn.update() end") == 0);
    CHECK(status_of(run, "function cairn.update() error('broken') end") == 1);
    CHECK(status_of(run, "function cairn.draw() error('broken') end") == 1);
    CHECK(status_of(run,
                    "local frames = 0 function cairn.update() frames = frames + 1 end "
                    "function cairn.draw() if frames == 3 then error('broken') end end") == 1);
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

TEST_CASE("each test begins with what its own save folder holds, whatever another one loaded from there") {
    const GameFolder folder(
        {{"main.lua", ""}, {"wide.png", png_of({8, 4})}, {"high.png", png_of({2, 16})}, {"tests/one.lua", R"(
local test = cairn.test
local function save(picture)
    cairn.files.write("save/picture.png", cairn.files.read(picture))
end
test.test("saves a wide picture", function()
    save("wide.png")
    test.expect_equal(table.concat({ cairn.graphics.new_image("save/picture.png"):size() }, " "), "8 4")
end)
test.test("saves a high one", function()
    save("high.png")
    test.expect_equal(table.concat({ cairn.graphics.new_image("save/picture.png"):size() }, " "), "2 16")
end)
test.test("saves none", function()
    test.expect_error(function() cairn.graphics.new_image("save/picture.png") end, "save/picture.png")
end))"}});
    CHECK(test_game(folder.source()) == 0);
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

TEST_CASE("a test's first finger reaches all that one on a device does: menus, the mouse, actions") {
    const std::string main = R"(
heard, chosen, level = {}, 0, 0
local function hear(name, ...) heard[#heard + 1] = table.concat({ name, ... }, " ") end
for _, name in ipairs{ "mouse_moved", "mouse_pressed", "mouse_released", "touch_pressed", "touch_moved",
    "touch_released", "action_pressed", "action_released" } do
    cairn[name] = function(...) hear(name, ...) end
end
function cairn.load()
    cairn.input.bind("fire", { "mouse_left" })
    menu = cairn.ui.new{ title = "Menu" }
    menu:add_button{ text = "Play", action = function() chosen = chosen + 1 end }
end
function cairn.update() menu:update() end
)";
    CHECK(status_of(R"(
local test = cairn.test
local function heard_since()
    local text = table.concat(heard, ", ")
    heard = {}
    return text
end
test.test("touches", function()
    test.start{}
    test.touch_press(1, 640, 380)
    test.touch_press(2, 5, 6)
    test.run(1)
    test.expect_equal(heard_since(), "mouse_moved 640.0 380.0 640.0 380.0, mouse_pressed 640.0 380.0 left, "
        .. "action_pressed fire, touch_pressed 1 640.0 380.0, touch_pressed 2 5.0 6.0")
    test.expect(cairn.input.is_mouse_down("left"))
    test.touch_release(1, 640, 380)
    test.run(2)
    test.expect_equal(heard_since(), "mouse_released 640.0 380.0 left, action_released fire, touch_released 1 640.0 380.0")
    test.expect_equal(chosen, 1)
    -- Several within one update follow each other.
    test.touch_press(1, 100, 100)
    test.touch_move(1, 110, 100)
    test.touch_move(1, 110, 125)
    test.mouse_move(112, 125)
    test.run(1)
    test.expect_equal(heard_since(), "mouse_moved 100.0 100.0 -540.0 -280.0, mouse_pressed 100.0 100.0 left, "
        .. "action_pressed fire, touch_pressed 1 100.0 100.0, mouse_moved 110.0 100.0 10.0 0.0, "
        .. "touch_moved 1 110.0 100.0 10.0 0.0, mouse_moved 110.0 125.0 0.0 25.0, touch_moved 1 110.0 125.0 0.0 25.0, "
        .. "mouse_moved 112.0 125.0 2.0 0.0")
    -- A recording holds what the mouse did, so that it plays alike.
    local text = test.recording()
    test.expect(text:find("1 mouse_pressed left 640 380\n1 touch_pressed 1 640 380\n", 1, true), text)
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
