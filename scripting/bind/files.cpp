// cairn.files.
#include <algorithm>

#include "bind/context.h"
#include "bind/data_values.h"
#include "bind/modules.h"
#include "data/table_parser.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

constexpr std::string_view kSaveFolder = "save/";

bool is_save_path(std::string_view path) {
    return path.substr(0, kSaveFolder.size()) == kSaveFolder || path == "save";
}

/// What a run that only plays its save folder holds under a path, or null.
const std::string* played_file(const Context& context, std::string_view path) {
    const auto found = context.played_saves->find(path);
    return found == context.played_saves->end() ? nullptr : &found->second;
}

engine::Result<std::string> read(lua_State* L, std::string_view path) {
    const Context& context = context_of(L);
    check_or_raise(L, engine::check_virtual_path(path));
    if (!context.played_saves || !is_save_path(path)) return context.services.files.read_text(path);
    if (const std::string* text = played_file(context, path)) return *text;
    return engine::Error{"\"" + std::string(path) + "\" does not exist"};
}

engine::Result<void> write(lua_State* L, std::string_view path, std::string_view text) {
    Context& context = context_of(L);
    check_or_raise(L, engine::check_virtual_path(path));
    if (!context.played_saves) return context.services.files.write(path, text);
    if (!is_save_path(path)) {
        return engine::Error{"cannot write \"" + std::string(path) +
                             "\": only paths below save/ can be written"};
    }
    (*context.played_saves)[std::string(path)] = text;
    return {};
}

bool exists(lua_State* L, std::string_view path) {
    const Context& context = context_of(L);
    if (!context.played_saves || !is_save_path(path)) return context.services.files.exists(path);
    return played_file(context, path) != nullptr;
}

Pushed list(lua_State* L, std::string_view folder) {
    const Context& context = context_of(L);
    std::vector<std::string> names;
    if (context.played_saves && is_save_path(folder)) {
        const std::string prefix = std::string(folder) + (folder.back() == '/' ? "" : "/");
        for (const auto& [path, text] : *context.played_saves) {
            if (path.compare(0, prefix.size(), prefix) != 0) continue;
            const std::string name =
                path.substr(prefix.size(), path.find('/', prefix.size()) - prefix.size());
            if (names.empty() || names.back() != name) names.push_back(name);
        }
    } else {
        names = value_or_raise(L, context.services.files.list(folder));
    }
    lua_createtable(L, static_cast<int>(names.size()), 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
        lua_pushlstring(L, names[i].data(), names[i].size());
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    return {1};
}

Pushed read_data(lua_State* L, std::string_view path) {
    const std::string text = value_or_raise(L, read(L, path));
    push_value(L, value_or_raise(L, parse_table_text(text, path)));
    return {1};
}

engine::Result<void> write_data(lua_State* L, std::string_view path, TableArgument table) {
    const Value value = value_or_raise(L, to_value(L, table.index));
    return write(L, path, to_table_file(value));
}

constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kFunctions[] = {
    function<&read>("read", "path", "text", "The contents of a file."),
    function<&write>("write", "path, text", "",
                     "Replaces a file below `save/` in one stroke; folders are made as needed."),
    function<&exists>("exists", "path", "exists", ""),
    function_pushing<&list>("list", "folder", "names", kReturnsTable,
                            "Sorted names of what a folder holds; \"\" is the game."),
    function_pushing<&read_data>("read_data", "path", "data", kReturnsTable,
                                 "Reads Lua table text, `return { ... }`, as data: it is never run."),
    function<&write_data>(
        "write_data", "path, data", "",
        "Writes a table of numbers, strings, booleans and such tables so that read_data reads it back."),
};

}  // namespace

const Module kFilesModule = {"cairn.files",
                             "Files of the game, of the shared assets and, below `save/`, of the player. "
                             "Paths have forward slashes and never lead "
                             "out of these. Only `save/` can be written. Headless runs and replays play the "
                             "save folder in memory: they neither see "
                             "nor change what a player saved.",
                             kFunctions};

}  // namespace cairn::scripting
