// The starter: short enough to be read at once, and moving from the first second.
#include "new_game.h"

#include <filesystem>
#include <fstream>

namespace cairn::player {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMain =
    R"(-- A pile of crates and a ball to throw at it. Click to throw; R starts again.
local world, camera

-- Called once. Lengths are metres, y points up.
function cairn.load()
    world = cairn.physics.new_world{ gravity_y = -10 }
    camera = cairn.camera.new{ x = 0, y = 4.5, height = 12 }
    world:add_box{ type = "static", y = -0.5, width = 60, height = 1, friction = 0.8 }
    for column = 0, 2 do
        for row = 0, 4 do
            world:add_box{
                x = 3 + column * 1.1, y = 0.5 + row, width = 1, height = 1,
                data = { color = { 0.85, 0.60 - 0.06 * row, 0.30 } },
            }
        end
    end
end

-- Called 60 times a second of game time, however fast the computer is; dt is always 1/60.
function cairn.update(dt)
    world:step(dt)
    for _, a, b, impulse in world:events("hit") do
        if impulse > 5 then
            a.data.flash, b.data.flash = 1, 1
        end
    end
end

-- Called once per picture.
function cairn.draw()
    cairn.graphics.clear(0.93, 0.90, 0.84)
    camera:attach()
    cairn.graphics.draw_world(world)
    camera:detach()
    cairn.graphics.set_color(0.25, 0.22, 0.20)
    cairn.graphics.print("Click to throw a ball. R: again", 16, 12)
    cairn.graphics.print(("%d of %d bodies awake"):format(world:awake_count(), world:body_count()), 16, 38)
end

function cairn.mouse_pressed(x, y)
    local target_x, target_y = camera:to_world(x, y)
    local start_x, start_y = -6, 3
    local ball = world:add_circle{
        x = start_x, y = start_y, radius = 0.4, density = 4, restitution = 0.3,
        data = { color = { 0.36, 0.53, 0.72 } },
    }
    ball:set_linear_velocity((target_x - start_x) * 2, (target_y - start_y) * 2 + 2)
end

function cairn.key_pressed(key)
    if key == "r" then
        world:destroy()
        cairn.load()
    elseif key == "escape" then
        cairn.quit()
    end
end
)";

constexpr const char* kTest = R"(-- Run with `cairn test .`
local test = cairn.test

test.test("a click throws one ball", function()
    test.start{}
    test.run(1)
    test.mouse_press(900, 400)
    test.run(60)
    test.expect_equal(test.result(), nil)
end)
)";

engine::Result<void> write_file(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) return engine::Error{"cannot write \"" + path.string() + "\""};
    return {};
}

}  // namespace

engine::Result<void> new_game(const std::string& folder) {
    std::error_code failed;
    const fs::path root = folder;
    if (fs::exists(root, failed) && !(fs::is_directory(root, failed) && fs::is_empty(root, failed))) {
        return engine::Error{"\"" + folder + "\" exists already and is not an empty folder"};
    }
    fs::create_directories(root / "tests", failed);
    if (failed) return engine::Error{"cannot make the folder \"" + folder + "\": " + failed.message()};
    fs::path named = fs::absolute(root, failed).lexically_normal();
    if (named.filename().empty()) named = named.parent_path();
    std::string title;
    for (const char c : named.filename().string()) {
        if (c != '"' && c != '\\') title += c;
    }
    const std::string conf = "return {\n    title = \"" + title + "\",\n    width = 1280, height = 720,\n}\n";
    if (auto written = write_file(root / "conf.lua", conf); !written) return written;
    if (auto written = write_file(root / "main.lua", kMain); !written) return written;
    return write_file(root / "tests" / "throw.lua", kTest);
}

}  // namespace cairn::player
