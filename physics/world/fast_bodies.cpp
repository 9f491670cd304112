// Prediction of contacts for fast bodies.
#include "world/fast_bodies.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "continuous/passage.h"
#include "world/body_lanes.h"
#include "world/box_cover.h"
#include "world/finalize.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {
namespace {

// m. Sweeps end with this gap: near enough to be a contact, wide enough for the distance to have a direction.
constexpr float kImpactGap_m = 0.25f * tuning::kLinearSlop_m;

// m. Ways up to this end where the solver sees the other shape before they begin, and wakes it.
constexpr float kSeenAhead_m = tuning::kSpeculativeDistance_m;

// Of what is solid about the thinner shape: so deep a corner may be in it. With a half, balls of 1 cm fell
// through gaps that were narrower than they.
constexpr float kCornerShare = 0.1f;

// Flags of bodies of which boxes cover the way.
constexpr std::uint32_t kCovered = place_flag::kHasty | place_flag::kRouses;

// What is left of the step before.
constexpr std::uint32_t kOutdated =
    kCovered | place_flag::kFast | place_flag::kStrayed | place_flag::kHasWay | place_flag::kLost;

// What a thread takes at once.
constexpr int kRowsPerChunk = 512;

// The mean velocity over the step if nothing is met.
Vec2 expected_velocity(const BodyStore& bodies, int body, Vec2 gravity, float dt_s) {
    const BodyRecord& record = bodies.slots[body];
    const Vec2 v = bodies.rows_of(body).velocity[record.row];
    const bool falls = record.set == RowSet::Awake && record.inverse_mass > 0;
    return falls ? v + 0.5f * dt_s * record.gravity_scale * gravity : v;
}

Advance advance_of(const BodyStore& bodies, int body, Vec2 gravity, float dt_s) {
    const BodyRecord& record = bodies.slots[body];
    return {expected_velocity(bodies, body, gravity, dt_s),
            std::fabs(bodies.rows_of(body).spin[record.row]) * record.turn_arm_m,
            std::min(kFastShare * record.inner_radius_m, kCalmWay_m)};
}

struct Marks {
    bool covered = false;   // boxes are to cover the way
    bool has_way = false;   // and to go along it
    bool outgrown = false;  // boxes covered a longer way in the step before, and would be too large for long
};

// Sets the flags of a body for the step.
Marks mark_ahead(std::uint32_t& flags, const AheadLanes& ahead, int lane, bool some_sleep) {
    const std::uint32_t outdated = flags & kOutdated;
    const bool is_fast = (ahead.fast >> lane & 1) != 0;
    const bool is_hasty = (ahead.hasty >> lane & 1) != 0;
    const bool rouses = some_sleep && !is_hasty && (ahead.seen_late >> lane & 1) != 0;
    const std::uint32_t before = outdated & kCovered;
    const std::uint32_t now = is_hasty ? place_flag::kHasty : rouses ? place_flag::kRouses : 0;
    // Boxes over ways that are longer than the body overlap those of many that go along; boxes over shorter
    // ones hold for several steps.
    const bool has_way = is_fast && (ahead.far_ways >> lane & 1) != 0;
    const bool had_way = (outdated & place_flag::kHasWay) != 0;
    flags =
        (flags & ~kOutdated) | now | (is_fast ? place_flag::kFast : 0) | (has_way ? place_flag::kHasWay : 0);
    return {now != 0, has_way, (before != 0 && before != now && !is_hasty) || (had_way && !has_way)};
}

Sweep make_sweep(const Stores& stores, int shape, Position origin, Vec2 gravity, float dt_s) {
    const int body = stores.shapes[shape].body;
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const Place& place = stores.bodies.places[body];
    return {&stores.shapes[shape].convex(),
            place.center - origin,
            place.rotation,
            record.mass.center_m,
            expected_velocity(stores.bodies, body, gravity, dt_s),
            rows.spin[record.row]};
}

// m. How deep a pair may be when its contact is made: not so deep that the centre of one is in the other.
float surprise_of(const BodyRecord& a, const BodyRecord& b) {
    float depth_m = kSurprise_m;
    for (const BodyRecord* body : {&a, &b}) {
        if (body->type == BodyType::Dynamic) depth_m = std::min(depth_m, kFastShare * body->inner_radius_m);
    }
    return depth_m;
}

// m. How far gravity moves the two of a contact apart or together in the step, at most.
float fall_of(const BodyStore& bodies, const ContactRecord& contact, Vec2 gravity, float dt_s) {
    const auto fall = [&](int body) {
        return dt_s * length(expected_velocity(bodies, body, gravity, dt_s) -
                             expected_velocity(bodies, body, {}, dt_s));
    };
    return fall(contact.body_a) + fall(contact.body_b);
}

// m. How deep a corner may be when it is met that is passed at first: so little that it does not go through.
float may_fall(const BodyStore& bodies, const ContactRecord& contact) {
    float depth_m = tuning::kLinearSlop_m;
    for (const int body : {contact.body_a, contact.body_b}) {
        const BodyRecord& record = bodies.slots[body];
        if (record.type == BodyType::Dynamic)
            depth_m = std::min(depth_m, kCornerShare * record.inner_radius_m);
    }
    return depth_m;
}

// How far the solver will see a point moved that it knows by this arm, when the body has moved on by time_s.
Vec2 moved(const Sweep& sweep, Vec2 arm, float time_s) {
    const Rotation turned = Rotation::from_small_angle(sweep.spin * time_s);
    return time_s * sweep.velocity + rotate(turned, arm) - arm;
}

}  // namespace

