// LÖVE is a program of its own: it runs the same loops in its own Lua and prints one number.
#include "lua.h"

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include <cairn/scripting/lua_cost.h>

namespace cairn::bench {
namespace {

/// What the first line of a command's output says, if it is a number above 0.
std::optional<double> number_printed_by(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    char line[64] = {};
    const bool has_line = std::fgets(line, sizeof line, pipe) != nullptr;
    pclose(pipe);
    const double number = has_line ? std::strtod(line, nullptr) : 0;
    return number > 0 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string measure_lua(measure::Output& output) {
    const auto cost = scripting::measure_lua_cost("cairn-bench", CAIRN_BENCH_ASSETS);
    if (!cost) return cost.error().message;
    const auto love_ns = number_printed_by("love '" CAIRN_BENCH_LOVE "' 2>/dev/null");
    char text[160];
    const auto row = [&](const char* what, double value, const char* unit) {
        std::snprintf(text, sizeof text, "%-44s %9.2f %s", what, value, unit);
        output.row(text);
    };
    row("body:position()", cost->position_ns, "ns");
    if (love_ns) {
        row("body:getPosition() in LOVE, the same loop", *love_ns, "ns");
    } else {
        output.row("love is not installed: nothing to compare body:position() with");
    }
    row("world:read_transforms, for each body", cost->read_transforms_ns, "ns");
    row("transforms:transform(i)", cost->transform_ns, "ns");
    row("frame of 1,000 moving, drawn bodies", cost->frame_ms, "ms");
    row("allocated by Lua in such a frame", cost->allocated_bytes, "bytes");
    row("draw calls of a picture of 5,000 bodies", cost->many_draw_calls, "");
    nlohmann::ordered_json line = {{"bench", "lua"},
                                   {"bodies", cost->bodies},
                                   {"position_ns", cost->position_ns},
                                   {"read_transforms_ns", cost->read_transforms_ns},
                                   {"transform_ns", cost->transform_ns},
                                   {"frame_ms", cost->frame_ms},
                                   {"allocated_bytes", cost->allocated_bytes},
                                   {"many_bodies", cost->many_bodies},
                                   {"many_draw_calls", cost->many_draw_calls}};
    if (love_ns) line["love_position_ns"] = *love_ns;
    output.line(line.dump());
    return "";
}

}  // namespace cairn::bench
