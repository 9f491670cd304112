// The passes over contacts in lanes, against the scalar form of the same contacts and against themselves at
// other SIMD levels.
#include "resolve/contact_passes.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <vector>

#include <cairn/physics/simd.h>

#include "base/standing.h"
#include "physics/support/contact_heap.h"

namespace cairn::physics {
namespace {

using namespace test;

// As between the passes: centimetres, and turns so small that arms need not turn.
void displace(Motions& motions, unsigned seed) {
    Random random(seed);
    for (int row = 1; row < motions.size(); ++row) {
        motions.pose[row].d = random.vector(-0.01, 0.01);
        motions.pose[row].theta = random.real_f(-1e-4, 1e-4) / std::max(motions.pose[row].k, 0.1f);
        motions.turned[row] = Rotation::from_small_angle(motions.angle(row));
    }
}

constexpr float kStepRatio = 1.3f;
constexpr float kFrictionRatio = 0.8f;

template <class Solve>  // solve(pass)
void run_passes(Motions& motions, Solve&& solve) {
    solve(Pass::Biased);
    displace(motions, 1);
    for (const Pass pass : {Pass::Relax, Pass::Biased, Pass::Relax}) solve(pass);
}

void run_lanes(Heap& heap) {
    TaskPool alone(1);
    const WholeHeap whole(heap);
    warm_start(whole.runs(), heap.motions, kStepRatio, kFrictionRatio, alone);
    run_passes(heap.motions, [&](Pass pass) {
        solve(whole.runs(), heap.motions, kHeapRules, kHeapSubstep_s, pass, Scope::All, alone);
    });
}

Motions run_scalars(Heap& heap) {
    Motions motions = heap.motions;
    for (Placed& p : heap.placed) warm_start_contact(p.scalar, motions, kStepRatio, kFrictionRatio);
    run_passes(motions, [&](Pass pass) {
        for (Placed& p : heap.placed) solve_contact(p.scalar, motions, kHeapRules, kHeapSubstep_s, pass);
    });
    return motions;
}

bool same_bits(const VelocityRow& a, const VelocityRow& b) {
    using Bits = std::array<std::uint32_t, 4>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

auto approx(float expected, double margin) {
    return Approx(static_cast<double>(expected)).margin(margin).epsilon(2e-5);
}

void check_lane(Heap& heap, const Placed& p) {
    const ContactBlock& block = heap.block(p);
    const int lane = p.lane % kLanes;
    for (int k = 0; k < p.scalar.count; ++k) {
        const ContactPointConstraint& expected = p.scalar.points[k];
        CHECK(block.points[k].impulse[lane] == approx(expected.normal_impulse, 5e-5));
        CHECK(block.points[k].separation[lane] == approx(expected.end_separation, 1e-6));
        const float total = block.reports ? expected.total_normal_impulse : 0;
        CHECK(block.total_impulse[k][lane] == approx(total, 1e-4));
    }
    CHECK(block.friction_impulse[lane] == approx(p.scalar.friction_impulse, 5e-5));
}

}  // namespace

TEST_CASE("a lane that is blanked does nothing in the passes, and keeps its friction and its contact") {
    Heap heap = make_heap(2, {BlockKind::TwoBodies}, 2, 1);
    const Placed p = heap.placed.front();
    heap.lanes.blank(p.lane);
    // It keeps its bodies: nobody else may write their rows while its block is solved.
    CHECK(heap.block(p).a[p.lane % kLanes] == p.input.a);
    CHECK(heap.block(p).b[p.lane % kLanes] == p.input.b);
    CHECK(heap.block(p).friction[p.lane % kLanes] == p.input.friction);
    CHECK(heap.pairs(p).contact[p.lane % kLanes] == 0);
    const std::vector<VelocityRow> before = heap.motions.velocity;
    run_lanes(heap);
    for (int row = 0; row < heap.motions.size(); ++row) {
        CHECK(same_bits(heap.motions.velocity[row], before[row]));
    }
}

TEST_CASE("the first guess of lanes is that of the scalar form, for steps of any length") {
    const float step_ratio = GENERATE(0.5f, 1.0f, 1.7f);
    const float friction_ratio = GENERATE(0.0f, 0.7f);
    Heap heap = make_heap(3, kAllKinds, 100, 200);
    std::vector<std::array<float, 2>> remembered;
    for (const Placed& p : heap.placed) remembered.push_back(heap.lanes.memory(p.lane).impulse);

    Motions by_scalars = heap.motions;
    for (Placed& p : heap.placed) warm_start_contact(p.scalar, by_scalars, step_ratio, friction_ratio);
    TaskPool alone(1);
    warm_start(WholeHeap(heap).runs(), heap.motions, step_ratio, friction_ratio, alone);
    for (int i = 0; i < static_cast<int>(heap.placed.size()); ++i) {
        const Placed& p = heap.placed[i];
        const ContactMemory memory = heap.lanes.memory(p.lane);
        for (int k = 0; k < p.scalar.count; ++k) {
            const float at_rest = p.scalar.points[k].static_impulse;
            CHECK(memory.impulse[k] == first_guess(remembered[i][k], at_rest, step_ratio));
        }
        CHECK(memory.friction_impulse == friction_ratio * p.input.friction_impulse);
    }
    for (int row = 0; row < by_scalars.size(); ++row) {
        CHECK(static_cast<double>(length(heap.motions.velocity[row].v - by_scalars.velocity[row].v)) < 1e-5);
        CHECK(heap.motions.spin(row) == approx(by_scalars.spin(row), 2e-5));
    }
}

// Runs the passes with rows as they are marked, and checks that who was kicked is marked.
Heap run_disturbed(unsigned seed, std::uint8_t mark, int disturbed) {
    Heap heap = make_heap(seed, kAllKinds, 200, 300);
    heap.motions.standing.assign(static_cast<std::size_t>(heap.motions.size()), mark);
    heap.motions.standing[kWorldRow] = kStands;
    for (int i = 0; i < disturbed; ++i) heap.motions.standing[heap.first_free + 7 * i] = kMoves;
    const std::vector<VelocityRow> before = heap.motions.velocity;
    TaskPool alone(1);
    const WholeHeap whole(heap);
    run_passes(heap.motions, [&](Pass pass) {
        solve(whole.runs(), heap.motions, kHeapRules, kHeapSubstep_s, pass, Scope::Disturbed, alone);
    });
    for (int row = 0; row < heap.motions.size(); ++row) {
        const bool changed = !same_bits(heap.motions.velocity[row], before[row]);
        if (length(heap.motions.velocity[row].v - before[row].v) > 10 * kStillSpeed_m_s)
            CHECK(heap.motions.standing[row] == kMoves);
        if (mark == kStands && disturbed == 0) CHECK_FALSE(changed);
    }
    return heap;
}

TEST_CASE("where no body stands, passes over what is disturbed are those over all, to the bit") {
    const unsigned seed = GENERATE(8u, 9u);
    const Heap disturbed = run_disturbed(seed, kMoves, 0);
    Heap all = make_heap(seed, kAllKinds, 200, 300);
    TaskPool alone(1);
    const WholeHeap whole(all);
    run_passes(all.motions, [&](Pass pass) {
        solve(whole.runs(), all.motions, kHeapRules, kHeapSubstep_s, pass, Scope::All, alone);
    });
    for (int row = 0; row < all.motions.size(); ++row)
        CHECK(same_bits(disturbed.motions.velocity[row], all.motions.velocity[row]));
    for (const Placed& p : all.placed)
        CHECK(disturbed.lanes.memory(p.lane).impulse == all.lanes.memory(p.lane).impulse);
}

TEST_CASE("contacts of bodies that stand do nothing until one is kicked, at every SIMD level alike") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const int disturbed : {0, 1, 20}) {
        std::vector<Heap> heaps;
        for (const SimdLevel level : levels) {
            INFO(name(level) << ", " << disturbed << " disturbed");
            force_simd_level(level).value();
            heaps.push_back(run_disturbed(10, kStands, disturbed));
            force_simd_level(levels.back()).value();
            const Heap& heap = heaps.back();
            CHECK(heap.motions.standing == heaps.front().motions.standing);
            for (int row = 0; row < heap.motions.size(); ++row)
                CHECK(same_bits(heap.motions.velocity[row], heaps.front().motions.velocity[row]));
            const auto kicked = std::ranges::count(heap.motions.standing, kMoves);
            CHECK(kicked >= disturbed);
            if (disturbed == 20) CHECK(kicked > 60);
        }
    }
}

