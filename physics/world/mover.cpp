// Collide and slide. A plane between two convex shapes keeps them apart on its own, so shapes that the
// capsule already touches are kept out by planes, and the others by a cast: together nothing is ever entered.
// Source: Fauerby, "Improved Collision Detection and Response", 2003, for the sliding; the planes instead of
// his iterated projections make corners exact.
#include <algorithm>

#include <cairn/physics/mover.h>
#include <cairn/physics/tuning.h>

#include "base/check.h"
#include "collide/convex.h"

namespace cairn::physics {
namespace {

// m. Kept between the capsule and everything, so that rounding never counts as touching.
constexpr float kGap_m = tuning::kLinearSlop_m;
// m. Shapes no farther than this are touched. Much more than rounding, much less than the gap.
constexpr float kTouching_m = kGap_m + 1e-4f;
// m. Motion too small to see; what is left when a way is blocked.
constexpr float kStill_m = 1e-5f;
// m. Farther out the queries would refuse places.
constexpr double kFarthestMover_m = 1e11;
constexpr float kFastest_m_s = 1e6f;

/// The surroundings of one call of Mover::move.
struct Surroundings {
    const World& world;
    const MoverDef& def;
    const QueryFilter& filter;
    float cosine_of_slope;
    Vec2 right;          // unit, across `up`
    Position start_m{};  // of the move
    Vec2 wish_m_s{};     // the way it wants to go

    [[nodiscard]] std::vector<CollisionPlane> touched(Position at) const {
        return world.collision_planes(def.capsule, {at, {}}, kTouching_m, filter).value();
    }

    [[nodiscard]] Position foot(Position at) const {
        const float lowest = std::min(dot(def.capsule.a_m, def.up), dot(def.capsule.b_m, def.up));
        return at + (lowest - def.capsule.radius_m) * def.up;
    }

    // Whether the capsule is wholly on the side from which a shape is solid. Most are solid from all sides.
    [[nodiscard]] bool meets(ShapeId id, BodyId body) const {
        const Shape shape = world.shape(id).value();
        const Vec2 local_normal = shape.one_way_normal();
        if (local_normal == Vec2{}) return true;
        const Transform pose = world.body(body)->transform();
        const Vec2 normal = rotate(pose.q, local_normal);
        const Outline& outline = shape.outline();
        float surface = dot(outline.points_m[0], local_normal);
        for (int i = 1; i < outline.count; ++i)
            surface = std::max(surface, dot(outline.points_m[i], local_normal));
        surface += outline.radius_m;
        const Vec2 place = start_m - pose.p;
        const float lowest =
            std::min(dot(place + def.capsule.a_m, normal), dot(place + def.capsule.b_m, normal)) -
            def.capsule.radius_m;
        return lowest >= surface - kStill_m;
    }

    // The flatter of the edges that meet where the plane touches.
    [[nodiscard]] Vec2 flatter_edge(const CollisionPlane& plane) const {
        return dot(plane.normal_after, def.up) > dot(plane.normal_before, def.up) ? plane.normal_after
                                                                                  : plane.normal_before;
    }

    [[nodiscard]] bool is_level(Vec2 normal) const { return dot(normal, def.up) >= cosine_of_slope; }

    // Ground is what is level enough. The round bottom touches the corner of a step at a steep angle though
    // what lies behind is level: that is ground too where the step is low, and one walks up to it or level
    // ground is below.
    [[nodiscard]] bool is_ground(const CollisionPlane& plane, Position at) const {
        if (dot(plane.normal, def.up) <= 1e-3f) return false;
        if (is_level(plane.normal)) return true;
        if (!is_level(flatter_edge(plane))) return false;
        const float risen = std::max(0.0f, dot(at - start_m, def.up));
        if (dot(plane.point_m - foot(at), def.up) + risen > def.step_height_m) return false;
        const bool walks_up_to_it = dot(wish_m_s, right) * dot(plane.normal, right) < 0;
        return walks_up_to_it || is_above_level_ground(at);
    }

    [[nodiscard]] bool is_above_level_ground(Position at) const {
        const float radius = def.capsule.radius_m;
        const Position center = foot(at) + radius * def.up;
        const auto below = world.cast_ray(center, -(radius + def.step_height_m) * def.up, filter).value();
        return below && is_level(below->normal);
    }

