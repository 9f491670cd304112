// The places of all bodies of a world, as one Lua value that is filled again and again.
#pragma once

#include <lua.hpp>
#include <vector>

#include "bind/function.h"
#include "bind/physics_objects.h"

namespace cairn::scripting {

/// User value 1 is the world whose bodies these are.
struct TransformsObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Transforms;
    std::vector<physics::BodyTransform> places;
    std::vector<physics::Rotation> rotations{};  ///< of the places, and
    std::vector<float> angles_rad{};             ///< what they are, found when an angle is first asked for
};

template <>
struct Argument<TransformsObject*> {
    static constexpr std::string_view kType = "Transforms";
    static TransformsObject* get(lua_State* L, int index) {
        auto* transforms = object_at<TransformsObject>(L, index);
        if (transforms == nullptr) argument_error(L, index, "a Transforms");
        return transforms;
    }
};

/// `cairn.physics.new_transforms`.
Pushed new_transforms(lua_State* L);
/// `world:read_transforms`.
std::int64_t read_transforms(lua_State* L, WorldRef self, TransformsObject* transforms);

}  // namespace cairn::scripting
