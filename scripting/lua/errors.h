// A script's error as a person wants to read it: one message that begins with FILE:LINE, and the calls that
// led there.
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scripting {

struct ScriptError {
    std::string message;                 ///< "src/aim.lua:12: attempt to ..."
    std::vector<std::string> traceback;  ///< innermost call first: "src/aim.lua:12: in function 'release'"
    /// What the file that the message names said when it was loaded; empty: what it says now.
    std::string source = {};

    /// The message, and below it the traceback with four spaces before each line.
    [[nodiscard]] std::string to_text() const;
};

/// A place in a script, from the beginning of a message such as "src/aim.lua:12: ...".
struct ScriptPlace {
    std::string file;
    int line = 0;
};
std::optional<ScriptPlace> place_of(const std::string& message);

/// Needs no memory of Lua's, so that it works when a script has used up all. Calls the function below its
/// `arguments` on the stack, as lua_pcall does. After an error the stack holds neither function, arguments
/// nor results.
std::optional<ScriptError> protected_call(lua_State* L, int arguments, int results);

/// Compiles text; the function is pushed. `name` is the path that messages show.
std::optional<ScriptError> load_text(lua_State* L, const std::string& text, const std::string& name);

/// Raises an error with the place of the Lua code that called the running C function.
[[noreturn]] void raise(lua_State* L, const std::string& message);

}  // namespace cairn::scripting
