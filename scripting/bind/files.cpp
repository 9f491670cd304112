// cairn.files.
#include <cmath>
#include <optional>

#include "bind/context.h"
#include "bind/data_values.h"
#include "bind/modules.h"
#include "data/table_parser.h"
#include "data/table_writer.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

engine::Files& files(lua_State* L) {
    return context_of(L).services.files;
}

engine::Result<std::string> read(lua_State* L, std::string_view path) {
    check_or_raise(L, engine::check_virtual_path(path));
    return files(L).read_text(path);
}

engine::Result<void> write(lua_State* L, std::string_view path, std::string_view text) {
    check_or_raise(L, engine::check_virtual_path(path));
    // Refuses what is not below save/.
    return files(L).write(path, text);
}

bool exists(lua_State* L, std::string_view path) {
    return files(L).exists(path);
}

engine::Result<void> remove(lua_State* L, std::string_view path) {
    check_or_raise(L, engine::check_virtual_path(path));
    // Refuses what is not below save/.
    return files(L).remove(path);
}

bool is_folder(lua_State* L, std::string_view path) {
    const auto kind = files(L).kind(path);
    return kind && *kind == engine::FileKind::Folder;
}

Pushed list(lua_State* L, std::string_view folder) {
    check_or_raise(L, engine::check_virtual_path(folder));
    const auto names = value_or_raise(L, files(L).list(folder));
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

// The first number that could be written but not read, such as t.best = 1/0; nothing when there is none.
std::optional<std::string> find_unreadable(const Value& value, const std::string& path) {
    if (value.kind() == Value::Kind::Number) {
        const double number = std::get<double>(value.content);
        if (std::isfinite(number)) return std::nullopt;
        return path + " is " +
               (std::isnan(number) ? "not a number"
                : number > 0       ? "infinite"
                                   : "-infinite") +
               "; numbers in a file must be finite";
    }
    if (value.kind() != Value::Kind::Table) return std::nullopt;
    for (const Entry& entry : value.entries()) {
        const auto* name = std::get_if<std::string>(&entry.key);
        const std::string key =
            name != nullptr ? '.' + *name : '[' + std::to_string(std::get<std::int64_t>(entry.key)) + ']';
        if (auto found = find_unreadable(entry.value, path + key)) return found;
    }
    return std::nullopt;
}

engine::Result<void> write_data(lua_State* L, std::string_view path, TableArgument table) {
    const Value value = value_or_raise(L, to_value(L, table.index));
    if (auto unreadable = find_unreadable(value, "t")) return engine::Error{*unreadable};
    return write(L, path, to_table_file(value));
}

constexpr std::array<std::string_view, 1> kReturnsTable = {"table"};

constexpr Function kFunctions[] = {
    function<&read>("read", "path", "text", "The contents of a file."),
    function<&write>("write", "path, text", "",
                     "Replaces a file below `save/` in one stroke; folders are made as needed."),
    function<&remove>("remove", "path", "", "Deletes a file below `save/`."),
    function<&exists>("exists", "path", "exists", ""),
    function<&is_folder>("is_folder", "path", "folder", ""),
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
                             "nor change what a player saved, and may keep 64 MiB.",
                             kFunctions};

}  // namespace cairn::scripting
