// Rows of bodies in SIMD lanes. What is read of a record stands in rows of four floats.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/body_lanes.cpp"
#include "world/body_lanes.h"

#include <algorithm>
#include <cstddef>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/prefetch.h"
#include "base/simd_rows-inl.h"
#include "base/simd_turn-inl.h"
#include "base/simd_vec-inl.h"
#include "world/fast_bodies.h"
#include "world/tiny_contacts.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

// Of what is added up, the share that float may lose; and what stands for that of a way beyond all measure.
constexpr float kRounding = 1e-6f;
constexpr float kMostRounding_m = 1e3f;

HWY_INLINE V length(Vec a) {
    return hn::Sqrt(dot(a, a));
}

// Four floats of each record, from the one at `offset` on.
HWY_INLINE Columns load_records(const BodyLanes& lanes, int lane, std::size_t offset) {
    const float* from[kStep];
    for (int i = 0; i < kStep; ++i)
        from[i] =
            reinterpret_cast<const float*>(reinterpret_cast<const char*>(lanes.records[lane + i]) + offset);
    return load_rows(from, 0);
}

constexpr std::size_t kMassRow = offsetof(BodyRecord, inverse_mass);
static_assert(offsetof(BodyRecord, inverse_inertia) == kMassRow + 4 &&
              offsetof(BodyRecord, extent_m) == kMassRow + 8 &&
              offsetof(BodyRecord, turn_arm_m) == kMassRow + 12);
constexpr std::size_t kDriveRow = offsetof(BodyRecord, inner_radius_m);
static_assert(offsetof(BodyRecord, gravity_scale) == kDriveRow + 12);
constexpr std::size_t kSleepRow = offsetof(BodyRecord, sleep_speed_m_s);

// A column of the rows, and zero for those that there are not.
HWY_INLINE V load_column(const BodyLanes& lanes, int lane, const std::vector<float>& column) {
    const float* from = column.data() + lanes.first;
    if (HWY_LIKELY(lanes.count == kLanes)) return hn::LoadU(D(), from + lane);
    alignas(32) float values[kStep] = {};
    for (int i = 0; i < kStep && lane + i < lanes.count; ++i) values[i] = from[lane + i];
    return hn::Load(D(), values);
}

HWY_INLINE void store_column(V v, const BodyLanes& lanes, int lane, std::vector<float>& column) {
    float* to = column.data() + lanes.first;
    if (HWY_LIKELY(lanes.count == kLanes)) {
        hn::StoreU(v, D(), to + lane);
        return;
    }
    alignas(32) float values[kStep];
    hn::Store(v, D(), values);
    for (int i = 0; i < kStep && lane + i < lanes.count; ++i) to[lane + i] = values[i];
}

HWY_INLINE Vec load_vectors(const BodyLanes& lanes, int lane, const std::vector<Vec2>& column) {
    alignas(32) std::int32_t rows[kStep];
    for (int i = 0; i < kStep; ++i) rows[i] = lanes.first + std::min(lane + i, lanes.count - 1);
    return load_vecs(column.data(), rows);
}

void look_ahead(const BodyStore& bodies, const BodyLanes& lanes, Vec2 gravity_m_s2, float dt_s, float seen_m,
                AheadLanes& ahead) {
    const BodyRows& awake = bodies.rows(RowSet::Awake);
    const V dt = set(dt_s);
    const V zero = hn::Zero(D());
    unsigned fast = 0;
    unsigned hasty = 0;
    unsigned far_ways = 0;
    unsigned seen_late = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const Columns mass =
            load_records(lanes, lane, kMassRow);  // inverse mass, inverse inertia, extent, arm
        const Columns drive = load_records(lanes, lane, kDriveRow);  // inner radius, damping, gravity scale
        const Vec v = load_vectors(lanes, lane, awake.velocity);
        const V spin = load_column(lanes, lane, awake.spin);
        const V pull = hn::Mul(set(0.5f * dt_s), drive.u);
        const M falls = hn::Gt(mass.x, zero);
        const Vec expected{hn::IfThenElse(falls, hn::Add(v.x, hn::Mul(pull, set(gravity_m_s2.x))), v.x),
                           hn::IfThenElse(falls, hn::Add(v.y, hn::Mul(pull, set(gravity_m_s2.y))), v.y)};
        const V turning = hn::Mul(hn::Abs(spin), mass.u);
        const V thin = hn::Mul(set(kFastShare), drive.x);
        const V calm = hn::Min(thin, set(kCalmWay_m));
        const V speed = length(expected);
        const V farthest = hn::Mul(dt, hn::Add(speed, turning));
        fast |= bits_of(hn::Gt(farthest, thin)) << lane;
        hasty |= bits_of(hn::Gt(farthest, calm)) << lane;
        far_ways |= bits_of(hn::Gt(hn::Mul(dt, speed), mass.z)) << lane;
        seen_late |= bits_of(hn::Gt(farthest, set(seen_m))) << lane;

        const Vec way = scale(dt, expected);
        const V turn = hn::Mul(dt, spin);
        // A point that turns is at most this far from the straight way between its ends.
        const V bulge = least(hn::Mul(hn::Mul(set(0.125f), turn), turn), set(2));
        const V aside = hn::Mul(bulge, mass.u);
        const V rounding = least(set(kMostRounding_m), hn::Mul(set(kRounding), hn::Add(length(way), mass.z)));
        store(way.x, ahead.way_x, lane);
        store(way.y, ahead.way_y, lane);
        store(turn, ahead.turn, lane);
        store(rounding, ahead.rounding, lane);
        store(hn::Add(aside, rounding), ahead.room, lane);
        alignas(32) std::int32_t rows[kStep];
        for (int i = 0; i < kStep; ++i) rows[i] = lane + i;
        store_rows(&ahead.advances[0].velocity_m_s.x, rows, {expected.x, expected.y, turning, calm});
    }
    ahead.fast = static_cast<LaneBits>(fast);
    ahead.hasty = static_cast<LaneBits>(hasty);
    ahead.far_ways = static_cast<LaneBits>(far_ways);
    ahead.seen_late = static_cast<LaneBits>(seen_late);
}

