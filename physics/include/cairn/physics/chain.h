// Chains: long outlines of segments that are solid from one side, for the ground and walls of a level.
//
//                       walking along the points, what is solid for others lies on the right
//
//            room:  1 -> 2                 island:  2 <- 1                  ground:
//                   ^    |                          |    ^                  <-----------------
//                   |    v                          v    |                  points from right to left:
//                   4 <- 3                          3 -> 4                  things stand on it
//            clockwise: things are         anticlockwise: things are
//            held inside                   kept outside
//
// Invariant: a chain of n points has n - 1 segments, or n when it is closed; each segment is a shape of the
// body, and nothing that slides along the chain feels the joins between segments.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cairn/physics/body.h>
#include <cairn/physics/ids.h>
#include <cairn/physics/shape.h>

namespace cairn::physics {

struct ChainDef {
    /// In the body's frame; copied. At least 2, or 3 when closed; neighbours at least 5 mm apart.
    std::span<const Vec2> points_m{};
    bool closed = false;  ///< a segment leads from the last point to the first
    /// Of an open chain: the points with which another chain goes on before the first point and after the
    /// last, so that nothing feels the join to it. An end without one is free: things may stand on it and
    /// round it, as if the chain turned squarely behind itself there.
    std::optional<Vec2> before_m{};
    std::optional<Vec2> after_m{};
    /// None for the standard material, one for all segments, or one for each segment.
    std::span<const Material> materials{};
    Filter filter{};
    bool contact_events = false;  ///< as in ShapeDef
    bool hit_events = false;      ///< as in ShapeDef
    std::uint64_t user_data = 0;  ///< of the chain and of each of its shapes
};

/// A chain of a world, found with `World::chain`. A view, as `Body` is: keep the ChainId instead. Changes
/// refresh the contacts of the segments that change shape, and wake what touches them or is near their new
/// place. They cost time in proportion to what changes, except that inserting and removing moves the list of
/// the points behind, and that the next step measures once how far the body reaches. Errors name the point by
/// its index and then nothing changes.
class Chain {
  public:
    [[nodiscard]] ChainId id() const { return id_; }
    [[nodiscard]] BodyId body() const;
    [[nodiscard]] bool is_closed() const;

    /// In the body's frame. Valid until the chain changes.
    [[nodiscard]] std::span<const Vec2> points() const;
    [[nodiscard]] int segment_count() const;
    /// Segment i leads from point i to the next one.
    Result<ShapeId> segment(int index) const;
    /// Which segment a shape is; nothing for shapes that are not of this chain. Searches the chain.
    [[nodiscard]] std::optional<int> index_of(ShapeId shape) const;

    Result<void> set_point(int index, Vec2 point_m);
    /// Before the point `index`, or after all when it is their number. New segments have the material of the
    /// one that they divide or go on from.
    Result<void> insert_points(int index, std::span<const Vec2> points_m);
    Result<void> remove_points(int first, int count);
    /// See ChainDef::before_m and after_m.
    Result<void> set_ends(std::optional<Vec2> before_m, std::optional<Vec2> after_m);

    [[nodiscard]] Material material(int segment) const;  ///< 0 <= segment < segment_count()
    Result<void> set_material(int segment, Material material);

    [[nodiscard]] std::uint64_t user_data() const;
    void set_user_data(std::uint64_t data);

  private:
    friend class World;
    Chain(WorldState& world, ChainId id) : world_(&world), id_(id) {}

    WorldState* world_;
    ChainId id_;
};

}  // namespace cairn::physics
