// The edges of two convex cores against each other: the axis of least overlap, and the facing edge of one
// clipped to the reference edge of the other. What hulls.cpp and chains.cpp build manifolds from.
#pragma once

#include <algorithm>
#include <limits>

#include <cairn/physics/tuning.h>

#include "collide/distance.h"
#include "collide/manifold.h"

namespace cairn::physics {

struct EdgeEnds {
    Vec2 a;
    Vec2 b;
};

struct CoreEdges {  // a convex shape in the frame of A
    std::array<Vec2, kMaxPolygonVertices> points;
    std::array<Vec2, kMaxPolygonVertices> normals;
    int count;
    float radius;

    [[nodiscard]] int next(int i) const { return i + 1 < count ? i + 1 : 0; }
    [[nodiscard]] EdgeEnds edge(int i) const { return {points[i], points[next(i)]}; }
};

inline CoreEdges edges_of(const Convex& shape) {
    return {shape.outline.points_m, shape.normals, shape.count(), shape.radius()};
}

inline CoreEdges edges_of(const Convex& shape, const RelativePose& pose) {
    CoreEdges edges{{}, {}, shape.count(), shape.radius()};
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
inline Axis best_axis(const CoreEdges& of, const CoreEdges& other) {
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

inline int facing_edge(const CoreEdges& of, Vec2 normal) {
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

// The part of the incident edge that lies in front of the reference edge.
struct Clipped {
    std::array<Vec2, 2> ends;
    std::array<float, 2> separations;  // of the cores
    bool beside;                       // no part does: the nearer end point stands for it
};

inline Clipped clip(const CoreEdges& reference, int reference_edge, const CoreEdges& incident,
                    int incident_edge, bool cores_overlap) {
    const EdgeEnds base = reference.edge(reference_edge);
    const EdgeEnds face = incident.edge(incident_edge);
    const Vec2 normal = reference.normals[reference_edge];
    const Vec2 tangent = left_perp(normal);  // from base.a to base.b
    const float length_base = dot(base.b - base.a, tangent);
    // Along the tangent the incident edge runs the other way: b comes first.
    const float first = dot(face.b - base.a, tangent);
    const float last = dot(face.a - base.a, tangent);
    const auto at = [&](float along) {
        if (along <= first) return face.b;
        if (along >= last) return face.a;
        return face.b + (along - first) / (last - first) * (face.a - face.b);
    };
    std::array<Vec2, 2> ends{at(std::clamp(first, 0.0f, length_base)),
                             at(std::clamp(last, 0.0f, length_base))};
    // The ends of a capsule or segment that stands upright on the base lie above each other. When it has gone
    // through, the nearer is wanted; in front of it, which one this is the search for corners tells.
    if (cores_overlap && last <= first) ends = {face.b, face.a};
    const bool beside = last < 0 || first > length_base;
    return {ends, {dot(ends[0] - base.a, normal), dot(ends[1] - base.a, normal)}, beside};
}

struct Candidate {
    const CoreEdges& reference;
    const CoreEdges& incident;
    Axis axis;
    bool flipped;  // the reference is B
    int face;      // of the incident shape
    Clipped clipped;

    Candidate(const CoreEdges& reference_, const CoreEdges& incident_, Axis axis_, bool flipped_)
        : reference(reference_),
          incident(incident_),
          axis(axis_),
          flipped(flipped_),
          face(facing_edge(incident_, reference_.normals[axis_.edge])),
          clipped(clip(reference_, axis_.edge, incident_, face, axis_.separation < 0)) {}

    // Whether the least distance, or nearly it, is indeed found in front of the reference edge, and not past
    // its end.
    [[nodiscard]] bool is_nearest(float tolerance) const {
        const float found = std::min(clipped.separations[0], clipped.separations[1]);
        return !clipped.beside && found <= axis.separation + tolerance;
    }

    // The way from the reference edge to the corner of the other core that is deepest below it, be it past
    // the end of that edge.
    [[nodiscard]] Distance to_deepest_corner() const {
        const EdgeEnds base = reference.edge(axis.edge);
        const Vec2 normal = reference.normals[axis.edge];
        const EdgeEnds side = incident.edge(face);
        const bool first = dot(side.a - side.b, normal) <= 0;
        const int corner = first ? face : incident.next(face);
        const Vec2 deepest = incident.points[corner];
        const bool near_b = dot(deepest - base.a, base.b - base.a) > 0.5f * length_squared(base.b - base.a);
        const int end = near_b ? reference.next(axis.edge) : axis.edge;
        const Vec2 foot = deepest - axis.separation * normal;
        const float distance = axis.separation - reference.radius - incident.radius;
        return flipped ? Distance{distance, -normal, deepest, foot, corner, end}
                       : Distance{distance, normal, foot, deepest, end, corner};
    }

    [[nodiscard]] Manifold manifold(float reach) const {
        const Vec2 normal = reference.normals[axis.edge];
        Manifold m;
        m.normal = flipped ? -normal : normal;
        for (int end = 0; end < 2; ++end) {
            const float separation = clipped.separations[end] - reference.radius - incident.radius;
            if (separation > reach) continue;
            if (m.count == 1 && clipped.ends[0] == clipped.ends[1]) continue;
            const float to_middle = 0.5f * (reference.radius - incident.radius - clipped.separations[end]);
            m.points[m.count++] = {clipped.ends[end] + to_middle * normal, separation,
                                   feature_id(flipped, axis.edge, face, end)};
        }
        return m;
    }
};

// One point, with the normal between the nearest points of the cores; nothing when these overlap.
inline Manifold between_corners(const Distance& nearest, float radius_a, float radius_b, float reach) {
    if (nearest.distance > reach || nearest.normal == Vec2{}) return {};
    const Vec2 on_a = nearest.point_a + radius_a * nearest.normal;
    const Vec2 on_b = nearest.point_b - radius_b * nearest.normal;
    Manifold m;
    m.normal = nearest.normal;
    m.count = 1;
    m.points[0] = {0.5f * (on_a + on_b), nearest.distance,
                   static_cast<std::uint16_t>(1 << 13 | nearest.vertex_a << 4 | nearest.vertex_b)};
    return m;
}

}  // namespace cairn::physics