void cover_fast_ways(Stores& stores, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch, TaskPool& tasks) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    resize_amply(scratch.advances, static_cast<std::size_t>(awake.size()) + 1);
    scratch.advances[kWorldRow] = {};
    const bool some_sleep = stores.bodies.rows(RowSet::Asleep).size() > 0;
    scratch.fast_found.start(awake.size(), kRowsPerChunk, tasks);
    scratch.untold_boxes.start(awake.size(), kRowsPerChunk, tasks);
    std::atomic<bool> some_have_ways = false;
    std::atomic<float> thinnest_m = std::numeric_limits<float>::infinity();  // of what is fast
    tasks.parallel_for(awake.size(), kRowsPerChunk, [&](const Chunk& chunk) {
        float thinnest_here_m = std::numeric_limits<float>::infinity();
        bool some_here = false;
        ChunkedList<int>::Appender fast(scratch.fast_found, chunk);
        ChunkedList<int>::Appender untold(scratch.untold_boxes, chunk);
        BoxCover boxes(stores, untold.items());
        AheadLanes ahead;
        for (int row = chunk.begin; row < chunk.end; row += kLanes) {
            const BodyLanes lanes = body_lanes(stores.bodies, row, chunk.end);
            look_ahead(stores.bodies, lanes, gravity_m_s2, dt_s, kSeenAhead_m, ahead);
            std::copy_n(ahead.advances.begin(), lanes.count, scratch.advances.begin() + row + 1);
            for (int lane = 0; lane < lanes.count; ++lane) {
                const int body = awake.body[row + lane];
                const auto [covered, has_way, outgrown] =
                    mark_ahead(lanes.places[lane]->flags, ahead, lane, some_sleep);
                if ((ahead.fast >> lane & 1) != 0) {
                    fast.items().push_back(body);
                    thinnest_here_m = std::min(thinnest_here_m, lanes.records[lane]->inner_radius_m);
                }
                some_here |= has_way;
                if (outgrown) {
                    boxes.finish();  // so that what is untold is in the order of the bodies
                    renew_boxes(stores, body, untold.items());
                }
                if (covered) boxes.add(body, ahead, lane, has_way);
            }
        }
        boxes.finish();
        if (some_here) some_have_ways.store(true, std::memory_order_relaxed);
        float least_m = thinnest_m;
        while (thinnest_here_m < least_m && !thinnest_m.compare_exchange_weak(least_m, thinnest_here_m)) {
        }
    });
    tell_fat_boxes(stores, scratch, some_have_ways ? dt_s : 0, tasks);
    scratch.fast_found.copy_to(scratch.fast);
    scratch.stray_m = 0.5f * thinnest_m;
}

void extend_advances(Stores& stores, Vec2 gravity_m_s2, float dt_s, StepScratch& scratch) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    for (int row = static_cast<int>(scratch.advances.size()) - 1; row < awake.size(); ++row) {
        stores.bodies.places[awake.body[row]].flags &= ~kOutdated;
        scratch.advances.push_back(advance_of(stores.bodies, awake.body[row], gravity_m_s2, dt_s));
    }
}

