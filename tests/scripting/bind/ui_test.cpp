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
    REQUIRE(run("menu:set_value(sound, false) menu:set_value(volume, 10) menu:set_value(detail, 1) "
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
    CHECK(run("menu:set_value(volume, 99)") ==
          "test.lua:1: Ui:set_value: value is 99; expected a number from 0 to 10 for widget 4 \"Volume\"");
    CHECK(run("menu:set_value(volume, 0/0)").find("expected a number from 0 to 10") != std::string::npos);
    CHECK(run("menu:set_focus(1)") ==
          "test.lua:1: Ui:set_focus: widget is 1; expected one that can be used; widget 1 \"Hello\" is a "
          "label");
    CHECK(run("menu:set_enabled(play, false) menu:set_focus(play)") ==
          "test.lua:1: Ui:set_focus: widget is 2; expected one that can be used; widget 2 \"Play\" is "
          "disabled");
    CHECK(draw_error(*this, "menu:draw()") == "");
    CHECK(run("menu:draw()").find("call it inside cairn.draw") != std::string::npos);
}

TEST_CASE_METHOD(Menus, "the game gives a field no text that the player could not type") {
    REQUIRE(run("short = menu:add_text{ text = 'Short', value = 'fünf!', max_length = 5 }") == "");
    CHECK(run("menu:add_text{ value = 'sechs!', max_length = 5 }") ==
          "test.lua:1: Ui:add_text: value = \"sechs!\": must have at most 5 characters");
    CHECK(run("menu:add_text{ value = 'a\\nb' }").find("must have no control characters") !=
          std::string::npos);
    CHECK(run("menu:set_value(short, 'sechs!')") ==
          "test.lua:1: Ui:set_value: value is \"sechs!\"; expected a text with at most 5 characters for "
          "widget 7 "
          "\"Short\"");
    CHECK(run("menu:set_value(short, 'a\\127')").find("a text with no control characters") !=
          std::string::npos);
    CHECK(run("menu:set_value(short, 3)").find("expected a string") != std::string::npos);
    CHECK(
        run("menu:set_value(short, 'a\\255')") ==
        "test.lua:1: Ui:set_value: value is \"a\\255\"; expected a text with no bytes that are not UTF-8 for "
        "widget 7 \"Short\"");
    CHECK(run("menu:add_text{ value = '\\xc3' }").find("must have no bytes that are not UTF-8") !=
          std::string::npos);
    CHECK(run("menu:set_value(short, '\\u{fffd}')") == "");
    REQUIRE(run("menu:set_value(short, 'fünf!')") == "");
    CHECK(value("menu:value(short)") == "fünf!");
}

namespace {

/// A menu with the focus on a field, in a game that notes what it gets.
struct TypingMenus : Menus {
    TypingMenus() {
        REQUIRE(run("menu:set_focus(name) cairn.input.bind('jump', { 'w' }) "
                    "function note(name) return function(what) log[#log + 1] = name .. ' ' .. tostring(what) "
                    "end end "
                    "for _, name in ipairs{ 'key_pressed', 'key_released', 'text_input', 'action_pressed', "
                    "'action_released', 'mouse_pressed' } do cairn[name] = note(name) end") == "");
        lines({});
    }
};

}  // namespace

TEST_CASE_METHOD(TypingMenus, "what is typed into a field of a menu does not reach the game") {
    CHECK(value("menu:is_typing()") == "false");
    lines({"key_pressed w", "text_entered w", "key_released w"});
    CHECK(take() == "key_pressed w, action_pressed jump, text_input w, key_released w, action_released jump");
    lines({"key_pressed return", "key_released return"});
    CHECK(take() == "key_pressed return, key_released return");  // the field is not open yet
    CHECK(value("menu:is_typing()") == "true");
    lines({"key_pressed w", "text_entered w"});
    CHECK(take() == "name Jow");
    CHECK(value("cairn.input.is_down('w')") == "false");
    CHECK(value("cairn.input.is_action_down('jump')") == "false");
    lines({"key_released w", "key_pressed escape"});
    CHECK(take() == "");  // closes the field, and neither the menu nor what the game does for escape
    CHECK(value("menu:is_typing()") == "false");
    lines({"key_pressed escape repeat", "key_released escape"});
    CHECK(take() == "");
    lines({"key_pressed escape", "key_released escape"});
    CHECK(take() == "key_pressed escape, key_released escape, back");
}

TEST_CASE_METHOD(TypingMenus,
                 "a key that was held when a field was opened is let go of, one that went into it is not") {
    lines({"key_pressed w", "key_pressed return"});
    REQUIRE(value("cairn.input.is_action_down('jump')") == "true");
    REQUIRE(take() == "key_pressed w, action_pressed jump, key_pressed return");
    lines({"key_pressed w repeat", "text_entered w", "key_pressed x", "key_released w"});
    CHECK(take() == "key_released w, action_released jump, name Jow");
    CHECK(value("cairn.input.is_down('w')") == "false");
    lines({"key_pressed escape", "key_pressed x repeat", "key_released x", "key_pressed x"});
    CHECK(take() == "key_pressed x");
    CHECK(value("cairn.input.is_down('x')") == "true");
}

TEST_CASE_METHOD(TypingMenus,
                 "within an update, events before a field is opened or behind its end are the game's") {
    lines({"key_pressed w", "key_pressed return", "text_entered n", "key_pressed return", "key_pressed x"});
    CHECK(take() == "key_pressed w, action_pressed jump, key_pressed return, key_pressed x, name Jon");
    lines({"key_pressed return"});
    REQUIRE(take() == "key_pressed return");
    lines({"text_entered a", "mouse_pressed left 1 1", "text_entered b"});
    CHECK(take() == "mouse_pressed 1.0, text_input b, name Jona");
}

TEST_CASE_METHOD(TypingMenus,
                 "a field that is typed into takes its keys from other menus too, while it is updated") {
    REQUIRE(
        run("chat = menu menu = cairn.ui.new{ back = note('back of') } menu:add_button{ action = function() "
            "note('pressed')('button') end } function cairn.update() chat:update() if menu then "
            "menu:update() end "
            "end") == "");
    lines({});
    lines({"mouse_pressed left 1 1"});
    lines({"key_pressed return"});
    REQUIRE(take() == "mouse_pressed 1.0, key_pressed return, pressed button");
    lines({"text_entered a", "key_pressed escape"});
    CHECK(take() == "name Joa");
    lines({"key_pressed return"});
    REQUIRE(take() == "key_pressed return, pressed button");
    REQUIRE(run("function cairn.update() menu:update() end") == "");
    lines({"key_pressed q"});  // the chat could still have been there
    lines({"key_pressed w", "key_pressed escape"});
    CHECK(take() == "key_pressed w, action_pressed jump, key_pressed escape, back of nil");
}

TEST_CASE_METHOD(TypingMenus,
                 "buttons of gamepads that are pressed while a field is open do not reach the game") {
    REQUIRE(run("cairn.input.bind('fire', { 'gamepad_a' }) for _, name in ipairs{ 'gamepad_pressed', "
                "'gamepad_released' } do cairn[name] = function(pad, button) note(name)(button) end end") ==
            "");
    lines({"gamepad_connected 1 Pad", "gamepad_pressed 1 x"});
    REQUIRE(take() == "gamepad_pressed x");
    lines({"gamepad_pressed 1 a"});  // opens it, as return does
    REQUIRE(value("menu:is_typing()") == "true");
    REQUIRE(take() == "gamepad_pressed a, action_pressed fire");
    // What was held is let go of; what goes down now is the field's, both ends of it.
    lines({"gamepad_released 1 a", "gamepad_released 1 x"});
    CHECK(take() == "gamepad_released a, action_released fire, gamepad_released x");
    lines({"gamepad_pressed 1 dpad_up", "gamepad_pressed 1 start", "gamepad_moved 1 left_x 0.75"});
    CHECK(take() == "");
    CHECK(value("cairn.input.is_gamepad_down(1, 'start')") == "false");
    CHECK(value("cairn.input.gamepad_axis(1, 'left_x')") == "0.75");
    CHECK(value("menu:focus() == name") == "true");
    lines({"gamepad_released 1 dpad_up", "gamepad_pressed 1 a"});
    CHECK(value("menu:is_typing()") == "false");
    CHECK(value("cairn.input.is_action_down('fire')") == "false");
    lines({"gamepad_released 1 a", "gamepad_released 1 start"});
    CHECK(take() == "");
    lines({"gamepad_pressed 1 start"});
    CHECK(take() == "gamepad_pressed start");
    // "b" closes the field, and neither the menu nor what the game does for it.
    lines({"key_pressed return", "key_released return"});
    REQUIRE(value("menu:is_typing()") == "true");
    REQUIRE(take() == "key_pressed return, key_released return");
    lines({"gamepad_pressed 1 b", "gamepad_released 1 b"});
    CHECK(take() == "");
    CHECK(value("menu:is_typing()") == "false");
    lines({"gamepad_pressed 1 b"});
    CHECK(take() == "gamepad_pressed b, back");
}

TEST_CASE_METHOD(TypingMenus, "a field that the blank key opens does not begin with a blank") {
    lines({"key_pressed space", "text_entered %20"});
    lines({"text_entered %20", "text_entered a"});
    CHECK(take() == "key_pressed space, name Jo , name Jo a");
}

}  // namespace cairn::scripting::test
