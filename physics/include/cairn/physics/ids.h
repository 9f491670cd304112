// Typed generational handles. Invariant: the zero handle is null; a handle whose object is gone, or that
// belongs to another world, is recognised as such (a slot retires before its generation wraps; worlds share a
// tag only with the 65,535th made after them).
#pragma once

#include <compare>
#include <cstdint>

namespace cairn::physics {

/// Names one object of one world: 8 bytes, freely copied, stored and compared.
/// The fields are the world's business; ask `World` what a handle stands for.
template <class Tag>
struct Handle {
    std::uint64_t index1 : 24 = 0;      ///< slot number plus one; 0 is null
    std::uint64_t generation : 24 = 0;  ///< how often the slot was used before
    std::uint64_t world : 16 = 0;       ///< which world made it

    /// True for a handle that a world once gave out; it may still be stale.
    explicit constexpr operator bool() const { return index1 != 0; }
    friend constexpr bool operator==(const Handle&, const Handle&) = default;

    /// The handle as one number, for storing it elsewhere (a script, a user-data field).
    [[nodiscard]] constexpr std::uint64_t bits() const {
        return index1 | static_cast<std::uint64_t>(generation) << 24 |
               static_cast<std::uint64_t>(world) << 48;
    }
    [[nodiscard]] static constexpr Handle from_bits(std::uint64_t bits) {
        return make(bits, bits >> 24, bits >> 48);
    }
    /// From the lowest bits of each.
    [[nodiscard]] static constexpr Handle make(std::uint64_t index1, std::uint64_t generation,
                                               std::uint64_t world) {
        return {.index1 = index1 & 0xffffff, .generation = generation & 0xffffff, .world = world & 0xffff};
    }
};

using BodyId = Handle<struct BodyTag>;
using ShapeId = Handle<struct ShapeTag>;
using ChainId = Handle<struct ChainTag>;
using JointId = Handle<struct JointTag>;

}  // namespace cairn::physics
