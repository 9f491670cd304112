// Maps the world (metres, y up) to the screen (logical pixels, y down): the only place where the two meet.
// Invariant: to_world(to_screen(p)) is p, up to rounding, because zoom is positive.
#pragma once

#include <cairn/engine/geometry.h>

namespace cairn::engine {

class Camera2D {
  public:
    /// Position of the middle of the screen, in metres.
    Vec2 position_m;
    /// Displacement by a shake, in metres, added to the position.
    Vec2 shake_m;

    /// Asserts view_height_m > 0.
    explicit Camera2D(float view_height_m = 10, Size screen = {1280, 720});

    /// How many metres fit from the top to the bottom of the screen.
    float view_height_m() const { return view_height_m_; }
    void set_view_height_m(float height_m);
    float view_width_m() const;

    Size screen_size() const { return screen_; }
    /// A size without area is ignored, as when a window is minimised.
    void set_screen_size(Size screen);

    float pixels_per_metre() const;
    Vec2 to_screen(Vec2 world_m) const;
    Vec2 to_world(Vec2 screen) const;

    /// The same map as to_screen, for Renderer::apply_transform.
    Affine2 world_to_screen() const;

  private:
    float view_height_m_;
    Size screen_;
};

}  // namespace cairn::engine
