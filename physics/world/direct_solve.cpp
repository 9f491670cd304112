// Phases of the groups within a step.
#include "world/direct_solve.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "integrator/integrate.h"
#include "world/prepare.h"
#include "world/solve.h"

namespace cairn::physics {
namespace {

DirectScene scene_of(StepScratch& scratch, const ContactRules& rules, float h_s) {
    return {scratch.joints, scratch.contacts, scratch.motions, scratch.drives, rules, h_s};
}

// The group to which a contact belongs as a whole, or kNone.
int group_of(const ContactRecord& c, const DirectGroups& groups, const Stores& stores) {
    const int a = groups.of_body[static_cast<std::size_t>(c.body_a)];
    const int b = groups.of_body[static_cast<std::size_t>(c.body_b)];
    if (a == b) return a;
    const auto is_held = [&](int body) { return stores.bodies.slots[body].inverse_mass == 0; };
    if (a == kNone && is_held(c.body_a)) return b;
    if (b == kNone && is_held(c.body_b)) return a;
    return kNone;
}

// Contacts that a group may take over: with more of them per body nearly everything touches everything, and
// the factors fill.
constexpr std::size_t kContactsPerBody = 3;
constexpr std::size_t kSpareContacts = 4;

// Takes contacts between members of groups out of the sweep.
void distribute_contacts(const Stores& stores, StepScratch& scratch, DirectGroups& groups) {
    for (std::vector<int>& list : groups.contacts) list.clear();
    std::erase_if(scratch.scalar_contacts, [&](int i) {
        const ContactRecord& c = stores.contacts.slots[scratch.contacts[static_cast<std::size_t>(i)].contact];
        const int group = group_of(c, groups, stores);
        if (group != kNone) groups.contacts[static_cast<std::size_t>(group)].push_back(i);
        return group != kNone;
    });
    for (std::size_t g = 0; g < static_cast<std::size_t>(groups.count); ++g) {
        std::vector<int>& contacts = groups.contacts[g];
        if (contacts.size() <= kContactsPerBody * groups.groups[g].bodies.size() + kSpareContacts) continue;
        scratch.scalar_contacts.insert(scratch.scalar_contacts.end(), contacts.begin(), contacts.end());
        contacts.clear();
    }
}

// Calls work(solver) with what solves a group.
template <class Groups, class Work>
void with_solver(Groups& groups, std::size_t group, const Work& work) {
    if (groups.is_chain[group] != 0) {
        work(groups.chains[group]);
    } else {
        work(groups.components[group]);
    }
}

// What structures do to bodies is not taken for an impulse of contacts, where there are any.
template <class Work>
void for_each_solver(DirectGroups& groups, Motions& motions, Acting acting, TaskPool& tasks,
                     const Work& work) {
    const auto for_rows = [&](const auto& solver, auto&& set_apart) {
        if (!acting.contacts) return;
        for (int body = 0; body < solver.bodies(); ++body)
            set_apart(motions, solver.row(body), solver.row(body) + 1);
    };
    tasks.parallel_for(groups.count, 1, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            with_solver(groups, static_cast<std::size_t>(i), [&](auto& solver) {
                for_rows(solver, begin_joints);
                work(solver);
                for_rows(solver, end_joints);
            });
        }
    });
}

}  // namespace

void start_direct_solve(Stores& stores, const ContactRules& rules, const StepTime& time, StepScratch& scratch,
                        DirectGroups& groups, TaskPool& tasks) {
    if (groups.count == 0) return;
    distribute_contacts(stores, scratch, groups);
    const DirectScene scene = scene_of(scratch, rules, time.h_s);
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const auto rows = static_cast<std::size_t>(scratch.motions.size());
    groups.inertia.assign(rows, 0);
    groups.body_of_row.assign(rows, -1);
    for (std::size_t g = 0; g < static_cast<std::size_t>(groups.count); ++g) {
        groups.places.clear();
        for (const int joint : groups.groups[g].joints) {
            const int place = stores.joints.slots[joint].swept_index;
            if (scratch.joints[static_cast<std::size_t>(place)].law_count > 0) groups.places.push_back(place);
        }
        const bool is_chain =
            groups.contacts[g].empty() && groups.chains[g].assemble(groups.places, scene, groups.body_of_row);
        groups.is_chain[g] = is_chain ? 1 : 0;
        if (!is_chain)
            groups.components[g].assemble(groups.places, groups.contacts[g], scene, groups.body_of_row);
        with_solver(groups, g, [&](const auto& solver) {
            for (int body = 0; body < solver.bodies(); ++body) {
                const int row = solver.row(body);
                scratch.motions.mover[row] = MovedBy::Direct;
                groups.inertia[static_cast<std::size_t>(row)] =
                    stores.bodies.slots[awake.body[row - 1]].joint_inertia;
            }
        });
    }
    tasks.parallel_for(groups.count, 1, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            with_solver(groups, static_cast<std::size_t>(i),
                        [&](auto& solver) { solver.start(scene, groups.inertia); });
        }
    });
}

void solve_direct(DirectGroups& groups, StepScratch& scratch, const ContactRules& rules, float h_s,
                  Acting acting, TaskPool& tasks) {
    if (groups.count == 0) return;
    const DirectScene scene = scene_of(scratch, rules, h_s);
    for_each_solver(groups, scratch.motions, acting, tasks, [&](auto& solver) { solver.solve(scene); });
}

void move_direct(DirectGroups& groups, StepScratch& scratch, const ContactRules& rules, float h_s,
                 Acting acting, TaskPool& tasks) {
    if (groups.count == 0) return;
    const DirectScene scene = scene_of(scratch, rules, h_s);
    for_each_solver(groups, scratch.motions, acting, tasks, [&](auto& solver) { solver.move(scene); });
}

void store_direct(const DirectGroups& groups, Stores& stores, StepScratch& scratch) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    for (std::size_t g = 0; g < static_cast<std::size_t>(groups.count); ++g) {
        if (groups.is_chain[g] != 0) groups.chains[g].finish(scratch.joints);
        with_solver(groups, g, [&](const auto& solver) {
            for (int i = 0; i < solver.bodies(); ++i) {
                stores.bodies.slots[awake.body[solver.row(i) - 1]].joint_inertia =
                    static_cast<float>(solver.inertia(i));
            }
        });
    }
}

}  // namespace cairn::physics
