// What calls from Lua cost, for benchmarks.
#pragma once

#include <string>

#include <cairn/engine/result.h>

namespace cairn::scripting {

struct LuaCost {
    int bodies = 0;
    double position_ns = 0;         ///< one body:position(), the loop around it taken off
    double read_transforms_ns = 0;  ///< world:read_transforms, for each body
    double transform_ns = 0;        ///< transforms:transform(i)
    double frame_ms = 0;         ///< a step of moving bodies and a batch of their sprites, drawn into memory
    double allocated_bytes = 0;  ///< asked for by Lua in such a frame, the mean
    int many_bodies = 0;
    int many_draw_calls = 0;  ///< of a picture of so many bodies; the same for each renderer
};

/// Takes a few seconds. `program_path` is argv[0].
engine::Result<LuaCost> measure_lua_cost(const std::string& program_path, const std::string& assets);

}  // namespace cairn::scripting
