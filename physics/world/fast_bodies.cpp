// Prediction of contacts for fast bodies.
#include "world/fast_bodies.h"

#include <algorithm>
#include <limits>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "world/finalize.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {
namespace {

// m. Sweeps end with this gap: near enough to be a contact, wide enough for the distance to have a direction.
constexpr float kImpactGap_m = 0.25f * tuning::kLinearSlop_m;

// Of what is added up, the share that float may lose; and what stands for that of a way beyond all measure.
constexpr float kRounding = 1e-6f;
constexpr float kMostRounding_m = 1e3f;

// m. Ways up to this end where the solver sees the other shape before they begin, and wakes it.
constexpr float kSeenAhead_m = tuning::kSpeculativeDistance_m;

// Flags of bodies of which boxes cover the way.
constexpr std::uint32_t kCovered = place_flag::kFast | place_flag::kRouses;

// What is left of the step before.
constexpr std::uint32_t kOutdated = kCovered | place_flag::kStrayed | place_flag::kHasWay;

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
            kFastShare * record.inner_radius_m};
}

// How far a step takes any point of a body at most.
float farthest_way(const Advance& advance, float dt_s) {
    return dt_s * (length(advance.velocity_m_s) + advance.turning_m_s);
}

// The boxes of the body enclose where it is and where it is expected, which is `turn` further round, and all
// that lies between. What room they leave is that about the expected place. On a long way they are made
// anew, and go with the body, so that what moves along with it is no neighbour for that alone.
void cover_way(Stores& stores, int body, Vec2 way, float turn, std::vector<int>& untold) {
    const BodyRecord& record = stores.bodies.slots[body];
    const Transform now = stores.bodies.transform(body);
    const Vec2 center = record.mass.center_m;
    const Rotation q = turn == 0 ? now.q : Rotation::from_small_angle(turn) * now.q;
    const bool has_way = (stores.bodies.places[body].flags & place_flag::kHasWay) != 0;
    const Vec2 swing = rotate(now.q, center) - rotate(q, center);
    // A point that turns is at most this far from the straight way between its ends.
    const float aside = turn == 0 ? 0 : std::min(0.125f * turn * turn, 2.0f) * record.turn_arm_m;
    const float rounding = std::min(kMostRounding_m, kRounding * (length(way) + record.extent_m));
    float slack = std::numeric_limits<float>::infinity();
    for (int s = record.first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
        const ShapeRecord& shape = stores.shapes[s];
        const Extents start = extents(shape.convex, now.q);
        const Extents end = turn == 0 ? start : extents(shape.convex, q);
        // A box that goes along holds the shape in each of its turns on all of the way.
        Vec2 lower = smallest(start.lower, end.lower + (way + swing));
        Vec2 upper = largest(start.upper, end.upper + (way + swing));
        if (has_way) {
            lower = smallest(start.lower, end.lower + swing) + smallest({}, way);
            upper = largest(start.upper, end.upper + swing) + largest({}, way);
        }
        const Aabb all = grown(make_aabb(now.p, lower, upper), aside + rounding);
        const Aabb reach = grown(all, tuning::kAabbReach_m);
        if (has_way || !contains(stores.fat_boxes[s], reach)) {
            stores.fat_boxes[s] = grown(all, shape.margin_m);
            untold.push_back(s);
        }
        slack = std::min(slack, clearance(stores.fat_boxes[s], reach));
    }
    // Long ways are rounded when they are added up.
    stores.bodies.rows_of(body).box_slack[record.row] = slack - rounding;
}

Sweep make_sweep(const Stores& stores, int shape, Position origin, Vec2 gravity, float dt_s) {
    const int body = stores.shapes[shape].body;
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const Place& place = stores.bodies.places[body];
    return {&stores.shapes[shape].convex,
            place.center - origin,
            place.rotation,
            record.mass.center_m,
            expected_velocity(stores.bodies, body, gravity, dt_s),
            rows.spin[record.row]};
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
    const auto cover = [&](int row, std::vector<int>& fast, std::vector<int>& untold) {
        const int body = awake.body[row];
        Advance& advance = scratch.advances[row + 1];
        advance = advance_of(stores.bodies, body, gravity_m_s2, dt_s);
        std::uint32_t& flags = stores.bodies.places[body].flags;
        const std::uint32_t outdated = flags & kOutdated;
        const std::uint32_t before = outdated & kCovered;
        flags &= ~kOutdated;
        // A body is fast when a step takes it further than half of what is solid about its thinnest shape.
        const float way = farthest_way(advance, dt_s);
        const bool is_fast = way > advance.thin_m;
        const bool rouses = some_sleep && !is_fast && way > kSeenAhead_m;
        const std::uint32_t now = is_fast ? place_flag::kFast : rouses ? place_flag::kRouses : 0;
        flags |= now;
        if (is_fast) fast.push_back(body);
        // Boxes over ways that are longer than the body overlap those of many that go along; boxes over
        // shorter ones hold for several steps.
        const bool has_way =
            is_fast && dt_s * length(advance.velocity_m_s) > stores.bodies.slots[body].extent_m;
        if (has_way) flags |= place_flag::kHasWay;
        // What covered a longer way would be too large for long.
        const bool had_way = (outdated & place_flag::kHasWay) != 0;
        if ((before != 0 && before != now && !is_fast) || (had_way && !has_way))
            renew_boxes(stores, body, untold);
        if (now != 0) cover_way(stores, body, dt_s * advance.velocity_m_s, dt_s * awake.spin[row], untold);
    };
    tasks.parallel_for(awake.size(), kRowsPerChunk, [&](const Chunk& chunk) {
        ChunkedList<int>::Appender fast(scratch.fast_found, chunk);
        ChunkedList<int>::Appender untold(scratch.untold_boxes, chunk);
        for (int row = chunk.begin; row < chunk.end; ++row) cover(row, fast.items(), untold.items());
    });
    tell_fat_boxes(stores, scratch, tasks);
    scratch.fast_found.copy_to(scratch.fast);
    for (const int body : scratch.fast) {
        const Place& place = stores.bodies.places[body];
        if ((place.flags & place_flag::kHasWay) == 0) continue;
        const Vec2 way = dt_s * scratch.advances[place.row].velocity_m_s;
        for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body)
            stores.broad.set_way(s, way);
    }
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
    // What moves along with the other cannot pass through it.
    if (dt_s * (length(velocity) + turning) <= std::min(a.thin_m, b.thin_m)) return false;
    return seen.gap_m <= 0 || seen.gap_m - dt_s * (turning - dot(velocity, seen.axis)) <= kImpactGap_m;
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
    const std::optional<float> time = time_of_impact(a, b, dt_s, unit * kImpactGap_m, apart);
    if (!time) return false;

    const RelativePose b_in_a = relative_pose_at(a, b, *time);
    const Manifold m = unit == 1 ? collide(*a.shape, *b.shape, b_in_a, tuning::kSpeculativeDistance_m)
                                 : collide_in_unit(*a.shape, *b.shape, b_in_a, unit);
    const SweptPose pose_a = pose_at(a, *time);
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
    const auto whirls = [&](int body) {
        return (bodies.places[body].flags & place_flag::kWhirls) != 0 &&
               bodies.slots[body].turn_arm_m > tuning::kLinearSlop_m;
    };
    if (whirls(contact.body_a) || whirls(contact.body_b)) input.reached_s = *time;
    input.friction = contact.friction;
    input.restitution = contact.restitution;
    input.radius_a = a.shape->radius();
    input.radius_b = b.shape->radius();
    return m.count > 0;
}

}  // namespace cairn::physics
