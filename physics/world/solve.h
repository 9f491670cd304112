// The solver's passes over all constraints of a step that are in no batch.
#pragma once

#include <algorithm>
#include <atomic>

#include "base/ample.h"
#include "integrator/integrate.h"
#include "resolve/joints/joint_solver.h"
#include "resolve/joints/laws.h"
#include "world/prepare.h"
#include "world/standing.h"
#include "world/sweeping_contacts.h"

namespace cairn::physics {

// Rows that a thread takes at once.
inline constexpr int kRowsPerChunk = 1024;

/// Calls work(first, last) for all rows that are in no batch.
template <class Work>
void for_rest_rows(const ContactBatches& batches, TaskPool& tasks, const Work& work) {
    const std::span<const RowRange> ranges = batches.rest_rows();
    // Where batches are scattered among the rows, ranges are short.
    constexpr int kRangesPerChunk = 16;
    const int grain = batches.count() > 0 ? kRangesPerChunk : 1;
    tasks.parallel_for(static_cast<int>(ranges.size()), grain, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const RowRange& range = ranges[static_cast<std::size_t>(i)];
            work(range.first, range.last);
        }
    });
}

/// Which sorts of constraints act in a step.
struct Acting {
    bool joints = false;
    bool contacts = false;
};

inline Acting what_acts(const Stores& stores, const StepScratch& scratch) {
    return {!scratch.joints.empty() || !stores.joints.lanes.empty(),
            !scratch.scalar_contacts.empty() || !scratch.sweeping.empty() ||
                !stores.contacts.lanes.blocks().empty()};
}

/// What nothing acts on flies in one stride, so a step may have no substep to make.
inline int substeps_of(const StepTime& time, Acting acting, const StepScratch& scratch,
                       const DirectGroups& direct) {
    const bool something_acts =
        acting.joints || acting.contacts || !scratch.awaited.empty() || direct.count > 0;
    return something_acts ? time.substeps : 0;
}

/// While one thread calls beside().
template <class Beside>
void prepare_kicks(Vec2 gravity_m_s2, const StepTime& time, const ContactRules& rules, StepScratch& scratch,
                   TaskPool& tasks, const Beside& beside) {
    Motions& motions = scratch.motions;
    const auto is_damped = [](const Drive& d) { return d.linear_damping != 0 || d.angular_damping != 0; };
    const auto size = static_cast<std::size_t>(motions.size());
    resize_amply(motions.kick, size);
    resize_amply(motions.kept, std::ranges::any_of(scratch.drives, is_damped) ? size : 0);
    resize_amply(motions.standing, size);
    std::atomic<int> still = 0;
    std::atomic<bool> creeps = false;
    tasks.parallel_for_beside(beside, motions.size(), kRowsPerChunk, [&](const Chunk& rows) {
        prepare_kicks(motions, scratch.drives, time.h_s, rows.begin, rows.end);
        const Stillness found = note_still(motions, rows.begin, rows.end);
        still.fetch_add(found.still, std::memory_order_relaxed);
        if (found.creeps) creeps.store(true, std::memory_order_relaxed);
    });
    begin_standing({still, creeps}, gravity_m_s2, time, rules, scratch, tasks);
}

/// In the first substep all contacts act.
inline Scope scope_of(int substep) {
    return substep == 0 ? Scope::All : Scope::Disturbed;
}

inline void integrate_velocities(StepScratch& scratch, Acting acting, int substep, TaskPool& tasks) {
    const bool afresh = substep == 0 || !acting.contacts;
    for_rest_rows(*scratch.batches, tasks,
                  [&](int first, int last) { integrate_velocities(scratch.motions, afresh, first, last); });
}

inline void integrate_positions(StepScratch& scratch, float h_s, TaskPool& tasks) {
    for_rest_rows(*scratch.batches, tasks,
                  [&](int first, int last) { integrate_positions(scratch.motions, h_s, first, last); });
}

/// Calls work(blocks, what is kept of them) for all blocks that are in no batch.
template <class Work>
void for_rest_blocks(ContactBatches& batches, TaskPool& tasks, const Work& work) {
    constexpr int kBlocksPerChunk = 128;
    const std::span<ContactBlock* const> blocks = batches.rest_blocks();
    const std::span<KeptImpulses> kept = batches.rest_kept();
    tasks.parallel_for(static_cast<int>(blocks.size()), kBlocksPerChunk, [&](const Chunk& chunk) {
        const auto first = static_cast<std::size_t>(chunk.begin);
        const auto count = static_cast<std::size_t>(chunk.end - chunk.begin);
        work(blocks.subspan(first, count), kept.subspan(first, count));
    });
}

/// Before the first substep, where something may come to rest in it.
inline void keep_impulses(StepScratch& scratch, int substeps, TaskPool& tasks) {
    if (substeps == 0 || scratch.motions.standing.empty() || scratch.all_stand) return;
    for_rest_blocks(*scratch.batches, tasks,
                    [](auto blocks, auto kept) { physics::keep_impulses(blocks, kept); });
}

/// After the first substep: who stands, of what is in no batch.
inline void note_standing(StepScratch& scratch, int substep, float h_s, TaskPool& tasks) {
    if (substep != 0 || scratch.motions.standing.empty()) return;
    std::atomic<int> moving = 0;
    std::atomic<int> resting = 0;
    for_rest_rows(*scratch.batches, tasks, [&](int first, int last) {
        const Standing found = note_standing(scratch.motions, h_s, first, last);
        moving.fetch_add(found.moving, std::memory_order_relaxed);
        resting.fetch_add(found.resting, std::memory_order_relaxed);
    });
    scratch.all_stand = moving == 0;
    if (resting == 0) return;
    Motions& motions = scratch.motions;
    for_rest_blocks(*scratch.batches, tasks,
                    [&](auto blocks, auto kept) { rouse_shifting(blocks, kept, motions); });
    for_rest_blocks(*scratch.batches, tasks,
                    [&](auto blocks, auto kept) { put_impulses_back(blocks, kept, motions); });
    for_rest_rows(*scratch.batches, tasks, [&](int first, int last) { stop_resting(motions, first, last); });
}