    [[nodiscard]] Vec2 ground_normal(const CollisionPlane& plane) const {
        const Vec2 edge = flatter_edge(plane);
        return is_level(edge) ? edge : plane.normal;
    }

    [[nodiscard]] bool is_steep_floor(const CollisionPlane& plane, Position at) const {
        return dot(plane.normal, def.up) > 1e-3f && std::fabs(dot(plane.normal, right)) >= 1e-3f &&
               !is_ground(plane, at);
    }

    // A floor too steep to stand on also blocks like a wall: what runs against it may not be led up.
    void add_walls(std::vector<CollisionPlane>& planes, Position at) const {
        const std::size_t count = planes.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (!is_steep_floor(planes[i], at)) continue;
            CollisionPlane wall = planes[i];
            const float across = dot(wall.normal, right);
            wall.normal = across > 0 ? right : -right;
            wall.separation_m = kGap_m + std::max(0.0f, wall.separation_m - kGap_m) / std::fabs(across);
            planes.push_back(wall);
        }
    }

    [[nodiscard]] std::optional<ShapeHit> first_untouched(Position from, Vec2 translation,
                                                          std::span<const CollisionPlane> planes) const {
        const auto is_untouched = [&](ShapeId shape, BodyId body) {
            return std::none_of(planes.begin(), planes.end(),
                                [&](const CollisionPlane& plane) { return plane.shape == shape; }) &&
                   filter.accepts(shape, body);
        };
        QueryFilter untouched = filter;
        untouched.accepts = is_untouched;
        Capsule grown = def.capsule;
        grown.radius_m += kGap_m;
        return world.cast_shape(grown, {from, {}}, translation, untouched).value();
    }

    // How far straight on it can go, as a fraction.
    [[nodiscard]] float free_fraction(Position from, Vec2 translation) const {
        const std::vector<CollisionPlane> planes = touched(from);
        for (const CollisionPlane& plane : planes) {
            if (dot(plane.normal, translation) < -kStill_m) return 0;
        }
        const auto hit = first_untouched(from, translation, planes);
        return hit ? hit->fraction : 1;
    }

    [[nodiscard]] Position slide(Position at, Vec2 rest) const {
        // Each round ends at a new shape; a wedge of two ends the motion, the rest is for curved
        // surroundings.
        constexpr int kMaxRounds = 8;
        for (int round = 0; round < kMaxRounds; ++round) {
            std::vector<CollisionPlane> planes = touched(at);
            add_walls(planes, at);
            const Vec2 step = solve_planes(rest, planes, kGap_m);
            if (length(step) < kStill_m) break;
            const auto hit = first_untouched(at, step, planes);
            const float fraction = hit ? hit->fraction : 1;
            at = at + fraction * step;
            if (!hit) break;
            rest = (1 - fraction) * step;
        }
        return at;
    }

    [[nodiscard]] const CollisionPlane* best_ground(std::span<const CollisionPlane> planes,
                                                    Position at) const {
        const CollisionPlane* best = nullptr;
        for (const CollisionPlane& plane : planes) {
            if (!is_ground(plane, at)) continue;
            const float up = dot(ground_normal(plane), def.up);
            if (!best || up > dot(ground_normal(*best), def.up)) best = &plane;
        }
        return best;
    }

    // Between two floors that are too steep by themselves, on either side: there is no way down. The flatter
    // one.
    [[nodiscard]] const CollisionPlane* notch(std::span<const CollisionPlane> planes, Position at) const {
        const CollisionPlane* best = nullptr;
        bool rises_left = false;
        bool rises_right = false;
        for (const CollisionPlane& plane : planes) {
            if (!is_steep_floor(plane, at)) continue;
            (dot(plane.normal, right) > 0 ? rises_left : rises_right) = true;
            if (!best || dot(plane.normal, def.up) > dot(best->normal, def.up)) best = &plane;
        }
        return rises_left && rises_right ? best : nullptr;
    }

    // Straight down onto ground by at most `drop`, if there is any.
    [[nodiscard]] std::optional<Position> lowered(Position at, float drop) const {
        const Vec2 down = -drop * def.up;
        const float fraction = free_fraction(at, down);
        if (fraction >= 1) return {};
        const Position landed = at + fraction * down;
        if (!best_ground(touched(landed), landed)) return {};
        return landed;
    }

