// Bounces in lanes against those of the same contacts in plain form, and against themselves at other SIMD
// levels.
#include "resolve/restitution_kernel.h"

#include <bit>
#include <catch2/catch.hpp>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/contact_heap.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kSlow_m_s = 1;
const ReboundTime kRebound{1 / kHeapSubstep_s, kSlow_m_s};

// A heap whose contacts have been solved for a step, under forces that differ from body to body.
struct Impacts {
    explicit Impacts(unsigned seed, const std::vector<BlockKind>& kinds)
        : heap(make_heap(seed, kinds, 200, 300)) {
        for (const Placed& p : heap.placed) {
            heap.block(p).reports = true;
            if (p.input.restitution > 0) set_lane_bit(heap.block(p).bounces, p.lane % kLanes, true);
        }
        const WholeHeap whole(heap);
        TaskPool alone(1);
        warm_start(whole.runs(), heap.motions, 1, 1, alone);
        for (const Pass pass : {Pass::Biased, Pass::Relax})
            solve(whole.runs(), heap.motions, kHeapRules, kHeapSubstep_s, pass, Scope::All, alone);
        Random random(seed + 1);
        drives.resize(heap.motions.velocity.size());
        heap.motions.kick.resize(heap.motions.velocity.size());
        for (int row = heap.first_free; row < heap.motions.size(); ++row) {
            const auto at = static_cast<std::size_t>(row);
            drives[at].acceleration = random.vector(-20, 20);
            heap.motions.kick[at].v = kHeapSubstep_s * drives[at].acceleration;
        }
    }

    void bounce_in_lanes() {
        for (const int bucket : heap.lanes.buckets()) {
            std::vector<BouncingBlock> blocks;
            for (const int block : heap.lanes.blocks(bucket))
                blocks.push_back({&heap.lanes.block(block), heap.lanes.impacts(block)});
            give_back_blocks(blocks, kind_of(bucket), heap.motions.velocity.data(), heap.motions.kick.data(),
                             kRebound);
        }
    }

    // As the lanes left them.
    [[nodiscard]] std::vector<ContactConstraint> plain_forms() {
        std::vector<ContactConstraint> all;
        for (const Placed& p : heap.placed) {
            ContactConstraint& c = all.emplace_back(p.scalar);
            const ContactBlock& block = heap.block(p);
            const int lane = p.lane % kLanes;
            for (int i = 0; i < c.count; ++i) {
                c.points[i].normal_impulse = block.points[i].impulse[lane];
                c.points[i].total_normal_impulse = block.total_impulse[i][lane];
                c.points[i].end_separation = block.points[i].separation[lane];
            }
        }
        return all;
    }

    Heap heap;
    std::vector<Drive> drives;
};

bool meets_fast(const ContactConstraint& c) {
    for (int i = 0; i < c.count; ++i) {
        const ContactPointConstraint& p = c.points[i];
        if (p.closing_velocity <= -kSlow_m_s && p.total_normal_impulse > 0) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("lanes of every kind give back what the plain form of the same contacts does") {
    const unsigned seed = GENERATE(1u, 2u, 3u, 4u);
    Impacts impacts(seed, kAllKinds);
    Motions by_scalars = impacts.heap.motions;
    std::vector<ContactConstraint> plain = impacts.plain_forms();
    apply_restitution(plain, by_scalars, impacts.drives, kHeapRules);
    const std::vector<VelocityRow> before = impacts.heap.motions.velocity;
    impacts.bounce_in_lanes();
    int changed = 0;
    for (int row = 0; row < by_scalars.size(); ++row) {
        const auto at = static_cast<std::size_t>(row);
        const VelocityRow& now = impacts.heap.motions.velocity[at];
        CHECK(static_cast<double>(length(now.v - by_scalars.velocity[at].v)) < 5e-5);
        CHECK(static_cast<double>(now.w) ==
              Approx(static_cast<double>(by_scalars.velocity[at].w)).margin(5e-5));
        changed += length(now.v - before[at].v) > 1e-3f ? 1 : 0;
    }
    CHECK(changed > 30);
}

TEST_CASE("impulses of impacts are forgotten, and no others") {
    Impacts impacts(5, kAllKinds);
    const std::vector<ContactConstraint> plain = impacts.plain_forms();
    std::vector<ContactMemory> before;
    for (const Placed& p : impacts.heap.placed) before.push_back(impacts.heap.lanes.memory(p.lane));
    impacts.bounce_in_lanes();
    int bounced = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const bool bounces = plain[i].restitution > 0 && meets_fast(plain[i]);
        const ContactMemory memory = impacts.heap.lanes.memory(impacts.heap.placed[i].lane);
        const ContactMemory expected = bounces ? ContactMemory{before[i].features} : before[i];
        CHECK(memory.impulse == expected.impulse);
        CHECK(memory.friction_impulse == expected.friction_impulse);
        bounced += bounces ? 1 : 0;
    }
    CHECK(bounced > 20);
}

TEST_CASE("lanes that do not bounce in this step are let alone, whatever their block remembers") {
    Impacts impacts(6, {BlockKind::TwoBodies});
    for (const Placed& p : impacts.heap.placed) impacts.heap.block(p).bounces = 0;
    const std::vector<VelocityRow> before = impacts.heap.motions.velocity;
    impacts.bounce_in_lanes();
    for (std::size_t row = 0; row < before.size(); ++row) {
        CHECK(impacts.heap.motions.velocity[row].v == before[row].v);
        CHECK(impacts.heap.motions.velocity[row].w == before[row].w);
    }
}

TEST_CASE("every SIMD level bounces to the same bits") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    std::vector<std::uint32_t> first;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Impacts impacts(7, kAllKinds);
        impacts.bounce_in_lanes();
        force_simd_level(levels.back()).value();
        std::vector<std::uint32_t> bits;
        for (const VelocityRow& row : impacts.heap.motions.velocity) {
            for (const float x : {row.v.x, row.v.y, row.w}) bits.push_back(std::bit_cast<std::uint32_t>(x));
        }
        if (first.empty()) first = bits;
        CAPTURE(name(level));
        CHECK(bits == first);
    }
}

}  // namespace cairn::physics
