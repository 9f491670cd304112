// A group of bindings: a table such as cairn.graphics, or the methods of an object type.
#pragma once

#include <lua.hpp>
#include <span>
#include <string>
#include <string_view>

#include "bind/function.h"
#include "bind/object.h"

namespace cairn::scripting {

struct Module {
    /// "cairn.graphics", "cairn.physics", or the type's name, "Body".
    const char* name;
    /// One or more paragraphs for the reference.
    const char* doc;
    std::span<const Function> functions;
    bool is_type = false;

    /// "graphics" of "cairn.graphics"; of types and of `cairn` itself the whole name.
    [[nodiscard]] constexpr std::string_view short_name() const {
        const std::string_view whole = name;
        return whole.substr(whole.rfind('.') + 1);  // all of it without a dot
    }
};

/// Every module, in the order of the reference.
std::span<const Module* const> all_modules();

/// Pushes one function of a module, as scripts see it.
void push_function(lua_State* L, const Module& module, const Function& function);
/// The same by its name, which the module has.
void push_function(lua_State* L, const Module& module, std::string_view name);

/// Adds the functions of a module to the table on top of the stack.
void add_functions(lua_State* L, const Module& module);

/// The same, and from then on asking that table for something that it lacks raises an
/// error that names the nearest thing it has.
void fill_table(lua_State* L, const Module& module);

/// Makes the metatable of an object type from its methods. `finalize` destroys the C++ object, or is null.
void register_type(lua_State* L, ObjectTag tag, const Module& methods, lua_CFunction finalize = nullptr);

/// Builds the global table `cairn` and every type.
void register_all(lua_State* L);

}  // namespace cairn::scripting
