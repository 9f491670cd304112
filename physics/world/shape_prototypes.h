// What shapes are made of, kept once for all that are made alike: most worlds are built of a few things, many
// times over, and what collision reads of those then fits the nearest cache.
// Invariant: no two prototypes are alike in all bits; one lasts as long as a shape is made of it, and stays
// where it is.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include <cairn/physics/shape.h>

#include "collide/convex.h"

namespace cairn::physics {

struct ShapePrototype {
    Convex convex;
    ShapeDef def;  // without user_data: each shape has its own

    bool operator==(const ShapePrototype& other) const;  // in all bits: -0 is not 0
};

class ShapePrototypes {
    struct Hash {
        std::size_t operator()(const ShapePrototype& prototype) const;
    };
    using Counts = std::unordered_map<ShapePrototype, int, Hash>;

  public:
    /// A prototype, and the number of the shapes that are made of it.
    using Shared = Counts::value_type;

    /// For one shape more. What `convex` and `def` refer to may be part of a prototype.
    Shared* take(const Convex& convex, const ShapeDef& def);
    /// For one shape more, made as another one.
    static Shared* take(Shared* shared) {
        ++shared->second;
        return shared;
    }
    /// For one shape less.
    void release(Shared* shared);
    /// No shape is made of any more.
    void clear();
    [[nodiscard]] std::size_t size() const { return counts_.size(); }

  private:
    Counts counts_;
    std::vector<Counts::node_type> spare_;  // of those that went, for their memory
};

}  // namespace cairn::physics
