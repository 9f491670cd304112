// Which bodies stand, to the last bit, where they stood when contacts were updated last. What was found then
// about contacts between such bodies would be found again, so blocks of them are not looked at
// (docs/adr/021-rest.md).
// Invariant: nothing that a world does depends on it. It is no state: without it all blocks are looked at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/motion.h"
#include "base/place.h"
#include "base/task_pool.h"
#include "resolve/contact_block.h"

namespace cairn::physics {

class Unmoved {
  public:
    /// Of what there is when contacts are updated; it must all be as it was for anything to count as unmoved.
    struct Surroundings {
        std::uint64_t lanes_version = 0;
        Vec2 gravity_m_s2;

        bool operator==(const Surroundings&) const = default;
    };

    /// For so many rows, whether or not any are compared: what comes to stand later allocates nothing.
    void make_room(int rows);
    /// Before blocks are looked at: compares with the last time. `bodies` are those of the rows from 1 on.
    void compare(std::span<const Place> places, std::span<const int> bodies, const Motions& motions,
                 const Surroundings& now, TaskPool& tasks);
    /// To be told in a step in which it is not to be used, and when places or lanes are others.
    void forget() {
        is_known_ = false;
        some_ = false;
        all_ = false;
    }

    /// Whether some body is unmoved, and whether all are.
    [[nodiscard]] bool some() const { return some_; }
    [[nodiscard]] bool all() const { return all_; }
    [[nodiscard]] bool is(int row) const { return rows_[row] != 0; }
    /// Of the bodies of a block, by their rows of this step; the world itself is unmoved.
    [[nodiscard]] bool all_of(const ContactBlock& block) const {
        unsigned all = 1;
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            all &= static_cast<unsigned>(rows_[block.a[lane]] & rows_[block.b[lane]]);
        return all != 0;
    }

  private:
    struct Seen {
        Position center;
        Rotation rotation;
    };

    bool is_known_ = false;
    bool some_ = false;
    bool all_ = false;
    Surroundings seen_;
    std::vector<int> bodies_;
    std::vector<Seen> places_;        // by row
    std::vector<std::uint8_t> rows_;  // by row: 1 for those unmoved
};

}  // namespace cairn::physics
