// Finding structures and groups. Two kinds of seeds: structures of joints, which are found again only when
// joints change; and uneven contacts, which are looked at in each step. From each seed the group grows over
// contacts.
#include "world/direct_groups.h"

#include <algorithm>
#include <map>

#include "base/union_find.h"
#include "resolve/direct/block_ldl.h"
#include "world/joint_lists.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// Of a structure: a sweep needs some 2.3 rounds per decimal digit, times mass ratio, times depth.
constexpr int kFewestJoints = 3;
constexpr float kMassRatio = 8;
constexpr int kDepth = 8;  // from what holds the structure; one that is not held bears no load
// Loops fill the factors: with more than this many joints per body, plus a few, nobody looks further.
constexpr float kJointsPerBody = 1.25f;
constexpr int kSpareJoints = 8;
// A chain takes 4 products of blocks per joint; three sweeps cost about as much as 16.
constexpr double kMaxProducts = 16;
// Bodies that a group takes up over contacts at most; where there are more, as in heaps, all of them are
// swept.
constexpr int kMaxTakenUp = 16;

using Structure = DirectStructure;

bool moves(const Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    return stores.bodies.is_awake(body) && (record.inverse_mass > 0 || record.inverse_inertia > 0);
}

// Calls visit(body) for the bodies of a joint; those of a gear are the bodies of its joints.
template <class Visit>
void for_each_body(const Stores& stores, int joint, Visit&& visit) {
    const JointRecord& record = stores.joints.slots[joint];
    visit(record.body_a);
    visit(record.body_b);
    if (const auto* gear = std::get_if<GearJointDef>(&record.def)) {
        for (const JointId id : {gear->joint_1, gear->joint_2}) {
            const JointRecord& geared = stores.joints.slots[stores.joints.slots.find(id)];
            visit(geared.body_a);
            visit(geared.body_b);
        }
    }
}

int first_moving(const Stores& stores, int joint) {
    int first = kNone;
    for_each_body(stores, joint, [&](int body) {
        if (first == kNone && moves(stores, body)) first = body;
    });
    return first;
}

// Joints that share bodies that move, in the order of their first joints.
std::vector<Structure> all_structures(const Stores& stores) {
    const auto bodies = static_cast<std::size_t>(stores.bodies.slots.end_index());
    UnionFind sets;
    sets.reset(static_cast<int>(bodies));
    for (const int joint : stores.joints.active) {
        const int first = first_moving(stores, joint);
        for_each_body(stores, joint, [&](int body) {
            if (moves(stores, body)) sets.unite(first, body);
        });
    }
    std::vector<Structure> structures;
    std::vector<int> of_root(bodies, kNone);
    std::vector<char> seen(bodies, 0);
    for (const int joint : stores.joints.active) {
        const int first = first_moving(stores, joint);
        if (first == kNone) continue;
        int& structure = of_root[static_cast<std::size_t>(sets.find(first))];
        if (structure == kNone) {
            structure = static_cast<int>(structures.size());
            structures.push_back({});
        }
        Structure& s = structures[static_cast<std::size_t>(structure)];
        s.joints.push_back(joint);
        for_each_body(stores, joint, [&](int body) {
            if (!moves(stores, body) || seen[static_cast<std::size_t>(body)]) return;
            seen[static_cast<std::size_t>(body)] = 1;
            s.bodies.push_back(body);
        });
    }
    return structures;
}

// Joints between the farthest body and what holds the structure; 0 if nothing does.
int depth_of(const Structure& s, const Stores& stores) {
    std::map<int, int> level;  // by body
    std::map<int, std::vector<int>> joints_of;
    std::vector<int> reached;
    const auto reach = [&](int body, int at_level) {
        if (moves(stores, body) && level.try_emplace(body, at_level).second) reached.push_back(body);
    };
    for (const int joint : s.joints) {
        bool held = false;
        for_each_body(stores, joint, [&](int body) {
            joints_of[body].push_back(joint);
            held = held || !moves(stores, body);
        });
        if (held) for_each_body(stores, joint, [&](int body) { reach(body, 1); });
    }
    if (reached.empty()) return 0;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const int body = reached[next];
        const int next_level = level[body] + 1;
        for (const int joint : joints_of[body]) {
            for_each_body(stores, joint, [&](int other) { reach(other, next_level); });
        }
    }
    return level[reached.back()];
}

