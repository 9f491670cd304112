// Finding groups. Two kinds of seeds: structures of joints (direct_structures.h), which are found again only
// when joints change; and uneven contacts, which are looked at in each step. From each seed the group grows
// over contacts, and over the joints of what it takes up: what a heavy body lies on is held by them.
#include "world/direct_groups.h"

#include <algorithm>

#include "world/joint_lists.h"
#include "world/joints.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// Bodies that a group takes up over contacts at most: so many, and for each structure as many as it has, up
// to a bound. Where there are more, as in heaps, all of them are swept.
constexpr int kMaxTakenUp = 16;
// As many where they stand in rows, on or beside each other: what lies on a column of twenty is thrown off by
// a sweep if it weighs as much as ten thousand of them. So many more contacts than bodies may a row have.
constexpr int kMaxInRow = 64;
constexpr int kLoopsOfRow = 8;
constexpr int kMaxTakenUpByStructure = 64;
// And over joints that are in no structure.
constexpr int kMaxTakenUpByJoints = 64;
// Contacts between bodies that move, for each that is taken up, and besides: more of them are loops, which
// fill the factors.
constexpr int kMaxContactsPerBody = 3;
constexpr int kSpareContacts = 16;

bool moves(const Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    return stores.bodies.is_awake(body) && (record.inverse_mass > 0 || record.inverse_inertia > 0);
}

