// The map between world metres and logical pixels. Invariant: view height and screen size are positive.
#include <cassert>

#include <cairn/engine/camera.h>

namespace cairn::engine {

Camera2D::Camera2D(float view_height_m, Size screen) : view_height_m_(view_height_m), screen_(screen) {
    assert(view_height_m > 0 && screen.width > 0 && screen.height > 0);
}

void Camera2D::set_view_height_m(float height_m) {
    assert(height_m > 0);
    view_height_m_ = height_m;
}

float Camera2D::view_width_m() const {
    return static_cast<float>(screen_.width) / pixels_per_metre();
}

void Camera2D::set_screen_size(Size screen) {
    if (screen.width > 0 && screen.height > 0) screen_ = screen;
}

float Camera2D::pixels_per_metre() const {
    return static_cast<float>(screen_.height) / view_height_m_;
}

Vec2 Camera2D::to_screen(Vec2 world_m) const {
    return world_to_screen().apply(world_m);
}

Vec2 Camera2D::to_world(Vec2 screen) const {
    const float scale = pixels_per_metre();
    const Vec2 center = position_m + shake_m;
    return {center.x + (screen.x - 0.5f * static_cast<float>(screen_.width)) / scale,
            center.y - (screen.y - 0.5f * static_cast<float>(screen_.height)) / scale};
}

Affine2 Camera2D::world_to_screen() const {
    const float scale = pixels_per_metre();
    const Vec2 center = position_m + shake_m;
    return {scale,
            0,
            0,
            -scale,
            0.5f * static_cast<float>(screen_.width) - scale * center.x,
            0.5f * static_cast<float>(screen_.height) + scale * center.y};
}

}  // namespace cairn::engine
