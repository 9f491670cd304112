// cairn.camera and the methods of Camera.
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
    object->rig.set_screen_size(context_of(L).services.window.logical_size());
    const float pixels_per_metre = object->rig.camera().pixels_per_metre();
    object->rig.set_offset_m(
        {-object->offset_px.x / pixels_per_metre, object->offset_px.y / pixels_per_metre});
    return {*object, object->rig};
}

namespace {

using Pair = std::tuple<float, float>;

constexpr Field kX = number_field("x", 0, "0", "m; what the middle of the picture shows");
constexpr Field kY = number_field("y", 0, "0", "m");
constexpr Range kHeights{kLeastViewHeight_m, kMostViewHeight_m};
constexpr Range kZooms{0, 1e6, true};
constexpr Field kHeight = within(
    number_field("height", 10, "10", "m from the bottom to the top of the picture at zoom 1"), kHeights);
constexpr Field kZoom = within(number_field("zoom", 1, "1", "2 shows everything twice as large"), kZooms);
constexpr Field kFollowRate = above(
    number_field("follow_rate", 6, "6", "1/s; of the way to what it follows, 63 % is covered in 1 / rate"), 0,
    1e6);
constexpr Field kDeadZoneWidth =
    at_least(number_field("dead_zone_width", 0, "0", "m; inside this area around the middle"), 0);
constexpr Field kDeadZoneHeight =
    at_least(number_field("dead_zone_height", 0, "0", "m; what it follows does not move it"), 0);
constexpr Field kShakeShare =
    at_least(number_field("shake_share", 0.04, "0.04",
                          "how far a shake of 1 moves the picture, in heights of the view"),
             0);
constexpr const Field* kOwn[] = {
    &kX, &kY, &kHeight, &kZoom, &kFollowRate, &kDeadZoneWidth, &kDeadZoneHeight, &kShakeShare};
constexpr FieldSet kCameraFields{kOwn};

Pushed new_camera(lua_State* L, std::optional<TableArgument> description) {
    if (!description) lua_newtable(L);
    const FieldReader reader(L, description ? description->index : -1, kCameraFields);
    engine::CameraRig rig({.view_height_m = reader.real(kHeight),
                           .zoom = reader.real(kZoom),
                           .follow_rate_1_s = reader.real(kFollowRate),
                           .dead_zone_m = {reader.real(kDeadZoneWidth), reader.real(kDeadZoneHeight)},
                           .shake_share = reader.real(kShakeShare)},
                          context_of(L).services.window.logical_size());
    rig.set_position_m({reader.real(kX), reader.real(kY)});
    new_object<CameraObject>(L, 0, rig, engine::Vec2{});
    return {1};
}

void attach(lua_State* L, CameraRef self) {
    Context& context = context_of(L);
    if (!context.is_drawing) call_error(L, "there is no picture to draw on; call it inside cairn.draw");
    engine::Renderer& renderer = context.services.renderer;
    const AttachedCamera attached{&self.object, renderer.current_canvas(), renderer.transform_depth()};
    check_or_raise(L, renderer.push_transform());
    engine::Camera2D camera = self.rig.camera_at(static_cast<float>(context.alpha));
    if (!attached.canvas.is_null()) camera.set_screen_size(renderer.target_size());
    renderer.apply_camera(camera);
    context.draw.cameras.push_back(attached);
    if (attached.canvas.is_null()) context.world_view = renderer.transform();
}

void detach(lua_State* L, CameraRef self) {
    Context& context = context_of(L);
    if (!context.is_drawing || context.draw.cameras.empty()) call_error(L, "no camera is attached");
    const AttachedCamera last = context.draw.cameras.back();
    if (last.camera != &self.object) call_error(L, "it is not the camera that was attached last");
    engine::Renderer& renderer = context.services.renderer;
    if (renderer.current_canvas() != last.canvas)
        call_error(L, "a canvas was attached since; detach that first");
    while (renderer.transform_depth() > last.depth) check_or_raise(L, renderer.pop_transform());
    context.draw.cameras.pop_back();
}

Pair to_world(CameraRef self, float x, float y) {
    const engine::Vec2 p = self.rig.camera().to_world({x, y});
    return {p.x, p.y};
}
Pair to_screen(CameraRef self, float x, float y) {
    const engine::Vec2 p = self.rig.camera().to_screen({x, y});
    return {p.x, p.y};
}
Pair position(CameraRef self) {
    const engine::Vec2 p = self.rig.camera().position_m;
    return {p.x, p.y};
}
void set_position(CameraRef self, float x, float y) {
    self.rig.set_position_m({x, y});
}
float height(CameraRef self) {
    return self.rig.view_height_m();
}
void set_height(CameraRef self, Ranged<kHeights, float> height_m) {
    self.rig.set_view_height_m(height_m);
}
float width(CameraRef self) {
    return self.rig.camera().view_width_m() * self.rig.zoom();
}
void set_shake(CameraRef self, float dx, float dy) {
    self.object.offset_px = {dx, dy};
}

float zoom(CameraRef self) {
    return self.rig.zoom();
}
void set_zoom(CameraRef self, Ranged<kZooms, float> zoom) {
    self.rig.set_zoom(zoom);
}
void zoom_at(lua_State* L, CameraRef self, float x, float y, Ranged<kZooms, float> factor) {
    if (!kZooms.contains(static_cast<double>(factor * self.rig.zoom())))
        argument_error(L, 4, "a factor that leaves the zoom " + to_text(kZooms));
    self.rig.zoom_at({x, y}, factor);
}
void set_bounds(lua_State* L, CameraRef self, std::optional<float> left, std::optional<float> bottom,
                std::optional<float> right, std::optional<float> top) {
    if (!left && !bottom && !right && !top) return self.rig.set_bounds(std::nullopt);
    if (!left || !bottom || !right || !top)
        call_error(L, "left, bottom, right and top are expected, or no argument at all");
    if (!(*left <= *right))
        call_error(L, "left is " + describe_value(L, 2) + " and right is " + describe_value(L, 4) +
                          "; expected left <= right");
    if (!(*bottom <= *top))
        call_error(L, "bottom is " + describe_value(L, 3) + " and top is " + describe_value(L, 5) +
                          "; expected bottom <= top");
    self.rig.set_bounds(engine::CameraBounds{{*left, *bottom}, {*right, *top}});
}
void follow(lua_State* L, CameraRef self, std::optional<float> x, std::optional<float> y) {
    if (!x && !y) return self.rig.follow(std::nullopt);
    if (!x || !y) call_error(L, "x and y are expected, or no argument at all");
    self.rig.follow(engine::Vec2{*x, *y});
}
void shake(CameraRef self, NotNegative strength) {
    self.rig.shake(strength);
}
void update(CameraRef self, StepTime dt) {
    self.rig.update(dt);
}
std::tuple<float, float, float, float> visible_area(CameraRef self) {
    const engine::Camera2D& camera = self.rig.camera();
    const engine::Size screen = camera.screen_size();
    const engine::Vec2 low = camera.to_world({0, static_cast<float>(screen.height)});
    const engine::Vec2 high = camera.to_world({static_cast<float>(screen.width), 0});
    return {low.x, low.y, high.x, high.y};
}

constexpr std::array<std::string_view, 1> kReturnsCamera = {"Camera"};

constexpr Function kModuleFunctions[] = {
    function_pushing<&new_camera>("new", "fields = {}", "camera", kReturnsCamera, "Makes a camera.",
                                  &kCameraFields),
};

constexpr Function kMethods[] = {
    function<&attach>(
        "attach", "", "",
        "From here on drawing is in the world's metres, y up; only in `cairn.draw`. In a canvas the camera "
        "looks at "
        "the canvas: its position is in the middle of that, and its height from the bottom to the top."),
    function<&detach>("detach", "", "", "Drawing is again as it was before `attach`."),
    function<&to_world>("to_world", "x [px], y [px]", "x [m], y [m]",
                        "Where in the world a point of the screen is."),
    function<&to_screen>("to_screen", "x [m], y [m]", "x [px], y [px]",
                         "Where on the screen a point of the world is."),
    function<&follow>(
        "follow", "x [m] = nil, y [m] = nil", "",
        "What `update` moves to from now on; without arguments it stays where it is. Call it in every "
        "update with the place of what is followed."),
    function<&update>(
        "update", "dt [s]", "",
        "Moves the camera on its way, and lets shakes fade. Once per update; pictures in between show it "
        "in between."),
    function<&shake>("shake", "strength", "",
                     "Shakes the picture; strengths add up to 1 at most and fade within a second."),
    function<&set_bounds>(
        "set_bounds", "left [m] = nil, bottom [m] = nil, right [m] = nil, top [m] = nil", "",
        "Nothing outside is shown; where the view is larger, it shows the middle. Without arguments: "
        "no bounds."),
    function<&zoom>("zoom", "", "zoom", ""),
    function<&set_zoom>("set_zoom", "zoom", "", "2 shows everything twice as large as 1."),
    function<&zoom_at>(
        "zoom_at", "x [px], y [px], factor", "",
        "Multiplies the zoom; what lies at that point of the screen stays there, as under a mouse wheel."),
    function<&visible_area>("visible_area", "", "left [m], bottom [m], right [m], top [m]",
                            "What the picture shows."),
    function<&position>("position", "", "x [m], y [m]", "What the middle of the picture shows."),
    function<&set_position>("set_position", "x [m], y [m]", "",
                            "At once; what it follows it approaches from there."),
    function<&height>("height", "", "height [m]",
                      "How much of the world fits from the bottom to the top, at zoom 1."),
    function<&set_height>("set_height", "height [m]", "", ""),
    function<&width>("width", "", "width [m]", "How much of the world fits from left to right, at zoom 1."),
    function<&set_shake>("set_shake", "dx [px], dy [px]", "", "Moves the picture, not the position."),
};

}  // namespace

const Module kCameraModule = {
    "cairn.camera",
    "Cameras convert between the world (metres, y up) and the screen (logical pixels, y down).",
    kModuleFunctions};
const Module kCameraMethods = {"Camera", "A view into the world.", kMethods, true};

}  // namespace cairn::scripting
