// The hook looks at the clock every so many instructions, and after the first error is called for each: only
// so does one fall behind the pcall that took the error before it. Source: "Programming in Lua", 4th edition,
// on hooks; lua.c of Lua 5.4, which answers SIGINT by lua_sethook too.
#include "lua/interruption.h"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace cairn::scripting {
namespace {

constexpr int kInstructions = 10000;

// What a handler reads must be free of locks.
std::atomic<lua_State*> watched = nullptr;
std::atomic<std::int64_t> asked_at_ms = 0;  // 0: not asked
static_assert(std::atomic<lua_State*>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

/// POSIX lets signal handlers call clock_gettime; of the C++ library's clocks nobody says so.
std::int64_t now_ms() {
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec / 1'000'000 + 1;
}

void end_when_late(lua_State* L, lua_Debug*) {
    if (now_ms() - asked_at_ms < 1000 * Interruption::kPatience_s) return;
    lua_sethook(L, end_when_late, LUA_MASKCOUNT, 1);
    luaL_where(L, 0);
    lua_pushfstring(L, "the program was asked to end, and the script went on for %d s",
                    Interruption::kPatience_s);
    lua_concat(L, 2);
    lua_error(L);
}

void set_hook(lua_State* L) {
    lua_sethook(L, end_when_late, LUA_MASKCOUNT, kInstructions);
}

}  // namespace

Interruption::Interruption() {
    asked_at_ms = 0;
}

Interruption::~Interruption() {
    watched = nullptr;
}

void Interruption::watch(lua_State* L) {
    watched = L;
    if (L != nullptr && asked_at_ms != 0) set_hook(L);
}

void Interruption::request() {
    if (asked_at_ms == 0) asked_at_ms = now_ms();
    if (lua_State* L = watched) set_hook(L);
}

}  // namespace cairn::scripting