float mass_ratio_of(const Structure& s, const Stores& stores) {
    float least = kUnlimited;
    float most = 0;
    for (const int body : s.bodies) {
        const float inverse_mass = stores.bodies.slots[body].inverse_mass;
        if (inverse_mass <= 0) continue;
        least = std::min(least, inverse_mass);
        most = std::max(most, inverse_mass);
    }
    return most > 0 ? most / least : 1;
}

bool is_hard_to_sweep(const Structure& s, const Stores& stores) {
    if (static_cast<int>(s.joints.size()) < kFewestJoints) return false;
    const float most = kJointsPerBody * static_cast<float>(s.bodies.size()) + kSpareJoints;
    if (static_cast<float>(s.joints.size()) > most) return false;
    return mass_ratio_of(s, stores) > kMassRatio || depth_of(s, stores) > kDepth;
}

// Products of blocks that one factorization of the structure takes, per joint.
double products_per_joint(const Structure& s, const Stores& stores) {
    std::map<int, int> node_of;
    std::vector<BlockLdl::Node> nodes;
    for (const int body : s.bodies) {
        node_of[body] = static_cast<int>(nodes.size());
        nodes.push_back({3, false});
    }
    std::vector<BlockLdl::Edge> edges;
    for (const int joint : s.joints) {
        const int node = static_cast<int>(nodes.size());
        nodes.push_back({2, true});
        std::vector<int> linked;
        for_each_body(stores, joint, [&](int body) {
            if (!moves(stores, body) || std::find(linked.begin(), linked.end(), body) != linked.end()) return;
            linked.push_back(body);
            edges.push_back({node_of[body], node});
        });
    }
    BlockLdl system;
    system.analyze(nodes, edges);
    return static_cast<double>(system.products()) / static_cast<double>(s.joints.size());
}

void find_structures(Stores& stores, JointSolver solver, DirectGroups& groups) {
    for (const Structure& s : groups.structures) {
        for (const int body : s.bodies) groups.structure_of[static_cast<std::size_t>(body)] = kNone;
    }
    groups.structures.clear();
    groups.structure_of.resize(static_cast<std::size_t>(stores.bodies.slots.end_index()), kNone);
    for (const int joint : stores.joints.active) stores.joints.slots[joint].direct = false;
    if (solver != JointSolver::Sweeping) {
        for (Structure& s : all_structures(stores)) {
            if (solver == JointSolver::Automatic &&
                (!is_hard_to_sweep(s, stores) || products_per_joint(s, stores) > kMaxProducts)) {
                continue;
            }
            for (const int joint : s.joints) {
                unseat_joint(stores, joint);
                stores.joints.slots[joint].direct = true;
            }
            for (const int body : s.bodies) {
                groups.structure_of[static_cast<std::size_t>(body)] =
                    static_cast<int>(groups.structures.size());
            }
            groups.structures.push_back(std::move(s));
        }
    }
    groups.version = stores.joints.version;
}

// A body that hangs together with more than a group may take up.
constexpr int kTooMany = -2;

// Grows groups from seeds, one after the other.
class Growth {
  public:
    Growth(Stores& stores, DirectGroups& groups) : stores_(stores), groups_(groups) {
        const auto bodies = static_cast<std::size_t>(stores.bodies.slots.end_index());
        groups_.of_body.resize(bodies, kNone);
        groups_.structure_of.resize(bodies, kNone);
        groups_.too_many.clear();
    }

    void from(int body) {
        if (!moves(stores_, body) || mark(body) != kNone) return;
        groups_.reached.clear();
        groups_.found.clear();
        spare_ = kMaxTakenUp;
        take(body);
        if (reaches_all()) {
            add_group();
        } else {
            add_structures_alone();
        }
    }

    /// Once, when all seeds have been tried.
    void end() {
        for (const int body : groups_.too_many) {
            if (mark(body) == kTooMany) mark(body) = kNone;
        }
    }

