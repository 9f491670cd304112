#include "bind/level_parts.h"

#include "bind/data_values.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "bind/physics_objects.h"
#include "level/check.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

/// What a protected call needs; its stack holds this, the world, and the list of what was made.
struct Making {
    const Level& level;
    std::size_t part;
    /// Of references that lead nowhere; the call fails without a message of its own then.
    std::vector<std::string> faults;
};

/// Pushes what the reference names, or nil after adding its fault.
void push_made(lua_State* L, Making& making, int objects, const PartReference& reference) {
    const PartName name = split_part_name(reference.name);
    const auto part = making.level.find(name.name);
    if (part) {
        lua_rawgeti(L, objects, static_cast<lua_Integer>(*part + 1));
    } else {
        lua_pushnil(L);
    }
    if (lua_isnil(L, -1)) {
        making.faults.push_back(reference.place + '"' + name.name + "\" was not made");
        return;
    }
    if (name.index == 0) return;
    push_function(L, kPrefabMethods, "bodies");
    lua_insert(L, -2);
    lua_call(L, 1, 1);
    const auto count = static_cast<int>(lua_rawlen(L, -1));
    if (lua_rawgeti(L, -1, name.index) == LUA_TNIL) {
        making.faults.push_back(reference.place + "there is no such body; \"" + name.name + "\" has " +
                                std::to_string(count) + (count == 1 ? " body" : " bodies"));
    }
    lua_remove(L, -2);
}

/// Pushes the table that the part's function takes.
void push_fields(lua_State* L, Making& making, int world, int objects) {
    const LevelPart& part = making.level.parts[making.part];
    push_value(L, part.fields);
    for (const PartReference& reference : part.references) {
        push_made(L, making, objects, reference);
        lua_setfield(L, -2, reference.field.c_str());
    }
    if (!making.faults.empty()) {
        lua_pushnil(L);
        lua_error(L);
    }
    if (part.kind == PartKind::Trigger) {
        lua_pushliteral(L, "static");
        lua_setfield(L, -2, "type");
        lua_pushboolean(L, 1);
        lua_setfield(L, -2, "sensor");
    }
    if (part.kind == PartKind::Joint && lua_getfield(L, -1, "body_b") != LUA_TNIL &&
        lua_getfield(L, -2, "body_a") == LUA_TNIL) {
        lua_pop(L, 2);
        push_function(L, kWorldMethods, "ground");
        lua_pushvalue(L, world);
        lua_call(L, 1, 1);
        lua_setfield(L, -2, "body_a");
    }
}

/// (making, world, objects) -> Body, Joint or Prefab.
int run_make(lua_State* L) {
    Making& making = *static_cast<Making*>(lua_touserdata(L, 1));
    const LevelPart& part = making.level.parts[making.part];
    constexpr int kWorld = 2;
    constexpr int kObjects = 3;
    if (part.kind == PartKind::Prefab) {
        push_function(L, kPrefabModule, part.variant);
    } else {
        const std::string suffix = part.kind == PartKind::Joint ? "_joint" : "";
        push_function(L, kWorldMethods, part.variant.empty() ? "new_body" : "add_" + part.variant + suffix);
    }
    lua_pushvalue(L, kWorld);
    push_fields(L, making, kWorld, kObjects);
    lua_settop(L, 6);  // the function, the world and the fields stand at 4, 5 and 6
    lua_call(L, 2, 1);
    return 1;
}

/// (shape, body)
int run_make_shape(lua_State* L) {
    const ShapePart& shape = *static_cast<const ShapePart*>(lua_touserdata(L, 1));
    push_function(L, kBodyMethods, "add_" + shape.variant);
    lua_insert(L, 2);
    push_value(L, shape.fields);
    lua_call(L, 2, 0);
    return 0;
}

/// Without the name of the function, which the author of a level did not call.
std::string without_function_name(std::string message) {
    // "World:add_box: ..." or "cairn.prefab.rope: ...".
    const std::size_t end = message.find(": ");
    const bool names_function = end != std::string::npos && message.find_first_of(" \"") == end + 1;
    return names_function ? message.substr(end + 2) : message;
}

