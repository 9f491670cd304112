// cairn.timer and the Timer type.
#include "bind/context.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

struct TimerObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Timer;
    std::uint64_t number;
};

}  // namespace

template <>
struct Argument<TimerObject*> {
    static constexpr std::string_view kType = "Timer";
    static TimerObject* get(lua_State* L, int index) {
        auto* timer = object_at<TimerObject>(L, index);
        if (timer == nullptr) argument_error(L, index, "a Timer");
        return timer;
    }
};

namespace {

/// More timers than any game has at once; a script that makes one per frame and forgets it meets this.
constexpr std::size_t kMaxTimers = 10000;

Pushed start(lua_State* L, double seconds, FunctionArgument action, bool repeats) {
    Context& context = context_of(L);
    if (context.timers.count() >= kMaxTimers) {
        call_error(L, std::to_string(kMaxTimers) +
                          " timers are waiting already; cancel those that are no longer needed");
    }
    lua_pushvalue(L, action.index);
    const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
    const std::uint64_t number = context.timers.add(context.frame, seconds, repeats, reference);
    new_object<TimerObject>(L, 0, number);
    return {1};
}

Pushed after(lua_State* L, Seconds seconds, FunctionArgument action) {
    return start(L, seconds, action, false);
}
Pushed every(lua_State* L, Seconds seconds, FunctionArgument action) {
    return start(L, seconds, action, true);
}
double time(lua_State* L) {
    return context_of(L).time_s();
}
std::int64_t frame(lua_State* L) {
    return static_cast<std::int64_t>(context_of(L).frame);
}

void cancel(lua_State* L, TimerObject* self) {
    if (const auto reference = context_of(L).timers.cancel(self->number))
        luaL_unref(L, LUA_REGISTRYINDEX, *reference);
}

constexpr std::array<std::string_view, 1> kReturnsTimer = {"Timer"};

constexpr Function kFunctions[] = {
    function_pushing<&after>("after", "seconds [s], action", "timer", kReturnsTimer,
                             "Calls `action()` once."),
    function_pushing<&every>("every", "seconds [s], action", "timer", kReturnsTimer,
                             "Calls `action()` again and again, until it returns false: in the first update "
                             "after each whole number of "
                             "periods, and at most once in an update."),
    function<&time>("time", "", "seconds [s]", "Game time since the start."),
    function<&frame>("frame", "", "count", "Updates since the start: 1 in the first."),
};
constexpr Function kMethods[] = {
    function<&cancel>("cancel", "", "", "The action is not called any more."),
};

}  // namespace

const Module kTimerModule = {"cairn.timer",
                             "Actions for later, in game time: 60 updates, or as many as conf.lua says, are "
                             "a second, however fast the computer is. Due actions run "
                             "before `cairn.update`.",
                             kFunctions};
const Module kTimerMethods = {"Timer", "An action that waits.", kMethods, true};

}  // namespace cairn::scripting
