// Keys of the tools, and that the game does not notice them.
#include "debug/developer_tools.h"

#include <catch2/catch.hpp>

#include "scripting/debug/picture_with_tools.h"

namespace cairn::scripting::test {
namespace {

using engine::InputEvent;
using engine::InputKind;
using engine::Key;

InputEvent press(Key key) {
    return {.kind = InputKind::KeyPressed, .key = key};
}
InputEvent release(Key key) {
    return {.kind = InputKind::KeyReleased, .key = key};
}

TEST_CASE("the tools take their own keys and leave the others") {
    DeveloperTools tools;
    std::vector<InputEvent> events{
        press(Key::A), press(Key::F2), release(Key::F2), press(Key::F12), {.kind = InputKind::MouseMoved}};
    tools.take_keys(events);
    REQUIRE(events.size() == 3);
    CHECK(events[0] == press(Key::A));
    CHECK(events[1] == press(Key::F12));
    CHECK(events[2].kind == InputKind::MouseMoved);
}

TEST_CASE("F5 asks for a new start once, however long it is held") {
    DeveloperTools tools;
    CHECK_FALSE(tools.take_restart());
    std::vector<InputEvent> events{press(Key::F5)};
    tools.take_keys(events);
    CHECK(tools.take_restart());
    CHECK_FALSE(tools.take_restart());
    events = {{.kind = InputKind::KeyPressed, .key = Key::F5, .is_repeat = true}, release(Key::F5)};
    tools.take_keys(events);
    CHECK_FALSE(tools.take_restart());
}

TEST_CASE("tools that do not exist are refused by name") {
    DeveloperTools tools;
    CHECK(tools.show("help"));
    const auto shown = tools.show("debgu");
    REQUIRE_FALSE(shown);
    CHECK(shown.error().message.find("did you mean \"debug\"") != std::string::npos);
}

TEST_CASE("F2 looks through the game's camera, whatever state the game leaves the renderer in") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"}}, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("w = cairn.physics.new_world{} "
                      "w:add_box{ type = 'static', x = 50, y = 20, width = 4, height = 4 } "
                      "camera = cairn.camera.new{ x = 50, y = 20, height = 10 } "
                      "canvas = cairn.graphics.new_canvas(20, 20) "
                      "function cairn.draw() camera:attach() camera:detach() "
                      "cairn.graphics.push() cairn.graphics.translate(500, 500) "
                      "cairn.graphics.set_scissor(0, 0, 1, 1) end") == "");
    DeveloperTools tools;
    const engine::Image closed = picture_with(bench, tools);
    is_color(closed, 100, 50, 0, 0, 0);
    std::vector<InputEvent> events{press(Key::F2)};
    tools.take_keys(events);
    const engine::Image open = picture_with(bench, tools);
    CHECK(open.pixel(105, 55)[1] > 30);  // inside the box, which is 40 pixels wide in the middle
    CHECK(open.pixel(80, 55)[1] > 100);  // its rim
    CHECK(open.pixel(70, 55)[1] < 15);   // beside it
}

TEST_CASE("without a camera F2 shows all of the world") {
    LuaBench bench({{"conf.lua", "{ width = 200, height = 100 }"}}, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("w = cairn.physics.new_world{} "
                      "w:add_box{ x = 5000, y = 300, width = 40, height = 40 } function cairn.draw() end") ==
            "");
    DeveloperTools tools;
    REQUIRE(tools.show("debug"));
    const engine::Image image = picture_with(bench, tools);
    CHECK(image.pixel(110, 60)[0] > 40);
}

}  // namespace
}  // namespace cairn::scripting::test
