// Contacts in SIMD blocks against the scalar form of the same contacts, and against themselves at other SIMD
// levels.
#include "resolve/contact_blocks.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

constexpr float kDt_s = 1.0f / 60;
constexpr float kH_s = kDt_s / 4;

struct Heap {
    Motions motions;
    std::vector<ContactInput> contacts;
};

// Bodies of all masses, moving and a little displaced, with contacts between random pairs; some touch the
// world.
Heap make_heap(unsigned seed, int bodies, int contacts) {
    test::Random random(seed);
    const auto number = [&](float low, float high) {
        return random.real_f(static_cast<double>(low), static_cast<double>(high));
    };
    Heap heap;
    heap.motions.add({}, 0, 0, 0);
    for (int i = 0; i < bodies; ++i) {
        heap.motions.add({number(-2, 2), number(-2, 2)}, number(-3, 3), number(0.1f, 4), number(0.1f, 9));
        heap.motions.pose.back().d = {number(-0.01f, 0.01f), number(-0.01f, 0.01f)};
    }
    for (int i = 0; i < contacts; ++i) {
        ContactInput c{};
        c.contact = i;
        c.a = static_cast<int>(number(0, static_cast<float>(bodies) + 0.99f));
        c.b = c.a;
        while (c.b == c.a) c.b = static_cast<int>(number(0, static_cast<float>(bodies) + 0.99f));
        const Rotation q = Rotation::from_angle(static_cast<double>(number(-3, 3)));
        c.normal = {q.c, q.s};
        c.count = number(0, 1) < 0.7f ? 2 : 1;
        const Vec2 middle{number(-0.5f, 0.5f), number(-0.5f, 0.5f)};
        for (int k = 0; k < c.count; ++k) {
            // The points of a manifold lie on one line along its tangent.
            const Vec2 along = (k == 0 ? -0.3f : 0.3f) * right_perp(c.normal);
            c.points[k] = {middle + along, along - middle, number(-0.02f, 0.01f), number(0, 0.5f)};
        }
        c.friction = number(0, 1);
        c.friction_impulse = number(-0.2f, 0.2f);
        c.reports = number(0, 1) < 0.2f;
        heap.contacts.push_back(c);
    }
    return heap;
}

const ContactRules& rules() {
    static const ContactRules shared = make_contact_rules(kH_s, 3, 1);
    return shared;
}

void run(ContactBlocks& blocks, Motions& motions) {
    blocks.warm_start(motions);
    blocks.solve(motions, rules(), kH_s, Pass::Biased);
    blocks.solve(motions, rules(), kH_s, Pass::Relax);
}

}  // namespace

TEST_CASE("no body is moved by two lanes of one colour") {
    const Heap heap = make_heap(1, 60, 200);
    ContactBlocks blocks;
    blocks.start(heap.motions.size());
    std::vector<std::set<int>> rows_of_color(32);
    int packed = 0;
    for (const ContactInput& c : heap.contacts) {
        const ContactLane lane = blocks.add(c, heap.motions, kDt_s);
        if (!lane) continue;
        ++packed;
        for (const int row : {c.a, c.b}) {
            if (row == kWorldRow) continue;
            CHECK(rows_of_color[lane.bucket / 2].insert(row).second);
        }
    }
    CHECK(packed == 200);  // nobody has as many contacts as there are colours
}

TEST_CASE("blocks move bodies as the scalar form of the same contacts does") {
    const unsigned seed = GENERATE(2u, 3u, 4u, 5u);
    Heap heap = make_heap(seed, 200, 300);
    ContactBlocks blocks;
    blocks.start(heap.motions.size());
    struct Placed {
        ContactLane lane;
        ContactConstraint scalar;
    };
    std::vector<Placed> placed;
    for (const ContactInput& c : heap.contacts) {
        const ContactLane lane = blocks.add(c, heap.motions, kDt_s);
        REQUIRE(lane);
        placed.push_back({lane, make_contact(c, heap.motions, rules())});
    }
    // Contacts of one colour do not meet, so the order inside it is free; the colours come in turn.
    std::stable_sort(placed.begin(), placed.end(),
                     [](const Placed& p, const Placed& q) { return p.lane.bucket < q.lane.bucket; });

    Motions by_scalars = heap.motions;
    // The blocks' first pass takes separations as they were at the start of the step: so must the scalars'.
    for (PoseRow& row : by_scalars.pose) row.d = {};
    for (const Placed& p : placed) warm_start_contact(p.scalar, by_scalars);
    for (Placed& p : placed) solve_contact(p.scalar, by_scalars, rules(), kH_s, Pass::Biased);
    by_scalars.pose = heap.motions.pose;
    for (Placed& p : placed) solve_contact(p.scalar, by_scalars, rules(), kH_s, Pass::Relax);

    Motions by_blocks = heap.motions;
    run(blocks, by_blocks);
    for (int row = 0; row < by_blocks.size(); ++row) {
        // Velocities of a few m/s after some dozen float operations.
        CHECK(static_cast<double>(length(by_blocks.velocity[row].v - by_scalars.velocity[row].v)) < 2e-5);
        CHECK(static_cast<double>(by_blocks.spin(row) - by_scalars.spin(row)) == Approx(0).margin(5e-5));
    }
    for (const Placed& p : placed) {
        const ContactOutcome outcome = blocks.outcome(p.lane);
        for (int k = 0; k < p.scalar.count; ++k) {
            CHECK(static_cast<double>(outcome.impulse[k]) ==
                  Approx(static_cast<double>(p.scalar.points[k].normal_impulse)).margin(2e-5));
            CHECK(static_cast<double>(outcome.separation[k]) ==
                  Approx(static_cast<double>(p.scalar.points[k].end_separation)).margin(1e-6));
        }
    }
}

TEST_CASE("every SIMD level gives the same bits") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    std::vector<std::uint32_t> first;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Heap heap = make_heap(6, 300, 900);
        ContactBlocks blocks;
        blocks.start(heap.motions.size());
        for (const ContactInput& c : heap.contacts) (void)blocks.add(c, heap.motions, kDt_s);
        run(blocks, heap.motions);
        std::vector<std::uint32_t> bits;
        for (const VelocityRow& row : heap.motions.velocity) {
            for (const float x : {row.v.x, row.v.y, row.w}) bits.push_back(std::bit_cast<std::uint32_t>(x));
        }
        if (first.empty()) first = bits;
        CAPTURE(name(level));
        CHECK(bits == first);
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("a contact of a body that turns far in the step is left to the scalar form") {
    Heap heap = make_heap(7, 2, 0);
    heap.motions.add({}, 100, 1, 1);
    ContactInput c{};
    c.a = 3;
    c.b = 1;
    c.normal = {0, 1};
    c.count = 1;
    ContactBlocks blocks;
    blocks.start(heap.motions.size());
    CHECK_FALSE(blocks.add(c, heap.motions, kDt_s));
    c.a = 2;
    CHECK(blocks.add(c, heap.motions, kDt_s));
}

}  // namespace cairn::physics