/// Pops the error of a call for a part, or for a shape: a fault for each rule that is broken.
void take_faults(lua_State* L, const std::string& place, std::vector<std::string>& faults) {
    const char* text = lua_tostring(L, -1);
    std::string message = text == nullptr ? "cannot be made" : without_function_name(text);
    lua_pop(L, 1);
    for (std::size_t end = 0; end != std::string::npos;) {
        end = message.find(physics::kAndAlso);
        faults.push_back(place + ": " + message.substr(0, end));
        if (end != std::string::npos) message.erase(0, end + physics::kAndAlso.size());
    }
}

/// "PLACE: FIELD = ...", of a field of the part's own, with the place of that field.
std::string placed_at_field(const Level& level, const LevelPart& part, std::string fault) {
    if (part.kind != PartKind::Prefab && part.kind != PartKind::Joint) return fault;
    const std::size_t start = part.place.size() + 2;
    const std::size_t end = fault.find_first_of(" [", start);
    if (end == std::string::npos || (fault[end] == ' ' && !fault.substr(end).starts_with(" = ")))
        return fault;
    const std::string field = fault.substr(start, end - start);
    const Value* value = part.fields.find(field);
    if (value == nullptr) return fault;
    return place_of({&part.fields, part.path, level.path}, *value, field) + fault.substr(end);
}

const Module& methods_of(PartKind kind) {
    switch (kind) {
        case PartKind::Body:
        case PartKind::Trigger:
            return kBodyMethods;
        case PartKind::Prefab:
            return kPrefabMethods;
        case PartKind::Joint:
            break;
    }
    return kJointMethods;
}

// What lives of it.
void unmake_part(lua_State* L, const Level& level, std::size_t part, int objects) {
    objects = lua_absindex(L, objects);
    if (lua_rawgeti(L, objects, static_cast<lua_Integer>(part + 1)) != LUA_TNIL) {
        const PartKind kind = level.parts[part].kind;
        bool is_alive = true;
        if (kind != PartKind::Prefab) {
            push_function(L, methods_of(kind), "is_valid");
            lua_pushvalue(L, -2);
            lua_call(L, 1, 1);
            is_alive = lua_toboolean(L, -1) != 0;
            lua_pop(L, 1);
        }
        if (is_alive) {
            push_function(L, methods_of(kind), "destroy");
            lua_pushvalue(L, -2);
            lua_call(L, 1, 0);
        }
        lua_pushnil(L);
        lua_rawseti(L, objects, static_cast<lua_Integer>(part + 1));
    }
    lua_pop(L, 1);
}

}  // namespace

std::vector<std::string> make_part(lua_State* L, const Level& level, std::size_t number, int world,
                                   int objects) {
    const LevelPart& part = level.parts[number];
    Making making{level, number, {}};
    luaL_checkstack(L, LUA_MINSTACK, "parts of a level");
    lua_pushcfunction(L, run_make);
    lua_pushlightuserdata(L, &making);
    lua_pushvalue(L, world);
    lua_pushvalue(L, objects);
    std::vector<std::string> faults;
    if (lua_pcall(L, 3, 1, 0) != LUA_OK) {
        if (!making.faults.empty()) {
            lua_pop(L, 1);
            return making.faults;
        }
        take_faults(L, part.place, faults);
        for (std::string& fault : faults) fault = placed_at_field(level, part, std::move(fault));
        return faults;
    }
    for (const ShapePart& shape : part.shapes) {
        lua_pushcfunction(L, run_make_shape);
        lua_pushlightuserdata(L, const_cast<ShapePart*>(&shape));  // Lua keeps no const; nothing writes to it
        lua_pushvalue(L, -3);
        if (lua_pcall(L, 2, 0, 0) != LUA_OK) take_faults(L, shape.place, faults);
    }
    lua_rawseti(L, objects, static_cast<lua_Integer>(number + 1));
    return faults;
}

// Joints first: what they hold would wake and move meanwhile, were this done between steps.
void unmake_parts(lua_State* L, const Level& level, int objects) {
    for (std::size_t part = level.parts.size(); part-- > 0;) unmake_part(L, level, part, objects);
}

}  // namespace cairn::scripting
