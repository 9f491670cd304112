// Gathering of places. Centres are subtracted in double, so that it does not matter how far from the origin
// they are.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collide/place_lanes.cpp"
#include "collide/place_lanes.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <limits>

#include <cairn/physics/tuning.h>

#include "base/motion.h"
#include "base/simd_rows-inl.h"
#include "base/simd_vec-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cairn::physics {
namespace HWY_NAMESPACE {

constexpr float kFarApart_m = 1e9f;

// Rotations, rows and flags, as bits of floats.
HWY_INLINE Columns load_turns(const Place* places, const std::int32_t* bodies) {
    static_assert(offsetof(Place, rotation) == 16 && sizeof(Rotation) == 8 && sizeof(Place) == 32);
    const float* rows[kStep];
    for (int i = 0; i < kStep; ++i) rows[i] = &places[bodies[i]].rotation.c;
    return load_rows(rows, 0);
}

HWY_INLINE unsigned flagged(VI flags, std::uint32_t flag) {
    const VI set_flags = hn::And(flags, set_int(static_cast<std::int32_t>(flag)));
    return bits_of(hn::RebindMask(D(), hn::Ne(set_flags, hn::Zero(DI()))));
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Vec between(const Place* places, const std::int32_t* a, const std::int32_t* b) {
    const Vec2 d = places[b[0]].center - places[a[0]].center;
    return {set(d.x), set(d.y)};
}

#else

// The centre of b as seen from that of a.
HWY_INLINE Vec between(const Place* places, const std::int32_t* a, const std::int32_t* b) {
    static_assert(offsetof(Place, center) == 0);
    const hn::FixedTag<double, 2> two;
    const hn::FixedTag<float, 2> narrow;
    return from_pairs([&](int i) HWY_ATTR {
        const auto from_a = hn::Load(two, &places[a[i]].center.x);
        return hn::DemoteTo(narrow, hn::Sub(hn::Load(two, &places[b[i]].center.x), from_a));
    });
}

#endif

void load_places(const Place* places, const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b,
                 unsigned lanes, BlockPlaces& out) {
    out.hasty = out.turn_far = out.boxes_moved = out.direct = out.rouses = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const M wanted = wanted_lanes(lanes, lane);
        alignas(32) std::int32_t a[kLanes];
        alignas(32) std::int32_t b[kLanes];
        load_wanted(body_a, wanted, lane, a);
        load_wanted(body_b, wanted, lane, b);
        const Columns turn_a = load_turns(places, a);
        const Columns turn_b = load_turns(places, b);
        const Vec d = between(places, a, b);
        const V one = set(1);
        store(hn::IfThenElse(wanted, d.x, set(kFarApart_m)), out.poses.dx, lane);
        store(hn::IfThenElseZero(wanted, d.y), out.poses.dy, lane);
        store(hn::IfThenElse(wanted, turn_a.x, one), out.poses.cos_a, lane);
        store(hn::IfThenElseZero(wanted, turn_a.y), out.poses.sin_a, lane);
        store(hn::IfThenElse(wanted, turn_b.x, one), out.poses.cos_b, lane);
        store(hn::IfThenElseZero(wanted, turn_b.y), out.poses.sin_b, lane);
        const auto wanted_int = hn::RebindMask(DI(), wanted);
        store(hn::IfThenElse(wanted_int, hn::BitCast(DI(), turn_a.z), set_int(kWorldRow)), out.row_a, lane);
        store(hn::IfThenElse(wanted_int, hn::BitCast(DI(), turn_b.z), set_int(kWorldRow)), out.row_b, lane);
        const VI flags = hn::Or(hn::BitCast(DI(), turn_a.u), hn::BitCast(DI(), turn_b.u));
        out.hasty |= flagged(flags, place_flag::kHasty) << lane;
        out.turn_far |= flagged(flags, place_flag::kTurnsFar) << lane;
        out.boxes_moved |= flagged(flags, place_flag::kBoxesMoved) << lane;
        out.direct |= flagged(flags, place_flag::kDirect) << lane;
        out.rouses |= flagged(flags, place_flag::kRouses) << lane;
    }
    out.hasty &= lanes;
    out.turn_far &= lanes;
    out.boxes_moved &= lanes;
    out.direct &= lanes;
    out.rouses &= lanes;
}

// What rounding may make of a gap, as a share of what the bodies measure and how far apart they are.
constexpr float kRounding = 1e-5f;

// Rows of four numbers of some pairs, from the one at `offset` on.
HWY_INLINE Columns load_pairs(const NearPair* pairs, std::size_t offset) {
    const float* from[kStep];
    for (int i = 0; i < kStep; ++i)
        from[i] = reinterpret_cast<const float*>(reinterpret_cast<const char*>(pairs + i) + offset);
    return load_rows(from, 0);
}

// How far apart the shapes are at least, by when they were looked at. Seen from a, no point of b has gone
// further since than its centre and its own turn took it.
HWY_INLINE V gap_left(const NearPair* pairs, V reach, Vec q_a, Vec q_b, Vec between, V distance) {
    constexpr std::size_t kSightRow = offsetof(NearPair, sight);
    static_assert(kSightRow == 16 && sizeof(NearSight) == 20 && offsetof(NearSight, turn) == 12);
    const Columns head = load_pairs(pairs, kSightRow);       // gap, centre, cosine
    const Columns tail = load_pairs(pairs, kSightRow + 16);  // sine
    const Vec moved = sub(inverse_rotate(q_a, between), {head.y, head.z});
    const Vec chord = sub(inverse_rotate(q_a, q_b), {head.u, tail.x});
    const V turned = hn::Mul(reach, hn::Sqrt(dot(chord, chord)));
    const V rounding = hn::Mul(set(kRounding), hn::Add(reach, distance));
    return hn::Sub(head.x, hn::Add(hn::Add(hn::Sqrt(dot(moved, moved)), turned), rounding));
}

// Discs that hold the shapes, along the line between their centres; and what earlier looks said.
void look_near(const Place* places, const NearPair* pairs, const Advance* advances, float dt_s,
               unsigned lanes, NearLanes& out) {
    static_assert(offsetof(NearPair, body_b) == 4 && offsetof(NearPair, reach_m) == 8 &&
                  offsetof(NearPair, flags) == 12);
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const M wanted = wanted_lanes(lanes, lane);
        const Columns head = load_pairs(pairs + lane, 0);  // bodies, reach, flags
        alignas(32) std::int32_t a[kLanes];
        alignas(32) std::int32_t b[kLanes];
        hn::Store(hn::BitCast(DI(), hn::IfThenElseZero(wanted, head.x)), DI(), a);
        hn::Store(hn::BitCast(DI(), hn::IfThenElseZero(wanted, head.y)), DI(), b);
        const Columns turn_a = load_turns(places, a);
        const Columns turn_b = load_turns(places, b);
        const Vec d = between(places, a, b);
        hn::Store(hn::BitCast(DI(), turn_a.z), DI(), a);
        hn::Store(hn::BitCast(DI(), turn_b.z), DI(), b);
        const Columns advance_a = load_rows(&advances->velocity_m_s.x, a);
        const Columns advance_b = load_rows(&advances->velocity_m_s.x, b);
        const Vec velocity = sub({advance_b.x, advance_b.y}, {advance_a.x, advance_a.y});
        const VI flags = hn::Or(hn::BitCast(DI(), turn_a.u), hn::BitCast(DI(), turn_b.u));
        constexpr auto kLooksAhead = static_cast<std::int32_t>(place_flag::kHasty | place_flag::kRouses);
        const VI ahead = hn::And(flags, set_int(kLooksAhead));
        const V distance = hn::Sqrt(dot(d, d));
        const V opening = hn::Div(hn::Mul(set(dt_s), dot(velocity, d)), distance);
        const M looks_ahead = hn::RebindMask(D(), hn::Ne(ahead, hn::Zero(DI())));
        const V least = hn::IfThenElseZero(looks_ahead, hn::Min(opening, hn::Zero(D())));
        const V reach = head.z;
        const V gap = hn::Add(hn::Sub(distance, reach), least);
        // So that a distance of 0, which has no direction, counts as close.
        const V near = set(tuning::kSpeculativeDistance_m);
        const VI own_flags = hn::BitCast(DI(), head.u);
        out.boxes_moved |= flagged(flags, place_flag::kBoxesMoved) << lane;
        out.remembers |= flagged(own_flags, near_flag::kRemembers) << lane;
        const M close = hn::And(wanted, hn::Not(hn::Gt(gap, near)));
        const unsigned seen = flagged(own_flags, near_flag::kSeen);
        out.close |= bits_of(close) << lane;
        if ((bits_of(close) & seen) == 0) continue;
        const V turning = hn::Add(advance_a.z, advance_b.z);
        const V way = hn::Mul(set(dt_s), hn::Add(hn::Sqrt(dot(velocity, velocity)), turning));
        const V left = gap_left(pairs + lane, reach, {turn_a.x, turn_a.y}, {turn_b.x, turn_b.y}, d, distance);
        const M apart = hn::Gt(hn::Sub(left, hn::IfThenElseZero(looks_ahead, way)), near);
        out.close &= ~((bits_of(apart) & seen) << lane);
    }
    out.close &= lanes;
    out.boxes_moved &= lanes;
    out.remembers &= lanes;
}

