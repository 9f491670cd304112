// Ends a script that goes on although the program was asked to end. Invariant: costs nothing until then, for
// the signal's handler itself sets the hook, which is what Lua allows handlers to do.
#pragma once

#include <lua.hpp>

namespace cairn::scripting {

/// Listens as long as it lives; at most one at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Scripts of this state are ended. Null: of none; before a state is closed.
    void watch(lua_State* L);

    /// The program was asked to end: what runs on the main thread of the state from kPatience_s after this on
    /// gets an error, again and again, so that no pcall holds it. For signal handlers.
    static void request();

    /// As much as saving a game takes, and less than a system waits before it kills.
    static constexpr int kPatience_s = 2;
};

}  // namespace cairn::scripting
