// Queries of all kinds, and the character that is moved by them.
#include <cmath>

#include "fuzz/world/session.h"

namespace cairn::physics::fuzz {

void Session::ask() {
    const Vec2 at = in_.hostile_vector(-10, 10);
    const Position from{static_cast<double>(at.x), static_cast<double>(at.y)};
    const Vec2 way = in_.hostile_vector(-20, 20);
    const Result<std::optional<RayHit>> ray = world_.cast_ray(from, way);
    require(!ray || (is_finite(at) && is_finite(way)), "rays that are not finite are refused");
    if (ray && *ray) {
        require(shapes_.is_there((*ray)->shape) && bodies_.is_there((*ray)->body),
                "a ray hits what is there");
        require((*ray)->fraction >= 0 && (*ray)->fraction <= 1, "a ray is hit between its ends");
    }
    const Result<std::vector<RayHit>> all = world_.cast_ray_all(from, way);
    require(static_cast<bool>(all) == static_cast<bool>(ray), "both casts refuse the same rays");
    if (all) require(all->empty() == !ray->has_value(), "there is a first hit when there is any");
    Description shape;
    describe_hostile(shape, in_);
    const Transform pose{from, Rotation::from_angle(static_cast<double>(in_.real(-4, 4)))};
    const auto met = world_.cast_shape(shape.geometry, pose, way);
    if (met && *met) require(shapes_.is_there((*met)->shape), "a moving shape meets what is there");
    const auto all_met = world_.cast_shape_all(shape.geometry, pose, way);
    require(static_cast<bool>(met) == static_cast<bool>(all_met), "both casts refuse the same shapes");
    if (all_met) require(all_met->empty() == !met->has_value(), "there is a first one met when any is");
    if (const auto overlapping = world_.shapes_overlapping(shape.geometry, pose)) {
        for (const ShapeId id : *overlapping) require(shapes_.is_there(id), "what overlaps is there");
    }
    if (const auto near = world_.closest_point(from, in_.hostile(0, 10)); near && *near) {
        require(shapes_.is_there((*near)->shape), "the nearest shape is there");
    }
    if (const auto planes = world_.collision_planes(shape.geometry, pose, in_.hostile(0, 1))) {
        for (const CollisionPlane& plane : *planes) {
            require(shapes_.is_there(plane.shape), "what limits a shape is there");
            require(std::abs(length(plane.normal) - 1) < 1e-3f, "the normal of a plane has length 1");
        }
    }
}

void Session::walk() {
    const Vec2 at = in_.hostile_vector(-10, 10);
    const Position place{static_cast<double>(at.x), static_cast<double>(at.y)};
    if (!mover_) {
        MoverDef def;
        def.capsule.radius_m = in_.hostile(0.1f, 1);
        def.step_height_m = in_.hostile(0, 0.5f);
        def.max_slope_rad = in_.hostile(0, 1.5f);
        def.push_force_n = in_.hostile(0, 1000);
        if (const Result<Mover> made = Mover::create(def, place)) mover_ = *made;
        return;
    }
    if (in_.below(8) == 7) {
        const Result<void> done = mover_->teleport(place);
        require(!done || is_finite(at), "places that are not finite are refused");
    } else {
        const Vec2 velocity = in_.hostile_vector(-20, 20);
        const Result<void> done = mover_->move(world_, velocity, in_.hostile(0, 0.1f));
        require(!done || is_finite(velocity), "velocities that are not finite are refused");
    }
    require(is_finite(mover_->position()) && is_finite(mover_->velocity()), "a character stays finite");
    if (mover_->is_grounded()) {
        require(std::abs(length(mover_->ground_normal()) - 1) < 1e-3f,
                "the normal of the ground has length 1");
    }
}

}  // namespace cairn::physics::fuzz