struct DisplacementColumns {
    Columns head;  // moved x and y, chord, extent
    Columns tail;  // arm, least way
};

HWY_INLINE DisplacementColumns load_displacements(const Displacement* displacements, V rows) {
    static_assert(sizeof(Displacement) == 32 && offsetof(Displacement, arm_m) == 16);
    const float* from[kStep];
    alignas(32) std::int32_t row[kLanes];
    hn::Store(hn::BitCast(DI(), rows), DI(), row);
    for (int i = 0; i < kStep; ++i) from[i] = &displacements[row[i]].moved.x;
    return {load_rows(from, 0), load_rows(from, 4)};
}

// How a pair of bodies moved in the step, as one is seen from the other without turning.
struct RelativeWays {
    V before;   // distance of the centres
    V after;    // the same
    V nearest;  // the least on the way, less what rounding may make of it
    V length;
};

HWY_INLINE RelativeWays relative_ways(Vec after, Vec way) {
    const Vec before = sub(after, way);
    const V whole = dot(way, way);
    const V share =
        hn::Div(hn::Neg(dot(before, way)), hn::Max(whole, set(std::numeric_limits<float>::min())));
    const Vec nearest = add(before, scale(hn::Max(hn::Zero(D()), hn::Min(share, set(1))), way));
    RelativeWays ways;
    ways.before = hn::Sqrt(dot(before, before));
    ways.after = hn::Sqrt(dot(after, after));
    ways.length = hn::Sqrt(whole);
    const V rounding = hn::Mul(set(kRounding), hn::Add(ways.before, ways.length));
    ways.nearest = hn::Sub(hn::Sqrt(dot(nearest, nearest)), rounding);
    return ways;
}

