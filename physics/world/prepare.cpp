// Packing of constraints, and unpacking of impulses.
#include "world/prepare.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "world/contact_events.h"
#include "world/special_contacts.h"
#include "world/sweeping_contacts.h"

namespace cairn::physics {
namespace {

// rad. Below, separations are linear in the angle: that is wrong by half its square times the arm.
constexpr float kMaxTurn_rad = 0.25f;

// rad. A point of a body that turns further in a step goes round and not along.
constexpr float kWhirl_rad = 1;

// What a thread takes at once.
constexpr int kRowsPerChunk = 512;
constexpr int kContactsPerChunk = 128;

// Substeps that gravity alone asks for, so that no setting makes a step endless: enough for 9,200 m/s2 at
// 1/60 s.
constexpr int kMostForGravity = 32;

Drive drive_of(const BodyRecord& record, Vec2 gravity_m_s2, Vec2 force_n, float torque_nm) {
    Drive drive;
    if (record.inverse_mass == 0) return drive;  // a body without mass keeps its velocity
    drive.acceleration = without_locked(record.gravity_scale * gravity_m_s2 + record.inverse_mass * force_n,
                                        locked_axes(record));
    drive.angular_acceleration = record.inverse_inertia * torque_nm;
    drive.linear_damping = record.linear_damping_1_s;
    drive.angular_damping = record.angular_damping_1_s;
    drive.gravity_scale = record.gravity_scale;
    return drive;
}

// Those of awake rows from the first on.
void set_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, int first, StepScratch& scratch,
                 TaskPool& tasks) {
    Motions& motions = scratch.motions;
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    motions.resize(awake.size() + 1);
    resize_amply(scratch.drives, static_cast<std::size_t>(motions.size()));
    scratch.noted_rows.start(awake.size() - first, kRowsPerChunk, tasks);
    std::atomic<bool> some_turn_far = false;
    tasks.parallel_for(awake.size() - first, kRowsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender noted(scratch.noted_rows, chunk);
        for (int row = first + chunk.begin; row < first + chunk.end; ++row) {
            const BodyRecord& record = bodies.slots[awake.body[row]];
            motions.set_row(row + 1, awake.velocity[row], awake.spin[row], record.inverse_mass,
                            record.inverse_inertia, record.extent_m);
            scratch.drives[row + 1] = drive_of(record, gravity_m_s2, awake.force[row], awake.torque[row]);
            std::uint32_t& flags = bodies.places[awake.body[row]].flags;
            flags &= ~(place_flag::kTurnsFar | place_flag::kWhirls | place_flag::kSweeps);
            const float turn = std::fabs(awake.spin[row]) * dt_s;
            const bool is_swept = sweeps(record, turn);
            if (turn > kMaxTurn_rad || is_swept) {
                some_turn_far.store(true, std::memory_order_relaxed);
                flags |= place_flag::kTurnsFar;
                if (turn > kWhirl_rad) flags |= place_flag::kWhirls;
                if (is_swept) flags |= place_flag::kSweeps;
            }
            const bool carries =
                record.type == BodyType::Kinematic && (is_swept || (flags & place_flag::kFast) != 0);
            if (locked_axes(record) != 0 || carries) noted.items().push_back(row);
        }
    });
    scratch.motions.some_turn_far |= some_turn_far;
    scratch.noted_rows.for_each([&](int row) {
        const BodyRecord& record = bodies.slots[awake.body[row]];
        if (record.type == BodyType::Kinematic) {
            push_amply(scratch.paddles, awake.body[row]);
        } else {
            motions.lock(row + 1, locked_axes(record));
        }
    });
}

void mark_mover(Motions& motions, int row, MovedBy mover) {
    if (motions.mover[row] < mover) motions.mover[row] = mover;
}

}  // namespace

int substeps_under(float gravity_m_s2, float dt_s, int least, float unit) {
    const float slop_m = (unit < 1 ? 0.5f * unit : 1) * tuning::kLinearSlop_m;
    const float needed = std::min(dt_s * std::sqrt(2 * gravity_m_s2 / slop_m), float{kMostForGravity});
    int substeps = 1;
    while (static_cast<float>(substeps) < needed) substeps *= 2;
    return std::max(least, substeps);
}

namespace {

// How long a substep counts that no longer one has followed.
constexpr float kLongestCounts_s = 1;

float longest_substep(float h_s, const LastSteps& last) {
    return h_s >= last.longest_h_s || last.since_s >= kLongestCounts_s ? h_s : last.longest_h_s;
}

}  // namespace

StepTime make_step_time(float dt_s, int substeps, const LastSteps& last) {
    const float h_s = dt_s / static_cast<float>(substeps);
    const float ratio = last.h_s > 0 ? h_s / last.h_s : 1;
    return {
        dt_s, h_s, substeps, ratio, std::min(ratio, 1.0f), most_swept_frequency(longest_substep(h_s, last))};
}

