// The command `cairn-lab cost`. The proof needs builds that leave features out, which no program has in
// itself: the script beside this file makes them, and the command is that script.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"

namespace cairn::lab {

/// What the script is called with, itself first.
std::vector<std::string> cost_arguments(const CommandLine& line, const std::string& script);

/// The process goes on as the script. Returns only when there is no such script, with words about that.
std::string become_cost_script(const CommandLine& line);

}  // namespace cairn::lab