// A way counts when it is long enough, on its own and as seen from the other; and when it comes near enough:
// where the other turns, what it sees as straight is bent by no more than its chord at the end of the way.
HWY_INLINE M may_have_met(const DisplacementColumns& one, const DisplacementColumns& other,
                          const RelativeWays& ways) {
    const V arm = one.tail.x;
    const V turned = hn::Mul(one.head.z, arm);
    const V own_way = hn::Add(hn::Sqrt(dot({one.head.x, one.head.y}, {one.head.x, one.head.y})), turned);
    const V by_own_turn = hn::Add(ways.length, turned);
    const V by_other = hn::Mul(other.head.z, hn::Add(ways.before, arm));
    const V way = hn::Add(by_own_turn, by_other);
    const M far = hn::Gt(hn::Min(own_way, way), one.tail.y);
    const V bent = hn::Mul(other.head.z, hn::Add(ways.after, arm));
    const M beside = hn::Gt(hn::Sub(ways.nearest, arm), hn::Add(other.head.u, bent));
    return hn::AndNot(beside, far);
}

void find_passed(const Place* places, const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b,
                 const Displacement* displacements, unsigned lanes, unsigned& passed) {
    passed = 0;
    for (int lane = 0; lane < kLanes; lane += kStep) {
        const M wanted = wanted_lanes(lanes, lane);
        alignas(32) std::int32_t a[kLanes];
        alignas(32) std::int32_t b[kLanes];
        load_wanted(body_a, wanted, lane, a);
        load_wanted(body_b, wanted, lane, b);
        const Columns turn_a = load_turns(places, a);
        const Columns turn_b = load_turns(places, b);
        const VI flags = hn::Or(hn::BitCast(DI(), turn_a.u), hn::BitCast(DI(), turn_b.u));
        const unsigned fast = flagged(flags, place_flag::kFast);
        if (fast == 0) continue;
        const DisplacementColumns of_a = load_displacements(displacements, turn_a.z);
        const DisplacementColumns of_b = load_displacements(displacements, turn_b.z);
        const Vec relative = sub({of_b.head.x, of_b.head.y}, {of_a.head.x, of_a.head.y});
        const RelativeWays ways = relative_ways(between(places, a, b), relative);
        const M met = hn::Or(may_have_met(of_a, of_b, ways), may_have_met(of_b, of_a, ways));
        passed |= (bits_of(met) & fast) << lane;
    }
    passed &= lanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace cairn::physics
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cairn::physics {

HWY_EXPORT(load_places);
HWY_EXPORT(look_near);
HWY_EXPORT(find_passed);

NearSight make_sight(const PoseLanes& poses, int lane, float gap_m) {
    const Rotation q_a{poses.cos_a[lane], poses.sin_a[lane]};
    const Vec2 turn = inverse_rotate(q_a, {poses.cos_b[lane], poses.sin_b[lane]});
    return {gap_m, inverse_rotate(q_a, {poses.dx[lane], poses.dy[lane]}), {turn.x, turn.y}};
}

void load_places(const Place* places, const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b,
                 unsigned lanes, BlockPlaces& out) {
    HWY_DYNAMIC_DISPATCH(load_places)(places, body_a, body_b, lanes, out);
}

NearLanes look_near(const Place* places, const NearPair* pairs, const Advance* advances, float dt_s,
                    unsigned lanes) {
    NearLanes out;
    HWY_DYNAMIC_DISPATCH(look_near)(places, pairs, advances, dt_s, lanes, out);
    return out;
}

unsigned find_passed(const Place* places, const Lanes<std::int32_t>& body_a,
                     const Lanes<std::int32_t>& body_b, const Displacement* displacements, unsigned lanes) {
    unsigned passed = 0;
    HWY_DYNAMIC_DISPATCH(find_passed)(places, body_a, body_b, displacements, lanes, passed);
    return passed;
}

}  // namespace cairn::physics
#endif
