// Builds Lua tables and metatables from descriptions.
#include "bind/module.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "bind/fields.h"
#include "data/nearest.h"
#include "data/table_writer.h"

namespace cairn::scripting {
namespace {

/// __index of a module's table: reached only for names that are not there. Upvalue 1 is the module.
int report_unknown_name(lua_State* L) {
    const auto& module = *static_cast<const Module*>(lua_touserdata(L, lua_upvalueindex(1)));
    if (lua_type(L, 2) != LUA_TSTRING) return 0;
    const std::string name = lua_tostring(L, 2);
    std::vector<std::string> names;
    for (const Function& function : module.functions) {
        if (name == function.name)
            raise(L, std::string(module.name) + '.' + name + " is nil because the script has set it to nil");
        names.push_back(function.name);
    }
    const std::string_view best = nearest(name, names);
    raise(L, std::string(module.name) + " has no " + quote_text(name) +
                 (best.empty() ? std::string() : "; did you mean " + quote_text(best) + "?"));
}

/// __newindex of objects: a field that is set would be lost. Those with `data` have their own.
int refuse_field(lua_State* L) {
    const std::string type = object_type_name(L, 1);
    const bool begins_with_vowel = std::string_view("AEIO").find(type[0]) != std::string_view::npos;
    raise(L, (begins_with_vowel ? "an " : "a ") + type + " has no field " + describe_value(L, 2) +
                 " to set; keep values of your own in a table");
}

}  // namespace

void push_function(lua_State* L, const Module& module, const Function& function) {
    lua_pushlightuserdata(L, const_cast<Function*>(&function));
    lua_pushlightuserdata(L, const_cast<Module*>(&module));
    lua_pushcclosure(L, function.call, 2);
}

void push_function(lua_State* L, const Module& module, std::string_view name) {
    const auto found = std::find_if(module.functions.begin(), module.functions.end(),
                                    [&](const Function& function) { return name == function.name; });
    assert(found != module.functions.end());
    push_function(L, module, *found);
}

void add_functions(lua_State* L, const Module& module) {
    for (const Function& function : module.functions) {
        push_function(L, module, function);
        lua_setfield(L, -2, function.name);
    }
}

void fill_table(lua_State* L, const Module& module) {
    add_functions(L, module);
    lua_createtable(L, 0, 2);
    lua_pushlightuserdata(L, const_cast<Module*>(&module));
    lua_pushcclosure(L, report_unknown_name, 1);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

void register_type(lua_State* L, ObjectTag tag, const Module& methods, lua_CFunction finalize) {
    lua_createtable(L, 0, 3);
    lua_createtable(L, 0, static_cast<int>(methods.functions.size()));
    fill_table(L, methods);
    lua_setfield(L, -2, "__index");
    // A body has a metatable of its own, whose data has this one (physics_objects.cpp): fields of that are
    // set.
    if (tag != ObjectTag::Body) {
        lua_pushcfunction(L, refuse_field);
        lua_setfield(L, -2, "__newindex");
    }
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    if (finalize != nullptr) {
        lua_pushcfunction(L, finalize);
        lua_setfield(L, -2, "__gc");
    }
    set_metatable(L, tag);
}

}  // namespace cairn::scripting
