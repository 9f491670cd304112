// Which bodies rest, to the last bit, as the last step left them. The passes would leave them so again, so
// what is solved together is not solved where all of it rests (docs/adr/021-rest.md).
// Invariant: nothing that a world does depends on it. It is no state: without it all is solved.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/motion.h"
#include "resolve/contact_batches.h"
#include "resolve/contact_constraint.h"
#include "world/unmoved.h"

namespace cairn::physics {

class Resting {
  public:
    /// What all contacts of a step have in common.
    struct Common {
        float h_s = 0;
        ContactRules rules;

        bool operator==(const Common&) const = default;
    };

    /// Before the first substep, of so many rows.
    void begin(int rows, const Common& now);
    /// After that: compares rows from first up to, and without, last, with what rested in the last step. The
    /// result is how many of them the passes would leave as they are.
    int compare(const Motions& motions, const Unmoved& unmoved, int first, int last);
    /// After the last substep.
    void note(const Motions& motions);
    /// To be told in a step in which nothing is looked for that stands.
    void forget() {
        rests_.clear();
        same_ = false;
    }

    /// Whether the passes would leave all those rows as they are.
    [[nodiscard]] bool all_of(std::span<const RowRange> ranges) const;

  private:
    // All but contacts that the first substep makes a row's velocity from.
    struct Acting {
        Vec2 kick_m_s;
        float kick_w = 0;
        float kept = 1;
        float kept_w = 1;
        float inverse_mass = 0;
        float k = 0;
        float rounding_m_s = 0;

        bool operator==(const Acting&) const = default;
    };

    static Acting acting_on(const Motions& motions, int row);

    Common seen_;
    bool same_ = false;  // what all have in common is
    // By row, of the last step: 1 for what it found at rest and left so. Empty where that was not looked for.
    std::vector<std::uint8_t> rests_;
    std::vector<Acting> acting_;            // by row
    std::vector<std::uint8_t> candidates_;  // by row: 1 for what is found at rest, where it was
    std::vector<std::uint8_t> known_;       // by row: 1 for those that the passes would leave as they are
};

}  // namespace cairn::physics
