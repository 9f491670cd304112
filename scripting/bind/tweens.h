// Numbers in tables that move to a goal in time. Invariant: tweens run in order of their making, and of two
// that move the same field only the newer does.
#pragma once

#include <cstdint>
#include <lua.hpp>
#include <map>
#include <string>
#include <vector>

#include "bind/easing.h"

namespace cairn::scripting {

struct TweenField {
    std::string name;
    double goal = 0;
    double start = 0;
};

struct Tween {
    int target = LUA_NOREF;          ///< the table, in the registry
    int done = LUA_NOREF;            ///< a function to call at the end, in the registry
    const void* identity = nullptr;  ///< of the table: compared, never ordered by
    std::string place;               ///< where it was made, "main.lua:12: "
    std::vector<TweenField> fields;
    Ease ease;
    std::uint64_t begin = 0;   ///< the frame at whose end the fields still have their starting values
    std::uint64_t frames = 1;  ///< of one way
    std::uint64_t ways = 1;    ///< 0: for ever
    bool is_yoyo = false;      ///< every second way goes back
    bool has_begun = false;    ///< the starting values are read
};

/// By number, which counts from 1 in order of making.
struct Tweens {
    std::map<std::uint64_t, Tween> running;
    std::uint64_t made = 0;
};

/// Moves every tween of the state to the present frame. A lua_CFunction, because targets may have metatables
/// and the functions that are called at the end may raise errors.
int run_tweens(lua_State* L);

}  // namespace cairn::scripting
