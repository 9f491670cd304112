// Distance of convex cores by GJK: a simplex of points of B - A closes in on the origin.
// Source: Gilbert, Johnson and Keerthi 1988; the sub-distance by signed areas as in van den Bergen,
// "Collision Detection in Interactive 3D Environments", 2003.
#include "collide/distance.h"

#include <algorithm>
#include <array>

namespace cairn::physics {
namespace {

struct Vertex {
    Vec2 w;  // point of B minus point of A
    int index_a = 0;
    int index_b = 0;
};

struct Simplex {
    std::array<Vertex, 3> vertices;
    int count = 0;

    [[nodiscard]] bool has(const Vertex& v) const {
        for (int i = 0; i < count; ++i) {
            if (vertices[i].index_a == v.index_a && vertices[i].index_b == v.index_b) return true;
        }
        return false;
    }
};

// The later of two corners only if it lies farther along, so that of those that lie as far the first is
// found.
struct Corner {
    int index;
    float along;

    [[nodiscard]] Corner or_later(const Corner& later) const { return later.along > along ? later : *this; }
};

int support(const Convex& shape, Vec2 direction) {
    const auto corner = [&](int i) { return Corner{i, dot(shape.point(i), direction)}; };
    // Most shapes have up to four corners, and what stands behind their last repeats the first ones: to take
    // the best of four without a branch is faster than to guess at which the loop ends.
    if (shape.count() <= 4 && !shape.is_chained())
        return corner(0).or_later(corner(1)).or_later(corner(2).or_later(corner(3))).index;
    Corner best = corner(0);
    for (int i = 1; i < shape.count(); ++i) best = best.or_later(corner(i));
    return best.index;
}

// Keeps the vertices that carry the point of the simplex nearest to the origin, and gives that point.
Vec2 reduce_segment(Simplex& s, int i, int j) {
    const Vertex a = s.vertices[i];
    const Vertex b = s.vertices[j];
    const Vec2 edge = b.w - a.w;
    const float from_a = -dot(a.w, edge);
    const float whole = length_squared(edge);
    if (from_a <= 0 || whole == 0) {
        s.vertices[0] = a;
        s.count = 1;
        return a.w;
    }
    if (from_a >= whole) {
        s.vertices[0] = b;
        s.count = 1;
        return b.w;
    }
    s.vertices[0] = a;
    s.vertices[1] = b;
    s.count = 2;
    // The foot of the perpendicular, from the line's own normal: nothing cancels when the edge is long.
    const Vec2 normal = right_perp(edge);
    return (dot(a.w, normal) / whole) * normal;
}

// Of a segment and a vertex that lies nearer to the origin along it; false when the origin lies in the
// triangle. The edges of the new vertex are all that can be nearest. The old one is not looked at again:
// where the two are all but one line, rounding would take it for as near, and the search would go on from it
// for ever.
bool reduce_triangle(Simplex& s, Vec2& nearest) {
    const std::array<Vertex, 3> v = s.vertices;
    const float area = cross(v[1].w - v[0].w, v[2].w - v[0].w);
    bool inside = area != 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (cross(v[j].w - v[i].w, -v[i].w) * area < 0) inside = false;
    }
    if (inside) return false;
    Simplex other = s;
    nearest = reduce_segment(s, 1, 2);
    const Vec2 point = reduce_segment(other, 2, 0);
    if (length_squared(point) < length_squared(nearest)) {
        nearest = point;
        s = other;
    }
    return true;
}

}  // namespace

Distance distance_between(const Convex& a, const Convex& b, const RelativePose& b_in_a, Vec2 guess) {
    const auto vertex = [&](Vec2 direction) {  // of B - A, farthest along the direction
        Vertex v;
        v.index_a = support(a, -direction);
        v.index_b = support(b, inverse_rotate(b_in_a.q, direction));
        v.w = (b_in_a.p + rotate(b_in_a.q, b.point(v.index_b))) - a.point(v.index_a);
        return v;
    };
    Simplex simplex;
    simplex.vertices[0] = vertex(-guess);
    simplex.count = 1;
    Vec2 nearest = simplex.vertices[0].w;

    // Each round brings a new vertex or ends; two octagons have 64 pairs, and a handful of rounds is usual.
    constexpr int kMaxRounds = 24;
    for (int round = 0; round < kMaxRounds; ++round) {
        const Vertex next = vertex(-nearest);
        // No vertex lies nearer to the origin along this direction: the point is the nearest.
        const float gain = length_squared(nearest) - dot(nearest, next.w);
        if (simplex.has(next) || gain <= 1e-6f * length_squared(nearest)) break;
        simplex.vertices[simplex.count++] = next;
        if (simplex.count == 2) {
            nearest = reduce_segment(simplex, 0, 1);
        } else if (!reduce_triangle(simplex, nearest)) {
            return {};
        }
        if (length_squared(nearest) == 0) return {};
    }
    const float core = length(nearest);
    const Vertex& first = simplex.vertices[0];
    Distance result{core - a.radius() - b.radius(),
                    core > 0 ? (1 / core) * nearest : Vec2{},
                    a.point(first.index_a),
                    {},
                    first.index_a,
                    first.index_b};
    if (simplex.count == 2) {
        const Vertex& second = simplex.vertices[1];
        const Vec2 edge = second.w - first.w;
        const float t = std::clamp(dot(nearest - first.w, edge) / length_squared(edge), 0.0f, 1.0f);
        result.point_a += t * (a.point(second.index_a) - a.point(first.index_a));
    }
    result.point_b = result.point_a + nearest;
    return result;
}

}  // namespace cairn::physics
