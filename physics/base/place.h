// Where a body is, as collision reads it: one half of a cache line per body, in the body's slot.
#pragma once

#include <cstdint>

#include <cairn/physics/math.h>

namespace cairn::physics {

/// What collision must know of a body besides where it is. They are set anew in each step.
namespace place_flag {
inline constexpr std::uint32_t kFast = 1;      ///< could pass through others in this step
inline constexpr std::uint32_t kTurnsFar = 2;  ///< separations are not linear in its angle
inline constexpr std::uint32_t kDirect =
    8;  ///< is solved with what it is joined to and touches (world/direct_groups.h)
inline constexpr std::uint32_t kBoxesMoved = 4;  ///< a box of the broad phase was made anew
inline constexpr std::uint32_t kRouses = 16;     ///< could reach something that sleeps before it is seen
inline constexpr std::uint32_t kPushed = 64;     ///< is being moved out of what it was put into
inline constexpr std::uint32_t kWhirls = 32;     ///< turns so far that no straight way tells what it meets
inline constexpr std::uint32_t kStrayed = 128;   ///< has a way, and went another one than was expected
inline constexpr std::uint32_t kHasWay = 256;    ///< so fast that its boxes go with it: BroadPhase::move
inline constexpr std::uint32_t kSweeps = 1024;   ///< is long, and turns so far that its normals do too
inline constexpr std::uint32_t kHasty = 2048;    ///< could be deep in others before their contacts see it
inline constexpr std::uint32_t kLost = 512;      ///< fast, and the centre of a shape left the box it began in
}  // namespace place_flag

struct alignas(32) Place {
    Position center;  // of mass, m
    Rotation rotation;
    std::int32_t row = 0;  // among the motions of a step; that of the world itself unless the body is awake
    std::uint32_t flags = 0;
};

static_assert(sizeof(Place) == 32);

}  // namespace cairn::physics
