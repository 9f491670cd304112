// Loops in Lua around one call, timed from outside; the best of several rounds, because whatever else the
// machine does only makes them slower.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <unistd.h>

#include <cairn/engine/native_file.h>
#include <cairn/scripting/lua_cost.h>

#include "bridge/game.h"
#include "bridge/machine.h"

namespace cairn::scripting {
namespace {

namespace fs = std::filesystem;

constexpr int kBodies = 1000;
// Of all bodies: a millisecond or two, in which a busy machine now and then lets nobody else run; and so
// often that this happens.
constexpr int kRounds = 20;
constexpr int kRepeats = 400;
constexpr int kFrames = 300;
constexpr int kManyBodies = 5000;

constexpr const char* kScript = R"(
local bodies, transforms, batch, quads = {}, cairn.physics.new_transforms(), nil, {}
local world = cairn.physics.new_world{ gravity_y = 0 }
for i = 1, 1000 do
    bodies[i] = world:add_circle{ x = i % 40, y = i // 40, radius = 0.3, allow_sleep = false,
        linear_velocity_x = (i * 7 % 11 - 5) / 5, linear_velocity_y = (i * 5 % 13 - 6) / 6 }
end

function loop(rounds)
    local sum = 0
    for _ = 1, rounds do for i = 1, #bodies do local body = bodies[i] local x, y = i, i sum = sum + x + y end end
    return sum
end
function position(rounds)
    local sum = 0
    for _ = 1, rounds do for i = 1, #bodies do local body = bodies[i] local x, y = body:position() sum = sum + x + y end end
    return sum
end
function read(rounds)
    for _ = 1, rounds do world:read_transforms(transforms) end
end
function transform(rounds)
    local sum = 0
    for _ = 1, rounds do for i = 1, #bodies do local x, y, angle = transforms:transform(i) sum = sum + x + y end end
    return sum
end

-- Half boxes, half circles.
function show(count)
    local many, camera = cairn.physics.new_world{}, cairn.camera.new{ x = 50, y = count / 200, height = 1.2 * count / 100 }
    for i = 1, count do
        local x, y = i % 100, i // 100
        if i % 2 == 0 then many:add_box{ x = x, y = y, width = 0.5, height = 0.5 }
        else many:add_circle{ x = x, y = y, radius = 0.3 } end
    end
    function cairn.draw()
        camera:attach()
        cairn.graphics.draw_world(many)
        camera:detach()
    end
end

local canvas = cairn.graphics.new_canvas(16, 16)
batch = cairn.graphics.new_batch(canvas)
for _, body in ipairs(bodies) do quads[body] = true end
local camera = cairn.camera.new{ x = 20, y = 12, height = 30 }
function cairn.update(dt) world:step(dt) end
function cairn.draw()
    camera:attach()
    batch:clear()
    batch:add_bodies(world, quads, 0.6 / 16)
    batch:draw()
    camera:detach()
end
)";

/// A folder with the script, gone with this object.
struct ScriptFolder {
    ScriptFolder()
        : path((fs::temp_directory_path() / ("cairn-lua-cost-" + std::to_string(getpid()))).string()) {
        std::error_code ignored;
        fs::create_directories(path, ignored);
    }
    ~ScriptFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    std::string path;
};

/// The shortest of several calls of a global function with the number of rounds, s.
engine::Result<double> best_time_s(Game& game, const char* function) {
    using Clock = std::chrono::steady_clock;
    lua_State* L = game.lua();
    double best_s = 1e9;
    for (int i = 0; i < kRepeats; ++i) {
        lua_getglobal(L, function);
        lua_pushinteger(L, kRounds);
        const auto begin = Clock::now();
        if (const auto error = protected_call(L, 1, 0)) return engine::Error{error->to_text()};
        best_s = std::min(best_s, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    return best_s;
}

}  // namespace

engine::Result<LuaCost> measure_lua_cost(const std::string& program_path, const std::string& assets) {
    const ScriptFolder folder;
    if (auto written = engine::write_native_file(folder.path + "/main.lua", kScript); !written)
        return written.error();
    const GameSource source{.program_path = program_path,
                            .path = folder.path,
                            .name = "lua-cost",
                            .assets = {assets},
                            .save_root = folder.path + "/saves"};
    auto machine = make_machine(source, MachineKind::HeadlessDrawing);
    if (!machine) return machine.error();
    Game game((*machine)->services(), {.plays_saves = true});
    if (const auto error = game.load((*machine)->main_path, {})) return engine::Error{error->to_text()};

    constexpr double kCalls = 1.0 * kBodies * kRounds;
    LuaCost cost{.bodies = kBodies};
    const auto loop_s = best_time_s(game, "loop");
    if (!loop_s) return loop_s.error();
    const std::pair<const char*, double*> calls[] = {{"position", &cost.position_ns},
                                                     {"read", &cost.read_transforms_ns},
                                                     {"transform", &cost.transform_ns}};
    for (const auto& [function, ns] : calls) {
        const auto time_s = best_time_s(game, function);
        if (!time_s) return time_s.error();
        const bool is_loop = ns != &cost.read_transforms_ns;
        *ns = (*time_s - (is_loop ? *loop_s : 0)) / kCalls * 1e9;
    }

    engine::Renderer& renderer = *(*machine)->renderer;
    std::uint64_t allocated_before = 0;
    auto begin = std::chrono::steady_clock::now();
    for (int frame = -30; frame < kFrames; ++frame) {
        if (frame == 0) {  // what is made once is made by now
            allocated_before = game.state().allocated_bytes();
            begin = std::chrono::steady_clock::now();
        }
        auto error = game.update({});
        renderer.begin_frame({});
        if (!error) error = game.draw(1);
        renderer.end_frame();
        if (error) return engine::Error{error->to_text()};
    }
    cost.frame_ms =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / kFrames * 1e3;
    cost.allocated_bytes = static_cast<double>(game.state().allocated_bytes() - allocated_before) / kFrames;

    lua_getglobal(game.lua(), "show");
    lua_pushinteger(game.lua(), kManyBodies);
    auto error = protected_call(game.lua(), 1, 0);
    renderer.begin_frame({});
    if (!error) error = game.draw(1);
    renderer.end_frame();
    if (error) return engine::Error{error->to_text()};
    cost.many_bodies = kManyBodies;
    cost.many_draw_calls = renderer.stats().draw_calls;
    return cost;
}

}  // namespace cairn::scripting
