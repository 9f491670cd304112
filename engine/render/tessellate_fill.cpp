// Brushes and filled convex polygons. Invariant: the inner and the outer contour have the same number of
// points, one pair per corner, half a pixel inside and half a pixel outside of the true corner's edges.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/tessellate.h"

namespace cairn::engine {
namespace {

/// Corners closer than this (in pixels) are one corner: the direction of a shorter edge is rounding noise.
constexpr float kMinEdge = 0.02f;

/// How far a sharp corner's outer point may go, in units of the offset. More would grow spikes; less would
/// blunt the right angles of boxes, which need 1.41.
constexpr float kMaxMiter = 2;

std::uint8_t to_byte(float component) {
    if (!(component > 0)) return 0;  // also NaN
    return static_cast<std::uint8_t>(std::min(component, 1.0f) * 255 + 0.5f);
}

/// The corners without repetitions, turned so that the area is positive; the first stays the first.
std::vector<Vec2> tidy_corners(std::span<const Vec2> points, float& area) {
    std::vector<Vec2> corners;
    corners.reserve(points.size());
    for (const Vec2 p : points)
        if (corners.empty() || length(p - corners.back()) > kMinEdge) corners.push_back(p);
    while (corners.size() > 1 && length(corners.front() - corners.back()) <= kMinEdge) corners.pop_back();

    float doubled = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // Relative to the first corner, to keep digits for polygons far from the origin.
        const Vec2 a = corners[i] - corners[0];
        const Vec2 b = corners[(i + 1) % corners.size()] - corners[0];
        doubled += cross(a, b);
    }
    if (doubled < 0) std::reverse(corners.begin() + 1, corners.end());
    area = 0.5f * std::fabs(doubled);
    return corners;
}

/// The outward normal of the edge that starts at each corner. With positive area, outward is to the right.
std::vector<Vec2> edge_normals(const std::vector<Vec2>& corners) {
    const std::size_t n = corners.size();
    std::vector<Vec2> normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 edge = corners[(i + 1) % n] - corners[i];
        normals[i] = Vec2{edge.y, -edge.x} * (1 / length(edge));
    }
    return normals;
}

/// The inner contour, and the rim around it.
void add_filled(const std::vector<Vec2>& corners, const std::vector<Vec2>& normals,
                std::span<const std::array<int, 3>> triangles, float inset, const Brush& paint,
                TriangleList& out) {
    inset = std::min(inset, paint.half_rim());
    const std::size_t n = corners.size();
    const int first = static_cast<int>(out.vertices.size());
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = normals[(i + n - 1) % n];
        const Vec2 after = normals[i];
        // Along this vector, a step of 1 moves the corner 1 away from both edges.
        Vec2 miter = (before + after) * (1 / std::max(1 + dot(before, after), 1e-3f));
        const float reach = length(miter);
        if (reach > kMaxMiter) miter = miter * (kMaxMiter / reach);
        out.add(paint.vertex(corners[i] - miter * inset, 1));
        out.add(paint.vertex(corners[i] + miter * paint.half_rim(), 0));
    }
    const int count = static_cast<int>(n);
    for (const auto& [a, b, c] : triangles) out.add_triangle(first + 2 * a, first + 2 * b, first + 2 * c);
    if (paint.half_rim() == 0) return;
    for (int i = 0; i < count; ++i) {
        const int here = first + 2 * i;
        const int next = first + 2 * ((i + 1) % count);
        out.add_quad(here, here + 1, next + 1, next);
    }
}

/// Around the first corner.
std::vector<std::array<int, 3>> fan(std::size_t corners) {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 1; i + 1 < static_cast<int>(corners); ++i) triangles.push_back({0, i, i + 1});
    return triangles;
}

float perimeter(const std::vector<Vec2>& corners) {
    float sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += length(corners[(i + 1) % corners.size()] - corners[i]);
    return sum;
}

}  // namespace

Rgba8 to_rgba8(Color color) {
    const auto unit = [](float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; };
    const float a = unit(color.a);
    return {to_byte(unit(color.r) * a), to_byte(unit(color.g) * a), to_byte(unit(color.b) * a), to_byte(a)};
}

Brush Brush::with_edge(Edge edge) const {
    Brush brush = *this;
    brush.edge_ = edge;
    return brush;
}

Brush Brush::faded(float factor) const {
    Brush brush = *this;
    brush.coverage_ *= factor;
    return brush;
}

RenderVertex Brush::vertex(Vec2 position, float coverage) const {
    Color color = color_;
    const float share = coverage * coverage_;
    if (edge_ == Edge::Fading) color.a *= share;
    if (edge_ == Edge::Covering) color = {color.r * color.a, color.g * color.a, color.b * color.a, share};
    const Vec2 uv = uv_from_output_.apply(position);
    return {position,
            to_rgba8(color),
            {std::clamp(uv.x, uv_bounds_.x, uv_bounds_.x + uv_bounds_.width),
             std::clamp(uv.y, uv_bounds_.y, uv_bounds_.y + uv_bounds_.height)}};
}

void fill_convex(std::span<const Vec2> points, const Brush& brush, TriangleList& out) {
    float area = 0;
    const std::vector<Vec2> corners = tidy_corners(points, area);
    const std::size_t n = corners.size();
    if (n < 3 || area <= 0) return;

    const std::vector<Vec2> normals = edge_normals(corners);
    Vec2 centroid;
    for (const Vec2 corner : corners) centroid = centroid + corner * (1 / static_cast<float>(n));
    float inradius = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < n; ++i) inradius = std::min(inradius, dot(normals[i], corners[i] - centroid));
    if (!(inradius > 0)) return;

    // A sliver has no room for half a pixel inside. It shrinks to its spine, and is faded so that its
    // coverage still sums to its area: a triangular profile of height h over a strip of width 2 r + 1 holds h
    // (r + 1/2), and should hold 2 r.
    const float inset = std::min(0.5f, inradius);
    const Brush paint = inset < 0.5f ? brush.faded(2 * inset / (inset + 0.5f)) : brush;

    add_filled(corners, normals, fan(n), inset, paint, out);
}

void fill_star(std::span<const Vec2> points, const Brush& brush, TriangleList& out) {
    float area = 0;
    const std::vector<Vec2> corners = tidy_corners(points, area);
    if (corners.size() < 3 || area <= 0) return;
    // Twice the area over the perimeter is the inradius of what has one.
    add_filled(corners, edge_normals(corners), fan(corners.size()),
               std::min(0.5f, 2 * area / perimeter(corners)), brush, out);
}

void fill_simple(std::span<const Vec2> points, const Brush& brush, TriangleList& out) {
    float area = 0;
    const std::vector<Vec2> corners = tidy_corners(points, area);
    if (corners.size() < 3 || area <= 0) return;
    add_filled(corners, edge_normals(corners), cut_into_triangles(corners),
               std::min(0.5f, 2 * area / perimeter(corners)), brush, out);
}

}  // namespace cairn::engine
