// The message handler runs where the error happened, so that the traceback still shows the calls.
#include "lua/errors.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <cairn/engine/printable.h>

#include "data/source_text.h"
#include "lua/sandbox.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// "src/aim.lua:12: in function 'release'" for each Lua function on the stack. C functions without a name are
/// the program's own frames and tell an author nothing.
std::vector<std::string> traceback_of(lua_State* L, int first_level) {
    constexpr int kMostLines = 24;  // an endless recursion has 200,000
    std::vector<std::string> lines;
    lua_Debug frame;
    int level = first_level;
    for (; lua_getstack(L, level, &frame) != 0 && static_cast<int>(lines.size()) < kMostLines; ++level) {
        lua_getinfo(L, "Slnt", &frame);
        const bool is_c = *frame.what == 'C';
        if (is_c && (frame.name == nullptr || *frame.namewhat == '\0')) continue;
        std::string line;
        if (is_c) {
            line = std::string("[built in]: in '") + frame.name + "'";
        } else {
            line = std::string(frame.short_src) + ':' + std::to_string(frame.currentline) + ": in ";
            if (*frame.what == 'm') {
                line += "the main chunk";
            } else if (frame.name != nullptr && *frame.namewhat != '\0') {
                line += std::string(frame.namewhat) + " '" + frame.name + "'";
            } else {
                line += "the function of line " + std::to_string(frame.linedefined);
            }
        }
        lines.push_back(line);
    }
    if (lua_getstack(L, level, &frame) != 0 && static_cast<int>(lines.size()) >= kMostLines)
        lines.push_back("...");
    return lines;
}

/// The text at an index with NUL bytes made visible: whatever prints it would stop there.
std::string message_at(lua_State* L, int index) {
    std::size_t length = 0;
    const char* text = lua_tolstring(L, index, &length);
    std::string message;
    for (const char c : std::string_view(text, length)) {
        if (c == '\0') {
            message += "\\0";
        } else {
            message += c;
        }
    }
    return message;
}

/// An error that leaves a function of coroutine.wrap, or is raised again by error(), got a second place put
/// before its own; what the author needs is where it began, and the calls name the other.
std::string without_repeated_place(std::string message) {
    constexpr int kMostRepeats = 16;  // a message made of places alone would be copied for ever
    constexpr std::size_t kLongestPlace = 256;
    for (int i = 0; i < kMostRepeats; ++i) {
        const auto outer = place_of(message.substr(0, kLongestPlace));
        if (!outer) break;
        const std::size_t end = message.find(": ", outer->file.size() + 1);
        if (end == std::string::npos) break;
        // Prose may hold a number between colons too.
        const auto inner = place_of(message.substr(end + 2, kLongestPlace));
        if (!inner || !inner->file.ends_with(".lua")) break;
        message.erase(0, end + 2);
    }
    return message;
}

/// The text in which the place of a message was counted, when a script that runs has raised it. A place that
/// no call stands at was named by whoever read a file just now.
std::string source_of(lua_State* L, const ScriptError& error) {
    const auto place = place_of(error.message);
    if (!place) return "";
    const std::string start = place->file + ':' + std::to_string(place->line) + ": ";
    for (const std::string& call : error.traceback) {
        if (!call.starts_with(start)) continue;
        const std::string* source = State::of(L).source(place->file);
        return source == nullptr ? "" : *source;
    }
    return "";
}

constexpr const char* kOutOfMemory = "not enough memory: the script used up what a game may have";

/// Where handle_error puts what it finds: the error of the innermost protected call on this thread. A closure
/// over it would need memory, which is what a script may just have used up.
thread_local ScriptError* current_error = nullptr;

int handle_error(lua_State* L) {
    ScriptError& error = *current_error;
    if (lua_type(L, 1) == LUA_TSTRING || luaL_getmetafield(L, 1, "__tostring") != LUA_TNIL) {
        lua_settop(L, 1);
        push_text(L, 1);
        error.message = without_repeated_place(message_at(L, -1));
    } else {
        error.message = std::string("an error value that is ") + luaL_typename(L, 1) + " was raised";
    }
    error.traceback = traceback_of(L, 1);
    // error("text", 0) and errors that are not strings come without a place; the innermost Lua call is the
    // best known.
    if (!place_of(error.message)) {
        for (const std::string& line : error.traceback) {
            if (const auto place = place_of(line)) {
                error.message = place->file + ':' + std::to_string(place->line) + ": " + error.message;
                break;
            }
        }
    }
    error.source = source_of(L, error);
    return 1;
}

}  // namespace

std::string ScriptError::to_text() const {
    std::string text = message;
    for (const std::string& line : traceback) text += "\n    " + line;
    return text;
}

std::optional<ScriptPlace> place_of(const std::string& message) {
    // A file's name holds no blank before its ":LINE:", which tells it from prose with a colon.
    const std::size_t colon = message.find(':');
    if (colon == std::string::npos || colon == 0 || message[0] == '[') return std::nullopt;
    char* end = nullptr;
    const long line = std::strtol(message.c_str() + colon + 1, &end, 10);
    if (line <= 0 || *end != ':') return std::nullopt;
    return ScriptPlace{message.substr(0, colon), static_cast<int>(line)};
}

std::optional<ScriptError> protected_call(lua_State* L, int arguments, int results) {
    ScriptError error;
    ScriptError* const outer_error = std::exchange(current_error, &error);
    const int handler = lua_gettop(L) - arguments;
    lua_pushcfunction(L, handle_error);
    lua_insert(L, handler);
    const int status = lua_pcall(L, arguments, results, handler);
    current_error = outer_error;
    lua_remove(L, handler);
    if (status == LUA_OK) return std::nullopt;
    if (status == LUA_ERRMEM) {
        const std::string place = State::place_of_refusal(L);
        error.message = place + (place.empty() ? "" : ": ") + kOutOfMemory;
        error.traceback.clear();
    }
    if (status == LUA_ERRERR) error.message = "an error happened while another one was handled";
    if (status < 0)
        error.message = "the program ran out of memory";  // a C++ exception: only allocations throw
    lua_pop(L, 1);
    return error;
}

std::optional<ScriptError> load_text(lua_State* L, const std::string& text, const std::string& name) {
    const std::string_view code = code_of(text);
    if (luaL_loadbufferx(L, code.data(), code.size(), ('@' + name).c_str(), "t") == LUA_OK)
        return std::nullopt;
    ScriptError error;
    error.message = message_at(L, -1);
    error.source = text;
    lua_pop(L, 1);
    return error;
}

namespace {

/// Pushes a text whose control characters but ends of lines are escaped, as are bytes that are no UTF-8: a
/// message may quote what anybody gave, and a terminal would obey it. Keeps nothing of its own that an error
/// would leave behind.
void push_printable(lua_State* L, std::string_view text) {
    luaL_Buffer out;
    luaL_buffinit(L, &out);
    engine::give_printable(text,
                           [&](std::string_view part) { luaL_addlstring(&out, part.data(), part.size()); });
    luaL_pushresult(&out);
}

}  // namespace

void raise(lua_State* L, const std::string& message) {
    luaL_where(L, 1);
    push_printable(L, message);
    lua_concat(L, 2);
    lua_error(L);
    std::abort();  // lua_error never returns; its declaration does not say so
}

}  // namespace cairn::scripting
