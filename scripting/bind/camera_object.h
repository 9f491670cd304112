// Camera as a Lua value.
#pragma once

#include <cairn/engine/camera.h>

#include "bind/function.h"
#include "bind/object.h"

namespace cairn::scripting {

struct CameraObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Camera;
    engine::Camera2D camera;
    engine::Vec2 shake_px;  ///< how far the picture is moved, pixels, y down
};

struct CameraRef {
    CameraObject& object;
    engine::Camera2D& camera;
};
template <>
struct Argument<CameraRef> {
    static constexpr std::string_view kType = "Camera";
    static CameraRef get(lua_State* L, int index);
};

}  // namespace cairn::scripting
