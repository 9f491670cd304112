// The moving of cameras. Invariant: the position lies inside the bounds after every call.
//
// Source of the shake: S. Eiserloh, "Math for Game Programmers: Juicing Your Cameras With Math", GDC 2016:
// the offset grows with the square of a strength that fades evenly, along a smooth noise.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <cairn/engine/camera_rig.h>

namespace cairn::engine {
namespace {

/// Strength lost per second: a full shake is over in 0.8 s. Less outlasts the blow that caused it.
constexpr float kFade_1_s = 1.25f;
/// How often per second the noise takes a new direction; slower swims, faster only blurs.
constexpr float kNoise_hz = 17;

/// A number in -1 .. 1 for each whole number. Source of the mixing: T. Wang's integer hash, 2007.
float noise_at(std::uint32_t n) {
    n = (n ^ 61u) ^ (n >> 16);
    n *= 9u;
    n ^= n >> 4;
    n *= 0x27d4eb2du;
    n ^= n >> 15;
    return static_cast<float>(n >> 8) * (2.0f / (1 << 24)) - 1;
}

/// Smooth between the whole numbers; `stream` makes independent ones.
float smooth_noise(float time, std::uint32_t stream) {
    const float whole = std::floor(time);
    const float share = time - whole;
    const auto n = static_cast<std::uint32_t>(whole) + stream * 0x10000u;
    const float weight = share * share * (3 - 2 * share);
    return noise_at(n) + (noise_at(n + 1) - noise_at(n)) * weight;
}

Vec2 mix(Vec2 a, Vec2 b, float share) {
    return a + (b - a) * share;
}

/// The part of a distance that lies outside of a dead zone around 0.
float beyond(float distance, float zone) {
    const float half = 0.5f * zone;
    return distance - std::clamp(distance, -half, half);
}

float bounded_between(float middle, float half_view, float low, float high) {
    if (high - low <= 2 * half_view) return 0.5f * (low + high);
    return std::clamp(middle, low + half_view, high - half_view);
}

}  // namespace

CameraRig::CameraRig(const CameraRigDef& def, Size screen)
    : def_(def), camera_(def.view_height_m / def.zoom, screen), previous_height_m_(camera_.view_height_m()) {
    assert(def.view_height_m > 0 && def.zoom > 0 && def.follow_rate_1_s > 0);
}

Vec2 CameraRig::bounded(Vec2 position) const {
    if (!bounds_) return position;
    return {bounded_between(position.x, 0.5f * camera_.view_width_m(), bounds_->low_m.x, bounds_->high_m.x),
            bounded_between(position.y, 0.5f * camera_.view_height_m(), bounds_->low_m.y, bounds_->high_m.y)};
}

void CameraRig::apply() {
    camera_.position_m = bounded(camera_.position_m);
    camera_.shake_m = shake_offset_m() + offset_m_;
}

Vec2 CameraRig::shake_offset_m() const {
    if (strength_ <= 0) return {};
    const float reach_m = strength_ * strength_ * def_.shake_share * camera_.view_height_m();
    return {reach_m * smooth_noise(shake_time_, 0), reach_m * smooth_noise(shake_time_, 1)};
}

Camera2D CameraRig::camera_at(float alpha) const {
    Camera2D between = camera_;
    between.set_view_height_m(previous_height_m_ + (camera_.view_height_m() - previous_height_m_) * alpha);
    between.position_m = mix(previous_position_m_, camera_.position_m, alpha);
    between.shake_m = mix(previous_shake_m_, shake_offset_m(), alpha) + offset_m_;
    return between;
}

void CameraRig::set_position_m(Vec2 position) {
    camera_.position_m = position;
    apply();
    previous_position_m_ = camera_.position_m;
}

void CameraRig::set_screen_size(Size screen) {
    camera_.set_screen_size(screen);
    apply();
}

void CameraRig::set_view_height_m(float height_m) {
    assert(height_m > 0);
    def_.view_height_m = height_m;
    camera_.set_view_height_m(def_.view_height_m / def_.zoom);
    previous_height_m_ = camera_.view_height_m();
    apply();
}

void CameraRig::set_zoom(float zoom) {
    assert(zoom > 0);
    def_.zoom = zoom;
    set_view_height_m(def_.view_height_m);
}

void CameraRig::zoom_at(Vec2 screen, float factor) {
    const Vec2 held = camera_.to_world(screen);
    set_zoom(def_.zoom * factor);
    set_position_m(camera_.position_m + held - camera_.to_world(screen));
}

void CameraRig::set_bounds(const std::optional<CameraBounds>& bounds) {
    bounds_ = bounds;
    apply();
    previous_position_m_ = bounded(previous_position_m_);
}

void CameraRig::set_offset_m(Vec2 offset) {
    offset_m_ = offset;
    apply();
}

void CameraRig::shake(float strength) {
    if (strength > 0) strength_ = std::min(1.0f, strength_ + strength);
}

void CameraRig::update(float dt_s) {
    previous_position_m_ = camera_.position_m;
    previous_shake_m_ = shake_offset_m();
    previous_height_m_ = camera_.view_height_m();
    if (target_m_) {
        const Vec2 way = *target_m_ - camera_.position_m;
        // The implicit step of v' = -rate v: never beyond the target, however long the step, and without
        // exp().
        const float share = def_.follow_rate_1_s * dt_s / (1 + def_.follow_rate_1_s * dt_s);
        camera_.position_m = camera_.position_m + share * Vec2{beyond(way.x, def_.dead_zone_m.x),
                                                               beyond(way.y, def_.dead_zone_m.y)};
    }
    strength_ = std::max(0.0f, strength_ - kFade_1_s * dt_s);
    // Wrapped where floats still have fine digits; the noise repeats after an hour of shaking.
    shake_time_ = strength_ > 0 ? std::fmod(shake_time_ + kNoise_hz * dt_s, 65536.0f) : 0;
    apply();
}

}  // namespace cairn::engine