bool could_meet(const Advance& a, const Advance& b, const AxisGap& seen, float dt_s) {
    const Vec2 velocity = b.velocity_m_s - a.velocity_m_s;
    const float turning = a.turning_m_s + b.turning_m_s;
    // What moves along with the other neither passes through it nor gets deep into it.
    if (dt_s * (length(velocity) + turning) <= std::min(a.calm_way_m, b.calm_way_m)) return false;
    return seen.gap_m <= 0 || seen.gap_m - dt_s * (turning - dot(velocity, seen.axis)) <= kImpactGap_m;
}

bool goes_over_corner(const Stores& stores, const ContactRecord& contact, Vec2 gravity_m_s2, Vec2 normal,
                      float dt_s) {
    // What it comes from holds it, so it does not fall; if not, it may fall in by so much until it is met.
    if (fall_of(stores.bodies, contact, gravity_m_s2, dt_s) > may_fall(stores.bodies, contact)) return false;
    const Position origin = stores.bodies.places[contact.body_a].center;
    const Sweep a = make_sweep(stores, contact.shape_a, origin, {}, dt_s);
    const Sweep b = make_sweep(stores, contact.shape_b, origin, {}, dt_s);
    return Passage(a, b, dt_s).goes_over_corner(normal);
}

bool predict_contact(const Stores& stores, const ContactRecord& contact, const AxisGap& seen,
                     Vec2 gravity_m_s2, float dt_s, ContactInput& input) {
    const BodyStore& bodies = stores.bodies;
    const BodyRecord& body_a = bodies.slots[contact.body_a];
    const BodyRecord& body_b = bodies.slots[contact.body_b];
    const Advance advance_a = advance_of(bodies, contact.body_a, gravity_m_s2, dt_s);
    const Advance advance_b = advance_of(bodies, contact.body_b, gravity_m_s2, dt_s);
    AxisGap apart = seen;
    if (apart.gap_m <= 0) {
        const Vec2 between = bodies.center_offset(contact.body_a, contact.body_b);
        apart = {normalized(between), length(between) - body_a.extent_m - body_b.extent_m};
    }
    if (!could_meet(advance_a, advance_b, apart, dt_s)) return false;

    const Position origin = bodies.places[contact.body_a].center;
    const Sweep a = make_sweep(stores, contact.shape_a, origin, gravity_m_s2, dt_s);
    const Sweep b = make_sweep(stores, contact.shape_b, origin, gravity_m_s2, dt_s);
    const float unit = length_unit(stores, contact);
    Passage passage(a, b, dt_s);
    if (passage.keeps_apart(apart, unit * kImpactGap_m)) return false;
    if (passage.goes_along(surprise_of(body_a, body_b))) return false;
    const std::optional<float> time = time_of_impact(a, b, dt_s, unit * kImpactGap_m, apart);
    if (!time) return false;

    const SweptPose pose_a = pose_at(a, *time);
    const RelativePose b_in_a = relative_pose(pose_a, pose_at(b, *time));
    const Manifold m = unit == 1 ? collide(*a.shape, *b.shape, b_in_a, tuning::kSpeculativeDistance_m)
                                 : collide_in_unit(*a.shape, *b.shape, b_in_a, unit);
    input = {};
    input.normal = rotate(pose_a.rotation, m.normal);
    input.count = m.count;
    for (int i = 0; i < m.count; ++i) {
        const Vec2 at = pose_a.origin + rotate(pose_a.rotation, m.points[i].point);
        ContactInput::Point& p = input.points[i];
        // The arms are those of the impact, so that both bodies feel the impulse in one place. The gap is
        // chosen such that the one which the solver sees at the impact is the true one.
        p.r_a = at - (a.center + *time * a.velocity);
        p.r_b = at - (b.center + *time * b.velocity);
        p.feature = m.points[i].id;
        p.separation =
            m.points[i].separation - dot(moved(b, p.r_b, *time) - moved(a, p.r_a, *time), input.normal);
    }
    input.reached_s = *time;
    input.friction = contact.friction;
    input.restitution = contact.restitution;
    input.radius_a = a.shape->radius();
    input.radius_b = b.shape->radius();
    return m.count > 0;
}

}  // namespace cairn::physics
