// Capsules and polygons, rounded or not, against each other: up to two points.
// Method: the axis of least overlap among the edge normals of both; the facing edge of the other shape is
// clipped to the reference edge. Cores that are apart and meet corner to corner get one point, with the
// normal between the corners. Source: Gregorius, "The Separating Axis Test between Convex Polyhedra", GDC
// 2013.
#include <limits>

#include <cairn/physics/tuning.h>

#include "collide/clip.h"
#include "collide/manifold.h"

namespace cairn::physics {
namespace {

struct Edges {  // a convex shape in the frame of A
    std::array<Vec2, kMaxPolygonVertices> points;
    std::array<Vec2, kMaxPolygonVertices> normals;
    int count;
    float radius;

    [[nodiscard]] int next(int i) const { return i + 1 < count ? i + 1 : 0; }
    [[nodiscard]] Segment edge(int i) const { return {points[i], points[next(i)]}; }
};

Edges edges_of(const Convex& shape) {
    return {shape.outline.points_m, shape.normals, shape.count(), shape.radius()};
}

Edges edges_of(const Convex& shape, const RelativePose& pose) {
    Edges edges{{}, {}, shape.count(), shape.radius()};
    for (int i = 0; i < shape.count(); ++i) {
        edges.points[i] = pose.p + rotate(pose.q, shape.point(i));
        edges.normals[i] = rotate(pose.q, shape.normals[i]);
    }
    return edges;
}

struct Axis {
    float separation = -std::numeric_limits<float>::infinity();
    int edge = 0;
};

// The edge of `of` that the other core is farthest in front of.
Axis best_axis(const Edges& of, const Edges& other) {
    Axis best;
    for (int i = 0; i < of.count; ++i) {
        float nearest = std::numeric_limits<float>::infinity();
        for (int j = 0; j < other.count; ++j) {
            nearest = std::min(nearest, dot(of.normals[i], other.points[j] - of.points[i]));
        }
        if (nearest > best.separation) best = {nearest, i};
    }
    return best;
}

int facing_edge(const Edges& of, Vec2 normal) {
    int best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < of.count; ++i) {
        const float along = dot(of.normals[i], normal);
        if (along < least) {
            least = along;
            best = i;
        }
    }
    return best;
}

std::uint16_t make_id(bool flipped, int reference_edge, int incident_edge, int end) {
    return static_cast<std::uint16_t>(flipped << 12 | reference_edge << 8 | incident_edge << 4 | end);
}

// One point between two corners; ids continue those of clipped points, so a contact that rocks over a corner
// keeps its impulse.
Manifold between_corners(Vec2 on_reference, Vec2 on_incident, const Edges& reference, const Edges& incident,
                         bool flipped, std::uint16_t id, float reach) {
    const Vec2 d = on_incident - on_reference;
    const float distance = length(d);
    const float separation = distance - reference.radius - incident.radius;
    if (separation > reach) return {};
    const Vec2 normal = (1 / distance) * d;
    Manifold m;
    m.count = 1;
    m.normal = flipped ? -normal : normal;
    m.points[0] = {
        0.5f * ((on_reference + reference.radius * normal) + (on_incident - incident.radius * normal)),
        separation, id};
    return m;
}

// The part of the incident edge between the ends of the reference edge.
Manifold clip(const Edges& reference, int reference_edge, const Edges& incident, int incident_edge,
              bool flipped, float reach) {
    const Segment base = reference.edge(reference_edge);
    const Segment face = incident.edge(incident_edge);
    const Vec2 normal = reference.normals[reference_edge];
    const Vec2 tangent = left_perp(normal);  // from base.a to base.b
    const float length_base = dot(base.b - base.a, tangent);
    // Along the tangent the incident edge runs the other way: b comes first.
    const float first = dot(face.b - base.a, tangent);
    const float last = dot(face.a - base.a, tangent);
    const float span = last - first;
    const auto at = [&](float along) {
        return span > 1e-9f ? face.b + (along - first) / span * (face.a - face.b) : face.b;
    };
    const std::array<Vec2, 2> ends{first < 0 && last > 0 ? at(0) : face.b,
                                   last > length_base && first < length_base ? at(length_base) : face.a};
    Manifold m;
    m.normal = flipped ? -normal : normal;
    for (int end = 0; end < 2; ++end) {
        const float core = dot(ends[end] - base.a, normal);
        const float separation = core - reference.radius - incident.radius;
        if (separation > reach) continue;
        const Vec2 middle = ends[end] + 0.5f * (reference.radius - incident.radius - core) * normal;
        m.points[m.count++] = {middle, separation, make_id(flipped, reference_edge, incident_edge, end)};
    }
    return m;
}

}  // namespace

Manifold collide_hulls(const Convex& shape_a, const Convex& shape_b, const RelativePose& b_in_a,
                       float reach_m) {
    const Edges a = edges_of(shape_a);
    const Edges b = edges_of(shape_b, b_in_a);
    const float reach = a.radius + b.radius + reach_m;
    const Axis axis_a = best_axis(a, b);
    if (axis_a.separation > reach) return {};
    const Axis axis_b = best_axis(b, a);
    if (axis_b.separation > reach) return {};

    // A is preferred when the two are about equal, so that the reference does not flip back and forth.
    const bool flipped = axis_b.separation > axis_a.separation + 0.1f * tuning::kLinearSlop_m;
    const Edges& reference = flipped ? b : a;
    const Edges& incident = flipped ? a : b;
    const Axis axis = flipped ? axis_b : axis_a;
    const int face = facing_edge(incident, reference.normals[axis.edge]);

    if (axis.separation > 0.1f * tuning::kLinearSlop_m) {  // the cores are apart: corners may be nearest
        const SegmentDistance nearest = nearest_points(reference.edge(axis.edge), incident.edge(face));
        const bool corner1 = nearest.fraction1 == 0 || nearest.fraction1 == 1;
        const bool corner2 = nearest.fraction2 == 0 || nearest.fraction2 == 1;
        const Vec2 d = nearest.point2 - nearest.point1;
        if (corner1 && corner2 && length_squared(d) > axis.separation * axis.separation * 1.0001f) {
            const int end = nearest.fraction2 == 0 ? 1 : 0;
            return between_corners(nearest.point1, nearest.point2, reference, incident, flipped,
                                   make_id(flipped, axis.edge, face, end), reach_m);
        }
    }
    return clip(reference, axis.edge, incident, face, flipped, reach_m);
}

}  // namespace cairn::physics
