// Expressions in Lua with which every binding can be called, from its description.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>

#include "bind/module.h"
#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {

/// "World:step", "cairn.graphics.circle".
inline std::string full_name(const Module& module, const Function& function) {
    return std::string(module.name) + (module.is_type ? ":" : ".") + function.name;
}

/// Lua expressions for an object of each type.
inline std::string receiver(const std::string& type) {
    if (type == "World") return "cairn.physics.new_world{}";
    if (type == "Body") return "cairn.physics.new_world{}:add_circle{ radius = 1 }";
    if (type == "Shape") return "cairn.physics.new_world{}:add_circle{ radius = 1 }:shapes()[1]";
    if (type == "Chain") {
        return "select(2, cairn.physics.new_world{}:add_chain{ type = 'static', points = { { 9, 0 }, { 0, 0 "
               "}, { -9, 0 "
               "} } })";
    }
    if (type == "Transforms") return "cairn.physics.new_transforms()";
    if (type == "Recording") return "cairn.physics.new_recording()";
    if (type == "Mover") return "cairn.physics.new_mover{}";
    if (type == "Level") return "cairn.level.load('level.lua')";
    if (type == "Camera") return "cairn.camera.new{}";
    if (type == "Font") return "cairn.graphics.new_font(20)";
    if (type == "Random") return "cairn.random.new(1)";
    if (type == "Timer") return "cairn.timer.after(1, print)";
    if (type == "Canvas") return "cairn.graphics.new_canvas(4, 4)";
    if (type == "Quad") return "cairn.graphics.new_quad(cairn.graphics.new_image('pixel.png'), 0, 0, 1, 1)";
    if (type == "Atlas") return "cairn.graphics.new_atlas('atlas.json')";
    if (type == "Batch") return "cairn.graphics.new_batch(cairn.graphics.new_image('pixel.png'))";
    if (type == "Tween") return "cairn.tween.to({ x = 1 }, { x = 2 }, 1)";
    if (type == "Particles") return "cairn.particles.new{}";
    if (type == "TileMap") return "cairn.tilemap.load('map.tmj')";
    if (type == "Ui") return "cairn.ui.new{}";
    if (type == "Text") return "cairn.text.new('words')";
    if (type == "Prefab") return "cairn.prefab.pendulum(cairn.physics.new_world{})";
    if (type == "Joint") {
        return "(function() local w = cairn.physics.new_world{} return w:add_distance_joint{ body_a = "
               "w:new_body{}, body_b = "
               "w:new_body{ x = 2 } } end)()";
    }
    if (type == "Image") return "cairn.graphics.new_image('pixel.png')";
    FAIL("no expression makes a " << type << ": add one here");
    return "";
}

/// A PNG of one pixel.
inline const std::string kPixel(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\6\0\0\0\x1f\x15\xc4\x89\0\0\0\rIDATx\x9c"
    "c\xf8\xcf\xc0\xf0\x1f\0\5\0\1\xff\x89\x99=\x1d\0\0\0\0IEND\xae"
    "B`\x82",
    70);

/// What the expressions read.
inline const GameFiles kGoodFiles{
    {"pixel.png", kPixel},
    {"atlas.json", R"({"frames": {}, "meta": {"image": "pixel.png"}})"},
    {"level.lua", "{ bodies = { { name = 'a', shape = 'circle', radius = 1 } } }"},
    {"map.tmj", R"({"width": 1, "height": 1, "tilewidth": 1, "tileheight": 1, "layers": []})"}};

/// A world with one of each, for arguments that are fine.
inline const char* const kGood = R"(
    function make()
    world = cairn.physics.new_world{}
    body = world:add_box{ width = 1, height = 1 }
    other = world:add_box{ x = 3, width = 1, height = 1 }
    shape = body:shapes()[1]
    joint = world:add_revolute_joint{ body_a = body, body_b = other, x = 1, y = 0 }
    joint_2 = world:add_revolute_joint{ body_a = body, body_b = other, x = 2, y = 0 }
    _, chain = world:add_chain{ points = { { 9, -3 }, { 0, -3 }, { -9, -3 } } }
    prefab = cairn.prefab.rope(world, { x = 20, to_x = 22 })
    image = cairn.graphics.new_image('pixel.png')
    dead = world:add_circle{ radius = 1 }
    dead:destroy()
    end
    make()
)";

/// One of each that kGood made, else a new one.
inline std::string good_receiver(const std::string& type) {
    if (type == "World" || type == "Body" || type == "Shape" || type == "Joint" || type == "Chain" ||
        type == "Prefab")
        return static_cast<char>(type[0] + ('a' - 'A')) + type.substr(1);
    return receiver(type);
}

/// Makes kGood anew if a call destroyed some of it.
inline const char* const kMend = R"(
    if not (world:is_valid() and body:is_valid() and joint:is_valid() and chain:is_valid() and shape:is_valid()) then
        if world:is_valid() then world:destroy() end
        make()
    end
)";

/// An expression that a parameter of a type takes.
inline std::string good_value(std::string_view type) {
    if (type.ends_with('?')) type.remove_suffix(1);
    if (type == "number") return "1";
    if (type == "integer") return "1";
    if (type == "boolean") return "true";
    if (type == "string") return "'text'";
    if (type == "table") return "{}";
    if (type == "function") return "print";
    if (type == "World") return "world";
    if (type == "Body") return "body";
    if (type == "Shape") return "shape";
    if (type == "Joint") return "joint";
    if (type == "Image|Canvas|Quad") return "image";
    if (type == "integer|function|table") return "function() return true end";
    return "nil";
}

}  // namespace cairn::scripting::test