// The bits of a byte of integers.
HWY_INLINE VI byte_of(VI numbers, int byte) {
    return hn::And(hn::ShiftRightSame(numbers, 8 * byte), set_int(0xff));
}

HWY_INLINE M is_set(VI bytes) {
    return hn::RebindMask(D(), hn::Ne(bytes, hn::Zero(DI())));
}

PlaceOutcome take_places(BodyStore& bodies, const BodyLanes& lanes, const Motions& motions,
                         std::span<const Advance> advances, float dt_s, bool sleep_enabled) {
    static_assert(offsetof(BodyRecord, type) == 0 && offsetof(BodyRecord, allow_sleep) == 2);
    BodyRows& awake = bodies.rows(RowSet::Awake);
    const V dt = set(dt_s);
    const V zero = hn::Zero(D());
    unsigned hurled = 0;
    unsigned box_left = 0;
    unsigned rest_by_rule = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        alignas(32) std::int32_t rows[kStep];
        const float* turn_rows[kStep];
        for (int i = 0; i < kStep; ++i) {
            rows[i] = lanes.first + std::min(lane + i, lanes.count - 1) + 1;
            turn_rows[i] = &lanes.places[lane + i]->rotation.c;
        }
        const Columns pose = load_rows(&motions.pose[0].d.x, rows);          // way, turn, scale of angles
        const Columns velocity = load_rows(&motions.velocity[0].v.x, rows);  // velocity, spin
        const Columns expected = load_rows(&advances[0].velocity_m_s.x, rows);
        const Columns place = load_rows(turn_rows, 0);              // rotation, row, flags
        const Columns mass = load_records(lanes, lane, kMassRow);   // extent and arm in the third and fourth
        const Columns thin = load_records(lanes, lane, kDriveRow);  // inner radius
        const V spin_before = load_column(lanes, lane, awake.spin);
        const V turned = hn::Mul(pose.z, pose.u);
        const V spin = hn::Mul(velocity.z, pose.u);

        // The box of a hasty body has room about where it was expected.
        const VI flags = hn::BitCast(DI(), place.u);
        const auto flagged = [&](std::uint32_t flag) HWY_ATTR {
            return hn::RebindMask(D(), hn::Ne(hn::And(flags, set_int(flag)), hn::Zero(DI())));
        };
        const M hasty = flagged(place_flag::kHasty);
        const Vec aside = select(
            hasty, {hn::Sub(pose.x, hn::Mul(dt, expected.x)), hn::Sub(pose.y, hn::Mul(dt, expected.y))},
            {pose.x, pose.y});
        const V turned_aside = hn::IfThenElse(hasty, hn::Sub(turned, hn::Mul(dt, spin_before)), turned);
        const V went = hn::Add(length(aside), hn::Mul(hn::Abs(turned_aside), mass.u));
        const V slack = hn::Sub(load_column(lanes, lane, awake.box_slack), went);
        store_column(slack, lanes, lane, awake.box_slack);
        box_left |= bits_of(hn::Not(hn::Gt(slack, zero))) << lane;
        const V moved = length({pose.x, pose.y});
        const V farthest_point = hn::Add(moved, hn::Mul(hn::Abs(turned), mass.u));
        const M is_far = hn::Gt(farthest_point, hn::Mul(set(kFastShare), thin.x));
        hurled |= bits_of(hn::AndNot(flagged(place_flag::kFast), is_far)) << lane;
        store_column(spin, lanes, lane, awake.spin);

        // What is pushed out of an overlap moves, though that speed is taken from it again at once: it would
        // sleep where it is, and keep the overlap.
        const Columns sleep = load_records(lanes, lane, kSleepRow);
        const V fastest = greatest(length({velocity.x, velocity.y}), hn::Mul(hn::Abs(spin), mass.z));
        const V farthest = greatest(moved, hn::Mul(hn::Abs(turned), mass.z));
        const VI head = hn::BitCast(DI(), load_records(lanes, lane, 0).x);  // type, set, whether it may sleep
        const M may_sleep = is_set(byte_of(head, 2));
        const M rests =
            hn::And(hn::And(hn::Lt(fastest, sleep.x), hn::Lt(farthest, hn::Mul(dt, sleep.x))), may_sleep);
        const V rest_time = load_column(lanes, lane, awake.rest_time);
        const M is_other =
            hn::Or(hn::RebindMask(
                       D(), hn::Ne(byte_of(head, 0), set_int(static_cast<std::int32_t>(BodyType::Dynamic)))),
                   hn::Lt(mass.z, set(kTinyExtent_m)));
        if (sleep_enabled) {
            rest_by_rule |= bits_of(is_other) << lane;
            const V longer = hn::IfThenElseZero(rests, hn::Add(rest_time, dt));
            store_column(hn::IfThenElse(is_other, rest_time, longer), lanes, lane, awake.rest_time);
        } else {
            store_column(zero, lanes, lane, awake.rest_time);
        }

        const Vec turn = small_turn(turned);
        // The product of both, of length 1.
        const Vec now{hn::Sub(hn::Mul(turn.x, place.x), hn::Mul(turn.y, place.y)),
                      hn::Add(hn::Mul(turn.y, place.x), hn::Mul(turn.x, place.y))};
        const V norm = length(now);
        const M has_length = hn::Gt(norm, zero);
        alignas(32) float c[kStep];
        alignas(32) float s[kStep];
        hn::Store(hn::IfThenElse(has_length, hn::Div(now.x, norm), set(1)), D(), c);
        hn::Store(hn::IfThenElseZero(has_length, hn::Div(now.y, norm)), D(), s);
        for (int i = 0; i < kStep && lane + i < lanes.count; ++i) {
            const auto row = static_cast<std::size_t>(lanes.first + lane + i);
            Place& to = *lanes.places[lane + i];
            const Vec2 way = motions.pose[row + 1].d;
            awake.rotation_before[row] = to.rotation;
            awake.moved[row] = way;
            awake.velocity[row] = motions.velocity[row + 1].v;
            awake.force[row] = {};
            awake.torque[row] = 0;
            to.center = to.center + way;
            to.rotation = {c[i], s[i]};
        }
    }
    const unsigned all = (1u << lanes.count) - 1;
    return {static_cast<LaneBits>(hurled & all), static_cast<LaneBits>(box_left & all),
            static_cast<LaneBits>(rest_by_rule & all)};
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(look_ahead);
HWY_EXPORT(take_places);

