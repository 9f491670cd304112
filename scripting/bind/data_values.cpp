// Copying data in and out of Lua.
#include "bind/data_values.h"

#include <algorithm>
#include <optional>

#include "bind/fields.h"
#include "data/table_parser.h"

namespace cairn::scripting {
namespace {

/// Gives the error, if any.
std::optional<std::string> copy(lua_State* L, int index, const std::string& path, int depth, Value& out) {
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN:
            out.content = lua_toboolean(L, index) != 0;
            return std::nullopt;
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) {
                out.content = static_cast<std::int64_t>(lua_tointeger(L, index));
            } else {
                out.content = lua_tonumber(L, index);
            }
            return std::nullopt;
        case LUA_TSTRING: {
            std::size_t length = 0;
            const char* text = lua_tolstring(L, index, &length);
            out.content = std::string(text, length);
            return std::nullopt;
        }
        case LUA_TTABLE:
            break;
        default:
            return path + " is " + describe_value(L, index) +
                   "; data is numbers, strings, booleans and tables";
    }
    if (depth > kMaxTableDepth) return path + " is nested too deep; a table must not hold itself";
    luaL_checkstack(L, 4, "nested data");
    Entries entries;
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        Entry entry;
        std::string entry_path;
        if (lua_type(L, -2) == LUA_TSTRING) {
            std::size_t length = 0;
            const char* name = lua_tolstring(L, -2, &length);
            entry.key = std::string(name, length);
            entry_path = path + '.' + name;
        } else if (lua_isinteger(L, -2)) {
            entry.key = static_cast<std::int64_t>(lua_tointeger(L, -2));
            entry_path = path + '[' + std::to_string(lua_tointeger(L, -2)) + ']';
        } else {
            return path + " has the key " + describe_value(L, -2) + "; keys of data are strings and integers";
        }
        if (auto error = copy(L, lua_gettop(L), entry_path, depth + 1, entry.value)) return error;
        entries.push_back(std::move(entry));
        lua_pop(L, 1);
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
    out.content = std::move(entries);
    return std::nullopt;
}

}  // namespace

engine::Result<Value> to_value(lua_State* L, int index) {
    const int top = lua_gettop(L);
    Value value;
    auto error = copy(L, lua_absindex(L, index), "t", 1, value);
    lua_settop(L, top);
    if (error) return engine::Error{*error};
    return value;
}

void push_value(lua_State* L, const Value& value) {
    luaL_checkstack(L, 4, "nested data");
    switch (value.kind()) {
        case Value::Kind::Boolean:
            lua_pushboolean(L, std::get<bool>(value.content) ? 1 : 0);
            return;
        case Value::Kind::Integer:
            lua_pushinteger(L, std::get<std::int64_t>(value.content));
            return;
        case Value::Kind::Number:
            lua_pushnumber(L, std::get<double>(value.content));
            return;
        case Value::Kind::String:
            lua_pushlstring(L, value.text().data(), value.text().size());
            return;
        case Value::Kind::Table:
            break;
    }
    lua_newtable(L);
    for (const Entry& entry : value.entries()) {
        push_value(L, entry.value);
        if (const auto* name = std::get_if<std::string>(&entry.key)) {
            lua_pushlstring(L, name->data(), name->size());
            lua_insert(L, -2);
            lua_rawset(L, -3);
        } else {
            lua_rawseti(L, -2, std::get<std::int64_t>(entry.key));
        }
    }
}

}  // namespace cairn::scripting
