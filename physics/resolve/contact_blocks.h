// Contacts packed into blocks of eight, by colour, and the passes over them.
// Invariant: within a colour no body is moved by two lanes, so lanes and blocks of a colour may be solved in
// any order with the same result. Source: first-fit edge colouring in the order of the contacts.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "resolve/contact_block.h"
#include "resolve/contact_constraint.h"
#include "resolve/contact_kernels.h"

namespace cairn::physics {

/// Where a contact was packed.
struct ContactLane {
    int block = kNoBlock;  // that: nowhere
    int lane = 0;
    int bucket = 0;  // 2 * colour + kind of block

    explicit operator bool() const { return block != kNoBlock; }
};

/// What a lane holds after the substeps.
struct ContactOutcome {
    std::array<float, 2> impulse;
    std::array<float, 2>
        total_impulse;  // of the step; without reports that of the last substep stands for it
    std::array<float, 2> separation;
    float friction_impulse;
};

class ContactBlocks {
  public:
    /// Empties the blocks, for a step with this many rows.
    void start(int rows);

    /// Packs a contact. Nowhere, when it must be solved as a scalar: its bodies turn far in the step, or move
    /// without being moved, or have no colour left; or it has rolling resistance or a running surface, or a
    /// locked axis.
    ContactLane add(const ContactInput& contact, const Motions& motions, float dt_s);

    void warm_start(Motions& motions) const;
    void solve(Motions& motions, const ContactRules& rules, float h_s, Pass pass);

    [[nodiscard]] ContactOutcome outcome(const ContactLane& at) const;
    /// Calls visit(contact, outcome) for each packed contact.
    template <class Visit>
    void for_each_outcome(Visit&& visit) const {
        for (int i = 0; i < used_; ++i) {
            for (int lane = 0; lane < blocks_[i].used; ++lane)
                visit(blocks_[i].contact[lane], outcome({i, lane}));
        }
    }

  private:
    static constexpr int kColors = 32;
    static constexpr int kBuckets = 2 * kColors;

    [[nodiscard]] int open_block(int bucket);
    [[nodiscard]] int choose_bucket(const ContactInput& c, const Motions& motions, float dt_s);

    std::vector<std::uint32_t> colors_of_row_;
    // All blocks of a step, in the order of their first contacts; those of a bucket are chained. One pool for
    // all buckets grows to the most contacts ever seen and then stays.
    std::vector<ContactBlock> blocks_;
    int used_ = 0;
    std::array<int, kBuckets> first_{};  // block of each bucket
    std::array<int, kBuckets> last_{};
};

}  // namespace cairn::physics