  private:
    int& mark(int body) { return groups_.of_body[static_cast<std::size_t>(body)]; }
    [[nodiscard]] const DirectStructure& structure(int i) const {
        return groups_.structures[static_cast<std::size_t>(i)];
    }

    void visit(int body) {
        mark(body) = groups_.count;
        groups_.reached.push_back(body);
    }

    // With the structure that it is part of.
    void take(int body) {
        const int found = groups_.structure_of[static_cast<std::size_t>(body)];
        if (found == kNone) {
            --spare_;
            return visit(body);
        }
        groups_.found.push_back(found);
        for (const int other : structure(found).bodies) visit(other);
    }

    // Takes up what touches, or may within the step; false when that is too much.
    bool reaches_all() {
        bool met_too_many = false;
        for (std::size_t next = 0; next < groups_.reached.size(); ++next) {
            const int first = stores_.bodies.slots[groups_.reached[next]].first_contact;
            for_each_edge(stores_.contacts.slots, first, [&](int contact, int) {
                const ContactRecord& c = stores_.contacts.slots[contact];
                if (special::has(c, special::kRefused)) return;
                for (const int other : {c.body_a, c.body_b}) {
                    if (!moves(stores_, other)) continue;
                    met_too_many = met_too_many || mark(other) == kTooMany;
                    if (mark(other) == kNone && spare_ >= 0) take(other);
                }
            });
            if (spare_ < 0 || met_too_many) return false;
        }
        return true;
    }

    // Its memory is that of an earlier step.
    DirectStructure& new_group() {
        const auto needed = static_cast<std::size_t>(groups_.count) + 1;
        if (groups_.groups.size() < needed) {
            groups_.groups.resize(needed);
            groups_.components.resize(needed);
            groups_.contacts.resize(needed);
        }
        DirectStructure& group = groups_.groups[needed - 1];
        group.joints.clear();
        group.bodies.clear();
        return group;
    }

    void close_group(const DirectStructure& group) {
        for (const int body : group.bodies) {
            mark(body) = groups_.count;
            stores_.bodies.places[body].flags |= place_flag::kDirect;
        }
        ++groups_.count;
    }

    void add_group() {
        DirectStructure& group = new_group();
        group.bodies.assign(groups_.reached.begin(), groups_.reached.end());
        for (const int found : groups_.found) {
            group.joints.insert(group.joints.end(), structure(found).joints.begin(),
                                structure(found).joints.end());
        }
        close_group(group);
    }

    void add_structures_alone() {
        for (const int body : groups_.reached) {
            mark(body) = kTooMany;
            groups_.too_many.push_back(body);
        }
        for (const int found : groups_.found) {
            DirectStructure& group = new_group();
            group.bodies.assign(structure(found).bodies.begin(), structure(found).bodies.end());
            group.joints.assign(structure(found).joints.begin(), structure(found).joints.end());
            close_group(group);
        }
    }

    Stores& stores_;
    DirectGroups& groups_;
    int spare_ = 0;  // bodies that may still be taken up
};

void forget_groups(Stores& stores, DirectGroups& groups) {
    for (int g = 0; g < groups.count; ++g) {
        for (const int body : groups.groups[static_cast<std::size_t>(g)].bodies) {
            groups.of_body[static_cast<std::size_t>(body)] = kNone;
            stores.bodies.places[body].flags &= ~place_flag::kDirect;
        }
    }
    groups.count = 0;
}

}  // namespace

void choose_direct_groups(Stores& stores, JointSolver solver, DirectGroups& groups) {
    forget_groups(stores, groups);
    if (groups.version != stores.joints.version) find_structures(stores, solver, groups);
    const bool any = !groups.structures.empty() || stores.contacts.uneven.size() > 0;
    if (!any || solver == JointSolver::Sweeping) return;
    Growth growth(stores, groups);
    for (const DirectStructure& structure : groups.structures) growth.from(structure.bodies.front());
    for (const int contact : stores.contacts.uneven) growth.from(stores.contacts.slots[contact].body_a);
    growth.end();
}

}  // namespace cairn::physics
