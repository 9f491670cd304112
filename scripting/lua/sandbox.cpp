// Opens the safe parts of Lua's libraries and replaces the rest by versions that cannot harm.
#include "lua/sandbox.h"

#include <cstdio>
#include <cstring>
#include <string>

#include "bind/object.h"
#include "lua/deterministic_math.h"

namespace cairn::scripting {
namespace {

/// load(chunk [, name [, mode [, env]]]): text only. Bytecode is not verified by Lua and can break its
/// memory.
int safe_load(lua_State* L) {
    std::string text;
    if (lua_isfunction(L, 1)) {
        while (true) {
            lua_pushvalue(L, 1);
            lua_call(L, 0, 1);
            std::size_t length = 0;
            const char* piece = lua_type(L, -1) == LUA_TSTRING ? lua_tolstring(L, -1, &length) : nullptr;
            if (piece == nullptr && !lua_isnil(L, -1))
                return luaL_error(L, "load: the function must return strings");
            text.append(piece != nullptr ? piece : "", length);
            lua_pop(L, 1);
            if (length == 0) break;
        }
    } else {
        std::size_t length = 0;
        const char* chunk = luaL_checklstring(L, 1, &length);
        text.assign(chunk, length);
    }
    const char* name = luaL_optstring(L, 2, "=(load)");
    const char* mode = luaL_optstring(L, 3, "t");
    const bool has_environment = !lua_isnone(L, 4);
    if (std::strchr(mode, 't') == nullptr) {
        lua_pushnil(L);
        lua_pushfstring(L, "load: mode is \"%s\"; only text can be loaded (\"t\")", mode);
        return 2;
    }
    if (luaL_loadbufferx(L, text.data(), text.size(), name, "t") != LUA_OK) {
        lua_pushnil(L);
        lua_insert(L, -2);
        return 2;
    }
    if (has_environment) {
        lua_pushvalue(L, 4);
        lua_setupvalue(L, -2, 1);
    }
    return 1;
}

int count_garbage(lua_State* L) {
    const char* option = luaL_optstring(L, 1, "count");
    if (std::strcmp(option, "count") != 0) {
        return luaL_error(L, "collectgarbage: option is \"%s\"; only \"count\" is offered", option);
    }
    lua_pushnumber(L, lua_gc(L, LUA_GCCOUNT) + lua_gc(L, LUA_GCCOUNTB) / 1024.0);
    return 1;
}

/// setmetatable without finalizers: they run at moments that no replay can repeat, and outlive every guard.
int safe_setmetatable(lua_State* L) {
    if (lua_type(L, 2) == LUA_TTABLE) {
        lua_pushliteral(L, "__gc");
        lua_rawget(L, 2);
        if (!lua_isnil(L, -1)) return luaL_error(L, "setmetatable: __gc (a finalizer) is not offered");
        lua_pop(L, 1);
    }
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    return lua_gettop(L);
}

int safe_tostring(lua_State* L) {
    luaL_checkany(L, 1);
    push_text(L, 1);
    return 1;
}

int safe_print(lua_State* L) {
    const int count = lua_gettop(L);
    std::string line;
    for (int i = 1; i <= count; ++i) {
        push_text(L, i);
        std::size_t length = 0;
        const char* text = lua_tolstring(L, -1, &length);
        if (i > 1) line += '\t';
        line.append(text, length);
        lua_pop(L, 1);
    }
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), stdout);
    // So that lines stand before the error that follows them, and are not lost with a program that is ended.
    std::fflush(stdout);
    return 0;
}

/// string.format without %p, and with values as `tostring` shows them here.
int safe_format(lua_State* L) {
    const char* format = luaL_checkstring(L, 1);
    for (const char* c = format; *c != '\0'; ++c) {
        if (*c != '%') continue;
        ++c;
        if (*c == '%') continue;
        while (*c != '\0' && std::strchr("-+ #0123456789.", *c) != nullptr) ++c;
        if (*c == 'p') return luaL_error(L, "string.format: %%p (an address) is not offered");
        if (*c == '\0') break;
    }
    for (int i = 2; i <= lua_gettop(L); ++i) {
        const int type = lua_type(L, i);
        if (type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA || type == LUA_TTHREAD) {
            push_text(L, i);
            lua_replace(L, i);
        }
    }
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    return 1;
}

void remove_fields(lua_State* L, int table, std::initializer_list<const char*> names) {
    table = lua_absindex(L, table);
    for (const char* name : names) {
        lua_pushnil(L);
        lua_setfield(L, table, name);
    }
}

/// Replaces table[name] by a function that finds the original as its upvalue.
void wrap_field(lua_State* L, int table, const char* name, lua_CFunction function) {
    table = lua_absindex(L, table);
    lua_getfield(L, table, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, table, name);
}

}  // namespace

void push_text(lua_State* L, int index) {
    index = lua_absindex(L, index);
    switch (lua_type(L, index)) {
        case LUA_TTABLE:
        case LUA_TFUNCTION:
        case LUA_TTHREAD:
            if (luaL_getmetafield(L, index, "__tostring") != LUA_TNIL) {
                lua_pop(L, 1);
                luaL_tolstring(L, index, nullptr);
            } else {
                lua_pushstring(L, luaL_typename(L, index));
            }
            return;
        case LUA_TUSERDATA:
            lua_pushstring(L, object_type_name(L, index));
            return;
        default:
            luaL_tolstring(L, index, nullptr);
    }
}

void open_safe_libraries(lua_State* L) {
    static constexpr luaL_Reg kLibraries[] = {
        {LUA_GNAME, luaopen_base},       {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
        {LUA_MATHLIBNAME, luaopen_math}, {LUA_UTF8LIBNAME, luaopen_utf8}, {LUA_COLIBNAME, luaopen_coroutine},
    };
    for (const luaL_Reg& library : kLibraries) {
        luaL_requiref(L, library.name, library.func, 1);
        lua_pop(L, 1);
    }
    // luaL_requiref keeps a table of the loaded modules in the registry; scripts cannot reach it.
    lua_pushglobaltable(L);
    remove_fields(L, -1, {"dofile", "loadfile", "warn"});
    lua_pushcfunction(L, safe_load);
    lua_setfield(L, -2, "load");
    lua_pushcfunction(L, count_garbage);
    lua_setfield(L, -2, "collectgarbage");
    lua_pushcfunction(L, safe_tostring);
    lua_setfield(L, -2, "tostring");
    lua_pushcfunction(L, safe_print);
    lua_setfield(L, -2, "print");
    wrap_field(L, -1, "setmetatable", safe_setmetatable);

    lua_getfield(L, -1, LUA_STRLIBNAME);
    remove_fields(L, -1, {"dump"});
    wrap_field(L, -1, "format", safe_format);
    lua_pop(L, 1);

    // The metatable that all strings share must not be had by scripts: it would let one module change every
    // other.
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 2);

    lua_getfield(L, -1, LUA_MATHLIBNAME);
    install_deterministic_math(L);
    lua_pop(L, 2);
}

}  // namespace cairn::scripting
