// The substeps of batches.
#include "world/batches.h"

#include "base/standing.h"
#include "integrator/integrate.h"
#include "world/solve.h"

namespace cairn::physics {
namespace {

void solve_batch(ContactBatches& batches, int batch, Motions& motions, const Resting& resting,
                 const ContactRules& rules, const StepTime& time) {
    const std::span<const RowRange> rows = batches.rows(batch);
    const bool some_stand = !motions.standing.empty();
    if (some_stand && resting.all_of(rows)) return leave_resting(motions, rows);
    batches.fetch_lanes(batch);
    if (some_stand) keep_impulses(batches.blocks(batch), batches.kept(batch));
    const std::span<const ContactRun> runs = batches.runs(batch);
    for (int substep = 0; substep < time.substeps; ++substep) {
        const Scope scope = scope_of(substep);
        for (const RowRange& r : rows) integrate_velocities(motions, substep == 0, r.first, r.last);
        for (const ContactRun& run : runs) {
            if (substep == 0) warm_start(run, motions, time.step_ratio, time.impulse_ratio);
        }
        for (const ContactRun& run : runs) solve(run, motions, rules, time.h_s, Pass::Biased, scope);
        for (const RowRange& r : rows) integrate_positions(motions, time.h_s, r.first, r.last);
        for (const ContactRun& run : runs) solve(run, motions, rules, time.h_s, Pass::Relax, scope);
        if (substep != 0 || !some_stand) continue;
        Standing found;
        for (const RowRange& r : rows) {
            const Standing part = note_standing(motions, time.h_s, r.first, r.last);
            found.moving += part.moving;
            found.resting += part.resting;
        }
        if (found.resting > 0) {
            rouse_shifting(batches.blocks(batch), batches.kept(batch), motions);
            put_impulses_back(batches.blocks(batch), batches.kept(batch), motions);
            for (const RowRange& r : rows) stop_resting(motions, r.first, r.last);
        }
        if (found.moving == 0) break;
    }
    batches.return_lanes(batch);
}

}  // namespace

void cut_into_batches(Stores& stores, int substeps, StepScratch& scratch) {
    if (substeps == 0) return;
    if (!scratch.batches) scratch.batches = std::make_unique<ContactBatches>();
    const StandingScratch& standing = *scratch.standing;
    scratch.batches->cut(
        stores.contacts.lanes, scratch.motions, stores.bodies.rows(RowSet::Awake).body,
        standing.most_rest && !standing.all_rest,
        scratch.domains ? std::span<const int>(scratch.domains->first_row) : std::span<const int>());
    scratch.batches->fetch_rest();
    if (!scratch.motions.standing.empty()) scratch.batches->make_room_to_keep();
}

void solve_batches(StepScratch& scratch, int substeps, const ContactRules& rules, const StepTime& time,
                   TaskPool& tasks) {
    if (substeps == 0) return;
    ContactBatches& batches = *scratch.batches;
    tasks.parallel_for(batches.count(), 1, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i)
            solve_batch(batches, i, scratch.motions, scratch.standing->resting, rules, time);
    });
}

void return_rest(StepScratch& scratch, int substeps) {
    if (substeps > 0) scratch.batches->return_rest();
}

}  // namespace cairn::physics
