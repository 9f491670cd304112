// The inspector, driven by events as a person would, and seen by its pixels.
#include "debug/inspector.h"

#include <catch2/catch.hpp>

#include "scripting/debug/picture_with_tools.h"

namespace cairn::scripting::test {
namespace {

using engine::InputEvent;
using engine::InputKind;
using engine::Key;

class InspectorBench {
  public:
    InspectorBench() : bench_({}, MachineKind::HeadlessDrawing) {
        REQUIRE(
            bench_.run("w = cairn.physics.new_world{ gravity_y = 0 } "
                       "box = w:add_box{ x = 1, width = 2, height = 2 } "
                       "camera = cairn.camera.new{ height = 10 } "
                       "function cairn.draw() camera:attach() cairn.graphics.draw_world(w) camera:detach() "
                       "end") == "");
    }

    engine::Image picture() { return picture_with(bench_, tools_); }
    /// What is left for the game.
    std::vector<InputEvent> send(std::vector<InputEvent> events) {
        tools_.take_keys(events);
        tools_.take_input(events, bench_.game());
        return events;
    }
    std::size_t textures() { return bench_.machine().renderer->loaded_textures().size(); }
    DeveloperTools& tools() { return tools_; }
    LuaBench& bench() { return bench_; }

  private:
    LuaBench bench_;
    DeveloperTools tools_;
};

InputEvent click(float x, float y, InputKind kind = InputKind::MousePressed) {
    return {.kind = kind, .position = {x, y}};
}

TEST_CASE("a run that does not open the inspector makes nothing of it") {
    InspectorBench bench;
    const std::size_t textures = bench.textures();
    static_cast<void>(bench.picture());
    CHECK(bench.textures() == textures);
    CHECK(bench.send({click(640, 360)}).size() == 1);
    static_cast<void>(bench.send({{.kind = InputKind::KeyPressed, .key = Key::F10}}));
    static_cast<void>(bench.picture());
    CHECK(bench.textures() == textures + 1);  // its letters
}

TEST_CASE("the inspector covers its part of the picture and takes the mouse there, and not elsewhere") {
    InspectorBench bench;
    const engine::Image closed = bench.picture();
    REQUIRE(bench.tools().show("inspector"));
    static_cast<void>(bench.picture());
    const engine::Image open = bench.picture();
    const auto differs = [&](int x, int y) { return open.pixel(x, y)[2] != closed.pixel(x, y)[2]; };
    CHECK(differs(1000, 300));
    CHECK_FALSE(differs(100, 300));
    static_cast<void>(bench.send({{.kind = InputKind::MouseMoved, .position = {1000, 300}}}));
    static_cast<void>(bench.picture());
    CHECK(bench.send({click(1000, 300)}).empty());
    CHECK(bench.send({click(1000, 300, InputKind::MouseReleased)}).empty());
    static_cast<void>(bench.send({{.kind = InputKind::MouseMoved, .position = {100, 300}}}));
    static_cast<void>(bench.picture());
    CHECK(bench.send({click(100, 300), click(100, 300, InputKind::MouseReleased)}).size() == 2);
}

TEST_CASE("a finger on the inspector never reaches the game, one beside it does") {
    InspectorBench bench;
    REQUIRE(bench.tools().show("inspector"));
    static_cast<void>(bench.picture());
    const auto touch = [](InputKind kind, float x) {
        return InputEvent{.kind = kind, .position = {x, 300}, .number = 1};
    };
    CHECK(bench
              .send({touch(InputKind::TouchPressed, 1000), touch(InputKind::TouchMoved, 100),
                     touch(InputKind::TouchReleased, 100)})
              .empty());
    CHECK(bench
              .send({touch(InputKind::TouchPressed, 100), touch(InputKind::TouchMoved, 1000),
                     touch(InputKind::TouchReleased, 1000)})
              .size() == 3);
}

TEST_CASE("the middle button gives a gamepad to the inspector, and back to the game") {
    InspectorBench bench;
    REQUIRE(bench.tools().show("inspector"));
    static_cast<void>(bench.picture());
    const auto pad = [](InputKind kind, engine::GamepadButton button, int number = 1) {
        return InputEvent{.kind = kind, .number = number, .gamepad_button = button};
    };
    const auto stick = [](float value) {
        return InputEvent{.kind = InputKind::GamepadMoved,
                          .number = 1,
                          .gamepad_axis = engine::GamepadAxis::LeftX,
                          .value = value};
    };
    const auto down = InputKind::GamepadPressed;
    const auto up = InputKind::GamepadReleased;
    const auto a = engine::GamepadButton::A;
    const auto right = engine::GamepadButton::DpadRight;
    const auto guide = engine::GamepadButton::Guide;
    const auto connect = [](int number) {
        return InputEvent{.kind = InputKind::GamepadConnected, .text = "pad", .number = number};
    };
    CHECK(bench.send({connect(1), connect(2), pad(down, a), stick(1)}).size() == 4);  // the game's

    // What the game saw go down, it sees come up; of the rest it sees nothing.
    CHECK(bench.send({pad(down, guide), pad(up, guide)}).empty());
    const engine::Image before = bench.picture();
    CHECK(bench.send({pad(up, a), stick(0)}).size() == 2);
    CHECK(bench.send({pad(down, a, 2), pad(up, a, 2)}).size() == 2);
    CHECK(bench.send({stick(0.9f)}).empty());
    CHECK(bench.send({stick(0)}).size() == 1);
    for (int i = 0; i < 2; ++i) {
        CHECK(bench.send({pad(down, right)}).empty());
        static_cast<void>(bench.picture());
        CHECK(bench.send({pad(up, right)}).empty());
        static_cast<void>(bench.picture());
    }
    CHECK(bench.picture().rgba != before.rgba);  // the mark has moved

    CHECK(bench.send({pad(down, guide), pad(up, guide)}).empty());
    CHECK(bench.send({pad(down, a), pad(up, a), stick(0.9f)}).size() == 3);

    CHECK(bench.send({pad(down, guide), pad(up, guide)}).empty());
    CHECK(bench.send({{.kind = InputKind::GamepadDisconnected, .number = 1}}).size() == 1);
    static_cast<void>(bench.picture());
    CHECK(bench.send({connect(1), pad(down, a), pad(up, a)}).size() == 3);
}

TEST_CASE("a click on a body picks it, and the game sees nothing of the click") {
    InspectorBench bench;
    REQUIRE(bench.tools().show("inspector"));
    static_cast<void>(bench.picture());
    const engine::Image before = bench.picture();
    // 72 pixels are a metre; the box is at x = 1.
    CHECK(bench.send({click(712, 360), click(712, 360, InputKind::MouseReleased)}).empty());
    static_cast<void>(bench.picture());
    const engine::Image after = bench.picture();
    CHECK(after.pixel(712 + 14, 360)[1] > 200);  // the mark around its centre
    CHECK(before.pixel(712 + 14, 360)[1] < 200);
    REQUIRE(bench.bench().run("box:destroy()") == "");
    static_cast<void>(bench.picture());  // what was selected is gone
    REQUIRE(bench.bench().run("w:destroy() cairn.draw = nil") == "");
    static_cast<void>(bench.picture());
}

}  // namespace
}  // namespace cairn::scripting::test
