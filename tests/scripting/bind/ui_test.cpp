// cairn.ui: what is called for what the player does.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

struct Menus : LuaBench {
    Menus() : LuaBench({}, MachineKind::HeadlessDrawing) {
        REQUIRE(run("log = {} local function note(name) return function(...) local words = { name } for _, "
                    "value in "
                    "ipairs{ ... } do words[#words + 1] = tostring(value) end log[#log + 1] = "
                    "table.concat(words, ' ') end "
                    "end "
                    "menu = cairn.ui.new{ title = 'Menu', back = note('back') } "
                    "menu:add_label{ text = 'Hello' } play = menu:add_button{ text = 'Play', action = "
                    "note('play') } "
                    "sound = menu:add_toggle{ text = 'Sound', value = true, changed = note('sound') } "
                    "volume = menu:add_slider{ text = 'Volume', value = 5, high = 10, step = 1, changed = "
                    "note('volume') } "
                    "detail = menu:add_choice{ text = 'Detail', choices = { 'low', 'high' }, value = 2, "
                    "changed = "
                    "note('detail') } name = menu:add_text{ text = 'Name', value = 'Jo', changed = "
                    "note('name') } "
                    "function cairn.update() menu:update() menu:update() end") == "");
    }
    void lines(const std::vector<const char*>& texts) {
        std::vector<engine::InputEvent> events;
        for (const char* text : texts) events.push_back(*engine::input_event_from_text(text));
        const auto error = game().update(events);
        if (error) FAIL(error->to_text());
    }
    std::string take() {
        const std::string text = value("table.concat(log, ', ')");
        REQUIRE(run("log = {}") == "");
        return text;
    }
};

}  // namespace

TEST_CASE_METHOD(Menus, "each thing that the player does is called once, with its value") {
    lines({"key_pressed return", "key_pressed down", "key_pressed space", "key_pressed down",
           "key_pressed left", "gamepad_pressed 1 dpad_down", "gamepad_pressed 1 a", "key_pressed down",
           "key_pressed return", "text_entered e", "key_pressed return", "key_pressed escape"});
    CHECK(take() == "play, sound false, volume 4.0, detail 1 low, name Joe, back");
    lines({});
    CHECK(take() == "");
    CHECK(
        value(
            "tostring(menu:value(sound)) .. menu:value(volume) .. menu:value(detail) .. menu:value(name)") ==
        "false4.01Joe");
    CHECK(value("menu:value(play)") == "nil");
    CHECK(value("menu:focus() == name") == "true");
}

TEST_CASE_METHOD(Menus, "a menu that is open keeps to the middle of a screen that changes its size") {
    REQUIRE(
        run("pressed = 0 menu = cairn.ui.new{} menu:add_button{ text = 'Go', action = function() pressed = "
            "pressed + 1 end }") == "");
    const auto click = [&](const std::string& place) {
        lines({("mouse_pressed left " + place).c_str(), ("mouse_released left " + place).c_str()});
        return value("pressed");
    };
    REQUIRE(value("cairn.window.size()") == "1280");
    CHECK(click("640 360") == "1");
    lines({"window_resized 800 1000"});
    CHECK(click("640 360") == "1");
    CHECK(click("400 500") == "2");
    lines({"window_resized 200 100"});  // less than the panel wants
    CHECK(click("100 50") == "3");
    CHECK(click("190 50") == "3");  // the panel's edge, and not a button that reaches beyond the screen
    REQUIRE(run("menu = cairn.ui.new{ x = 50, y = 60 } menu:add_button{ action = function() pressed = "
                "pressed + 1 end "
                "}") == "");
    lines({"window_resized 800 600"});
    CHECK(click("50 60") == "4");  // where the author put it
}

TEST_CASE_METHOD(Menus, "values set by the game are not told") {
    REQUIRE(run("menu:set_value(sound, false) menu:set_value(volume, 99) menu:set_value(detail, 1) "
                "menu:set_value(name, "
                "'Al') menu:set_text(play, 'Go') menu:set_title('Title') menu:set_enabled(play, false)") ==
            "");
    lines({});
    CHECK(take() == "");
    CHECK(value("menu:value(volume)") == "10.0");
    CHECK(value("menu:focus() == sound") == "true");
}

TEST_CASE_METHOD(Menus, "a widget's function may take the menu apart") {
    REQUIRE(run("menu:clear() menu:add_button{ action = function() menu:clear() menu:add_button{ action = "
                "function() "
                "log[1] = 'second' end } end }") == "");
    lines({"key_pressed return", "key_pressed return"});
    CHECK(take() == "second");  // what the first press made took the second
    lines({"key_pressed escape"});
    CHECK(take() == "back");
}

TEST_CASE_METHOD(Menus, "a menu is drawn in screen pixels, also under a camera") {
    const engine::Image plain = picture_of(*this, "menu:draw()");
    const engine::Image under =
        picture_of(*this, "local c = cairn.camera.new{} c:attach() menu:draw() c:detach()");
    CHECK(plain.rgba == under.rgba);
    is_color(plain, 5, 5, 0, 0, 0);
    CHECK(int(plain.pixel(640, 250)[2]) > 20);
}

TEST_CASE_METHOD(Menus, "wrong widgets name the field, the value and the rule") {
    CHECK(run("menu:add_slider{ low = 3, high = 3 }") ==
          "test.lua:1: Ui:add_slider: high = 3: must be above low");
    CHECK(run("menu:add_slider{ low = 3, high = 5, value = 5.5 }") ==
          "test.lua:1: Ui:add_slider: value = 5.5: must be from 3 to 5");
    CHECK(run("assert(menu:value(menu:add_slider{ low = 3, high = 5 }) == 3)") == "");
    CHECK(run("assert(menu:value(menu:add_slider{ low = -1, high = 5 }) == 0)") == "");
    CHECK(run("menu:add_choice{ choices = {} }").find("must not be empty") != std::string::npos);
    CHECK(run("menu:add_choice{ choices = { 'a', 3 } }").find("choices[2] is 3; expected a string") !=
          std::string::npos);
    CHECK(run("menu:add_choice{ choices = { 'a' }, value = 2 }").find("value = 2: must be from 1 to 1") !=
          std::string::npos);
    CHECK(run("menu:add_button{ acton = print }").find("did you mean \"action\"?") != std::string::npos);
    CHECK(run("menu:value(9)") == "test.lua:1: Ui:value: widget is 9; expected a widget, from 1 to 8");
    CHECK(run("menu:set_value(play, 1)").find("labels and buttons have no value") != std::string::npos);
    CHECK(run("menu:set_value(sound, 1)").find("value is 1; expected true or false") != std::string::npos);
    CHECK(run("menu:set_value(detail, 3)").find("the number of a choice") != std::string::npos);
    CHECK(run("menu:set_value(detail, 1.5)").find("the number of a choice") != std::string::npos);
    CHECK(run("menu:set_value(detail, 4 / 2)") == "");
    CHECK(run("cairn.ui.new{ accent = { 1 } }").find("must be {r, g, b}") != std::string::npos);
    CHECK(draw_error(*this, "menu:draw()") == "");
    CHECK(run("menu:draw()").find("call it inside cairn.draw") != std::string::npos);
}

}  // namespace cairn::scripting::test
