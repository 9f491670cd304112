// The stack of scenes: who is called, in which order, with what.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// Scenes a, b and c that note each call in `log`.
struct Scenes : LuaBench {
    Scenes() {
        REQUIRE(run(R"(
            log = {}
            local function scene(name, fields)
                local s = fields or {}
                for _, callback in ipairs{ 'enter', 'leave', 'pause', 'resume', 'update', 'draw', 'key_pressed' } do
                    s[callback] = function(self, ...)
                        assert(self == s)
                        local words = { name .. '.' .. callback }
                        for _, value in ipairs{ ... } do words[#words + 1] = tostring(value) end
                        log[#log + 1] = table.concat(words, ' ')
                    end
                end
                return s
            end
            a, b, c = scene('a'), scene('b'), scene('c', { overlay = true })
            function cairn.update() log[#log + 1] = 'update' end
            function cairn.draw() log[#log + 1] = 'draw' end
            function take() local text = table.concat(log, ', ') log = {} return text end)") == "");
    }
    std::string take() { return value("take()"); }
    void frame(std::vector<engine::InputEvent> events = {}) {
        const auto error = game().update(events);
        if (error) FAIL(error->to_text());
    }
};

}  // namespace

TEST_CASE_METHOD(Scenes, "scenes are entered, paused, resumed and left with what is handed over") {
    REQUIRE(run("cairn.scene.push(a, 1, 'x') cairn.scene.push(b) cairn.scene.pop('score', 7) "
                "cairn.scene.switch(c, 3) "
                "cairn.scene.pop()") == "");
    CHECK(take() == "a.enter 1 x, a.pause, b.enter, b.leave, a.resume score 7, a.leave, c.enter 3, c.leave");
    CHECK(value("cairn.scene.count()") == "0");
    CHECK(value("cairn.scene.current()") == "nil");
}

TEST_CASE_METHOD(Scenes, "the top scene gets the callbacks, after the game itself") {
    REQUIRE(run("cairn.scene.push(a) cairn.scene.push(b) log = {}") == "");
    engine::InputEvent event{.kind = engine::InputKind::KeyPressed, .key = engine::Key::Space};
    frame({event});
    CHECK(take() == "b.key_pressed space false, update, b.update " + value("1 / 60"));
    CHECK(value("cairn.scene.current() == b and cairn.scene.count() == 2") == "true");
}

TEST_CASE_METHOD(Scenes, "overlays are drawn over what is below them, up to a scene that is none") {
    REQUIRE(run("cairn.scene.push(a) cairn.scene.push(b) cairn.scene.push(c) log = {}") == "");
    machine().renderer->begin_frame({});
    REQUIRE_FALSE(game().draw(0.5));
    CHECK(take() == "draw, b.draw 0.5, c.draw 0.5");
}

TEST_CASE_METHOD(Scenes, "a scene may leave from its own update, and the next one is called from then on") {
    REQUIRE(run("cairn.scene.push(a) cairn.scene.push(b) function b:update() log[#log + 1] = 'leaving' "
                "cairn.scene.pop() end log = {}") == "");
    frame();
    CHECK(take() == "update, leaving, b.leave, a.resume");
    frame();
    CHECK(take() == "update, a.update " + value("1 / 60"));
}

TEST_CASE_METHOD(Scenes, "a scene of a class finds its methods through its metatable") {
    REQUIRE(run("Menu = {} Menu.__index = Menu function Menu:update() log[#log + 1] = self.name end "
                "cairn.scene.push(setmetatable({ name = 'menu' }, Menu)) log = {}") == "");
    frame();
    CHECK(take() == "update, menu");
}

TEST_CASE_METHOD(Scenes, "a scene can ask that a window being closed stays open") {
    REQUIRE(run("cairn.scene.push{ quit_requested = function() return true end }") == "");
    frame({{.kind = engine::InputKind::QuitRequested}});
    CHECK_FALSE(game().wants_quit());
    REQUIRE(run("cairn.scene.pop()") == "");
    frame({{.kind = engine::InputKind::QuitRequested}});
    CHECK(game().wants_quit());
}

TEST_CASE_METHOD(Scenes, "wrong uses of scenes say what is wrong") {
    CHECK(run("cairn.scene.pop()") == "test.lua:1: cairn.scene.pop: there is no scene to leave");
    REQUIRE(run("cairn.scene.push(a)") == "");
    CHECK(run("cairn.scene.push(a)") == "test.lua:1: cairn.scene.push: that scene is on the stack already");
    CHECK(run("cairn.scene.push('menu')") ==
          "test.lua:1: cairn.scene.push: scene is \"menu\"; expected a table");
    CHECK(run("for i = 1, 100 do cairn.scene.push{} end").find("64 scenes are on the stack already") !=
          std::string::npos);
}

TEST_CASE_METHOD(Scenes, "a callback of a scene that is no function is told where the scene is given") {
    REQUIRE(run("cairn.scene.push(a) log = {}") == "");
    CHECK(run("\ncairn.scene.push{ enter = 3 }") ==
          "test.lua:2: cairn.scene.push: the scene's enter is 3; expected a function");
    CHECK(run("\n\ncairn.scene.switch{ touch_moved = {} }")
              .find("test.lua:3: cairn.scene.switch: the scene's touch_moved is a table") == 0);
    CHECK(run("cairn.scene.push(setmetatable({}, { __index = { draw = 'x' } }))") ==
          "test.lua:1: cairn.scene.push: the scene's draw is \"x\"; expected a function");
    // The scene below noticed nothing, and goes on.
    CHECK(take() == "");
    CHECK(value("cairn.scene.current() == a and cairn.scene.count() == 1") == "true");
    CHECK(run("cairn.scene.push{ load = 3, update = nil, speed = 3 }") == "");
}

TEST_CASE_METHOD(Scenes, "a callback that becomes something else later names the place of the scene") {
    REQUIRE(run("\ncairn.scene.push(a)\na.update = 3") == "");
    const auto error = game().update({});
    REQUIRE(error);
    CHECK(error->message ==
          "test.lua:2: the update of the scene that is put on here is 3 by now; expected a function");
    CHECK(run("a.leave = true cairn.scene.pop()") ==
          "test.lua:1: cairn.scene.pop: the scene's leave is true; expected a function");
}

TEST_CASE_METHOD(Scenes, "a scene whose enter raises an error is off the stack again") {
    REQUIRE(run("cairn.scene.push(a) log = {} broken = {}\nfunction broken:enter()\nerror('no door') end") ==
            "");
    lua_State* L = game().lua();
    REQUIRE_FALSE(load_text(L, "cairn.scene.push(broken)", "other.lua"));
    const auto error = protected_call(L, 0, 0);
    REQUIRE(error);
    CHECK(error->message == "test.lua:3: no door");
    CHECK(error->to_text().find("other.lua:1: in ") != std::string::npos);  // the calls that led there
    CHECK(value("cairn.scene.current() == a and cairn.scene.count()") == "1");
    CHECK(run("cairn.scene.switch(broken)").find("no door") != std::string::npos);
    CHECK(value("cairn.scene.count()") == "0");
    // It may be put on again, where the script has caught the error too, and in a coroutine.
    REQUIRE(run("pcall(cairn.scene.push, broken) pcall(cairn.scene.push, broken) "
                "coroutine.resume(coroutine.create(cairn.scene.push), broken)") == "");
    CHECK(value("cairn.scene.count()") == "0");
    REQUIRE(run("broken.enter = nil cairn.scene.push(broken)") == "");
    CHECK(value("cairn.scene.current() == broken and cairn.scene.count()") == "1");
}

TEST_CASE_METHOD(Scenes, "an error in enter takes off no other scene than its own") {
    REQUIRE(run("hasty = { enter = function() cairn.scene.push(b) error('late') end } "
                "gone = { enter = function() cairn.scene.pop() cairn.scene.push(a) error('late') end }") ==
            "");
    CHECK(run("cairn.scene.push(hasty)").find("late") != std::string::npos);
    CHECK(value("cairn.scene.current() == b and cairn.scene.count()") == "1");
    CHECK(run("cairn.scene.push(gone)").find("late") != std::string::npos);
    CHECK(value("cairn.scene.current() == a and cairn.scene.count()") == "2");
    frame();  // the references of those that are left are whole
}

TEST_CASE_METHOD(Scenes, "an error in a scene names its line") {
    REQUIRE(run("cairn.scene.push{ update = function(self)\nself.missing.field = 1 end }") == "");
    const auto error = game().update({});
    REQUIRE(error);
    CHECK(error->message.find("test.lua:2:") == 0);
}

}  // namespace cairn::scripting::test
