// `cairn-bench lua`: what calls from Lua cost, beside LÖVE where it is installed.
#pragma once

#include <string>

#include "output.h"

namespace cairn::bench {

/// Prints the figures. An empty text, or what went wrong.
std::string measure_lua(measure::Output& output);

}  // namespace cairn::bench
