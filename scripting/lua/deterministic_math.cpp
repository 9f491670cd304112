// Thin wrappers around the physics' own elementary functions. sqrt, floor, fmod and the like are exact
// everywhere already.
#include "lua/deterministic_math.h"

#include <cmath>

#include <cairn/physics/math.h>

namespace cairn::scripting {
namespace {

namespace deterministic = physics::deterministic;

template <double (*F)(double)>
int unary(lua_State* L) {
    lua_pushnumber(L, F(luaL_checknumber(L, 1)));
    return 1;
}

int math_atan(lua_State* L) {
    lua_pushnumber(L, deterministic::atan2(luaL_checknumber(L, 1), luaL_optnumber(L, 2, 1)));
    return 1;
}

int math_pow(lua_State* L) {
    lua_pushnumber(L, deterministic::pow(luaL_checknumber(L, 1), luaL_checknumber(L, 2)));
    return 1;
}

int math_log(lua_State* L) {
    const double x = luaL_checknumber(L, 1);
    if (lua_isnoneornil(L, 2)) {
        lua_pushnumber(L, deterministic::log(x));
        return 1;
    }
    const double base = luaL_checknumber(L, 2);
    const double quotient = deterministic::log(x) / deterministic::log(base);
    // Exact powers have exact logarithms: log(8, 2) is 3.
    const double whole = std::round(quotient);
    lua_pushnumber(L, deterministic::pow(base, whole) == x ? whole : quotient);
    return 1;
}

}  // namespace

void install_deterministic_math(lua_State* L) {
    static constexpr luaL_Reg kFunctions[] = {
        {"sin", unary<deterministic::sin>},
        {"cos", unary<deterministic::cos>},
        {"tan", unary<deterministic::tan>},
        {"asin", unary<deterministic::asin>},
        {"acos", unary<deterministic::acos>},
        {"atan", math_atan},
        {"exp", unary<deterministic::exp>},
        {"log", math_log},
        {"pow", math_pow},
        {nullptr, nullptr},
    };
    luaL_setfuncs(L, kFunctions, 0);
}

}  // namespace cairn::scripting
