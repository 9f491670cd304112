// What the parts of the debug drawing share: sizes in pixels under any transform, and places between two
// steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <cairn/engine/renderer.h>
#include <cairn/physics/world.h>

namespace cairn::scripting {

/// Draws with lengths in pixels, at places in metres. Invariant: `pixel` is the length of a logical pixel in
/// the coordinates of the present transform.
class DebugPen {
  public:
    DebugPen(engine::Renderer& renderer, const physics::World& world, float alpha)
        : renderer_(renderer), world_(world), alpha_(alpha) {
        const float scale = renderer.transform().mean_scale();
        pixel_ = scale > 0 ? 1 / scale : 0;
    }

    [[nodiscard]] engine::Renderer& renderer() const { return renderer_; }
    [[nodiscard]] const physics::World& world() const { return world_; }
    [[nodiscard]] float pixels(float count) const { return count * pixel_; }

    /// Where the body is drawn.
    [[nodiscard]] physics::Transform place(const physics::Body& body) const {
        return body.interpolated_transform(alpha_);
    }
    /// Where a point that moves with the body is drawn, given where it is after the last step.
    [[nodiscard]] engine::Vec2 at(physics::BodyId id, physics::Position p) const {
        const auto body = world_.body(id);
        if (!body) return to_picture(p);
        const physics::Vec2 local = physics::inverse_transform_point(body->transform(), p);
        return to_picture(physics::transform_point(place(*body), local));
    }
    [[nodiscard]] static engine::Vec2 to_picture(physics::Position p) {
        return {static_cast<float>(p.x), static_cast<float>(p.y)};
    }

    void line(engine::Vec2 a, engine::Vec2 b, float width_px, engine::Color color) const {
        renderer_.draw_line(a, b, pixels(width_px), color, engine::LineCap::Butt);
    }
    void path(std::span<const engine::Vec2> points, float width_px, engine::Color color) const {
        renderer_.draw_polyline(points, pixels(width_px), color, engine::LineCap::Butt);
    }
    void dot(engine::Vec2 center, float radius_px, engine::Color color) const {
        renderer_.fill_circle(center, pixels(radius_px), color);
    }
    void ring(engine::Vec2 center, float radius_px, float width_px, engine::Color color) const {
        renderer_.outline_circle(center, pixels(radius_px), pixels(width_px), color);
    }
    void arc(engine::Vec2 center, float radius_px, float from_rad, float to_rad, float width_px,
             engine::Color color) const {
        renderer_.draw_arc(center, pixels(radius_px), from_rad, to_rad, pixels(width_px), color);
    }
    void dashes(engine::Vec2 a, engine::Vec2 b, float width_px, engine::Color color) const {
        constexpr float kDash_px = 6;
        constexpr float kMostDashes = 400;
        const float length = engine::length(b - a);
        const float count = std::min(std::floor(length / pixels(2 * kDash_px)) + 1, kMostDashes);
        for (float i = 0; i < count; ++i) {
            const float from = i / count;
            line(a + from * (b - a), a + (from + 0.5f / count) * (b - a), width_px, color);
        }
    }

  private:
    engine::Renderer& renderer_;
    const physics::World& world_;
    float alpha_;
    float pixel_ = 0;
};

/// Draws a joint by its kind: anchors, axes, limits, and what it holds or draws together.
void draw_joint_marks(const DebugPen& pen, const physics::Joint& joint);

}  // namespace cairn::scripting
