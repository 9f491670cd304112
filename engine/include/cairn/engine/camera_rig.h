// Moves a camera: follows a target smoothly, stays inside bounds, zooms and shakes.
// Invariant: what it does depends only on the calls and on the steps given to update(), so that a replay sees
// the same picture and a click lands on the same body. Nothing here is random.
#pragma once

#include <optional>

#include <cairn/engine/camera.h>

namespace cairn::engine {

struct CameraBounds {
    Vec2 low_m;
    Vec2 high_m;
};

struct CameraRigDef {
    float view_height_m = 10;  ///< at zoom 1; asserted to be above 0, as all of these
    float zoom = 1;
    /// How fast the distance to the target shrinks: the camera covers 63 % of it in 1 / rate seconds.
    float follow_rate_1_s = 6;
    /// While the target stays inside this area around the middle, the camera does not move.
    Vec2 dead_zone_m = {};
    /// How far a shake of strength 1 moves the picture, as a share of the view's height.
    float shake_share = 0.04f;
};

class CameraRig {
  public:
    explicit CameraRig(const CameraRigDef& def = {}, Size screen = {1280, 720});

    /// The camera of the last update, with its shake.
    const Camera2D& camera() const { return camera_; }
    /// The camera between the last two updates, for a picture between them.
    Camera2D camera_at(float alpha) const;

    /// Moves it at once; follow() then starts from there.
    void set_position_m(Vec2 position);
    void set_screen_size(Size screen);
    float view_height_m() const { return def_.view_height_m; }
    void set_view_height_m(float height_m);
    float zoom() const { return def_.zoom; }
    void set_zoom(float zoom);
    /// Changes the zoom and keeps the place of the world that lies under a point of the screen.
    void zoom_at(Vec2 screen, float factor);

    /// The picture shows nothing outside; where it is larger than the bounds, their middle is its middle.
    void set_bounds(const std::optional<CameraBounds>& bounds);

    /// What update() moves to; absent: it stays where it is.
    void follow(std::optional<Vec2> target_m) { target_m_ = target_m; }
    /// Adds to the strength of the shaking, which is 0 .. 1 and fades within a second or so.
    void shake(float strength);
    /// Moves the picture besides that, in metres.
    void set_offset_m(Vec2 offset);

    void update(float dt_s);

  private:
    Vec2 bounded(Vec2 position) const;
    Vec2 shake_offset_m() const;
    void apply();

    CameraRigDef def_;
    Camera2D camera_;
    Vec2 previous_position_m_;
    Vec2 previous_shake_m_;
    float previous_height_m_;
    std::optional<CameraBounds> bounds_;
    std::optional<Vec2> target_m_;
    Vec2 offset_m_;
    float strength_ = 0;
    float shake_time_ = 0;  ///< in periods of the noise
};

}  // namespace cairn::engine
