// Turns shapes into triangles with smooth edges, in output pixels.
// Invariant: the sum over the triangles of (area * mean coverage) is the shape's area, so a shape looks
// neither fatter nor thinner than it is. An edge is a rim one pixel wide, centred on the true edge, opaque
// inside and transparent outside: the coverage of a pixel by a straight edge, seen through a box filter.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/backend.h"

namespace cairn::engine {

/// Triangles; three indices each.
struct TriangleList {
    std::vector<RenderVertex> vertices;
    std::vector<int> indices;

    void clear() {
        vertices.clear();
        indices.clear();
    }
    int add(const RenderVertex& vertex) {
        vertices.push_back(vertex);
        return static_cast<int>(vertices.size()) - 1;
    }
    void add_triangle(int a, int b, int c) { indices.insert(indices.end(), {a, b, c}); }
    void add_quad(int a, int b, int c, int d) { indices.insert(indices.end(), {a, b, c, a, c, d}); }
};

/// What a shape is filled with: a color, or an image times a color.
class Brush {
  public:
    /// What coverage does to the color.
    enum class Edge {
        Fading,    ///< its alpha fades
        Covering,  ///< it takes the place of what lies under it by that share, its own transparency too
        Hard,      ///< nothing: shapes have no rim
    };

    explicit Brush(Color color) : color_(color) {}
    /// uv_bounds keeps the rim, which lies a little outside of the shape, from showing a neighbour in the
    /// image.
    Brush(Color tint, const Affine2& uv_from_output, const Rect& uv_bounds)
        : color_(tint), uv_from_output_(uv_from_output), uv_bounds_(uv_bounds) {}

    Brush with_edge(Edge edge) const;
    /// The same brush with its coverage multiplied.
    Brush faded(float factor) const;
    RenderVertex vertex(Vec2 position, float coverage) const;

    bool is_opaque() const { return color_.a >= 1; }
    /// How far the rim reaches to either side of the true edge, in pixels.
    float half_rim() const { return edge_ == Edge::Hard ? 0.0f : 0.5f; }

  private:
    Color color_;
    float coverage_ = 1;
    Edge edge_ = Edge::Fading;
    Affine2 uv_from_output_ = {0, 0, 0, 0, 0, 0};
    Rect uv_bounds_;
};

/// A convex polygon of either winding. One without area adds nothing.
void fill_convex(std::span<const Vec2> points, const Brush& brush, TriangleList& out);

/// A polygon that need not be convex, but whose every point can be seen from its first one.
void fill_star(std::span<const Vec2> points, const Brush& brush, TriangleList& out);

/// Whether the points go round a convex polygon once, either way. One without area counts as such.
bool is_convex(std::span<const Vec2> points);

/// Two sides that meet though they are no neighbours, by the places of their first corners.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(std::span<const Vec2> points);

/// The triangles, by the places of their corners, of a polygon with positive area whose sides do not meet.
std::vector<std::array<int, 3>> cut_into_triangles(std::span<const Vec2> corners);

/// A polygon that may have dents, and whose sides do not meet.
void fill_simple(std::span<const Vec2> points, const Brush& brush, TriangleList& out);

/// A line of the given width along the points; `closed` joins the last one to the first. Lines thinner than a
/// pixel are drawn one pixel wide and fainter instead.
void stroke(std::span<const Vec2> points, bool closed, float width, LineCap cap, const Brush& brush,
            TriangleList& out);

/// How many chords a full circle needs to lie within a tenth of a pixel of the true one; a multiple of 4.
int circle_segments(float radius_pixels);

/// Points of a circle after `output_from_local`. Their polygon has the area of the true circle.
std::vector<Vec2> circle_points(Vec2 center, float radius, const Affine2& output_from_local);
/// Points along an arc from one angle to another, both ends included.
std::vector<Vec2> arc_points(Vec2 center, float radius, float from_rad, float to_rad,
                             const Affine2& output_from_local);
/// Points of a capsule: two half circles around a and b.
std::vector<Vec2> capsule_points(Vec2 a, Vec2 b, float radius, const Affine2& output_from_local);

}  // namespace cairn::engine
