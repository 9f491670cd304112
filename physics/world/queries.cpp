// Each query walks the trees and asks the exact question of each shape, in the frame of that shape's body: so
// answers are as precise far from the world's origin as near it.
#include "world/queries.h"

#include <algorithm>
#include <tuple>

#include <cairn/physics/tuning.h>

#include "collide/ray_cast.h"
#include "collide/shape_cast.h"
#include "world/query_traversal.h"

namespace cairn::physics {
namespace {

// The order of answers. Of equally near shapes the one in the lowest slot comes first.
std::uint64_t rank(ShapeId shape) {
    return shape.index1;
}
auto rank(const RayHit& hit) {
    return std::tuple(hit.fraction, rank(hit.shape));
}
auto rank(const ShapeHit& hit) {
    return std::tuple(hit.fraction, rank(hit.shape));
}
auto rank(const SurfacePoint& point) {
    return std::tuple(point.distance_m, rank(point.shape));
}
auto rank(const CollisionPlane& plane) {
    return rank(plane.shape);
}

template <class Answer>
std::vector<Answer> sorted(std::vector<Answer> answers) {
    std::sort(answers.begin(), answers.end(),
              [](const Answer& a, const Answer& b) { return rank(a) < rank(b); });
    return answers;
}

template <class Answer>
void take_first(std::optional<Answer>& best, const Answer& answer) {
    if (!best || rank(answer) < rank(*best)) best = answer;
}

BodyId body_of(const Stores& stores, int shape) {
    return stores.bodies.slots.id(stores.shapes[shape].body);
}

RelativePose relative_pose(const Transform& of, const Transform& in) {
    return {inverse_transform_point(in, of.p), inverse(in.q) * of.q};
}

// Bounds of a shape, turned by q, about its origin.
struct Extent {
    Vec2 lower;
    Vec2 upper;
};

Extent extent(const Convex& shape, Rotation q) {
    Vec2 lower = rotate(q, shape.point(0));
    Vec2 upper = lower;
    for (int i = 1; i < shape.count(); ++i) {
        const Vec2 p = rotate(q, shape.point(i));
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    const Vec2 r{shape.radius(), shape.radius()};
    return {lower - r, upper + r};
}

Convex disc(float radius_m) {
    Convex shape;
    shape.outline.count = 1;
    shape.outline.radius_m = radius_m;
    return shape;
}

std::optional<RayHit> ray_hit(const Stores& stores, int shape, Position origin, Vec2 translation) {
    const ShapeRecord& record = stores.shapes[shape];
    const Transform xf = stores.bodies.transform(record.body);
    const auto hit =
        cast_ray(record.convex(), inverse_transform_point(xf, origin), inverse_rotate(xf.q, translation));
    if (!hit) return {};
    return RayHit{stores.shapes.id(shape), body_of(stores, shape), origin + hit->fraction * translation,
                  rotate(xf.q, hit->normal), hit->fraction};
}

// m. Of two points of a contact whose depths differ by less neither is the deeper one.
constexpr float kAboutEqual_m = 0.1f * tuning::kLinearSlop_m;

// What a segment of a chain has to do with a shape is for the rules of contacts to say: from which side, and
// with which normals, so that nothing hits the joins. The deeper of the points stands for both.
struct Meeting {
    Vec2 point;  // on the chain
    Vec2 normal;
    float separation = 0;
};

std::optional<Meeting> meeting(const Convex& segment, const Convex& other, const RelativePose& pose,
                               float reach) {
    const bool is_circle = other.outline.kind == ShapeKind::Circle;
    const Manifold m = is_circle ? collide_chain_and_circle(segment, other, pose, reach)
                                 : collide_chain_and_hull(segment, other, pose, reach);
    if (m.count == 0) return {};
    const auto on_chain = [&](int i) {
        return m.points[i].point + -0.5f * m.points[i].separation * m.normal;
    };
    const float first = m.points[0].separation;
    const float second = m.points[1].separation;
    if (m.count == 1 || first <= second - kAboutEqual_m) return Meeting{on_chain(0), m.normal, first};
    if (second <= first - kAboutEqual_m) return Meeting{on_chain(1), m.normal, second};
    // The other lies along the segment.
    return Meeting{0.5f * (on_chain(0) + on_chain(1)), m.normal, std::min(first, second)};
}

// The hit at a segment as if both its sides were solid is the one at its front, or none.
std::optional<LocalShapeHit> at_chain(const Convex& segment, const Convex& moving, const RelativePose& start,
                                      Vec2 way, const LocalShapeHit& hit) {
    const RelativePose there{start.p + hit.fraction * way, start.q};
    // Much more than the rounding of a long way, and little against what can be seen of a short one.
    const float reach = tuning::kLinearSlop_m + 1e-5f * length(way);
    const auto met = meeting(segment, moving, there, reach);
    if (!met) return {};
    const float overlap = hit.overlap > 0 ? std::max(0.0f, -met->separation) : 0;
    if (overlap == 0 && dot(way, met->normal) >= 0) return {};
    return LocalShapeHit{hit.fraction, overlap, met->normal, met->point};
}

std::optional<ShapeHit> shape_hit(const Stores& stores, int shape, const Convex& moving,
                                  const Transform& start, Vec2 translation) {
    const ShapeRecord& record = stores.shapes[shape];
    const Transform xf = stores.bodies.transform(record.body);
    const RelativePose relative = relative_pose(start, xf);
    const Vec2 way = inverse_rotate(xf.q, translation);
    auto hit = cast_shape(record.convex(), moving, relative, way);
    if (hit && record.convex().is_chained()) hit = at_chain(record.convex(), moving, relative, way, *hit);
    if (!hit) return {};
    return ShapeHit{stores.shapes.id(shape),   body_of(stores, shape), transform_point(xf, hit->point),
                    rotate(xf.q, hit->normal), hit->fraction,          hit->overlap};
}

// Nothing for a segment of a chain that the point is behind of.
std::optional<SurfacePoint> surface_point(const Stores& stores, int shape, Position point) {
    const ShapeRecord& record = stores.shapes[shape];
    const Transform xf = stores.bodies.transform(record.body);
    const Convex speck = disc(0);
    const RelativePose pose{inverse_transform_point(xf, point), {}};
    if (is_behind(record.convex(), pose.p)) return {};
    const Clearance at = clearance(minkowski_difference(record.convex(), speck, pose));
    const Vec2 nearest = meeting_point(record.convex(), speck, pose, at);
    return SurfacePoint{stores.shapes.id(shape), body_of(stores, shape), transform_point(xf, nearest),
                        rotate(xf.q, at.normal), at.distance};
}

// The normals of the two edges at the corner that reaches farthest along the normal; the normal itself where
// the surface is flat there, or a circle.
std::pair<Vec2, Vec2> edge_normals(const Convex& shape, Vec2 normal) {
    constexpr float kCosineOfFlat = 0.9998f;  // of 1 degree
    if (shape.is_chained()) {
        if (dot(shape.normals[0], normal) > kCosineOfFlat) return {normal, normal};
        const bool at_start = dot(left_perp(shape.normals[0]), normal) < 0;
        return {shape.normals[at_start ? 2 : 0], shape.normals[at_start ? 0 : 3]};
    }
    int corner = 0;
    for (int i = 0; i < shape.count(); ++i) {
        if (shape.count() > 1 && dot(shape.normals[i], normal) > kCosineOfFlat) return {normal, normal};
        if (dot(shape.point(i), normal) > dot(shape.point(corner), normal)) corner = i;
    }
    if (shape.count() == 1) return {normal, normal};
    return {shape.normals[corner == 0 ? shape.count() - 1 : corner - 1], shape.normals[corner]};
}

// Nothing when they are farther apart.
std::optional<CollisionPlane> collision_plane(const Stores& stores, int shape, const Convex& moving,
                                              const Transform& pose, float reach) {
    const ShapeRecord& record = stores.shapes[shape];
    const Transform xf = stores.bodies.transform(record.body);
    const RelativePose relative = relative_pose(pose, xf);
    Meeting met;
    if (record.convex().is_chained()) {
        const auto at_front = meeting(record.convex(), moving, relative, reach);
        if (!at_front) return {};
        met = *at_front;
    } else {
        const Clearance at = clearance(minkowski_difference(record.convex(), moving, relative));
        if (at.distance > reach) return {};
        met = {meeting_point(record.convex(), moving, relative, at), at.normal, at.distance};
    }
    const auto [before, after] = edge_normals(record.convex(), met.normal);
    return CollisionPlane{stores.shapes.id(shape),
                          body_of(stores, shape),
                          transform_point(xf, met.point),
                          rotate(xf.q, met.normal),
                          met.separation,
                          rotate(xf.q, before),
                          rotate(xf.q, after),
                          stores.bodies.slots[record.body].type == BodyType::Dynamic};
}

bool overlaps(const Stores& stores, int shape, const Convex& other, const Transform& pose) {
    const ShapeRecord& record = stores.shapes[shape];
    const RelativePose relative = relative_pose(pose, stores.bodies.transform(record.body));
    if (is_behind(record.convex(), relative.p + rotate(relative.q, other.centroid))) return false;
    return clearance(minkowski_difference(record.convex(), other, relative)).distance <= 0;
}

// The box is clipped to the bounds of the shape first. That changes nothing about the answer, and then it is
// no larger than the shape, and as precise.
bool overlaps_box(const Stores& stores, int shape, Position lower, Position upper) {
    const ShapeRecord& record = stores.shapes[shape];
    const Transform xf = stores.bodies.transform(record.body);
    const Position middle{0.5 * lower.x + 0.5 * upper.x, 0.5 * lower.y + 0.5 * upper.y};
    if (is_behind(record.convex(), inverse_transform_point(xf, middle))) return false;
    const Extent own = extent(record.convex(), xf.q);
    const auto low = [](double box, double center, float bound) {
        return static_cast<float>(std::max(box - center, static_cast<double>(bound)));
    };
    const auto high = [](double box, double center, float bound) {
        return static_cast<float>(std::min(box - center, static_cast<double>(bound)));
    };
    const Vec2 l{low(lower.x, xf.p.x, own.lower.x), low(lower.y, xf.p.y, own.lower.y)};
    const Vec2 u{high(upper.x, xf.p.x, own.upper.x), high(upper.y, xf.p.y, own.upper.y)};
    if (l.x > u.x || l.y > u.y) return false;
    Convex box = disc(0);
    std::array<Vec2, kMaxPolygonVertices>& points = box.outline.points_m;
    if (l.x < u.x && l.y < u.y) {
        points = {l, {u.x, l.y}, u, {l.x, u.y}};
        box.outline.count = 4;
    } else {
        points = {l, u};
        box.outline.count = l == u ? 1 : 2;
    }
    return clearance(minkowski_difference(record.convex(), box, {{}, inverse(xf.q)})).distance <= 0;
}

// Calls visit(point) for the shapes whose surface, or inside, is within the radius.
template <class Visit>
void visit_near(const Stores& stores, Position point, float radius, const QueryFilter& filter,
                Visit&& visit) {
    const Aabb box = make_aabb(point, {-radius, -radius}, {radius, radius});
    visit_in_box(stores, box, filter, [&](int shape) {
        const auto found = surface_point(stores, shape, point);
        if (found && found->distance_m <= radius) visit(*found);
    });
}

}  // namespace

std::optional<RayHit> cast_ray_closest(const Stores& stores, Position origin_m, Vec2 translation_m,
                                       const QueryFilter& filter) {
    std::optional<RayHit> best;
    visit_along_ray(stores, origin_m, translation_m, filter, [&](int shape) {
        if (const auto hit = ray_hit(stores, shape, origin_m, translation_m)) take_first(best, *hit);
        return best ? best->fraction : 1;
    });
    return best;
}

std::vector<RayHit> cast_ray_all(const Stores& stores, Position origin_m, Vec2 translation_m,
                                 const QueryFilter& filter) {
    std::vector<RayHit> hits;
    visit_along_ray(stores, origin_m, translation_m, filter, [&](int shape) {
        if (const auto hit = ray_hit(stores, shape, origin_m, translation_m)) hits.push_back(*hit);
        return 1.0f;
    });
    return sorted(std::move(hits));
}

std::optional<ShapeHit> cast_shape_closest(const Stores& stores, const Convex& shape, const Transform& start,
                                           Vec2 translation_m, const QueryFilter& filter) {
    std::optional<ShapeHit> best;
    const Extent own = extent(shape, start.q);
    visit_along_way(stores, start.p, own.lower, own.upper, translation_m, filter, [&](int other) {
        if (const auto hit = shape_hit(stores, other, shape, start, translation_m)) take_first(best, *hit);
        return best ? best->fraction : 1;
    });
    return best;
}

std::vector<ShapeHit> cast_shape_all(const Stores& stores, const Convex& shape, const Transform& start,
                                     Vec2 translation_m, const QueryFilter& filter) {
    std::vector<ShapeHit> hits;
    const Extent own = extent(shape, start.q);
    visit_along_way(stores, start.p, own.lower, own.upper, translation_m, filter, [&](int other) {
        if (const auto hit = shape_hit(stores, other, shape, start, translation_m)) hits.push_back(*hit);
        return 1.0f;
    });
    return sorted(std::move(hits));
}

std::optional<ShapeId> shape_at(const Stores& stores, Position point_m, const QueryFilter& filter) {
    std::optional<ShapeId> last;
    visit_in_box(stores, make_aabb(point_m, {}, {}), filter, [&](int shape) {
        const ShapeRecord& record = stores.shapes[shape];
        const Vec2 local = inverse_transform_point(stores.bodies.transform(record.body), point_m);
        if (!contains_point(record.convex(), local)) return;
        if (!last || rank(stores.shapes.id(shape)) > rank(*last)) last = stores.shapes.id(shape);
    });
    return last;
}

std::vector<ShapeId> shapes_overlapping(const Stores& stores, const Convex& shape, const Transform& pose,
                                        const QueryFilter& filter) {
    std::vector<ShapeId> found;
    visit_in_box(stores, bounds(shape, pose), filter, [&](int other) {
        if (overlaps(stores, other, shape, pose)) found.push_back(stores.shapes.id(other));
    });
    return sorted(std::move(found));
}

std::vector<ShapeId> shapes_in_box(const Stores& stores, Position lower_m, Position upper_m,
                                   const QueryFilter& filter) {
    std::vector<ShapeId> found;
    const Aabb box{{round_down(lower_m.x), round_down(lower_m.y)},
                   {round_up(upper_m.x), round_up(upper_m.y)}};
    visit_in_box(stores, box, filter, [&](int shape) {
        if (overlaps_box(stores, shape, lower_m, upper_m)) found.push_back(stores.shapes.id(shape));
    });
    return sorted(std::move(found));
}

std::optional<SurfacePoint> closest_point(const Stores& stores, Position point_m, float radius_m,
                                          const QueryFilter& filter) {
    std::optional<SurfacePoint> best;
    visit_near(stores, point_m, radius_m, filter,
               [&](const SurfacePoint& found) { take_first(best, found); });
    return best;
}

std::vector<SurfacePoint> closest_points(const Stores& stores, Position point_m, float radius_m,
                                         const QueryFilter& filter) {
    std::vector<SurfacePoint> points;
    visit_near(stores, point_m, radius_m, filter,
               [&](const SurfacePoint& found) { points.push_back(found); });
    return sorted(std::move(points));
}

std::vector<CollisionPlane> collision_planes(const Stores& stores, const Convex& shape, const Transform& pose,
                                             float reach_m, const QueryFilter& filter) {
    std::vector<CollisionPlane> planes;
    const Extent own = extent(shape, pose.q);
    const Vec2 reach{reach_m, reach_m};
    visit_in_box(stores, make_aabb(pose.p, own.lower - reach, own.upper + reach), filter, [&](int other) {
        if (const auto plane = collision_plane(stores, other, shape, pose, reach_m)) planes.push_back(*plane);
    });
    return sorted(std::move(planes));
}

}  // namespace cairn::physics
