// Questions to the world between steps.
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>

namespace cairn::physics {

/// The host's own say in what a query sees: a reference to a function object `bool(ShapeId, BodyId)`. It is
/// asked from within the query, in no promised order, and may read the world but not change it: meanwhile to
/// make or to destroy anything is an error. The object must live until the query returns, so write a lambda
/// into the call itself, or give it a name.
class ShapeFilter {
  public:
    ShapeFilter() = default;

    template <class Function>
    requires(std::is_object_v<Function>&& std::is_invocable_r_v<bool, const Function&, ShapeId, BodyId>)
        ShapeFilter(const Function& function)  // NOLINT: conversion is the point
        : object_(std::addressof(function)),
          call_([](const void* object, ShapeId shape, BodyId body) -> bool {
              return (*static_cast<const Function*>(object))(shape, body);
          }) {}

    /// False when made from nothing.
    [[nodiscard]] bool asks() const { return call_ != nullptr; }

    /// Accepts everything when made from nothing.
    bool operator()(ShapeId shape, BodyId body) const {
        return call_ == nullptr || call_(object_, shape, body);
    }

  private:
    const void* object_ = nullptr;
    bool (*call_)(const void*, ShapeId, BodyId) = nullptr;
};

/// Which shapes a query sees: those of a category in `mask` that would also collide with `categories`, are
/// not of `ignored_body`, and that `accepts` accepts.
struct QueryFilter {
    std::uint64_t categories = ~std::uint64_t{0};
    std::uint64_t mask = ~std::uint64_t{0};
    BodyId ignored_body{};  ///< say the one that asks; null: none
    ShapeFilter accepts{};
};

/// Where a ray first met a shape from outside. A ray that starts inside a shape does not see that shape.
struct RayHit {
    ShapeId shape{};
    BodyId body{};
    Position point_m{};
    Vec2 normal{};       ///< unit, out of the shape
    float fraction = 0;  ///< of the ray's length, 0..1
};

/// Where a moving shape first touched one of the world. A shape that it overlaps at the start is met at
/// fraction 0, with the depth of the overlap; one that it only touches at the start is met if it moves into
/// it.
struct ShapeHit {
    ShapeId shape{};
    BodyId body{};
    Position point_m{};   ///< on the shape of the world; the middle where edges meet
    Vec2 normal{};        ///< unit, out of that shape; of an overlap, the direction of the shortest way out
    float fraction = 0;   ///< of the translation, 0..1
    float overlap_m = 0;  ///< how long that way is; 0 unless they overlapped at the start
};

/// The nearest point of a shape's surface.
struct SurfacePoint {
    ShapeId shape{};
    BodyId body{};
    Position point_m{};
    Vec2 normal{};         ///< unit, out of the shape
    float distance_m = 0;  ///< negative inside the shape
};

/// A line between a shape that wants to move and one of the world: as long as the former stays in front of
/// it, the two do not overlap.
struct CollisionPlane {
    ShapeId shape{};
    BodyId body{};
    Position point_m{};      ///< of the other shape's surface, nearest to the one that moves
    Vec2 normal{};           ///< unit, towards the one that moves
    float separation_m = 0;  ///< between the surfaces, along the normal; negative when they overlap
    Vec2 normal_before{};    ///< of the two edges that meet at a corner there, else as `normal`
    Vec2 normal_after{};
    bool is_dynamic = false;  ///< whether the other body could give way
};

}  // namespace cairn::physics
