// What shapes are made of, kept once for all that are made alike: most worlds are built of a few things, many
// times over, and what collision reads of those then fits the nearest cache.
// Invariant: no two prototypes are alike in all bits; one lasts as long as a shape is made of it, and stays
// where it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <cairn/physics/shape.h>

#include "collide/convex.h"

namespace cairn::physics {

struct ShapePrototype {
    Convex convex;
    ShapeDef def;              // without user_data and group: each shape has its own
    int users = 0;             // shapes that are made of it
    std::uint32_t place = 0;   // among all; of one that went, the place of the next such
    std::uint32_t digest = 0;  // of all bits of the first two
    float reach_m = 0;         // of the convex shape, from its centroid
};

class ShapePrototypes {
  public:
    /// For one shape more. What `convex` and `def` refer to may be part of a prototype. -0 is not 0.
    ShapePrototype* take(const Convex& convex, const ShapeDef& def);
    /// For one shape less.
    void release(ShapePrototype* prototype);
    /// No shape is made of any more.
    void clear();
    [[nodiscard]] std::size_t size() const { return prototypes_.size() - free_count_; }

  private:
    // Of a table with open addresses: where a prototype is found by its digest, or in the next slots.
    struct Slot {
        std::uint32_t digest = 0;
        std::uint32_t place = kEmpty;
    };
    static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

    [[nodiscard]] std::size_t home(std::uint32_t digest) const { return digest & (slots_.size() - 1); }
    [[nodiscard]] std::size_t after(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
    void grow_table();
    void put(Slot entry);

    std::vector<std::unique_ptr<ShapePrototype>> prototypes_;
    std::vector<Slot> slots_;            // a power of two; half of them at least are empty
    std::uint32_t first_free_ = kEmpty;  // place of one that went, for its memory
    std::uint32_t free_count_ = 0;
};

}  // namespace cairn::physics
