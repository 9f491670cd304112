// The starter: short enough to be read at once, and moving from the first second.
#include "new_game.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include <cairn/engine/native_file.h>

namespace cairn::player {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMain =
    R"(-- A pile of crates and a ball to throw at it. Click to throw; R starts again.
world = nil  -- global, so that tests/throw.lua can look at it
local camera

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
    for _, body in ipairs(world:bodies()) do
        body.data.flash = math.max((body.data.flash or 0) - 3 * dt, 0)
    end
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
    for _, body in ipairs(world:bodies()) do
        if (body.data.flash or 0) > 0 and body:type() == "dynamic" then
            local x, y = body:position()
            cairn.graphics.set_color(1, 1, 1, body.data.flash)
            cairn.graphics.circle("fill", x, y, 0.3)
        end
    end
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

-- Starts the game and clicks on the pile. Gives the number of bodies before.
local function throw()
    test.start{}
    test.run(1)
    local before = world:body_count()
    test.mouse_press(900, 400)
    test.run(1)
    return before
end

test.test("a click throws one ball at the pile", function()
    local before = throw()
    test.expect_equal(world:body_count(), before + 1)
    local bodies = world:bodies()
    test.expect(bodies[#bodies]:linear_velocity() > 10, "the ball does not fly to the right")
end)

test.test("what is hit hard flashes", function()
    throw()
    local function flashes()
        for _, body in ipairs(world:bodies()) do
            if (body.data.flash or 0) > 0 then return true end
        end
    end
    test.expect(test.run_until(flashes, 120), "nothing has flashed in two seconds")
end)

test.test("the pile stands still", function()
    test.start{}
    test.run(1)
    local places = {}
    for i, body in ipairs(world:bodies()) do places[i] = { body:position() } end
    test.run(120)
    for i, body in ipairs(world:bodies()) do
        local x, y = body:position()
        test.expect_near(x, places[i][1], 0.05)
        test.expect_near(y, places[i][2], 0.05)
    end
end)

test.test("a crate that is lifted falls back", function()
    test.start{}
    test.run(1)
    local bodies = world:bodies()
    local crate = bodies[#bodies]
    local x, y = crate:position()
    crate:set_position(x, y + 2)
    test.run(90)
    test.expect_near(select(2, crate:position()), y, 0.1)
end)

test.test("R starts again", function()
    local before = throw()
    local old_world = world
    test.press("r")
    test.run(1)
    test.expect_equal(world:body_count(), before)
    test.expect(not old_world:is_valid(), "the world of before is still there")
end)
)";

/// Makes files and folders that were not there. Invariant: whatever exists is left alone, and what was made
/// is taken back unless all of it was made.
class Starter {
  public:
    Starter() = default;
    Starter(const Starter&) = delete;
    Starter& operator=(const Starter&) = delete;
    ~Starter() {
        std::error_code ignored;
        for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
    }

    engine::Result<void> make_folder(const fs::path& folder) {
        std::error_code failed;
        if (fs::is_directory(folder, failed)) return {};
        if (folder.has_parent_path() && folder.parent_path() != folder) {
            if (auto parent = make_folder(folder.parent_path()); !parent) return parent;
        }
        if (!fs::create_directory(folder, failed) && failed)
            return engine::Error{"cannot make the folder \"" + folder.string() + "\": " + failed.message()};
        made_.push_back(folder);
        return {};
    }

    engine::Result<void> make_file(const fs::path& path, const std::string& text) {
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(path, ignored)))
            return engine::Error{"\"" + path.string() + "\" exists already"};
        if (auto written = engine::write_native_file(path.string(), text); !written) return written;
        made_.push_back(path);
        return {};
    }

    void keep() { made_.clear(); }

  private:
    std::vector<fs::path> made_;
};

/// The folder's name as it can stand between quotes in conf.lua.
std::string title_of(const fs::path& folder) {
    std::error_code ignored;
    fs::path named = fs::absolute(folder, ignored).lexically_normal();
    if (named.filename().empty()) named = named.parent_path();
    std::string title;
    for (const char c : named.filename().string()) {
        const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        if (c != '"' && c != '\\' && !is_control) title += c;
    }
    return title;
}

}  // namespace

engine::Result<void> new_game(const std::string& folder) {
    if (folder.empty()) return engine::Error{"DIR is empty: it must name the folder of the new game"};
    std::error_code failed;
    const fs::path root = folder;
    if (fs::exists(root, failed) && !(fs::is_directory(root, failed) && fs::is_empty(root, failed))) {
        return engine::Error{"\"" + folder + "\" exists already and is not an empty folder"};
    }
    const std::string conf =
        "return {\n    title = \"" + title_of(root) + "\",\n    width = 1280, height = 720,\n}\n";
    Starter starter;
    if (auto made = starter.make_folder(root / "tests"); !made) return made;
    if (auto made = starter.make_file(root / "conf.lua", conf); !made) return made;
    if (auto made = starter.make_file(root / "main.lua", kMain); !made) return made;
    if (auto made = starter.make_file(root / "tests" / "throw.lua", kTest); !made) return made;
    starter.keep();
    return {};
}

std::string shell_word(const std::string& path) {
    const std::string named = path.starts_with('-') ? "./" + path : path;  // no option
    const auto is_plain = [](char c) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        return is_letter || std::string_view("_-./,:@%+=").find(c) != std::string_view::npos;
    };
    if (!named.empty() && std::all_of(named.begin(), named.end(), is_plain)) return named;
    std::string quoted = "'";
    for (const char c : named) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + '\'';
}

}  // namespace cairn::player
