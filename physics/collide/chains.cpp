// A segment of a chain against circles, capsules and polygons.
//
// A chain is a surface made of segments, and what slides along it must feel the surface and not the joins. So
// a segment admits only the normals that the surface has: its own over its length, and at a corner that juts
// out those between the two segments that meet there.
//
//        n0 \   | n                 free side
//            \  |                   Corner p1 juts out: its normals are those from n0 to n, and the segment
//     _______ p1________p2          that begins at p1 owns them. In a corner that recedes, or on the flat,
//     before  /  segment  \         there are none but the segments' own.
//                          \ after
//
// Method: the axes of hulls.cpp, of which those that the surface does not have are replaced by the segment's
// own normal, or given up where a neighbour has them. Source: the idea of admitting normals by the neighbours
// is Catto's ("Collision of one-sided chains" in Box2D); the rules here are our own.
#include "collide/clip.h"
#include "collide/manifold.h"

namespace cairn::physics {
namespace {

// Sine. Neighbours that turn by less are one plane.
constexpr float kFlat = 1e-3f;
// Sine. Normals this little outside of a corner's count as its own, so that none falls between two owners.
constexpr float kConeTolerance = 1e-2f;

// Whether a corner between edges with these normals juts out. One that folds back entirely is a tip.
bool juts_out(Vec2 normal_before, Vec2 normal_after) {
    const float turn = cross(normal_before, normal_after);
    return turn > kFlat || (turn >= -kFlat && dot(normal_before, normal_after) < 0);
}

struct Surface {
    Vec2 a;
    Vec2 b;
    Vec2 along;  // from a to b
    Vec2 normal;
    Vec2 normal_before;
    Vec2 normal_after;
    bool a_juts_out;
    bool b_juts_out;
    bool owns_b;

    explicit Surface(const Convex& segment)
        : a(segment.point(0)),
          b(segment.point(1)),
          along(left_perp(segment.normals[0])),
          normal(segment.normals[0]),
          normal_before(segment.normals[2]),
          normal_after(segment.normals[3]),
          a_juts_out(juts_out(normal_before, normal)),
          b_juts_out(juts_out(normal, normal_after)),
          owns_b(segment.owns_end) {}

    [[nodiscard]] float height(Vec2 p) const { return dot(normal, p - a); }
    // Nearer to the back of the surface than to its front.
    [[nodiscard]] bool has_behind(Vec2 p) const {
        if (height(p) >= 0) return false;
        if (a_juts_out && dot(normal_before, p - a) >= 0) return false;
        return !owns_b || dot(normal_after, p - b) < 0;
    }
};

enum class Verdict : std::uint8_t {
    Admit,  // the surface has this normal, here
    Face,   // it has the segment's own instead
    Skip,   // a neighbour meets what is there
};

// Whether a direction is one of those that a corner's normals sweep over.
bool is_between(Vec2 normal, Vec2 first, Vec2 last) {
    return cross(first, normal) >= -kConeTolerance && cross(normal, last) >= -kConeTolerance;
}

Verdict judge(const Surface& surface, Vec2 normal) {
    if (dot(normal, surface.along) < 0) {
        if (!surface.a_juts_out) return Verdict::Face;
        return is_between(normal, surface.normal_before, surface.normal) ? Verdict::Admit : Verdict::Skip;
    }
    if (!surface.b_juts_out) return Verdict::Face;
    if (!is_between(normal, surface.normal, surface.normal_after)) return Verdict::Skip;
    if (surface.owns_b) return Verdict::Admit;
    // The neighbour has the corner; the face may still hold the other's far side. Not at a sharp corner,
    // where what is below the face may be outside all the same.
    return dot(surface.normal, surface.normal_after) > 0 ? Verdict::Face : Verdict::Skip;
}

// The facing edge of the other core in front of the segment.
struct Front {
    Vec2 first;  // its end towards a
    Vec2 last;
    float first_at;  // along the segment, from a
    float last_at;
    int face;
    float length;