BodyLanes body_lanes(BodyStore& bodies, int first, int last) {
    const std::vector<int>& body_of = bodies.rows(RowSet::Awake).body;
    BodyLanes lanes{.first = first, .count = std::min(last - first, kLanes)};
    // Rows of what woke body by body are in no order that hardware would foresee.
    for (int row = first + 2 * kLanes; row < std::min(first + 3 * kLanes, last); ++row)
        bodies.ask_for(body_of[static_cast<std::size_t>(row)]);
    for (int lane = 0; lane < lanes.count; ++lane) {
        const int body = body_of[static_cast<std::size_t>(first + lane)];
        lanes.records[lane] = &bodies.slots[body];
        lanes.places[lane] = &bodies.places[static_cast<std::size_t>(body)];
    }
    for (int lane = lanes.count; lane < kLanes; ++lane) {
        lanes.records[lane] = lanes.records[lanes.count - 1];
        lanes.places[lane] = lanes.places[lanes.count - 1];
    }
    return lanes;
}

void look_ahead(const BodyStore& bodies, const BodyLanes& lanes, Vec2 gravity_m_s2, float dt_s, float seen_m,
                AheadLanes& ahead) {
    HWY_DYNAMIC_DISPATCH(look_ahead)(bodies, lanes, gravity_m_s2, dt_s, seen_m, ahead);
}

PlaceOutcome take_places(BodyStore& bodies, const BodyLanes& lanes, const Motions& motions,
                         std::span<const Advance> advances, float dt_s, bool sleep_enabled) {
    return HWY_DYNAMIC_DISPATCH(take_places)(bodies, lanes, motions, advances, dt_s, sleep_enabled);
}

}  // namespace cairn::physics
#endif
