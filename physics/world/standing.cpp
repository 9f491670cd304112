// What stands and rests.
#include "world/standing.h"

#include <atomic>
#include <cmath>

#include "base/ample.h"

namespace cairn::physics {
namespace {

// What a thread takes at once.
constexpr int kRowsPerChunk = 1024;

// Of the impulses that act on a body in a substep, what their sum may be wrong by: sixteen times the last
// digit of each. In a pyramid of base 100 it is up to 15.8 times.
constexpr float kRounding = 0x1p-20f;

// Whether nothing but weight acts on the body, so that all that is left over is rounding.
bool has_only_weight(const Motions& motions, int row, const Drive& drive, Vec2 gravity_m_s2) {
    const Vec2 falling = without_locked(drive.gravity_scale * gravity_m_s2, motions.locked_axes(row));
    return drive.acceleration == falling && drive.angular_acceleration == 0;
}

// How much of what the first substep does to rows is rounding. What stands on them is known where the statics
// estimate was made.
void find_rounding(Vec2 gravity_m_s2, const StepTime& time, StepScratch& scratch, int first, int last) {
    Motions& motions = scratch.motions;
    const bool has_loads = gravity_m_s2 != Vec2{} && scratch.statics &&
                           scratch.statics->stands.size() == motions.velocity.size();
    // Impulses of a step that was not as long will be others.
    const bool goes_on = time.step_ratio == 1;
    for (int i = first; i < last; ++i) {
        if (!goes_on || !has_only_weight(motions, i, scratch.drives[i], gravity_m_s2)) {
            motions.rounding_m_s[i] = -1;
            continue;
        }
        const float load = has_loads ? std::fabs(scratch.statics->stands[i].load) : 0;
        const float borne = load * motions.velocity[i].inverse_mass + length(motions.kick[i].v);
        motions.rounding_m_s[i] = kRounding * 2 * borne;
    }
}

}  // namespace

void begin_standing(const Stillness& all, Vec2 gravity_m_s2, const StepTime& time, const ContactRules& rules,
                    StepScratch& scratch, TaskPool& tasks) {
    Motions& motions = scratch.motions;
    begin_standing(motions, all);
    scratch.all_stand = false;
    scratch.standing->all_rest = scratch.standing->most_rest = false;
    scratch.standing->none_solved = false;
    if (motions.standing.empty()) return;
    for (const ContactConstraint& c : scratch.contacts) {
        keep_moving(motions, c.a);
        keep_moving(motions, c.b);
    }
    resize_amply(motions.rounding_m_s, static_cast<std::size_t>(motions.size()));
    StandingScratch& standing = *scratch.standing;
    standing.resting.begin(motions.size(), {time.h_s, rules});
    std::atomic<int> known = 0;
    tasks.parallel_for(motions.size(), kRowsPerChunk, [&](const Chunk& rows) {
        find_rounding(gravity_m_s2, time, scratch, rows.begin, rows.end);
        known.fetch_add(standing.resting.compare(motions, standing.unmoved, rows.begin, rows.end),
                        std::memory_order_relaxed);
    });
    standing.all_rest = known == motions.size();
    standing.most_rest = 2 * known > motions.size();
}

void leave_resting(Motions& motions, std::span<const RowRange> ranges) {
    for (const RowRange& rows : ranges) {
        for (int i = rows.first; i < rows.last; ++i) {
            if (motions.mover[i] != MovedBy::Flight) motions.standing[i] = kRests;
        }
    }
}

void note_resting(int substeps, StepScratch& scratch) {
    Resting& resting = scratch.standing->resting;
    if (substeps > 0 && !scratch.motions.standing.empty()) {
        resting.note(scratch.motions);
    } else {
        resting.forget();
    }
}

}  // namespace cairn::physics
