// Cairn's own objects in Lua: full userdata that begin with a tag. Invariant: every userdata of a state was
// made by new_object, because the safe libraries make none, so the first bytes of any userdata are an
// ObjectHeader. Comparing one number there is the whole type check of a method call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <new>
#include <utility>

namespace cairn::scripting {

/// One per type; also the index of its metatable in the registry.
enum class ObjectTag : std::uint32_t {
    World,
    Body,
    Shape,
    Joint,
    EventCursor,
    Camera,
    Image,
    Font,
    Random,
    Timer,
    Prefab,
    Canvas,
    Quad,
    Atlas,
    Batch,
    Tween,
    Particles,
    TileMap,
    Ui,
    Text,
    Chain,
    Mover,
    Level,
    Transforms,
    Recording
};
inline constexpr int kObjectTagCount = static_cast<int>(ObjectTag::Recording) + 1;

struct ObjectHeader {
    ObjectTag tag;
};

/// "World", "Body", ...: as scripts see the types.
constexpr const char* object_type_name(ObjectTag tag) {
    switch (tag) {
        case ObjectTag::World:
            return "World";
        case ObjectTag::Body:
            return "Body";
        case ObjectTag::Shape:
            return "Shape";
        case ObjectTag::Joint:
            return "Joint";
        case ObjectTag::EventCursor:
            return "EventCursor";
        case ObjectTag::Camera:
            return "Camera";
        case ObjectTag::Image:
            return "Image";
        case ObjectTag::Font:
            return "Font";
        case ObjectTag::Random:
            return "Random";
        case ObjectTag::Timer:
            return "Timer";
        case ObjectTag::Prefab:
            return "Prefab";
        case ObjectTag::Canvas:
            return "Canvas";
        case ObjectTag::Quad:
            return "Quad";
        case ObjectTag::Atlas:
            return "Atlas";
        case ObjectTag::Batch:
            return "Batch";
        case ObjectTag::Tween:
            return "Tween";
        case ObjectTag::Particles:
            return "Particles";
        case ObjectTag::TileMap:
            return "TileMap";
        case ObjectTag::Ui:
            return "Ui";
        case ObjectTag::Text:
            return "Text";
        case ObjectTag::Chain:
            return "Chain";
        case ObjectTag::Mover:
            return "Mover";
        case ObjectTag::Level:
            return "Level";
        case ObjectTag::Transforms:
            return "Transforms";
        case ObjectTag::Recording:
            return "Recording";
    }
    return "userdata";
}
/// Of a value that is a userdata.
const char* object_type_name(lua_State* L, int index);

/// Pushes the metatable of a type, as kept in the registry.
void push_metatable(lua_State* L, ObjectTag tag);
/// Pops a table and makes it the metatable of a type.
void set_metatable(lua_State* L, ObjectTag tag);

/// Makes and pushes an object. T begins with an ObjectHeader and says its tag in T::kTag.
template <class T, class... Arguments>
T& new_object(lua_State* L, int user_values, Arguments&&... arguments) {
    void* block = lua_newuserdatauv(L, sizeof(T), user_values);
    T* object = new (block) T{{T::kTag}, std::forward<Arguments>(arguments)...};
    push_metatable(L, T::kTag);
    lua_setmetatable(L, -2);
    return *object;
}

/// Tells the garbage collector of memory that an object holds outside of Lua, as it is allocated: it would
/// take a canvas of a megabyte for the few bytes of its userdata, and let thousands of dropped ones pile up.
/// May collect what nothing refers to, so the object itself has to be on the stack. Less than a kilobyte is
/// let pass.
void charge_native_memory(lua_State* L, std::size_t bytes);

/// The same for a list that has grown to other memory.
template <class List>
void charge_growth(lua_State* L, const List& list, std::size_t capacity_before) {
    if (list.capacity() > capacity_before)
        charge_native_memory(L, (list.capacity() - capacity_before) * sizeof(typename List::value_type));
}

/// Whether the value at an index is an object of that type. Null for what is no userdata; light ones, which
/// it would take for objects, never come into the hands of a script.
inline bool is_object(lua_State* L, int index, ObjectTag tag) {
    const auto* header = static_cast<ObjectHeader*>(lua_touserdata(L, index));
    return header != nullptr && header->tag == tag;
}

/// The object at an index, or null when something else stands there.
template <class T>
T* object_at(lua_State* L, int index) {
    auto* header = static_cast<ObjectHeader*>(lua_touserdata(L, index));
    const bool is_it = header != nullptr && header->tag == T::kTag;
    return is_it ? static_cast<T*>(static_cast<void*>(header)) : nullptr;
}

}  // namespace cairn::scripting
