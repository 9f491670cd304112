// Finding structures of joints that sweeping would not hold: what hangs together over joints, is deep, of
// uneven masses or on stiff springs, and takes few enough products to factor. Found again whenever joints
// come, go, wake or fall asleep, so most structures are refused by what is summed up of them, and only of the
// rest lists are made. Invariant: the order of structures, and what is in them, follow from the list of
// active joints alone.
#pragma once

#include <vector>

#include <cairn/physics/joint.h>

#include "base/union_find.h"
#include "resolve/direct/block_ldl.h"
#include "world/stiff_springs.h"

namespace cairn::physics {

struct Stores;

/// Joints, and the bodies that move of them and of what they touch.
struct DirectStructure {
    std::vector<int> joints;
    std::vector<int> bodies;
    bool only_free = false;  // solved directly only in steps in which nothing can touch it
};

class StructureSearch {
  public:
    /// Structures that are to be solved directly where springs of more than most_swept_hz are stiff, as the
    /// choice of the world says. Those of plain pins that would be but for their loops, and have pins whose
    /// loads are not known, are `without_loads`.
    void find(const Stores& stores, JointSolver solver, float most_swept_hz,
              std::vector<DirectStructure>& structures, std::vector<DirectStructure>& without_loads);
    /// Whether another most_swept_hz changes nothing of what was found.
    [[nodiscard]] bool holds_for(float most_swept_hz) const { return springs_.hold_for(most_swept_hz); }
    /// Empties the list, and keeps the memory of its structures for those that are found next.
    void recycle(std::vector<DirectStructure>& structures);

  private:
    struct Masses {
        float least_inverse = 0;  // of bodies that have mass; 0: none has
        float most_inverse = 0;

        void widen(float inverse_mass);
        [[nodiscard]] bool are_uneven(float ratio) const;
    };
    // What is known of a structure before it has lists.
    struct Summary {
        int joints = 0;
        int bodies = 0;
        Masses masses;
        bool is_held = false;     // by what does not move
        bool plain_pins = true;   // and nothing else
        bool lacks_load = false;  // of one of them
        int stiff_springs = 0;    // joints that have some
        bool holds = false;       // does more than draw by springs
        int listed = -1;          // place among the structures
    };

    Masses note_movers(const Stores& stores);
    [[nodiscard]] bool moves(int body) const { return moves_[static_cast<std::size_t>(body)] != 0; }
    [[nodiscard]] bool is_any_held(const Stores& stores) const;
    void join(const Stores& stores);
    void sum_up(const Stores& stores, float most_swept_hz);
    [[nodiscard]] static bool is_pendulum(const Summary& s);
    [[nodiscard]] static bool bears_with_few(const Summary& s);
    [[nodiscard]] static bool may_be_hard(const Summary& s);
    [[nodiscard]] static bool is_stiff(const Summary& s);
    void note_springs(const JointDef& def, float most_swept_hz, Summary& s);
    [[nodiscard]] static bool may_need_loads(const Summary& s);
    void list(const Stores& stores, JointSolver solver, std::vector<DirectStructure>& structures,
              std::vector<DirectStructure>& without_loads);
    void recycle(DirectStructure& structure);
    DirectStructure new_structure(const Summary& s);
    void number_bodies(const DirectStructure& s);
    // These want the bodies numbered.
    [[nodiscard]] bool is_hard_to_sweep(const DirectStructure& s, const Summary& summary,
                                        const Stores& stores);
    [[nodiscard]] bool is_open(const DirectStructure& s, const Stores& stores);
    [[nodiscard]] int depth_of(const DirectStructure& s, const Stores& stores);
    [[nodiscard]] double products_per_joint(const DirectStructure& s, const Stores& stores);

    StiffSprings springs_;
    std::vector<char> moves_;          // by body
    std::vector<float> inverse_mass_;  // by body, of awake ones
    UnionFind sets_;                   // of bodies
    UnionFind held_;                   // of local bodies, by joints that hold
    std::vector<int> first_;           // by place among the active joints: a body that moves, or kNone
    std::vector<int> of_root_;
    std::vector<char> seen_;
    std::vector<Summary> summaries_;
    std::vector<int> summary_of_;  // by place among the structures
    std::vector<DirectStructure> spare_;
    // Of one structure.
    std::vector<int> local_;  // by body
    std::vector<int> level_;  // by local body, 0: not reached
    std::vector<int> first_joint_;
    std::vector<int> joints_of_;
    std::vector<int> reached_;
    std::vector<BlockLdl::Node> nodes_;
    std::vector<BlockLdl::Edge> edges_;
    BlockLdl factors_;
};

}  // namespace cairn::physics
