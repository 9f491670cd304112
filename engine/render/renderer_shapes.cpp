// Shapes and meshes. Invariant: every shape becomes points in output pixels, passes State::prepare, and only
// then becomes triangles.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <cairn/engine/renderer.h>

#include "render/renderer_state.h"

namespace cairn::engine {
namespace {

/// A million pixels: far outside of any screen, and few enough for the rasterizer's 64-bit integers and for
/// the precision of floats to leave a sixteenth of a pixel.
constexpr float kMaxCoordinate = 1 << 20;

std::vector<Vec2> mapped(std::span<const Vec2> points, const Affine2& map) {
    std::vector<Vec2> result;
    result.reserve(points.size());
    for (const Vec2 p : points) result.push_back(map.apply(p));
    return result;
}

std::array<Vec2, 4> corners(const Rect& r) {
    return {Vec2{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}};
}

constexpr float kTurn = 6.28318531f;

/// What takes the unit circle to an ellipse in output pixels.
Affine2 unit_circle_to(Vec2 center, Vec2 radii, const Affine2& map) {
    return map * Affine2::translation(center) * Affine2::scaling(radii);
}

/// Radii and widths: NaN, infinity, zero and less draw nothing.
bool is_positive(float length) {
    return length > 0 && std::isfinite(length);
}

}  // namespace

bool Renderer::State::prepare(std::span<Vec2> points, float margin) const {
    if (points.empty()) return false;
    Vec2 low = points.front();
    Vec2 high = points.front();
    for (Vec2& p : points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
        p = {std::clamp(p.x, -kMaxCoordinate, kMaxCoordinate),
             std::clamp(p.y, -kMaxCoordinate, kMaxCoordinate)};
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return high.x > -margin && high.y > -margin &&
           low.x < static_cast<float>(viewport.output.width) + margin &&
           low.y < static_cast<float>(viewport.output.height) + margin;
}

Renderer::State::Paint Renderer::State::paint_for(const Brush& brush, BackendTexture texture) const {
    const BlendMode mode = batch.blend_mode();
    if (mode != BlendMode::Replace) return {brush, mode};
    // What replaces by a share leaves the rest of what was there, which is what Alpha does with the share as
    // alpha. The alpha that is left is then right where it is 1 before and after, or never seen: not for
    // translucent colors in canvases. No mode takes a share of alpha away, so those have hard edges; and so
    // do pictures, whose alpha is their own.
    const bool keeps_alpha = canvas.is_null() || brush.is_opaque();
    if (texture == 0 && keeps_alpha) return {brush.with_edge(Brush::Edge::Covering), BlendMode::Alpha};
    return {brush.with_edge(Brush::Edge::Hard), mode};
}

void Renderer::State::fill(std::vector<Vec2> points, const Brush& brush, BackendTexture texture) {
    constexpr float kRim = 1;
    if (!prepare(points, kRim)) return;
    const Paint paint = paint_for(brush, texture);
    fill_convex(points, paint.brush, batch.triangles(texture, paint.mode));
}

Result<void> Renderer::State::fill_dented(std::span<const Vec2> points, const Brush& brush,
                                          BackendTexture texture) {
    if (const auto crossing = find_crossing(points)) {
        const auto side = [&](std::size_t first) {
            return "from corner " + std::to_string(first + 1) + " to " +
                   std::to_string((first + 1) % points.size() + 1);
        };
        return Error{"the side " + side(crossing->first) + " crosses that " + side(crossing->second) +
                     "; the corners must stand in the order in which they go round the polygon"};
    }
    std::vector<Vec2> in_output = mapped(points, output_transform());
    if (!prepare(in_output, 1)) return {};
    const Paint paint = paint_for(brush, texture);
    fill_simple(in_output, paint.brush, batch.triangles(texture, paint.mode));
    return {};
}

void Renderer::State::outline(std::vector<Vec2> points, bool closed, float width, LineCap cap, Color color) {
    const float pixels = width * output_transform().mean_scale();
    if (!is_positive(pixels) || pixels > kMaxCoordinate) return;
    if (!prepare(points, pixels + 1)) return;
    const Paint paint = paint_for(Brush(color), 0);
    stroke(points, closed, pixels, cap, paint.brush, batch.triangles(0, paint.mode));
}

// ---- Filled

void Renderer::fill_rectangle(const Rect& rect, Color color) {
    fill_convex_polygon(corners(rect), color);
}

void Renderer::fill_circle(Vec2 center, float radius, Color color) {
    if (is_positive(radius))
        state_->fill(circle_points(center, radius, state_->output_transform()), Brush(color), 0);
}

void Renderer::fill_ellipse(Vec2 center, Vec2 radii, Color color) {
    if (!is_positive(radii.x) || !is_positive(radii.y)) return;
    state_->fill(circle_points({0, 0}, 1, unit_circle_to(center, radii, state_->output_transform())),
                 Brush(color), 0);
}

void Renderer::fill_sector(Vec2 center, float radius, float from_rad, float to_rad, Color color) {
    const float turn = to_rad - from_rad;
    if (!is_positive(radius) || !std::isfinite(turn) || turn == 0) return;
    if (std::fabs(turn) >= kTurn) return fill_circle(center, radius, color);
    const Affine2 map = state_->output_transform();
    // From the center all of it can be seen, however wide it is.
    std::vector<Vec2> points = {map.apply(center)};
    for (const Vec2 p : arc_points(center, radius, from_rad, to_rad, map)) points.push_back(p);
    if (!state_->prepare(points, 1)) return;
    const State::Paint paint = state_->paint_for(Brush(color), 0);
    fill_star(points, paint.brush, state_->batch.triangles(0, paint.mode));
}

void Renderer::fill_capsule(Vec2 a, Vec2 b, float radius, Color color) {
    if (is_positive(radius))
        state_->fill(capsule_points(a, b, radius, state_->output_transform()), Brush(color), 0);
}

void Renderer::fill_convex_polygon(std::span<const Vec2> points, Color color) {
    state_->fill(mapped(points, state_->output_transform()), Brush(color), 0);
}

void Renderer::fill_convex_polygon(std::span<const Vec2> points, TextureId texture,
                                   const Affine2& uv_from_local, Color tint) {
    const Texture* found = state_->find_texture(texture, "fill_convex_polygon");
    if (!found) return;
    const Affine2 map = state_->output_transform();
    const Brush brush(tint, uv_from_local * map.inverse(), {0, 0, 1, 1});
    state_->fill(mapped(points, map), brush, found->backend_texture);
}

Result<void> Renderer::fill_polygon(std::span<const Vec2> points, Color color) {
    if (!is_convex(points)) return state_->fill_dented(points, Brush(color), 0);
    fill_convex_polygon(points, color);
    return {};
}

Result<void> Renderer::fill_polygon(std::span<const Vec2> points, TextureId texture,
                                    const Affine2& uv_from_local, Color tint) {
    const Texture* found = state_->find_texture(texture, "fill_polygon");
    if (!found) return {};
    const Brush brush(tint, uv_from_local * state_->output_transform().inverse(), {0, 0, 1, 1});
    if (!is_convex(points)) return state_->fill_dented(points, brush, found->backend_texture);
    state_->fill(mapped(points, state_->output_transform()), brush, found->backend_texture);
    return {};
}

// ---- Outlines and lines

void Renderer::outline_rectangle(const Rect& rect, float width, Color color) {
    outline_polygon(corners(rect), width, color);
}

void Renderer::outline_circle(Vec2 center, float radius, float width, Color color) {
    if (!is_positive(radius)) return;
    state_->outline(circle_points(center, radius, state_->output_transform()), true, width, LineCap::Round,
                    color);
}

void Renderer::outline_ellipse(Vec2 center, Vec2 radii, float width, Color color) {
    if (!is_positive(radii.x) || !is_positive(radii.y)) return;
    state_->outline(circle_points({0, 0}, 1, unit_circle_to(center, radii, state_->output_transform())), true,
                    width, LineCap::Round, color);
}

void Renderer::draw_arc(Vec2 center, float radius, float from_rad, float to_rad, float width, Color color) {
    if (!is_positive(radius) || !std::isfinite(to_rad - from_rad)) return;
    if (std::fabs(to_rad - from_rad) >= kTurn) return outline_circle(center, radius, width, color);
    state_->outline(arc_points(center, radius, from_rad, to_rad, state_->output_transform()), false, width,
                    LineCap::Butt, color);
}

void Renderer::outline_capsule(Vec2 a, Vec2 b, float radius, float width, Color color) {
    if (!is_positive(radius)) return;
    state_->outline(capsule_points(a, b, radius, state_->output_transform()), true, width, LineCap::Round,
                    color);
}

void Renderer::outline_polygon(std::span<const Vec2> points, float width, Color color) {
    state_->outline(mapped(points, state_->output_transform()), true, width, LineCap::Round, color);
}

void Renderer::draw_polyline(std::span<const Vec2> points, float width, Color color, LineCap cap) {
    state_->outline(mapped(points, state_->output_transform()), false, width, cap, color);
}

void Renderer::draw_line(Vec2 a, Vec2 b, float width, Color color, LineCap cap) {
    draw_polyline(std::array{a, b}, width, color, cap);
}

// ---- Meshes

void Renderer::draw_mesh(std::span<const MeshVertex> vertices, std::span<const std::uint32_t> indices,
                         TextureId texture) {
    assert(indices.size() % 3 == 0);
    BackendTexture backend_texture = 0;
    if (!texture.is_null()) {
        const Texture* found = state_->find_texture(texture, "draw_mesh");
        if (!found) return;
        backend_texture = found->backend_texture;
    }
    const Affine2 map = state_->output_transform();
    std::vector<Vec2> points;
    points.reserve(vertices.size());
    for (const MeshVertex& v : vertices) points.push_back(map.apply(v.position));
    if (!state_->prepare(points, 0)) return;

    // NaN compares false with everything, so it becomes 0.
    const auto unit = [](float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; };
    TriangleList& out = state_->batch.triangles(backend_texture);
    const int first = static_cast<int>(out.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        out.add({points[i], to_rgba8(vertices[i].color), {unit(vertices[i].uv.x), unit(vertices[i].uv.y)}});
    for (const std::uint32_t index : indices) {
        assert(index < vertices.size());
        out.indices.push_back(first + static_cast<int>(index));
    }
}

}  // namespace cairn::engine