void find_structures(Stores& stores, JointSolver solver, float most_swept_hz, DirectGroups& groups) {
    for (const DirectStructure& s : groups.structures) {
        for (const int body : s.bodies) groups.structure_of[static_cast<std::size_t>(body)] = kNone;
    }
    groups.structure_of.resize(static_cast<std::size_t>(stores.bodies.slots.end_index()), kNone);
    for (const int joint : stores.joints.active) stores.joints.slots[joint].direct = false;
    groups.search.find(stores, solver, most_swept_hz, groups.structures, groups.without_loads);
    for (std::size_t s = 0; s < groups.structures.size(); ++s) {
        for (const int body : groups.structures[s].bodies)
            groups.structure_of[static_cast<std::size_t>(body)] = static_cast<int>(s);
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

    void from_structure(int i) {
        const DirectStructure& s = structure(i);
        if (s.only_free && !is_free(s)) return;
        from(s.bodies.front(), 0);
    }

    /// From contacts between uneven masses, when all structures have been tried. One of a heap that was too
    /// much for another would find that out again.
    void from_contact(int contact) {
        const ContactRecord& c = stores_.contacts.slots[contact];
        const bool is_too_many = mark(c.body_a) == kTooMany || mark(c.body_b) == kTooMany;
        if (!is_too_many || special::has(c, special::kRefused)) from(c.body_a, kMaxInRow - kMaxTakenUp);
    }

    // Takes up so many bodies more if the group is a row.
    void from(int body, int more_in_row) {
        if (!moves(stores_, body) || mark(body) != kNone) return;
        groups_.reached.clear();
        groups_.found.clear();
        spare_ = kMaxTakenUp + more_in_row;
        spare_joined_ = kMaxTakenUpByJoints;
        spare_contacts_ = kSpareContacts;
        take(body);
        if (reaches_all(more_in_row)) {
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

    [[nodiscard]] bool is_free(const DirectStructure& s) const {
        return std::all_of(s.bodies.begin(), s.bodies.end(), [&](int body) {
            bool free = true;
            for_each_edge(stores_.contacts.slots, stores_.bodies.slots[body].first_contact,
                          [&](int contact, int) {
                              free = free && special::has(stores_.contacts.slots[contact], special::kRefused);
                          });
            return free;
        });
    }

    // With the structure that it is part of.
    void take(int body) {
        const int found = groups_.structure_of[static_cast<std::size_t>(body)];
        if (found == kNone) {
            --spare_;
            spare_contacts_ += kMaxContactsPerBody;
            return visit(body);
        }
        groups_.found.push_back(found);
        spare_ += std::min(static_cast<int>(structure(found).bodies.size()), kMaxTakenUpByStructure);
        for (const int other : structure(found).bodies) visit(other);
    }

    // Takes up what touches, or may within the step; false when that is too much.
    bool reaches_all(int more_in_row) {
        bool met_too_many = false;
        int contact_ends = 0;
        for (std::size_t next = 0; next < groups_.reached.size(); ++next) {
            // Not for_each_edge: what stirs a heap touches hundreds, and a few are too many.
            int key = stores_.bodies.slots[groups_.reached[next]].first_contact;
            while (key != kNone && spare_ >= 0) {
                const ContactRecord& c = stores_.contacts.slots[edge_record(key)];
                key = c.edges[edge_side(key)].next;
                if (special::has(c, special::kRefused)) continue;
                if (moves(stores_, c.body_a) && moves(stores_, c.body_b)) ++contact_ends;
                for (const int other : {c.body_a, c.body_b}) {
                    if (!moves(stores_, other)) continue;
                    met_too_many = met_too_many || mark(other) == kTooMany;
                    if (mark(other) == kNone && spare_ >= 0) take(other);
                }
            }
            take_jointed(groups_.reached[next]);
            if (spare_ < 0 || spare_joined_ < 0 || met_too_many) return false;
        }
        if (spare_ < more_in_row) spare_contacts_ = static_cast<int>(groups_.reached.size()) + kLoopsOfRow;
        // Each has been met from both of its bodies.
        return contact_ends <= 2 * spare_contacts_;
    }

    // What is joined to a body outside of structures, which are whole.
    void take_jointed(int body) {
        if (groups_.structure_of[static_cast<std::size_t>(body)] != kNone) return;
        for_each_edge(stores_.joints.slots, stores_.bodies.slots[body].first_joint, [&](int joint, int) {
            if (spare_joined_ < 0 || !takes_part(stores_.joints.slots[joint])) return;
            for_each_body(stores_, joint, [&](int other) {
                if (!moves(stores_, other) || mark(other) != kNone) return;
                --spare_joined_;
                spare_contacts_ += kMaxContactsPerBody;
                visit(other);
            });
        });
    }

    // Each once, from the first of its bodies that is in the group.
    void add_joints_of(int body, DirectStructure& group) {
        if (groups_.structure_of[static_cast<std::size_t>(body)] != kNone) return;
        for_each_edge(stores_.joints.slots, stores_.bodies.slots[body].first_joint, [&](int joint, int side) {
            const JointRecord& record = stores_.joints.slots[joint];
            if (!takes_part(record) || (side == 1 && mark(record.body_a) == groups_.count)) return;
            group.joints.push_back(joint);
            groups_.joints.push_back(joint);
        });
    }

    // Its memory is that of an earlier step.
    DirectStructure& new_group() {
        const auto needed = static_cast<std::size_t>(groups_.count) + 1;
        if (groups_.groups.size() < needed) {
            groups_.groups.resize(needed);
            groups_.chains.resize(needed);
            groups_.components.resize(needed);
            groups_.is_chain.resize(needed);
            groups_.contacts.resize(needed);
        }
        DirectStructure& group = groups_.groups[needed - 1];
        group.joints.clear();
        group.bodies.clear();
        return group;
    }

    void close_group(const DirectStructure& group) {
        for (const int joint : group.joints) {
            leave_lane(stores_, joint);
            stores_.joints.slots[joint].direct = true;
        }
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
        for (const int body : groups_.reached) add_joints_of(body, group);
        close_group(group);
    }

    void add_structures_alone() {
        for (const int body : groups_.reached) {
            mark(body) = kTooMany;
            groups_.too_many.push_back(body);
        }
        for (const int found : groups_.found) {
            if (structure(found).only_free) continue;
            DirectStructure& group = new_group();
            group.bodies.assign(structure(found).bodies.begin(), structure(found).bodies.end());
            group.joints.assign(structure(found).joints.begin(), structure(found).joints.end());
            close_group(group);
        }
    }

    Stores& stores_;
    DirectGroups& groups_;
    int spare_ = 0;  // bodies that may still be taken up
    int spare_joined_ = 0;
    int spare_contacts_ = 0;
};

void forget_groups(Stores& stores, DirectGroups& groups) {
    for (int g = 0; g < groups.count; ++g) {
        for (const int body : groups.groups[static_cast<std::size_t>(g)].bodies) {
            groups.of_body[static_cast<std::size_t>(body)] = kNone;
            stores.bodies.places[body].flags &= ~place_flag::kDirect;
        }
    }
    for (const int joint : groups.joints) {
        if (stores.joints.slots.alive(joint)) stores.joints.slots[joint].direct = false;
    }
    groups.joints.clear();
    groups.count = 0;
}

}  // namespace

void choose_direct_groups(Stores& stores, JointSolver solver, float most_swept_hz, DirectGroups& groups) {
    forget_groups(stores, groups);
    if (groups.version != stores.joints.version || !groups.search.holds_for(most_swept_hz))
        find_structures(stores, solver, most_swept_hz, groups);
    const bool any = !groups.structures.empty() || stores.contacts.uneven.size() > 0;
    if (!any || solver == JointSolver::Sweeping) return;
    for (const DirectStructure& structure : groups.structures) {
        if (!structure.only_free) continue;
        for (const int joint : structure.joints) stores.joints.slots[joint].direct = false;
    }
    Growth growth(stores, groups);
    for (int i = 0; i < static_cast<int>(groups.structures.size()); ++i) growth.from_structure(i);
    for (const int contact : stores.contacts.uneven) growth.from_contact(contact);
    growth.end();
}

}  // namespace cairn::physics