    // Where it gets by going up, on, and down again, when that is farther than to slide.
    [[nodiscard]] std::optional<Position> stepped(Position from, Vec2 translation, Position slid) const {
        const float onward = dot(translation, right);
        const auto progress = [&](Position to) {
            return dot(to - from, right) * (onward > 0 ? 1.0f : -1.0f);
        };
        if (progress(slid) >= std::fabs(onward) - kStill_m) return {};
        const float rise = def.step_height_m * free_fraction(from, def.step_height_m * def.up);
        if (rise < kStill_m) return {};
        const Position over = slide(from + rise * def.up, onward * right);
        if (progress(over) <= progress(slid) + kStill_m) return {};
        return lowered(over, dot(over - from, def.up) + kGap_m);
    }

    [[nodiscard]] Position walk(Position from, Vec2 translation) const {
        Position to = slide(from, translation);
        if (const auto over = stepped(from, translation, to)) to = *over;
        if (best_ground(touched(to), to)) return to;
        return lowered(to, def.step_height_m + kGap_m).value_or(to);
    }
};

// Of velocities, and of ways within a step.
bool is_moderate(Vec2 v) {
    return std::fabs(v.x) <= kFastest_m_s && std::fabs(v.y) <= kFastest_m_s;
}

// What is faster than a mover can be carries none.
Vec2 velocity_of(const World& world, BodyId body, Position point) {
    const auto found = world.body(body);
    const Vec2 velocity = found ? found->velocity_at(point) : Vec2{};
    return is_moderate(velocity) ? velocity : Vec2{};
}

// What pushes has the given force and does not make a body faster than it is itself.
void push(World& world, const CollisionPlane& plane, Vec2 velocity, float greatest_impulse) {
    Body body = world.body(plane.body).value();
    const float closing = -dot(plane.normal, velocity - body.velocity_at(plane.point_m));
    const MassData mass = body.mass_data();
    if (closing <= 0 || mass.mass_kg <= 0) return;
    const float lever = cross(plane.point_m - body.world_center(), plane.normal);
    const float yielding =
        1 / mass.mass_kg + (mass.inertia_kg_m2 > 0 ? lever * lever / mass.inertia_kg_m2 : 0);
    const float impulse = std::min(greatest_impulse, closing / yielding);
    body.apply_impulse(-impulse * plane.normal, plane.point_m).value();
}

check::Fault validate_place(Position p) {
    if (auto fault = check::finite("mover.position_m", p)) return fault;
    const double farthest = std::max(std::fabs(p.x), std::fabs(p.y));
    return check::require(farthest <= kFarthestMover_m, "mover.position_m", farthest,
                          "within 1e11 m of the world's origin");
}

check::Fault validate(const MoverDef& def) {
    const auto number = [](float x) { return static_cast<double>(x); };
    const Result<Convex> capsule = make_convex(def.capsule);
    if (!capsule) return capsule.error();
    return check::first_of(
        {check::finite("mover.up", def.up),
         check::require(std::fabs(length(def.up) - 1) < 1e-3f, "the length of mover.up",
                        number(length(def.up)), "1"),
         check::within("mover.max_slope_rad", number(def.max_slope_rad), 0, number(kPi) / 2),
         check::not_negative("mover.step_height_m", number(def.step_height_m)),
         check::require(def.step_height_m <= 1e6f, "mover.step_height_m", number(def.step_height_m),
                        "at most 1e6 m"),
         check::not_negative("mover.push_force_n", number(def.push_force_n))});
}

check::Fault validate_move(Vec2 velocity, float dt_s) {
    if (auto fault = check::finite("mover.velocity_m_s", velocity)) return fault;
    const float fastest = std::max(std::fabs(velocity.x), std::fabs(velocity.y));
    return check::first_of({check::require(fastest <= kFastest_m_s, "mover.velocity_m_s",
                                           static_cast<double>(fastest), "at most 1e6 m/s along each axis"),
                            check::require(dt_s > 0 && dt_s <= 1, "mover.dt_s", static_cast<double>(dt_s),
                                           "greater than 0 and at most 1 s")});
}

}  // namespace

Mover::Mover(const MoverDef& def, Position position_m)
    : def_(def),
      position_m_(position_m),
      cosine_of_slope_(static_cast<float>(deterministic::cos(static_cast<double>(def.max_slope_rad)))) {
    def_.up = normalized(def.up);
}

Result<Mover> Mover::create(const MoverDef& def, Position position_m) {
    if (auto fault = check::first_of({validate(def), validate_place(position_m)})) return *fault;
    return Mover(def, position_m);
}

