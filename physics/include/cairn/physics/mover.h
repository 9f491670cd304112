// A character that walks through a world: an upright capsule, moved by the host's wishes and not by forces.
// Written on the public queries alone, so a game that wants another kind of character can write its own
// beside it.
#pragma once

#include <optional>
#include <span>

#include <cairn/physics/world.h>

namespace cairn::physics {

/// The translation nearest to translation_m that stays gap_m in front of every plane; from nearer than that,
/// it leads out. Where the planes leave no such place, those of dynamic bodies yield first, and then all by
/// the same least amount. Exact; the order of the planes does not matter but for rounding.
Vec2 solve_planes(Vec2 translation_m, std::span<const CollisionPlane> planes, float gap_m);

struct MoverDef {
    Capsule capsule{{0, 0.3f}, {0, 1.5f}, 0.3f};  ///< about the mover's position; it never turns
    Vec2 up{0, 1};                                ///< unit
    float max_slope_rad = 0.87f;                  ///< steeper ground is a wall; 0..pi/2
    /// Steps up to this height are walked over, and ground that falls away by less is followed. >= 0
    float step_height_m = 0.25f;
    float push_force_n = 300;  ///< at most, against dynamic bodies in the way, >= 0
};

/// Moves a capsule so that it collides with the world and slides along what it meets. It keeps 5 mm away from
/// everything. The world does not know of it: nothing collides with it unless a kinematic body goes with it
/// (which the filter of `move` must then ignore). Each update:
///
///     Vec2 v = player.velocity() + dt_s * world.gravity();
///     v.x = 5 * stick;
///     if (jump && player.is_grounded()) v.y = 6;
///     player.move(world, v, dt_s);
///     world.step(dt_s);
class Mover {
  public:
    static Result<Mover> create(const MoverDef& def, Position position_m);

    /// Goes on by dt_s (0 < dt_s <= 1) at velocity_m_s. What it stood on takes it along first. On the ground
    /// it walks: the part of the velocity across `up` leads along the ground, up to the greatest slope, over
    /// steps and down with the ground, until the velocity has a part upward. Dynamic bodies in the way are
    /// pushed. What the filter hides is walked through.
    Result<void> move(World& world, Vec2 velocity_m_s, float dt_s, QueryFilter filter = {});
    /// Somewhere else at once, standing on nothing.
    Result<void> teleport(Position position_m);

    [[nodiscard]] Position position() const { return position_m_; }
    /// What is left of the wanted velocity. On the ground it is relative to the ground and level: the speed
    /// along it; in the air it is that in the world, with what moving ground gave when it was left.
    [[nodiscard]] Vec2 velocity() const { return velocity_m_s_; }

    /// Whether it stands on something that is not too steep, or between two floors that are, with no way
    /// down. The ground may be gone again when it is asked.
    [[nodiscard]] bool is_grounded() const { return ground_.has_value(); }
    [[nodiscard]] Vec2 ground_normal() const { return ground_ ? ground_->normal : Vec2{}; }
    [[nodiscard]] BodyId ground_body() const { return ground_ ? ground_->body : BodyId{}; }
    [[nodiscard]] ShapeId ground_shape() const { return ground_ ? ground_->shape : ShapeId{}; }
    [[nodiscard]] const MoverDef& def() const { return def_; }

  private:
    struct Ground {
        ShapeId shape{};
        BodyId body{};
        Vec2 normal{};
        Position point_m{};
        Transform pose{};    // of the body, when the mover came to rest on it
        Vec2 local_place{};  // of the mover, in the body's frame
    };

    Mover(const MoverDef& def, Position position_m);

    MoverDef def_;
    Position position_m_;
    Vec2 velocity_m_s_{};
    std::optional<Ground> ground_;
    float cosine_of_slope_;
};

}  // namespace cairn::physics
