// The commands and options of cairn-bench, and what to say about wrong ones.
#pragma once

#include <string>
#include <vector>

#include <cairn/physics/simd.h>

#include "scene.h"

namespace cairn::bench {

enum class Command { Help, List, Run, Compare, State, Lua };

struct CommandLine {
    Command command = Command::Help;
    std::vector<const Scene*> scenes;
    int threads = 1;
    physics::SimdLevel simd{};
    int repeat = 1;
    int most_steps = 0;  ///< 0: as many as the scene has
    bool warm = false;   ///< whether scenes are also run in a world that has run them before
    std::string json;    ///< a file, "-" for standard output, or nothing
};

/// Reads the arguments that follow the program's name. For the help, `help` is set to its text.
physics::Result<CommandLine> parse_command_line(const std::vector<std::string>& arguments, std::string& help);

}  // namespace cairn::bench
