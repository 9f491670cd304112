// Contacts in lanes between random bodies, as the stages of a step leave them to the passes.
#pragma once

#include <vector>

#include "physics/support/random.h"
#include "resolve/contact_constraint.h"
#include "resolve/contact_lanes.h"
#include "resolve/contact_passes.h"

namespace cairn::physics::test {

inline constexpr float kHeapSubstep_s = 1.0f / 240;
inline const ContactRules kHeapRules = make_contact_rules(kHeapSubstep_s, 3, 1);
inline const std::vector<BlockKind> kAllKinds{BlockKind::TwoBodies, BlockKind::OneBody, BlockKind::Carried};

struct Placed {
    ContactInput input;
    int bucket = 0;
    int lane = 0;
    ContactConstraint scalar;
};

// Bodies of all masses, with contacts between random pairs; some touch the world, some a body that moves but
// is not moved.
struct Heap {
    Motions motions;
    int first_free = 1;  // rows from here on are moved by contacts
    ContactLanes lanes;
    std::vector<Placed> placed;  // in the order of their buckets

    [[nodiscard]] ContactBlock& block(const Placed& p) { return lanes.block(p.lane / kLanes); }
    [[nodiscard]] PairBlock& pairs(const Placed& p) { return lanes.pairs(p.lane / kLanes); }
};

/// All blocks of a heap, in runs of one colour and kind.
class WholeHeap {
  public:
    explicit WholeHeap(Heap& heap);
    [[nodiscard]] const std::vector<ContactRun>& runs() const { return runs_; }

  private:
    std::vector<std::vector<ContactBlock*>> blocks_;
    std::vector<ContactRun> runs_;
};

/// Contacts of each kind in turn.
Heap make_heap(unsigned seed, const std::vector<BlockKind>& kinds, int free_bodies, int contacts);

}  // namespace cairn::physics::test
