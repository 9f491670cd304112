// cairn.camera and the methods of Camera.
#include <cairn/engine/camera.h>

#include "bind/camera_object.h"
#include "bind/context.h"
#include "bind/fields.h"
#include "bind/modules.h"
#include "lua/state.h"

namespace cairn::scripting {

CameraRef Argument<CameraRef>::get(lua_State* L, int index) {
    auto* object = object_at<CameraObject>(L, index);
    if (object == nullptr) argument_error(L, index, "a Camera");
    // Asked each time: the platform decides what the logical size is.
    object->camera.set_screen_size(context_of(L).services.window.logical_size());
    const float pixels_per_metre = object->camera.pixels_per_metre();
    object->camera.shake_m = {-object->shake_px.x / pixels_per_metre, object->shake_px.y / pixels_per_metre};
    return {*object, object->camera};
}

namespace {

using Pair = std::tuple<float, float>;

constexpr Field kX = number_field("x", 0, "0", "m; what the middle of the picture shows");
constexpr Field kY = number_field("y", 0, "0", "m");
constexpr Field kHeight =
    number_field("height", 10, "10", "m from the bottom to the top of the picture; above 0");
constexpr const Field* kOwn[] = {&kX, &kY, &kHeight};
constexpr FieldSet kCameraFields{kOwn};

void check_height(lua_State* L, double height) {
    // Written so that NaN fails too.
    if (!(height > 0 && height <= 1e9)) {
        lua_pushnumber(L, height);
        call_error(L, "height is " + describe_value(L, -1) + "; it must be above 0 and at most 1e9");
    }
}

Pushed new_camera(lua_State* L, std::optional<TableArgument> description) {
    if (!description) lua_newtable(L);
    const FieldReader reader(L, description ? description->index : -1, kCameraFields);
    const double height = reader.number(kHeight);
    check_height(L, height);
    engine::Camera2D camera(static_cast<float>(height), context_of(L).services.window.logical_size());
    camera.position_m = {reader.real(kX), reader.real(kY)};
    new_object<CameraObject>(L, 0, camera, engine::Vec2{});
    return {1};
}

void attach(lua_State* L, CameraRef self) {
    Context& context = context_of(L);
    if (!context.is_drawing) call_error(L, "there is no picture to draw on; call it inside cairn.draw");
    check_or_raise(L, context.services.renderer.push_transform());
    context.services.renderer.apply_transform(self.camera.world_to_screen());
    ++context.draw.cameras;
}

void detach(lua_State* L, CameraRef) {
    Context& context = context_of(L);
    if (!context.is_drawing || context.draw.cameras == 0) call_error(L, "no camera is attached");
    check_or_raise(L, context.services.renderer.pop_transform());
    --context.draw.cameras;
}

Pair to_world(CameraRef self, float x, float y) {
    const engine::Vec2 p = self.camera.to_world({x, y});
    return {p.x, p.y};
}
Pair to_screen(CameraRef self, float x, float y) {
    const engine::Vec2 p = self.camera.to_screen({x, y});
    return {p.x, p.y};
}
Pair position(CameraRef self) {
    return {self.camera.position_m.x, self.camera.position_m.y};
}
void set_position(CameraRef self, float x, float y) {
    self.camera.position_m = {x, y};
}
float height(CameraRef self) {
    return self.camera.view_height_m();
}
void set_height(lua_State* L, CameraRef self, double height_m) {
    check_height(L, height_m);
    self.camera.set_view_height_m(static_cast<float>(height_m));
}
float width(CameraRef self) {
    return self.camera.view_width_m();
}
void set_shake(CameraRef self, float dx, float dy) {
    self.object.shake_px = {dx, dy};
}

constexpr std::array<std::string_view, 1> kReturnsCamera = {"Camera"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&new_camera>("new", "fields = {}", "camera", kReturnsCamera, "Makes a camera.",
                                  &kCameraFields),
};

constexpr Function kMethods[] = {
    function<&attach>("attach", "", "",
                      "From here on drawing is in the world's metres, y up; only in `cairn.draw`."),
    function<&detach>("detach", "", "", "Drawing is again as it was before `attach`."),
    function<&to_world>("to_world", "x [px], y [px]", "x [m], y [m]",
                        "Where in the world a point of the screen is."),
    function<&to_screen>("to_screen", "x [m], y [m]", "x [px], y [px]",
                         "Where on the screen a point of the world is."),
    function<&position>("position", "", "x [m], y [m]", "What the middle of the picture shows."),
    function<&set_position>("set_position", "x [m], y [m]", "", ""),
    function<&height>("height", "", "height [m]", "How much of the world fits from the bottom to the top."),
    function<&set_height>("set_height", "height [m]", "", ""),
    function<&width>("width", "", "width [m]", "How much of the world fits from left to right."),
    function<&set_shake>("set_shake", "dx [px], dy [px]", "", "Moves the picture, not the position."),
};

}  // namespace

const Module kCameraModule = {
    "cairn.camera",
    "Cameras convert between the world (metres, y up) and the screen (logical pixels, y down).",
    kModuleFunctions};
const Module kCameraMethods = {"Camera", "A view into the world.", kMethods, true};

}  // namespace cairn::scripting
