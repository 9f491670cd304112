// Runs one Lua file with the whole API but neither window nor sound: physics experiments, tools, tests.
#pragma once

#include <string>
#include <vector>

#include <cairn/scripting/play.h>

namespace cairn::scripting {

/// `source.path` is the file; the arguments are its `...`. Returns the exit status.
int run_script(const GameSource& source, const std::vector<std::string>& arguments);

}  // namespace cairn::scripting
