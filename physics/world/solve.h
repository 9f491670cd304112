// The solver's passes over all constraints of a step.
#pragma once

#include "integrator/integrate.h"
#include "resolve/joints/joint_solver.h"
#include "world/prepare.h"

namespace cairn::physics {

// Rows that a thread takes at once.
inline constexpr int kRowsPerChunk = 1024;

inline void integrate_velocities(StepScratch& scratch, float h_s, bool first_substep, TaskPool& tasks) {
    tasks.parallel_for(scratch.motions.size(), kRowsPerChunk, [&](const Chunk& rows) {
        integrate_velocities(scratch.motions, scratch.drives, h_s, first_substep, rows.begin, rows.end);
    });
}

inline void integrate_positions(StepScratch& scratch, float h_s, TaskPool& tasks) {
    tasks.parallel_for(scratch.motions.size(), kRowsPerChunk, [&](const Chunk& rows) {
        integrate_positions(scratch.motions, h_s, rows.begin, rows.end);
    });
}

// Joints before contacts: what comes last is satisfied best, and overlap is worse to see than a stretched
// joint.

/// The impulses of the last substep, as the first guess. Those of contacts are applied once per step:
/// integrate_velocities carries them on.
inline void warm_start(ContactLanes& lanes, StepScratch& scratch, const StepTime& time, bool first_substep,
                       TaskPool& tasks) {
    warm_start_joints(scratch.joints, scratch.motions);
    if (!first_substep) return;
    for (const int i : scratch.scalar_contacts) {
        warm_start_contact(scratch.contacts[i], scratch.motions, time.step_ratio, time.impulse_ratio);
    }
    lanes.warm_start(scratch.motions, time.step_ratio, time.impulse_ratio, tasks);
}

inline void solve(ContactLanes& lanes, StepScratch& scratch, const ContactRules& rules, float h_s, Pass pass,
                  TaskPool& tasks) {
    solve_joints(scratch.joints, scratch.motions, h_s, pass);
    for (const int i : scratch.scalar_contacts) {
        solve_contact(scratch.contacts[i], scratch.motions, rules, h_s, pass);
    }
    lanes.solve(scratch.motions, rules, h_s, pass, tasks);
}

}  // namespace cairn::physics
