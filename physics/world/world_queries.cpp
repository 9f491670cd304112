// The public queries: checks what comes from outside, then asks.
#include <cairn/physics/world.h>

#include "collide/convex.h"
#include "world/queries.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

constexpr float kLongest_m = 1e9f;

check::Fault validate_translation(const char* field, Vec2 translation) {
    if (auto fault = check::finite(field, translation)) return fault;
    const float longest = std::max(std::fabs(translation.x), std::fabs(translation.y));
    return check::require(longest <= kLongest_m, field, static_cast<double>(longest),
                          "at most 1e9 m along each axis");
}

check::Fault validate_length(const char* field, float length) {
    const auto value = static_cast<double>(length);
    if (auto fault = check::not_negative(field, value)) return fault;
    return check::require(length <= kLongest_m, field, value, "at most 1e9 m");
}

check::Fault validate_pose(const char* place, const char* rotation, const Transform& pose) {
    if (auto fault = check::placed(place, pose.p)) return fault;
    const double size = std::sqrt(static_cast<double>(pose.q.c) * static_cast<double>(pose.q.c) +
                                  static_cast<double>(pose.q.s) * static_cast<double>(pose.q.s));
    return check::require(std::fabs(size - 1) < 1e-3, rotation, size, "of size 1, as a cosine and sine are");
}

// What the function gives for the geometry in its convex form, or what is wrong with the arguments.
template <class Ask>
auto ask_with(const Geometry& geometry, const check::Fault& fault, Ask&& ask)
    -> Result<decltype(ask(std::declval<const Convex&>()))> {
    if (fault) return *fault;
    const Result<Convex> shape = make_convex(geometry);
    if (!shape) return shape.error();
    return ask(*shape);
}

check::Fault validate_ray(Position origin_m, Vec2 translation_m) {
    return check::first_of(
        {check::placed("ray.origin_m", origin_m), validate_translation("ray.translation_m", translation_m)});
}

check::Fault validate_shape_cast(const Transform& start, Vec2 translation_m) {
    return check::first_of({validate_pose("shape_cast.start.p", "shape_cast.start.q", start),
                            validate_translation("shape_cast.translation_m", translation_m)});
}

}  // namespace

Result<std::optional<RayHit>> World::cast_ray(Position origin_m, Vec2 translation_m,
                                              QueryFilter filter) const {
    if (auto fault = validate_ray(origin_m, translation_m)) return *fault;
    return cast_ray_closest(state_->stores, origin_m, translation_m, filter);
}

Result<std::vector<RayHit>> World::cast_ray_all(Position origin_m, Vec2 translation_m,
                                                QueryFilter filter) const {
    if (auto fault = validate_ray(origin_m, translation_m)) return *fault;
    return physics::cast_ray_all(state_->stores, origin_m, translation_m, filter);
}

Result<std::optional<ShapeHit>> World::cast_shape(const Geometry& geometry, const Transform& start,
                                                  Vec2 translation_m, QueryFilter filter) const {
    return ask_with(geometry, validate_shape_cast(start, translation_m), [&](const Convex& shape) {
        return cast_shape_closest(state_->stores, shape, start, translation_m, filter);
    });
}

Result<std::vector<ShapeHit>> World::cast_shape_all(const Geometry& geometry, const Transform& start,
                                                    Vec2 translation_m, QueryFilter filter) const {
    return ask_with(geometry, validate_shape_cast(start, translation_m), [&](const Convex& shape) {
        return physics::cast_shape_all(state_->stores, shape, start, translation_m, filter);
    });
}

Result<std::optional<ShapeId>> World::shape_at(Position point_m, QueryFilter filter) const {
    if (auto fault = check::placed("point_m", point_m)) return *fault;
    return physics::shape_at(state_->stores, point_m, filter);
}

Result<std::vector<ShapeId>> World::shapes_overlapping(const Geometry& geometry, const Transform& pose,
                                                       QueryFilter filter) const {
    return ask_with(geometry, validate_pose("pose.p", "pose.q", pose), [&](const Convex& shape) {
        return physics::shapes_overlapping(state_->stores, shape, pose, filter);
    });
}

Result<std::vector<ShapeId>> World::shapes_in_box(Position lower_m, Position upper_m,
                                                  QueryFilter filter) const {
    if (auto fault = check::first_of(
            {check::placed("box.lower_m", lower_m), check::placed("box.upper_m", upper_m),
             check::require(lower_m.x <= upper_m.x, "box.lower_m.x", lower_m.x, "at most upper_m.x"),
             check::require(lower_m.y <= upper_m.y, "box.lower_m.y", lower_m.y, "at most upper_m.y")})) {
        return *fault;
    }
    return physics::shapes_in_box(state_->stores, lower_m, upper_m, filter);
}

Result<std::optional<SurfacePoint>> World::closest_point(Position point_m, float radius_m,
                                                         QueryFilter filter) const {
    if (auto fault =
            check::first_of({check::placed("point_m", point_m), validate_length("radius_m", radius_m)})) {
        return *fault;
    }
    return physics::closest_point(state_->stores, point_m, radius_m, filter);
}

Result<std::vector<SurfacePoint>> World::closest_points(Position point_m, float radius_m,
                                                        QueryFilter filter) const {
    if (auto fault =
            check::first_of({check::placed("point_m", point_m), validate_length("radius_m", radius_m)})) {
        return *fault;
    }
    return physics::closest_points(state_->stores, point_m, radius_m, filter);
}

Result<std::vector<CollisionPlane>> World::collision_planes(const Geometry& geometry, const Transform& pose,
                                                            float reach_m, QueryFilter filter) const {
    const auto fault =
        check::first_of({validate_pose("pose.p", "pose.q", pose), validate_length("reach_m", reach_m)});
    return ask_with(geometry, fault, [&](const Convex& shape) {
        return physics::collision_planes(state_->stores, shape, pose, reach_m, filter);
    });
}

}  // namespace cairn::physics
