#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using engine::InputEvent;
using engine::InputKind;

TEST_CASE("events reach their callbacks, then timers, then update") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
log = {}
local function note(name) cairn[name] = function(...) log[#log + 1] = name .. '(' .. table.concat({ ... }, ',') .. ')' end end
for _, name in ipairs{ "mouse_pressed", "mouse_moved", "mouse_released", "wheel", "key_released", "text_input" } do note(name) end
function cairn.key_pressed(key, is_repeat) log[#log + 1] = key .. tostring(is_repeat) .. tostring(cairn.input.is_down(key)) end
function cairn.focus(has) log[#log + 1] = tostring(has) end
function cairn.update(dt) log[#log + 1] = ("update %.6f"):format(dt) end
cairn.timer.after(0, function() log[#log + 1] = "timer" end)
)") == "");
    const std::vector<InputEvent> events = {
        {.kind = InputKind::KeyPressed, .key = engine::Key::Space},
        {.kind = InputKind::MousePressed, .button = engine::MouseButton::Right, .position = {1, 2}},
        {.kind = InputKind::MouseMoved, .position = {3, 4}, .delta = {2, 2}},
        {.kind = InputKind::WheelMoved, .delta = {0, -1}},
        {.kind = InputKind::TextEntered, .text = "x"},
        {.kind = InputKind::WindowResized, .delta = {800, 600}},
        {.kind = InputKind::FocusLost},
        {.kind = InputKind::KeyReleased, .key = engine::Key::Space}};
    REQUIRE_FALSE(bench.game().update(events));
    CHECK(bench.value("table.concat(log, ' ')") ==
          "spacefalsetrue mouse_pressed(1.0,2.0,right) mouse_moved(3.0,4.0,2.0,2.0) wheel(0.0,-1.0) "
          "text_input(x) "
          "false key_released(space) timer update 0.016667");
    CHECK(bench.value("cairn.timer.frame()") == "1");
}

TEST_CASE("events of an update that failed are nobody's any more") {
    LuaBench bench;
    REQUIRE(bench.run("menu = cairn.ui.new{} pressed = 0 "
                      "menu:add_button{ action = function() pressed = pressed + 1 end } "
                      "function cairn.key_pressed() if not mended then error('slip') end end "
                      "function cairn.update() menu:update() end") == "");
    const std::vector<InputEvent> events = {{.kind = InputKind::KeyPressed, .key = engine::Key::Return}};
    REQUIRE(bench.game().update(events));
    REQUIRE(bench.run("mended = true menu:update()") == "");  // as cairn.after_reload might
    CHECK(bench.value("pressed") == "0");
    REQUIRE_FALSE(bench.game().update(events));
    CHECK(bench.value("pressed") == "1");
}

TEST_CASE("input that is released is up without a word to the game, and everything else stays") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.input.bind('jump', { 'space', 'gamepad_a' }) told = 0 "
                      "function cairn.focus() told = told + 1 end cairn.key_released = cairn.focus "
                      "cairn.action_released = cairn.focus") == "");
    const std::vector<InputEvent> events = {
        {.kind = InputKind::GamepadConnected, .text = "pad", .number = 1},
        {.kind = InputKind::GamepadPressed, .number = 1, .gamepad_button = engine::GamepadButton::A},
        {.kind = InputKind::KeyPressed, .key = engine::Key::Space},
        {.kind = InputKind::MousePressed, .button = engine::MouseButton::Left, .position = {3, 4}}};
    REQUIRE_FALSE(bench.game().update(events));
    CHECK(bench.value("cairn.input.is_action_down('jump')") == "true");
    bench.game().release_input();
    CHECK(bench.value("cairn.input.is_action_down('jump')") == "false");
    CHECK(bench.value("cairn.input.is_down('space') or cairn.input.is_gamepad_down(1, 'a') or "
                      "cairn.input.is_mouse_down('left')") == "false");
    CHECK(bench.game().context().input.has_focus());
    CHECK(bench.game().context().input.gamepad(1).is_connected());
    CHECK(bench.value("cairn.input.mouse_position()") == "3.0");
    REQUIRE_FALSE(bench.game().update({}));
    CHECK(bench.value("told") == "0");
}

TEST_CASE("a quit request ends the game unless the game goes on") {
    LuaBench bench;
    REQUIRE(bench.run("function cairn.quit_requested() return stay end stay = true") == "");
    const std::vector<InputEvent> quit = {{.kind = InputKind::QuitRequested}};
    REQUIRE_FALSE(bench.game().update(quit));
    CHECK_FALSE(bench.game().wants_quit());
    REQUIRE(bench.run("stay = false") == "");
    REQUIRE_FALSE(bench.game().update(quit));
    CHECK(bench.game().wants_quit());
}

TEST_CASE("a window closed while the game loads ends it in its first update, with nothing half done") {
    LuaBench bench;
    REQUIRE(bench.run("function cairn.load() world = cairn.physics.new_world{} loaded = true end "
                      "function cairn.update() updates = (updates or 0) + 1 end cairn.load()") == "");
    // What happened meanwhile comes with the first update, in its order; what stands behind the end counts no
    // more.
    const std::vector<InputEvent> waiting = {{.kind = InputKind::KeyPressed, .key = engine::Key::A},
                                             {.kind = InputKind::QuitRequested}};
    REQUIRE_FALSE(bench.game().update(waiting));
    CHECK(bench.game().wants_quit());
    CHECK(bench.value("updates") == "1");
}

TEST_CASE("a callback that is no function is an error that names it") {
    LuaBench bench;
    CHECK(bench.run("\ncairn.draw = 5") == "test.lua:2: cairn.draw is 5; expected a function");
    // Over one that is there as well, which then stays.
    CHECK(bench.run("function cairn.update() updates = (updates or 0) + 1 end\n\ncairn.update = 12") ==
          "test.lua:3: cairn.update is 12; expected a function");
    REQUIRE_FALSE(bench.game().update({}));
    CHECK(bench.value("updates") == "1");
    CHECK(bench.run("cairn.update = nil cairn.best = 5") == "");
    REQUIRE_FALSE(bench.game().update({}));
    CHECK(bench.value("updates") == "1");
}

TEST_CASE("callbacks are members of cairn like any others: they can be read, wrapped and walked over") {
    LuaBench bench;
    REQUIRE(bench.run(
                "function cairn.update() order = (order or '') .. 'a' end\n"
                "local before = cairn.update\n"
                "function cairn.update(dt) before(dt) order = order .. 'b' end\n"
                "cairn.helper = function() end\n"
                "for name, f in pairs(cairn) do\n"
                "    if name == 'update' then cairn[name] = function(dt) f(dt) order = order .. 'c' end end\n"
                "    if name == 'helper' or name == 'physics' then order = (order or '') .. '.' end\n"
                "end") == "");
    REQUIRE_FALSE(bench.game().update({}));
    CHECK(bench.value("order") == "..abc");
    CHECK(bench.value("cairn.draw") == "nil");
    CHECK(bench.value("type(cairn.update)") == "function");
}

TEST_CASE("a game that uses up its memory gets an error each time, and the program lives on") {
    LuaBench bench;
    REQUIRE(bench.run("hoard = {} function cairn.update() while true do hoard[#hoard + 1] = ('x'):rep(1000) "
                      ".. #hoard end end "
                      "function cairn.text_input(text) kept = text end") == "");
    for (int i = 0; i < 3; ++i) {
        const std::vector<InputEvent> events = {
            {.kind = InputKind::TextEntered, .text = std::string(1 << 20, 'y')}};
        const auto error = bench.game().update(events);
        REQUIRE(error);
        CHECK(error->message.find("not enough memory") != std::string::npos);
    }
}

TEST_CASE("load runs main.lua and then cairn.load with the arguments") {
    LuaBench bench(GameFiles{
        {"main.lua", "order = 'main' function cairn.load(args) order = order .. #args .. args[2] end"}});
    REQUIRE_FALSE(bench.game().load("main.lua", {"a", "b"}));
    CHECK(bench.value("order") == "main2b");
}

TEST_CASE("the state hash covers every living world and the gameplay stream") {
    LuaBench bench;
    const std::uint64_t empty = bench.game().state_hash();
    REQUIRE(bench.run("w = cairn.physics.new_world{}") == "");
    const std::uint64_t one = bench.game().state_hash();
    CHECK(one != empty);
    REQUIRE(bench.run("w:new_body{}") == "");
    CHECK(bench.game().state_hash() != one);
    // Forgetting a world must not change the hash at the next collection.
    const std::uint64_t kept = bench.game().state_hash();
    REQUIRE(bench.run("w = nil") == "");
    lua_gc(bench.game().lua(), LUA_GCCOLLECT);
    CHECK(bench.game().state_hash() == kept);
}

}  // namespace
}  // namespace cairn::scripting::test