    Front(const Surface& surface, const CoreEdges& other)
        : face(facing_edge(other, surface.normal)), length(dot(surface.b - surface.a, surface.along)) {
        first = other.edge(face).b;
        last = other.edge(face).a;
        first_at = dot(first - surface.a, surface.along);
        last_at = dot(last - surface.a, surface.along);
    }

    // Its ends, or where it crosses the ends of the segment. As in clip.h, each is asked about its own end
    // first.
    [[nodiscard]] std::array<Vec2, 2> ends() const {
        const float low = std::clamp(first_at, 0.0f, length);
        const float high = std::clamp(last_at, 0.0f, length);
        const auto between = [&](float place) {
            return first + (place - first_at) / (last_at - first_at) * (last - first);
        };
        return {low <= first_at  ? first
                : low >= last_at ? last
                                 : between(low),
                high >= last_at    ? last
                : high <= first_at ? first
                                   : between(high)};
    }
    [[nodiscard]] bool is_beside(float tolerance) const {
        return last_at < -tolerance || first_at > length + tolerance;
    }
};

Manifold face_manifold(const Surface& surface, const CoreEdges& other, const Front& front, float reach) {
    Manifold m;
    if (front.is_beside(kSharedAtJoin_m)) return m;
    const std::array<Vec2, 2> ends = front.ends();
    // Where the other reaches past a corner that juts out, and deeper there, it touches the corner with its
    // own edge: that contact has another normal, and the corner's owner makes it.
    const std::array<bool, 2> passes_corner{
        surface.a_juts_out && surface.height(front.first) < surface.height(ends[0]) - kAboutEqual_m,
        surface.b_juts_out && surface.height(front.last) < surface.height(ends[1]) - kAboutEqual_m};
    m.normal = surface.normal;
    for (int end = 0; end < 2; ++end) {
        const float core_separation = surface.height(ends[end]);
        const float separation = core_separation - other.radius;
        if (passes_corner[end] || separation > reach) continue;
        if (m.count == 1 && ends[0] == ends[1]) continue;
        const auto id = static_cast<std::uint16_t>(front.face << 4 | end);
        m.points[m.count++] = {ends[end] - 0.5f * (other.radius + core_separation) * surface.normal,
                               separation, id};
    }
    return m;
}

}  // namespace

bool is_behind(const Convex& shape, Vec2 point) {
    return shape.is_chained() && Surface(shape).has_behind(point);
}

bool leaves_to_neighbour(const Convex& segment, int end) {
    // Of what is beyond its first end, a segment meets what is in the wedge of a corner that juts out, by
    // however little.
    return end == 0 ? cross(segment.normals[2], segment.normals[0]) <= 0 : !segment.owns_end;
}

Manifold collide_chain_and_circle(const Convex& a, const Convex& b, const RelativePose& b_in_a,
                                  float reach_m) {
    const Surface surface(a);
    const Vec2 center = b_in_a.p + rotate(b_in_a.q, b.point(0));
    const Vec2 from_a = center - surface.a;
    const Vec2 from_b = center - surface.b;
    const float height = surface.height(center);

    // A neighbour asks the same questions in the same numbers, so no centre falls between two segments.
    const Vec2 edge = surface.b - surface.a;
    const bool before = dot(from_a, edge) < 0;
    const bool after = dot(from_b, edge) > 0;
    Vec2 normal = surface.normal;
    Vec2 nearest = center - height * surface.normal;
    if (before || after) {
        if (before && !(dot(from_a, surface.a - a.outline.points_m[2]) > 0)) return {};
        if (after && !surface.owns_b) return {};
        const bool juts_out = before ? surface.a_juts_out : surface.b_juts_out;
        if (!juts_out && height < 0) return {};
        if (after && height < 0) return {};
        nearest = before ? surface.a : surface.b;
        const Vec2 d = center - nearest;
        if (length(d) - b.radius() > reach_m)
            return {};  // at 1e19 m the square is infinite, and no normal left
        if (length(d) > 1e-12f) normal = normalized(d);
    } else if (height < 0) {
        return {};
    }
    const float distance = dot(center - nearest, normal);
    const float separation = distance - b.radius();
    Manifold m;
    if (separation > reach_m) return m;
    m.normal = normal;
    m.count = 1;
    m.points[0] = {nearest + 0.5f * separation * normal, separation, 0};
    return m;
}

Manifold collide_chain_and_hull(const Convex& shape_a, const Convex& shape_b, const RelativePose& b_in_a,
                                float reach_m) {
    const Surface surface(shape_a);
    const Vec2 center = b_in_a.p + rotate(b_in_a.q, shape_b.centroid);
    if (surface.has_behind(center)) return {};
    // Beside a sharp corner the other may be in front of the neighbour and behind the segment: then the
    // corner is all that it can meet.
    const bool corner_only = surface.height(center) < 0;

    const CoreEdges b = edges_of(shape_b, b_in_a);
    const float reach = b.radius + reach_m;
    float above = std::numeric_limits<float>::infinity();
    float below = above;
    for (int i = 0; i < b.count; ++i) {
        above = std::min(above, surface.height(b.points[i]));
        below = std::min(below, -surface.height(b.points[i]));
    }
    if (above > reach) return {};
    const Front front(surface, b);
    // Without corners that jut out there is the face and nothing else, and most that is near is beside it.
    if (!surface.a_juts_out && !surface.b_juts_out) {
        if (corner_only || front.is_beside(kSharedAtJoin_m)) return {};
        if (best_axis(b, edges_of(shape_a)).separation > reach) return {};
        return face_manifold(surface, b, front, reach_m);
    }
    const CoreEdges a = edges_of(shape_a);
    const Axis axis_b = best_axis(b, a);
    if (axis_b.separation > reach) return {};

    const auto by_face = [&] { return corner_only ? Manifold{} : face_manifold(surface, b, front, reach_m); };
    const Candidate by_edge(b, a, axis_b, true);
    const auto by_edge_if_admitted = [&] {
        switch (judge(surface, -b.normals[axis_b.edge])) {
            case Verdict::Admit:
                return by_edge.manifold(reach_m);
            case Verdict::Face:
                return by_face();
            case Verdict::Skip:
                return Manifold{};
        }
        return Manifold{};
    };

    const float best = std::max(above, axis_b.separation);
    const bool is_past = corner_only && below > best;
    const bool in_line = b.count == 2 && front.is_beside(0);
    const bool apart = in_line || (is_past ? below : best) > kAboutEqual_m;
    const bool prefer_edge = axis_b.separation > above + kAboutEqual_m;
    if (!apart) return is_past ? Manifold{} : prefer_edge ? by_edge_if_admitted() : by_face();
    if (!is_past) {
        const std::array<Vec2, 2> ends = front.ends();
        const float found = std::min(surface.height(ends[0]), surface.height(ends[1]));
        const bool face_is_nearest = !front.is_beside(0) && found <= above + 1e-3f * tuning::kLinearSlop_m;
        if (!prefer_edge && face_is_nearest) return by_face();
        const bool edge_may_be = prefer_edge || above - axis_b.separation <= kAboutEqual_m;
        if (edge_may_be && by_edge.is_nearest(kRounding_m)) return by_edge_if_admitted();
    }

    const Distance nearest = distance_between(shape_a, shape_b, b_in_a);
    if (nearest.normal == Vec2{}) return by_face();
    switch (judge(surface, nearest.normal)) {
        case Verdict::Admit:
            return between_corners(nearest, 0, b.radius, reach_m);
        case Verdict::Face:
            return by_face();
        case Verdict::Skip:
            return {};
    }
    return {};
}

}  // namespace cairn::physics