TEST_CASE("lanes of every kind move bodies as the scalar form of the same contacts does") {
    const unsigned seed = GENERATE(4u, 5u, 6u, 7u);
    const std::vector<BlockKind> kinds =
        GENERATE(std::vector{BlockKind::TwoBodies}, std::vector{BlockKind::OneBody},
                 std::vector{BlockKind::Carried}, kAllKinds);
    CAPTURE(seed, kinds.size(), static_cast<int>(kinds[0]));
    Heap heap = make_heap(seed, kinds, 200, 300);
    const std::vector<VelocityRow> before = heap.motions.velocity;
    const Motions by_scalars = run_scalars(heap);
    run_lanes(heap);
    for (int row = 0; row < by_scalars.size(); ++row) {
        // Velocities of a few m/s after some dozen float operations.
        CHECK(static_cast<double>(length(heap.motions.velocity[row].v - by_scalars.velocity[row].v)) < 4e-5);
        CHECK(heap.motions.spin(row) == approx(by_scalars.spin(row), 1e-4));
        if (row < heap.first_free) CHECK(same_bits(heap.motions.velocity[row], before[row]));
    }
    for (const Placed& p : heap.placed) check_lane(heap, p);
}

TEST_CASE(
    "separations of bodies that turn far are those of the scalar form, beside others that turn little") {
    const unsigned seed = GENERATE(11u, 12u, 13u);
    Heap heap = make_heap(seed, kAllKinds, 200, 300);
    Heap linear = make_heap(seed, kAllKinds, 200, 300);
    Random random(seed);
    for (int row = 1; row < heap.motions.size(); ++row) {
        PoseRow& pose = heap.motions.pose[row];
        pose.d = random.vector(-0.3, 0.3);
        pose.theta = pose.k > 0 ? random.real_f(-1.5, 1.5) / pose.k : 0;
        heap.motions.turned[row] = Rotation::from_angle(static_cast<double>(heap.motions.angle(row)));
        linear.motions.pose[row] = pose;
    }
    heap.lanes.make_room_for_turns();
    heap.motions.some_turn_far = true;
    const auto turns = [&](const Placed& p) { return p.lane % 3 == 0; };
    for (const Placed& p : heap.placed) {
        if (!turns(p)) continue;
        const auto bow = [&](auto&& arm_of) {
            float sum = 0;
            for (int k = 0; k < p.scalar.count; ++k) sum += dot(p.input.normal, arm_of(p.scalar.points[k]));
            return sum / static_cast<float>(p.scalar.count);
        };
        heap.lanes.turn(p.lane / kLanes, p.lane % kLanes, bow([](const auto& q) { return q.core_r_a; }),
                        bow([](const auto& q) { return q.core_r_b; }));
    }
    TaskPool alone(1);
    const auto relax = [&](Heap& h) {
        const WholeHeap whole(h);
        solve(whole.runs(), h.motions, kHeapRules, kHeapSubstep_s, Pass::Relax, Scope::All, alone);
    };
    relax(heap);
    relax(linear);
    int turned = 0;
    for (std::size_t i = 0; i < heap.placed.size(); ++i) {
        const Placed& p = heap.placed[i];
        const int lane = p.lane % kLanes;
        for (std::size_t k = 0; k < static_cast<std::size_t>(p.scalar.count); ++k) {
            const float found = heap.block(p).points[k].separation[lane];
            const float without = linear.block(linear.placed[i]).points[k].separation[lane];
            if (!turns(p)) {
                CHECK(found == without);
                continue;
            }
            const float expected = separation_now(p.scalar, p.scalar.points[k], heap.motions);
            // Two points have one bow, midway: each is off by half of what their separations differ by, in
            // half of which either body turns.
            const float apart = p.scalar.count == 2
                                    ? std::fabs(p.scalar.points[0].separation - p.scalar.points[1].separation)
                                    : 0;
            CHECK(std::fabs(found - expected) < 5e-6f + 0.5f * apart);
            turned += std::fabs(found - without) > 0.05f ? 1 : 0;
        }
    }
    CHECK(turned > 50);
}

TEST_CASE("every SIMD level gives the same bits") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    std::vector<std::uint32_t> first;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Heap heap = make_heap(8, kAllKinds, 300, 900);
        run_lanes(heap);
        force_simd_level(levels.back()).value();
        std::vector<std::uint32_t> bits;
        const auto add_bits = [&](float x) { bits.push_back(std::bit_cast<std::uint32_t>(x)); };
        for (const VelocityRow& row : heap.motions.velocity) {
            for (const float x : {row.v.x, row.v.y, row.w}) add_bits(x);
        }
        for (const Placed& p : heap.placed) {
            const ContactMemory memory = heap.lanes.memory(p.lane);
            for (const float x : {memory.impulse[0], memory.impulse[1], memory.friction_impulse}) add_bits(x);
            for (const ContactBlockPoint& point : heap.block(p).points)
                add_bits(point.separation[p.lane % kLanes]);
            for (const auto& total : heap.block(p).total_impulse) add_bits(total[p.lane % kLanes]);
        }
        if (first.empty()) first = bits;
        CAPTURE(name(level));
        CHECK(bits == first);
    }
}

}  // namespace cairn::physics