void note_step(const StepTime& time, LastSteps& last) {
    const float longest_h_s = longest_substep(time.h_s, last);
    last.since_s = longest_h_s == time.h_s ? 0 : last.since_s + time.dt_s;
    last.longest_h_s = longest_h_s;
    last.h_s = time.h_s;
}

void prepare_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch,
                     TaskPool& tasks) {
    scratch.motions.locked.clear();
    scratch.paddles.clear();
    scratch.motions.some_turn_far = false;
    set_motions(bodies, gravity_m_s2, dt_s, 0, scratch, tasks);
    scratch.motions.set_row(kWorldRow, {}, 0, 0, 0);
    scratch.drives[kWorldRow] = {};
}

void extend_motions(BodyStore& bodies, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch, TaskPool& tasks) {
    const int known = scratch.motions.size() - 1;
    if (known < bodies.rows(RowSet::Awake).size()) {
        set_motions(bodies, gravity_m_s2, dt_s, known, scratch, tasks);
    }
}

void choose_movers(const Stores& stores, StepScratch& scratch) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const auto acts_on = [](const std::vector<std::uint32_t>& colors, std::size_t body) {
        return body < colors.size() && colors[body] != 0;
    };
    for (int row = 0; row < awake.size(); ++row) {
        const auto body = static_cast<std::size_t>(awake.body[row]);
        if (acts_on(stores.joints.colors, body)) {
            scratch.motions.mover[row + 1] = MovedBy::Jointed;
        } else if (acts_on(stores.contacts.colors, body)) {
            scratch.motions.mover[row + 1] = MovedBy::Substeps;
        }
    }
    for (const int i : scratch.scalar_contacts) {
        mark_mover(scratch.motions, scratch.contacts[i].a, MovedBy::Turning);
        mark_mover(scratch.motions, scratch.contacts[i].b, MovedBy::Turning);
    }
    for (const SweepingContact& sweeping : scratch.sweeping) {
        const ContactConstraint& c = scratch.contacts[static_cast<std::size_t>(sweeping.contact)];
        mark_mover(scratch.motions, c.a, MovedBy::Turning);
        mark_mover(scratch.motions, c.b, MovedBy::Turning);
    }
    for (const AwaitedContact& awaited : scratch.awaited) {
        mark_mover(scratch.motions, awaited.input.a, MovedBy::Turning);
        mark_mover(scratch.motions, awaited.input.b, MovedBy::Turning);
    }
    // What carries others moves with them.
    const ContactLanes& lanes = stores.contacts.lanes;
    for (const int bucket : lanes.buckets()) {
        if (kind_of(bucket) != BlockKind::Carried) continue;
        for (const int block : lanes.blocks(bucket)) {
            for (const int row : lanes.block(block).a) mark_mover(scratch.motions, row, MovedBy::Substeps);
        }
    }
}

void collect_outcomes(const ContactStore& contacts, StepScratch& scratch, TaskPool& tasks) {
    const auto collect = [&](ContactConstraint& c) {
        if (!c.in_lane) return;
        const ContactRecord& record = contacts.slots[c.contact];
        const ContactBlock& block = contacts.lanes.block(record.lane / kLanes);
        const int lane = record.lane % kLanes;
        for (int i = 0; i < c.count; ++i) {
            c.points[i].normal_impulse = block.points[i].impulse[lane];
            c.points[i].total_normal_impulse = block.total_impulse[i][lane];
            c.points[i].end_separation = block.points[i].separation[lane];
        }
        c.friction_impulse = block.friction_impulse[lane];
    };
    tasks.parallel_for(static_cast<int>(scratch.contacts.size()), kContactsPerChunk, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) collect(scratch.contacts[static_cast<std::size_t>(i)]);
    });
}

void store_contact_impulses(ContactStore& contacts, const StepTime& time, const StepScratch& scratch) {
    for (const ContactConstraint& c : scratch.contacts) {
        ContactRecord& record = contacts.slots[c.contact];
        ContactMemory memory;
        // What came to a stop in the last substep has been stopped: it is not to be pushed as much again, but
        // only to be borne.
        const bool is_blow = c.reached_s > time.dt_s - time.h_s;
        float normal = 0;
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& p = c.points[i];
            memory.features[i] = p.feature;
            memory.impulse[i] = is_blow ? std::min(p.normal_impulse, p.static_impulse) : p.normal_impulse;
            normal += memory.impulse[i];
        }
        const float most = c.friction * normal;
        memory.friction_impulse = is_blow ? std::clamp(c.friction_impulse, -most, most) : c.friction_impulse;
        if (is_colored(record.bucket)) {
            contacts.lanes.set_memory(record.lane, memory);
        } else {
            record.memory = memory;
        }
    }
}

}  // namespace cairn::physics
