// In a build without scripting.
#include "lua.h"

namespace cairn::bench {

std::string measure_lua(measure::Output&) {
    return "this build has no scripting (CAIRN_SCRIPTING=OFF), so there is no Lua to measure";
}

}  // namespace cairn::bench
