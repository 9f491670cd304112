// Union-find over joints, sums of each set, and then lists of those few that may qualify.
#include "world/direct_structures.h"

#include <algorithm>
#include <span>

#include "base/prefetch.h"
#include "world/direct_groups.h"
#include "world/joint_lists.h"
#include "world/world_state.h"

namespace cairn::physics {
namespace {

// Of a structure: a sweep needs some 2.3 rounds per decimal digit, times mass ratio, times depth. Fewer
// joints are swept, but for pendulums that swing freely, which a sweep would make soft for the sake of what
// touches them, and where masses are as uneven as those of contacts that are solved directly.
constexpr int kFewestJoints = 3;
constexpr float kMassRatio = 8;
constexpr int kDepth = 8;  // from what holds the structure; one that is not held bears no load
// Loops fill the factors: with more than this many joints per body, plus a few, nobody looks further.
constexpr float kJointsPerBody = 1.25f;
constexpr int kSpareJoints = 8;
// A chain takes 4 products of blocks per joint; three sweeps cost about as much as 16.
constexpr double kMaxProducts = 16;
// Stiff springs are swept sixteen times by themselves where they share bodies, and sag too far then.
constexpr float kStiffJointsPerBody = 3;
constexpr double kMaxStiffProducts = 64;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// Calls visit(joint) for active joints, and asks for their records ahead.
template <class Visit>
void for_each_active(const Stores& stores, const Visit& visit) {
    const auto ask = [&](int joint) {
        const JointRecord& record = stores.joints.slots[joint];
        prefetch(&record.def, sizeof record.def + sizeof record.body_a + sizeof record.body_b);
    };
    visit_asking_ahead(std::span(stores.joints.active.begin(), stores.joints.active.end()), kRecordsAhead,
                       ask, visit);
}

}  // namespace

void StructureSearch::Masses::widen(float inverse_mass) {
    if (inverse_mass <= 0) return;
    if (least_inverse == 0 || inverse_mass < least_inverse) least_inverse = inverse_mass;
    most_inverse = std::max(most_inverse, inverse_mass);
}

bool StructureSearch::Masses::are_uneven(float ratio) const {
    return least_inverse > 0 && most_inverse / least_inverse > ratio;
}

void StructureSearch::find(const Stores& stores, JointSolver solver, float most_swept_hz,
                           std::vector<DirectStructure>& structures,
                           std::vector<DirectStructure>& without_loads) {
    springs_.forget();
    recycle(without_loads);
    recycle(structures);
    if (solver == JointSolver::Sweeping || stores.joints.active.size() == 0) return;
    const Masses masses = note_movers(stores);
    // What nothing holds, of masses like each other, is swept: ragdolls that tumble need no lists.
    static_assert(kMassRatio <= kUnevenMasses);
    if (solver != JointSolver::Direct && !masses.are_uneven(kMassRatio) && !is_any_held(stores)) return;
    join(stores);
    sum_up(stores, most_swept_hz);
    list(stores, solver, structures, without_loads);
}

// The last one first, so that they come back in their order.
void StructureSearch::recycle(std::vector<DirectStructure>& structures) {
    for (std::size_t i = structures.size(); i-- > 0;) recycle(structures[i]);
    structures.clear();
}

void StructureSearch::recycle(DirectStructure& structure) {
    structure.joints.clear();
    structure.bodies.clear();
    structure.only_free = false;
    spare_.push_back(std::move(structure));
}

DirectStructure StructureSearch::new_structure(const Summary& s) {
    DirectStructure made;
    if (!spare_.empty()) {
        made = std::move(spare_.back());
        spare_.pop_back();
    }
    made.joints.reserve(at(s.joints));
    made.bodies.reserve(at(s.bodies));
    return made;
}

StructureSearch::Masses StructureSearch::note_movers(const Stores& stores) {
    Masses masses;
    moves_.assign(at(stores.bodies.slots.end_index()), 0);
    inverse_mass_.resize(moves_.size());
    for (const int body : stores.bodies.rows(RowSet::Awake).body) {
        const BodyRecord& record = stores.bodies.slots[body];
        moves_[at(body)] = record.inverse_mass > 0 || record.inverse_inertia > 0 ? 1 : 0;
        inverse_mass_[at(body)] = record.inverse_mass;
        masses.widen(record.inverse_mass);
    }
    return masses;
}

bool StructureSearch::is_any_held(const Stores& stores) const {
    bool found = false;
    for_each_active(stores, [&](int joint) {
        for_each_body(stores, joint, [&](int body) { found = found || !moves(body); });
    });
    return found;
}

void StructureSearch::join(const Stores& stores) {
    sets_.reset(static_cast<int>(moves_.size()));
    first_.clear();
    for_each_active(stores, [&](int joint) {
        int first = kNone;
        for_each_body(stores, joint, [&](int body) {
            if (!moves(body)) return;
            if (first == kNone) {
                first = body;
            } else {
                sets_.unite(first, body);
            }
        });
        first_.push_back(first);
    });
}

// In the order of their first joints.
void StructureSearch::sum_up(const Stores& stores, float most_swept_hz) {
    summaries_.clear();
    of_root_.assign(moves_.size(), kNone);
    seen_.assign(moves_.size(), 0);
    std::size_t next = 0;
    for_each_active(stores, [&](int joint) {
        const int first = first_[next++];
        if (first == kNone) return;
        int& of_root = of_root_[at(sets_.find(first))];
        if (of_root == kNone) {
            of_root = static_cast<int>(summaries_.size());
            summaries_.push_back({});
        }
        Summary& s = summaries_[at(of_root)];
        ++s.joints;
        const JointRecord& record = stores.joints.slots[joint];
        const auto* pin = std::get_if<RevoluteJointDef>(&record.def);
        s.plain_pins = s.plain_pins && pin != nullptr && is_plain_pin(*pin);
        s.lacks_load = s.lacks_load || !record.load_known;
        note_springs(record.def, most_swept_hz, s);
        for_each_body(stores, joint, [&](int body) {
            if (!moves(body)) s.is_held = true;
            if (!moves(body) || seen_[at(body)]) return;
            seen_[at(body)] = 1;
            ++s.bodies;
            s.masses.widen(inverse_mass_[at(body)]);
        });
    });
}

void StructureSearch::note_springs(const JointDef& def, float most_swept_hz, Summary& s) {
    const JointActs acts = acts_of(def);
    s.holds = s.holds || acts.holds;
    if (acts.spring_hz > 0 && springs_.note(acts.spring_hz, most_swept_hz)) ++s.stiff_springs;
}

// Stiff springs that bear each other, or what is held: sweeps hand down too little from one to the other.
// What nothing holds has nothing to bear for long.
bool StructureSearch::is_stiff(const Summary& s) {
    return s.is_held && (s.stiff_springs > 1 || (s.stiff_springs > 0 && s.holds));
}

bool StructureSearch::is_pendulum(const Summary& s) {
    return s.joints < kFewestJoints && s.plain_pins && s.is_held && !bears_with_few(s);
}

bool StructureSearch::bears_with_few(const Summary& s) {
    return s.joints < kFewestJoints && s.masses.are_uneven(kUnevenMasses);
}

bool StructureSearch::may_be_hard(const Summary& s) {
    if (s.joints < kFewestJoints) return is_pendulum(s) || bears_with_few(s) || is_stiff(s);
    const float per_body = is_stiff(s) ? kStiffJointsPerBody : kJointsPerBody;
    if (static_cast<float>(s.joints) > per_body * static_cast<float>(s.bodies) + kSpareJoints) return false;
    const bool may_be_deep = s.is_held && s.joints > kDepth;
    return may_be_deep || is_stiff(s) || s.masses.are_uneven(kMassRatio);
}

bool StructureSearch::may_need_loads(const Summary& s) {
    return s.lacks_load && s.plain_pins && s.is_held && s.joints > kDepth;
}

void StructureSearch::list(const Stores& stores, JointSolver solver, std::vector<DirectStructure>& structures,
                           std::vector<DirectStructure>& without_loads) {
    const bool all = solver == JointSolver::Direct;
    summary_of_.clear();
    for (std::size_t i = 0; i < summaries_.size(); ++i) {
        Summary& s = summaries_[i];
        if (!all && !may_be_hard(s) && !may_need_loads(s)) continue;
        s.listed = static_cast<int>(structures.size());
        structures.push_back(new_structure(s));
        summary_of_.push_back(static_cast<int>(i));
    }
    if (structures.empty()) return;
    seen_.assign(moves_.size(), 0);
    for (int i = 0; i < stores.joints.active.size(); ++i) {
        if (first_[at(i)] == kNone) continue;
        const int listed = summaries_[at(of_root_[at(sets_.find(first_[at(i)]))])].listed;
        if (listed < 0) continue;
        DirectStructure& s = structures[at(listed)];
        s.joints.push_back(stores.joints.active[i]);
        for_each_body(stores, stores.joints.active[i], [&](int body) {
            if (!moves(body) || seen_[at(body)]) return;
            seen_[at(body)] = 1;
            s.bodies.push_back(body);
        });
    }
    if (all) return;
    local_.resize(moves_.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < structures.size(); ++i) {
        const Summary& summary = summaries_[at(summary_of_[i])];
        number_bodies(structures[i]);
        const bool hard = may_be_hard(summary) && is_hard_to_sweep(structures[i], summary, stores);
        const bool too_stiff = !hard && is_stiff(summary) && is_open(structures[i], stores);
        if (!hard && !too_stiff) {
            if (may_need_loads(summary) && depth_of(structures[i], stores) > kDepth) {
                without_loads.push_back(std::move(structures[i]));
            } else {
                recycle(structures[i]);
            }
            continue;
        }
        if (kept != i) structures[kept] = std::move(structures[i]);
        structures[kept].only_free = is_pendulum(summary);
        ++kept;
    }
    structures.resize(kept);
}

void StructureSearch::number_bodies(const DirectStructure& s) {
    for (std::size_t i = 0; i < s.bodies.size(); ++i) local_[at(s.bodies[i])] = static_cast<int>(i);
}

bool StructureSearch::is_hard_to_sweep(const DirectStructure& s, const Summary& summary,
                                       const Stores& stores) {
    if (summary.joints < kFewestJoints) return is_pendulum(summary) || bears_with_few(summary);
    const bool uneven = summary.masses.are_uneven(kMassRatio);
    if (!uneven && depth_of(s, stores) <= kDepth) return false;
    return products_per_joint(s, stores) <= kMaxProducts;
}

// Whether what is held forms no loop: there what springs bend by hairs would have to be true of all joints at
// once, and they would bear what they are built to bear a thousandfold. So would limits into which a stiff
// spring draws. Springs themselves may form loops.
bool StructureSearch::is_open(const DirectStructure& s, const Stores& stores) {
    const int ground = static_cast<int>(s.bodies.size());
    held_.reset(ground + 1);
    bool open = true;
    for (const int joint : s.joints) {
        const JointActs acts = acts_of(stores.joints.slots[joint].def);
        open = open && !acts.limits;
        if (!acts.holds) continue;
        int first = kNone;
        for_each_body(stores, joint, [&](int body) {
            const int root = held_.find(moves(body) ? local_[at(body)] : ground);
            if (first == kNone) {
                first = root;
            } else if (root == held_.find(first)) {
                open = false;
            } else {
                held_.unite(first, root);
            }
        });
    }
    return open && products_per_joint(s, stores) <= kMaxStiffProducts;
}

// Joints between the farthest body and what holds the structure; 0 if nothing does.
int StructureSearch::depth_of(const DirectStructure& s, const Stores& stores) {
    // Joints by body, from first_joint_[body] to that of the next one.
    first_joint_.assign(s.bodies.size() + 2, 0);
    for (const int joint : s.joints) {
        for_each_body(stores, joint, [&](int body) {
            if (moves(body)) ++first_joint_[at(local_[at(body)]) + 2];
        });
    }
    for (std::size_t i = 1; i < first_joint_.size(); ++i) first_joint_[i] += first_joint_[i - 1];
    joints_of_.resize(at(first_joint_.back()));
    level_.assign(s.bodies.size(), 0);
    reached_.clear();
    const auto reach = [&](int joint, int level) {
        for_each_body(stores, joint, [&](int body) {
            if (!moves(body) || level_[at(local_[at(body)])] > 0) return;
            level_[at(local_[at(body)])] = level;
            reached_.push_back(local_[at(body)]);
        });
    };
    for (const int joint : s.joints) {
        bool held = false;
        for_each_body(stores, joint, [&](int body) {
            held = held || !moves(body);
            if (moves(body)) joints_of_[at(first_joint_[at(local_[at(body)]) + 1]++)] = joint;
        });
        if (held) reach(joint, 1);
    }
    for (std::size_t next = 0; next < reached_.size(); ++next) {
        const std::size_t body = at(reached_[next]);
        for (int i = first_joint_[body]; i < first_joint_[body + 1]; ++i)
            reach(joints_of_[at(i)], level_[body] + 1);
    }
    return reached_.empty() ? 0 : level_[at(reached_.back())];
}

// Products of blocks that one factorization of the structure takes.
double StructureSearch::products_per_joint(const DirectStructure& s, const Stores& stores) {
    nodes_.assign(s.bodies.size(), {3, false});
    edges_.clear();
    for (const int joint : s.joints) {
        const int node = static_cast<int>(nodes_.size());
        nodes_.push_back({2, true});
        const std::size_t first = edges_.size();
        for_each_body(stores, joint, [&](int body) {
            if (!moves(body)) return;
            const BlockLdl::Edge edge{local_[at(body)], node};
            if (std::find(edges_.begin() + static_cast<std::ptrdiff_t>(first), edges_.end(), edge) ==
                edges_.end())
                edges_.push_back(edge);
        });
    }
    factors_.analyze(nodes_, edges_);
    return static_cast<double>(factors_.products()) / static_cast<double>(s.joints.size());
}

}  // namespace cairn::physics
