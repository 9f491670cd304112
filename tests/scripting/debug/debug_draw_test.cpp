// The debug drawing, by the pixels that must and must not change.
#include <catch2/catch.hpp>

#include "scripting/support/drawing.h"

namespace cairn::scripting::test {
namespace {

const std::map<std::string, std::string> kSmall = {{"conf.lua", "{ width = 200, height = 100 }"}};

/// A box of 4 m at (0, 0), at rest on the ground's top y = -2; 10 pixels are a metre.
const char* const kBoxOnGround =
    "w = cairn.physics.new_world{} "
    "ground = w:add_box{ type = 'static', y = -3, width = 30, height = 2 } "
    "box = w:add_box{ y = 0, width = 4, height = 4 } "
    "camera = cairn.camera.new{ height = 10 } "
    "for i = 1, 20 do w:step(1 / 60) end ";

int brightness(const engine::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return p[0] + p[1] + p[2];
}

std::string drawing(const std::string& options) {
    return "camera:attach() cairn.graphics.draw_debug(w, " + options + ") camera:detach()";
}

TEST_CASE("shapes are drawn where they are, and dark when they sleep") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(kBoxOnGround) == "");
    const std::string shapes = drawing("{ contacts = false, joints = false }");
    const engine::Image awake = picture_of(bench, shapes);
    CHECK(brightness(awake, 110, 40) > 100);
    CHECK(brightness(awake, 125, 40) == 0);  // beside the box
    CHECK(brightness(awake, 80, 40) > 300);  // its rim
    REQUIRE(bench.run("box:set_awake(false)") == "");
    const engine::Image asleep = picture_of(bench, shapes);
    CHECK(brightness(asleep, 110, 40) < 0.7 * brightness(awake, 110, 40));
    CHECK(brightness(asleep, 10, 80) == brightness(awake, 10, 80));  // the ground neither sleeps nor wakes
}

TEST_CASE("impulses of contacts point up from the ground, at the corners of a box") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(kBoxOnGround) == "");
    const engine::Image without = picture_of(bench, drawing("{ shapes = false, contacts = false }"));
    const engine::Image with = picture_of(bench, drawing("{ shapes = false }"));
    for (const int x : {80, 120}) {
        CHECK(brightness(without, x, 62) == 0);
        CHECK(with.pixel(x, 70)[0] > 150);  // the point
        CHECK(with.pixel(x, 62)[0] > 100);  // the normal
        CHECK(brightness(with, x, 78) == 0);
    }
    CHECK(brightness(with, 100, 62) == 0);
}

TEST_CASE("islands have colors of their own") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run(std::string(kBoxOnGround) +
                      "w:add_box{ x = 7, y = -1, width = 2, height = 2 } w:step(1 / 60)") == "");
    const auto same = [](const engine::Image& image) {
        const std::uint8_t* a = image.pixel(110, 40);
        const std::uint8_t* b = image.pixel(175, 58);
        return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    };
    CHECK(same(picture_of(bench, drawing("{ contacts = false }"))));
    CHECK_FALSE(same(picture_of(bench, drawing("{ contacts = false, islands = true }"))));
}

TEST_CASE("boxes of the broad phase lie around their shapes") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    REQUIRE(bench.run("w = cairn.physics.new_world{ gravity_y = 0 } "
                      "w:add_circle{ radius = 2 } camera = cairn.camera.new{ height = 10 }") == "");
    const std::string alone = "{ shapes = false, contacts = false, boxes = ";
    const engine::Image with = picture_of(bench, drawing(alone + "true }"));
    int lit = 0;
    for (int x = 100; x < 130; ++x) lit += brightness(with, x, 50) > 0 ? 1 : 0;
    CHECK(lit >= 1);  // its right side, and nothing else of that row
    CHECK(lit <= 3);
    CHECK(brightness(with, 100, 50) == 0);
    CHECK(brightness(picture_of(bench, drawing(alone + "false }")), 100, 50) == 0);
}

TEST_CASE("a joint of each kind is drawn between its anchors, far from the origin too") {
    LuaBench bench(kSmall, MachineKind::HeadlessDrawing);
    const std::string bodies =
        "w = cairn.physics.new_world{} "
        "a = w:add_box{ x = 1000, width = 1, height = 1 } "
        "b = w:add_box{ x = 1004, width = 1, height = 1 } "
        "camera = cairn.camera.new{ x = 1002, height = 10 } ";
    const std::string joints[] = {
        "w:add_distance_joint{ body_a = a, body_b = b }",
        "w:add_distance_joint{ body_a = a, body_b = b, enable_spring = true, frequency = 2, max_length = 5 }",
        "w:add_revolute_joint{ body_a = a, body_b = b, x = 1002, y = 0, enable_limit = true, lower = -1, "
        "upper = 1 "
        "}",
        "w:add_prismatic_joint{ body_a = a, body_b = b, x = 1002, y = 0, enable_limit = true, lower = -1, "
        "upper = 1 "
        "}",
        "w:add_weld_joint{ body_a = a, body_b = b, x = 1002, y = 0 }",
        "w:add_wheel_joint{ body_a = a, body_b = b, x = 1002, y = 0 }",
        "w:add_motor_joint{ body_a = a, body_b = b, x = 1002, y = 0, max_force = 1 }",
        "w:add_mouse_joint{ body = b, x = 1002, y = 0 }",
        "w:add_filter_joint{ body_a = a, body_b = b }",
    };
    for (const std::string& joint : joints) {
        INFO(joint);
        REQUIRE(bench.run(bodies + joint) == "");
        const engine::Image picture = picture_of(bench, drawing("{ shapes = false }"));
        int lit = 0;
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 200; ++x) lit += brightness(picture, x, y) > 60 ? 1 : 0;
        }
        CHECK(lit > 10);
    }
}

TEST_CASE("a part that does not exist is an error that names the nearest") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}") == "");
    CHECK(draw_error(bench, "cairn.graphics.draw_debug(w, { contact = true })").find("contacts") !=
          std::string::npos);
    CHECK(bench.run("cairn.graphics.draw_debug(w)").find("call it inside cairn.draw") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
