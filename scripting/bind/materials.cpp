// Materials as Lua says them. How a shape comes by one stands in physics_fields.cpp.
#include "bind/materials.h"

#include "bind/context.h"
#include "bind/physics_fields.h"
#include "lua/state.h"

namespace cairn::scripting {

void define_material(lua_State* L, std::string_view name, TableArgument fields) {
    if (name.empty()) argument_error(L, 1, "a name, not empty");
    const Matter matter = read_matter(FieldReader(L, fields.index, kMatterFields));
    context_of(L).materials.insert_or_assign(std::string(name), matter);
}

Pushed materials(lua_State* L) {
    lua_newtable(L);
    for (const auto& [name, matter] : context_of(L).materials) {
        push_material(L, matter.material);
        lua_pushnumber(L, static_cast<double>(matter.density_kg_m2));
        lua_setfield(L, -2, "density");
        lua_setfield(L, -2, name.c_str());
    }
    return {1};
}

}  // namespace cairn::scripting
