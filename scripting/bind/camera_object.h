// Camera as a Lua value.
#pragma once

#include <cairn/engine/camera_rig.h>

#include "bind/function.h"
#include "bind/object.h"

namespace cairn::scripting {

/// Between these the picture's scale can be told in floats.
inline constexpr double kLeastViewHeight_m = 1e-6;
inline constexpr double kMostViewHeight_m = 1e9;

struct CameraObject : ObjectHeader {
    static constexpr ObjectTag kTag = ObjectTag::Camera;
    engine::CameraRig rig;
    engine::Vec2 offset_px;  ///< how far the picture is moved, pixels, y down
};

struct CameraRef {
    CameraObject& object;
    engine::CameraRig& rig;
};
template <>
struct Argument<CameraRef> {
    static constexpr std::string_view kType = "Camera";
    static CameraRef get(lua_State* L, int index);
};

}  // namespace cairn::scripting