Result<void> Mover::teleport(Position position_m) {
    if (auto fault = validate_place(position_m)) return *fault;
    position_m_ = position_m;
    ground_.reset();
    return {};
}

Result<void> Mover::move(World& world, Vec2 velocity_m_s, float dt_s, QueryFilter filter) {
    if (auto fault = check::first_of({validate_move(velocity_m_s, dt_s), validate_place(position_m_)})) {
        return *fault;
    }
    if (ground_ && !world.contains(ground_->body)) ground_.reset();
    QueryFilter solid = filter;
    Surroundings around{world, def_, solid, cosine_of_slope_, right_perp(def_.up), position_m_};
    // What carries it stays solid, though it may have moved into it since.
    const ShapeId carrier = ground_shape();
    const auto is_solid = [&](ShapeId shape, BodyId body) {
        return filter.accepts(shape, body) && (shape == carrier || around.meets(shape, body));
    };
    solid.accepts = is_solid;

    // What it stands on has moved since: go along.
    Vec2 ground_velocity;
    if (ground_) {
        const Transform pose = world.body(ground_->body)->transform();
        const Vec2 carried = transform_point(pose, ground_->local_place) -
                             transform_point(ground_->pose, ground_->local_place);
        ground_velocity = velocity_of(world, ground_->body, ground_->point_m);
        if (!(carried == Vec2{}) && is_moderate(carried)) position_m_ = around.slide(position_m_, carried);
    }

    const bool walks = ground_ && dot(velocity_m_s, def_.up) <= 0;
    Vec2 own_velocity = velocity_m_s;  // relative to the ground while it walks
    if (walks) own_velocity = dot(velocity_m_s, around.right) * right_perp(ground_->normal);
    if (ground_ && !walks) own_velocity += ground_velocity;
    around.start_m = position_m_;
    around.wish_m_s = own_velocity;
    const Vec2 translation = dt_s * own_velocity;
    position_m_ = walks ? around.walk(position_m_, translation) : around.slide(position_m_, translation);

    Vec2 velocity = walks ? own_velocity + ground_velocity : own_velocity;  // in the world
    const std::vector<CollisionPlane> planes = around.touched(position_m_);
    for (const CollisionPlane& plane : planes) {
        if (plane.is_dynamic && !around.is_ground(plane, position_m_)) {
            push(world, plane, velocity, dt_s * def_.push_force_n);
        }
    }

    const CollisionPlane* ground = around.best_ground(planes, position_m_);
    const bool in_notch = ground == nullptr;
    if (in_notch) ground = around.notch(planes, position_m_);
    if (ground && !walks) {
        const Vec2 relative = velocity - velocity_of(world, ground->body, ground->point_m);
        if (dot(relative, def_.up) > 0) ground = nullptr;  // just leaving
    }
    if (!ground) {
        ground_.reset();
        // Down a steep floor the fall goes on: the floor takes its part in the next move anyway, and a host
        // that sets the speed across itself would lose what the floor turned into it.
        std::vector<CollisionPlane> limits = planes;
        around.add_walls(limits, position_m_);
        std::erase_if(limits,
                      [&](const CollisionPlane& plane) { return around.is_steep_floor(plane, position_m_); });
        for (CollisionPlane& limit : limits) limit.separation_m = 0;
        velocity_m_s_ = solve_planes(velocity, limits, 0);
        return {};
    }
    const Vec2 normal = in_notch ? def_.up : around.ground_normal(*ground);
    const Vec2 along = right_perp(normal);
    const Vec2 ground_gave = ground_velocity - velocity_of(world, ground->body, ground->point_m);
    float speed = walks ? dot(velocity_m_s, around.right) + dot(ground_gave, along)
                        : dot(velocity - velocity_of(world, ground->body, ground->point_m), around.right);
    for (const CollisionPlane& plane : planes) {
        const bool is_blocked = dot(plane.normal, speed * along) < -1e-3f * std::fabs(speed);
        if (is_blocked && !around.is_ground(plane, position_m_)) speed = 0;
    }
    velocity_m_s_ = speed * around.right;
    const Transform pose = world.body(ground->body)->transform();
    ground_ = Ground{ground->shape,   ground->body, normal,
                     ground->point_m, pose,         inverse_transform_point(pose, position_m_)};
    return {};
}

}  // namespace cairn::physics
