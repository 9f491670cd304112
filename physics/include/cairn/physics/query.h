// Questions to the world between steps.
#pragma once

#include <cstdint>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>

namespace cairn::physics {

/// Which shapes a query sees: those of a category in `mask` that would also collide with `categories`.
struct QueryFilter {
    std::uint64_t categories = ~std::uint64_t{0};
    std::uint64_t mask = ~std::uint64_t{0};
};

/// Where a ray first met a shape from outside. A ray that starts inside a shape does not see that shape.
struct RayHit {
    ShapeId shape{};
    BodyId body{};
    Position point_m{};
    Vec2 normal{};       ///< unit, out of the shape
    float fraction = 0;  ///< of the ray's length, 0..1
};

}  // namespace cairn::physics