/// Where all rests of what is in no batch, and all that acts on it is contacts in lanes, no substep is made.
inline void leave_resting(StepScratch& scratch, int substeps, Acting acting, const DirectGroups& direct) {
    if (substeps == 0 || scratch.motions.standing.empty()) return;
    if (acting.joints || direct.count > 0 || !scratch.awaited.empty() || !scratch.scalar_contacts.empty() ||
        !scratch.sweeping.empty())
        return;
    const std::span<const RowRange> rows = scratch.batches->rest_rows();
    if (!scratch.standing->resting.all_of(rows)) return;
    leave_resting(scratch.motions, rows);
    scratch.all_stand = true;
    scratch.standing->none_solved = scratch.standing->all_rest;
}

/// Where all stands, the first substep was the last.
inline bool is_made(const StepScratch& scratch, int substep, int substeps) {
    return substep < substeps && !scratch.all_stand;
}

inline void fly_freely(StepScratch& scratch, Vec2 gravity_m_s2, float dt_s, std::uint64_t step,
                       TaskPool& tasks) {
    tasks.parallel_for(scratch.motions.size(), kRowsPerChunk, [&](const Chunk& rows) {
        const int first = std::max(rows.begin, kWorldRow + 1);  // the world does not fly
        fly_freely(scratch.motions, scratch.drives, gravity_m_s2, dt_s, step, first, rows.end);
    });
}

inline JointPassTime joint_time(float h_s) {
    return {softness_of(JointStiffness{}, h_s), 1 / h_s};
}

/// How fast springs are before anything acts.
inline void note_spring_speeds(JointLanes& joints, StepScratch& scratch, TaskPool& tasks) {
    if (scratch.joints.empty() && joints.empty()) return;
    note_spring_speeds(scratch.joints, scratch.joint_places, scratch.motions);
    joints.note_spring_speeds(scratch.motions, tasks);
}

/// The impulses of contacts in the last step, as the first guess of this one. Within a step
/// integrate_velocities carries them on.
inline void warm_start_contacts(StepScratch& scratch, const StepTime& time, TaskPool& tasks) {
    scratch.plain_groups.for_each(tasks, [&](int i) {
        warm_start_contact(scratch.contacts[i], scratch.motions, time.step_ratio, time.impulse_ratio);
    });
    warm_start(scratch.batches->rest_runs(), scratch.motions, time.step_ratio, time.impulse_ratio, tasks);
}

inline void sweep_crowded_springs(JointLanes& lanes, StepScratch& scratch) {
    const bool some_joints = scratch.has_crowded_springs;
    const bool some_lanes = lanes.has_crowded_springs();
    const auto sweep_joints = [&](bool back) {
        if (some_joints) sweep_crowded_springs(scratch.joints, scratch.joint_places, scratch.motions, back);
    };
    const auto sweep_lanes = [&](bool back) {
        if (some_lanes) lanes.sweep_crowded_springs(scratch.motions, back);
    };
    if (!some_joints && !some_lanes) return;
    for (int i = 0; i < kCrowdedSweeps; ++i) {
        sweep_joints(false);
        sweep_lanes(false);
        sweep_lanes(true);
        sweep_joints(true);
    }
}

/// The passes of joints: biased ones start from the impulses of the last substep.
inline void solve_joints(JointLanes& lanes, StepScratch& scratch, float h_s, Acting acting, Pass pass,
                         TaskPool& tasks) {
    if (!acting.joints) return;
    Motions& motions = scratch.motions;
    const auto for_rows = [&](auto&& work) {
        if (!acting.contacts) return;
        if (scratch.few_are_jointed) {
            for (const int row : scratch.jointed_rows) work(motions, row, row + 1);
            return;
        }
        for_rest_rows(*scratch.batches, tasks, [&](int first, int last) { work(motions, first, last); });
    };
    const JointPassTime time = joint_time(h_s);
    for_rows(begin_joints);
    if (pass == Pass::Biased) {
        warm_start_joints(scratch.joints, scratch.joint_places, motions);
        lanes.warm_start(motions, tasks);
        sweep_crowded_springs(lanes, scratch);
    }
    solve_joints(scratch.joints, scratch.joint_places, motions, h_s, pass);
    if (pass == Pass::Biased) {
        lanes.solve(motions, time, tasks);
    } else {
        lanes.relax(motions, time, tasks);
    }
    for_rows(end_joints);
}

inline void solve_contacts(StepScratch& scratch, const ContactRules& rules, float h_s, Pass pass, Scope scope,
                           TaskPool& tasks) {
    scratch.plain_groups.for_each(
        tasks, [&](int i) { solve_contact(scratch.contacts[i], scratch.motions, rules, h_s, pass); });
    solve(scratch.batches->rest_runs(), scratch.motions, rules, h_s, pass, scope, tasks);
}

// Joints before contacts: what comes last is satisfied best, and overlap is worse to see than a stretched
// joint.
inline void solve(Stores& stores, StepScratch& scratch, const ContactRules& rules, float h_s, Acting acting,
                  Pass pass, int substep, TaskPool& tasks) {
    solve_joints(stores.joints.lanes, scratch, h_s, acting, pass, tasks);
    solve_sweeping(stores, scratch, substep, rules, h_s, pass);
    solve_contacts(scratch, rules, h_s, pass, scope_of(substep), tasks);
}

}  // namespace cairn::physics
