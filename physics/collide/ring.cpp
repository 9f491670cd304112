// Outlines, widths and parts of rings.
#include "collide/ring.h"

#include <algorithm>
#include <limits>

namespace cairn::physics {
namespace {

// How far a chord may leave its arc: of the radius, or, so that small roundings cost few corners, of the
// farthest reach of the shape from its middle. Smaller: discs fall into pieces of many corners; larger: what
// is left of a disc is seen to have corners.
constexpr double kChordSag = 0.035;
constexpr double kChordSagOfShape = 0.012;

const RingPoint& next_of(const Ring& ring, std::size_t i) {
    return ring[i + 1 < ring.size() ? i + 1 : 0];
}

int chords_for(double angle_rad, double radius, double sag) {
    int chords = 1;
    while (radius * (1 - deterministic::cos(angle_rad / (2 * chords))) > sag) ++chords;
    return chords;
}

// Points of the arc about `center` from the direction `from` on, `angle_rad` anticlockwise; the last one only
// if the arc has an end.
void add_arc(Ring& ring, RingPoint center, double radius, RingPoint from, double angle_rad, int chords,
             bool closed) {
    for (int k = 0; k < chords + (closed ? 0 : 1); ++k) {
        const double c = deterministic::cos(angle_rad * k / chords);
        const double s = deterministic::sin(angle_rad * k / chords);
        ring.push_back(center + radius * RingPoint{c * from.x - s * from.y, s * from.x + c * from.y});
    }
}

void append(std::vector<Convex>& shapes, const Ring& ring) {
    std::array<Vec2, kMaxPolygonVertices> points;
    for (std::size_t i = 0; i < ring.size(); ++i) points[i] = to_vec2(ring[i]);
    const Result<Convex> shape = make_convex(Polygon{std::span(points).first(ring.size())});
    if (shape) shapes.push_back(*shape);
}

// By the shortest diagonal that leaves halves of equal numbers of corners, until there are few enough.
void append_split(std::vector<Convex>& shapes, const Ring& ring) {
    if (ring.size() <= kMaxPolygonVertices) return append(shapes, ring);
    const std::size_t half = ring.size() / 2;
    std::size_t first = 0;
    for (std::size_t i = 1; i + half < ring.size(); ++i) {
        if (length(ring[i + half] - ring[i]) < length(ring[first + half] - ring[first])) first = i;
    }
    const auto at = [&](std::size_t i) { return ring.begin() + static_cast<std::ptrdiff_t>(i); };
    const Ring one(at(first), at(first + half) + 1);
    Ring other(at(first + half), ring.end());
    other.insert(other.end(), ring.begin(), at(first) + 1);
    append_split(shapes, one);
    append_split(shapes, other);
}

}  // namespace

Ring ring_of(const Convex& shape) {
    Ring ring;
    const auto radius = static_cast<double>(shape.radius());
    const int n = shape.count();
    if (radius == 0) {
        for (int i = 0; i < n; ++i) ring.push_back(to_ring_point(shape.point(i)));
        return ring;
    }
    const auto reach = static_cast<double>(farthest_distance(shape, shape.centroid));
    const double sag = std::max(kChordSag * radius, kChordSagOfShape * reach);
    if (n == 1) {
        const double turn = 2 * deterministic::acos(-1);
        const int chords = chords_for(turn, radius, sag);
        add_arc(ring, to_ring_point(shape.point(0)), radius, {1, 0}, turn, chords, true);
        return ring;
    }
    for (int i = 0; i < n; ++i) {
        const RingPoint before = to_ring_point(shape.normals[i == 0 ? n - 1 : i - 1]);
        const RingPoint after = to_ring_point(shape.normals[i]);
        // The two edges of a capsule are opposite: the turn is half a circle, of either sign.
        const double angle = std::fabs(deterministic::atan2(cross(before, after), dot(before, after)));
        add_arc(ring, to_ring_point(shape.point(i)), radius, before, angle, chords_for(angle, radius, sag),
                false);
    }
    return ring;
}

double area(const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 2; i < ring.size(); ++i) {
        twice += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    }
    return twice / 2;
}

double least_width(const Ring& ring) {
    if (ring.size() < 3) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RingPoint edge = next_of(ring, i) - ring[i];
        const double edge_length = length(edge);
        if (edge_length == 0) continue;
        double farthest = 0;
        for (const RingPoint p : ring) farthest = std::max(farthest, cross(edge, p - ring[i]) / edge_length);
        least = std::min(least, farthest);
    }
    return least;
}

bool contains(const Ring& ring, RingPoint point) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (cross(next_of(ring, i) - ring[i], point - ring[i]) < 0) return false;
    }
    return true;
}

RingPoint nearest_on_outline(const Ring& ring, RingPoint point) {
    RingPoint nearest = ring[0];
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RingPoint edge = next_of(ring, i) - ring[i];
        const double whole = dot(edge, edge);
        const double t = whole > 0 ? std::clamp(dot(point - ring[i], edge) / whole, 0.0, 1.0) : 0;
        const RingPoint candidate = ring[i] + t * edge;
        if (length(point - candidate) < length(point - nearest)) nearest = candidate;
    }
    return nearest;
}

RingBox box_of(const Ring& ring) {
    RingBox box{ring[0], ring[0]};
    for (const RingPoint p : ring) box = merged(box, {p, p});
    return box;
}

RingBox merged(const RingBox& a, const RingBox& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

bool overlap(const RingBox& a, const RingBox& b, double gap) {
    return a.lower.x <= b.upper.x + gap && b.lower.x <= a.upper.x + gap && a.lower.y <= b.upper.y + gap &&
           b.lower.y <= a.upper.y + gap;
}

Ring left_part(const Ring& ring, const DirectedLine& line) {
    Ring part;
    bool has_area = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RingPoint a = ring[i];
        const RingPoint b = next_of(ring, i);
        const double distance_a = line.distance(a);
        const double distance_b = line.distance(b);
        has_area = has_area || distance_a > 0;
        if (distance_a >= 0) part.push_back(a);
        if ((distance_a > 0 && distance_b < 0) || (distance_a < 0 && distance_b > 0)) {
            part.push_back(a + (distance_a / (distance_a - distance_b)) * (b - a));
        }
    }
    return has_area ? part : Ring{};
}

std::optional<Interval> interval_near(const Ring& ring, const DirectedLine& line, double reach) {
    const Ring strip = left_part(left_part(ring, line.shifted(-reach)), line.shifted(reach).reversed());
    if (strip.empty()) return {};
    Interval interval{line.along(strip[0]), line.along(strip[0])};
    for (const RingPoint p : strip) {
        interval.low = std::min(interval.low, line.along(p));
        interval.high = std::max(interval.high, line.along(p));
    }
    return interval;
}

std::vector<Convex> shapes_of(const Ring& ring) {
    std::vector<Convex> shapes;
    if (ring.size() >= 3) append_split(shapes, ring);
    return shapes;
}

}  // namespace cairn::physics
