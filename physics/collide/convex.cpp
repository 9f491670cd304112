// From a described geometry to the common convex form.
#include "collide/convex.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <cairn/physics/tuning.h>

#include "base/check.h"
#include "collide/hull.h"

namespace cairn::physics {
namespace {

// m. Larger shapes would overflow float in the products of the solver.
constexpr double kMaxLength_m = 1e6;

void set_points(Convex& shape, std::span<const Vec2> points, float radius_m) {
    shape.outline.count = static_cast<std::uint8_t>(points.size());
    shape.outline.radius_m = radius_m;
    std::copy(points.begin(), points.end(), shape.outline.points_m.begin());
    for (int i = 0; i < shape.count(); ++i) {
        shape.normals[i] = normalized(right_perp(shape.point(shape.next(i)) - shape.point(i)));
        shape.centroid += shape.point(i) * (1.0f / static_cast<float>(points.size()));
    }
    for (int i = shape.count(); i < kMaxPolygonVertices; ++i) {
        shape.outline.points_m[i] = shape.point(0);
        shape.normals[i] = shape.normals[0];
    }
}

// Of a segment of a chain, behind its own points: the far ends of its neighbours.
void set_far_ends(Convex& segment, const std::array<Vec2, 2>& far) {
    std::copy(far.begin(), far.end(), segment.outline.points_m.begin() + 2);
    segment.normals[2] = normalized(right_perp(segment.point(0) - far[0]));
    segment.normals[3] = normalized(right_perp(far[1] - segment.point(1)));
}

template <std::size_t n>
bool are_same_bits(const std::array<Vec2, n>& a, const std::array<Vec2, n>& b) {
    using Bits = std::array<std::uint64_t, n>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

check::Fault place(const char* field, Vec2 p) {
    if (auto fault = check::finite(field, p)) return fault;
    const double farthest =
        std::max(std::fabs(static_cast<double>(p.x)), std::fabs(static_cast<double>(p.y)));
    return check::require(farthest <= kMaxLength_m, field, farthest, "within 1e6 m of the body's origin");
}

check::Fault size(const char* field, double value) {
    if (auto fault = check::positive(field, value)) return fault;
    return check::require(value <= kMaxLength_m, field, value, "at most 1e6 m");
}

check::Fault rounding(const char* field, double value) {
    if (auto fault = check::not_negative(field, value)) return fault;
    return check::require(value <= kMaxLength_m, field, value, "at most 1e6 m");
}

Result<Convex> convert(const Circle& circle) {
    if (auto fault = check::first_of({size("circle.radius_m", static_cast<double>(circle.radius_m)),
                                      place("circle.center_m", circle.center_m)})) {
        return *fault;
    }
    Convex shape;
    shape.outline.kind = ShapeKind::Circle;
    set_points(shape, std::array{circle.center_m}, circle.radius_m);
    return shape;
}

check::Fault apart(const char* field, Vec2 a, Vec2 b) {
    const double distance = static_cast<double>(length(b - a));
    return check::require(distance > static_cast<double>(tuning::kLinearSlop_m), field, distance,
                          "greater than 0.005 m (for one point take a circle)");
}

Result<Convex> convert(const Capsule& capsule) {
    if (auto fault = check::first_of(
            {size("capsule.radius_m", static_cast<double>(capsule.radius_m)),
             place("capsule.a_m", capsule.a_m), place("capsule.b_m", capsule.b_m),
             apart("the distance from capsule.a_m to capsule.b_m", capsule.a_m, capsule.b_m)})) {
        return *fault;
    }
    Convex shape;
    shape.outline.kind = ShapeKind::Capsule;
    set_points(shape, std::array{capsule.a_m, capsule.b_m}, capsule.radius_m);
    return shape;
}

Result<Convex> convert(const Segment& segment) {
    if (auto fault = check::first_of(
            {place("segment.a_m", segment.a_m), place("segment.b_m", segment.b_m),
             apart("the distance from segment.a_m to segment.b_m", segment.a_m, segment.b_m)})) {
        return *fault;
    }
    Convex shape;
    shape.outline.kind = ShapeKind::Segment;
    set_points(shape, std::array{segment.a_m, segment.b_m}, 0);
    return shape;
}

// Corners are floats, and the farther they are from the body's origin, the coarser. A side of a box must not
// be lost in that: it would have no direction.
check::Fault told_apart(const char* field, float half_size, Vec2 a, Vec2 b) {
    const float side = 2 * half_size;
    if (std::fabs(length(b - a) - side) <= 0.1f * side) return {};
    const std::string rule = "large enough to tell its corners apart, " +
                             check::number(static_cast<double>(length(a))) + " m from the body's origin";
    return check::require(false, field, static_cast<double>(half_size), rule.c_str());
}

Result<Convex> convert(const Box& box) {
    if (auto fault = check::first_of({size("box.half_width_m", static_cast<double>(box.half_width_m)),
                                      size("box.half_height_m", static_cast<double>(box.half_height_m)),
                                      place("box.center_m", box.center_m),
                                      check::finite("box.angle_rad", static_cast<double>(box.angle_rad)),
                                      rounding("box.radius_m", static_cast<double>(box.radius_m))})) {
        return *fault;
    }
    const Rotation q = Rotation::from_angle(static_cast<double>(box.angle_rad));
    const auto corner = [&](float sx, float sy) {
        return box.center_m + rotate(q, {sx * box.half_width_m, sy * box.half_height_m});
    };
    const std::array corners{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    if (auto fault =
            check::first_of({told_apart("box.half_width_m", box.half_width_m, corners[0], corners[1]),
                             told_apart("box.half_height_m", box.half_height_m, corners[1], corners[2])})) {
        return *fault;
    }
    Convex shape;
    shape.outline.kind = ShapeKind::Polygon;
    set_points(shape, corners, box.radius_m);
    shape.is_box = box.angle_rad == 0 && box.radius_m == 0;
    shape.half_size = {box.half_width_m, box.half_height_m};
    if (shape.is_box) shape.centroid = box.center_m;
    return shape;
}

Result<Convex> convert(const Polygon& polygon) {
    if (auto fault = rounding("polygon.radius_m", static_cast<double>(polygon.radius_m))) return *fault;
    for (std::size_t i = 0; i < polygon.points_m.size(); ++i) {
        const Vec2 p = polygon.points_m[i];
        if (!place("", p)) continue;
        return *place(("polygon.points_m[" + std::to_string(i) + "]").c_str(), p);
    }
    const Result<Hull> hull = make_hull(polygon.points_m);
    if (!hull) return hull.error();
    Convex shape;
    shape.outline.kind = ShapeKind::Polygon;
    set_points(shape, std::span(hull->points).first(hull->count), polygon.radius_m);
    return shape;
}

}  // namespace

Result<Convex> make_convex(const Geometry& geometry) {
    return std::visit([](const auto& g) { return convert(g); }, geometry);
}

Convex make_chain_segment(std::optional<Vec2> before, Vec2 a, Vec2 b, std::optional<Vec2> after) {
    Convex shape;
    shape.outline.kind = ShapeKind::ChainSegment;
    set_points(shape, std::array{a, b}, 0);
    const Vec2 behind = left_perp(b - a);
    set_far_ends(shape, {before.value_or(a + behind), after.value_or(b + behind)});
    shape.owns_end = !after;
    return shape;
}

bool is_consistent(const Convex& shape) {
    const auto& points = shape.outline.points_m;
    Convex made;
    set_points(made, std::span(points).first(static_cast<std::size_t>(shape.count())), shape.radius());
    if (shape.is_chained()) set_far_ends(made, {points[2], points[3]});
    if (!are_same_bits(made.outline.points_m, points) || !are_same_bits(made.normals, shape.normals))
        return false;
    if (!shape.is_box) return are_same_bits(std::array{made.centroid}, std::array{shape.centroid});
    const Vec2 half = shape.half_size;
    const auto corner = [&](float sx, float sy) { return shape.centroid + Vec2{sx * half.x, sy * half.y}; };
    return shape.count() == 4 && shape.radius() == 0 && half.x > 0 && half.y > 0 &&
           points[0] == corner(-1, -1) && points[1] == corner(1, -1) && points[2] == corner(1, 1) &&
           points[3] == corner(-1, 1);
}

Extents extents(const Convex& shape, Rotation q) {
    if (shape.is_box) {
        const Vec2 center = rotate(q, shape.centroid);
        const Vec2 half{std::fabs(q.c) * shape.half_size.x + std::fabs(q.s) * shape.half_size.y,
                        std::fabs(q.s) * shape.half_size.x + std::fabs(q.c) * shape.half_size.y};
        return {center - half, center + half};
    }
    Vec2 lower = rotate(q, shape.point(0));
    Vec2 upper = lower;
    for (int i = 1; i < shape.count(); ++i) {
        const Vec2 p = rotate(q, shape.point(i));
        lower = smallest(lower, p);
        upper = largest(upper, p);
    }
    const Vec2 r{shape.radius(), shape.radius()};
    return {lower - r, upper + r};
}

Aabb bounds(const Convex& shape, const Transform& xf) {
    const Extents e = extents(shape, xf.q);
    return make_aabb(xf.p, e.lower, e.upper);
}

float farthest_distance(const Convex& shape, Vec2 from) {
    float farthest_m2 = 0;
    for (int i = 0; i < shape.count(); ++i)
        farthest_m2 = std::max(farthest_m2, length_squared(shape.point(i) - from));
    return std::sqrt(farthest_m2) + shape.radius();
}

float inner_radius(const Convex& shape) {
    if (shape.count() < 3) return shape.radius();
    float nearest = dot(shape.normals[0], shape.point(0) - shape.centroid);
    for (int i = 1; i < shape.count(); ++i) {
        nearest = std::min(nearest, dot(shape.normals[i], shape.point(i) - shape.centroid));
    }
    return nearest + shape.radius();
}

bool contains_point(const Convex& shape, Vec2 point) {
    if (shape.is_line()) return false;
    bool inside = shape.count() >= 3;
    float nearest_squared = length_squared(point - shape.point(0));
    for (int i = 0; i < shape.count(); ++i) {
        const Vec2 a = shape.point(i);
        const Vec2 edge = shape.point(shape.next(i)) - a;
        if (dot(point - a, shape.normals[i]) > 0) inside = false;
        const float along = dot(point - a, edge);
        const float whole = length_squared(edge);
        const float t = whole > 0 ? std::clamp(along / whole, 0.0f, 1.0f) : 0;
        nearest_squared = std::min(nearest_squared, length_squared(point - (a + t * edge)));
    }
    return inside || nearest_squared <= shape.radius() * shape.radius();
}

}  // namespace cairn::physics
