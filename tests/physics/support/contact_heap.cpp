#include "physics/support/contact_heap.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "resolve/prepare_kernel.h"

namespace cairn::physics::test {
namespace {

void add_bodies(Heap& heap, Random& random, int carriers, int free_bodies) {
    heap.motions.add({}, 0, 0, 0);
    heap.first_free = 1 + carriers;
    while (heap.motions.size() < heap.first_free + free_bodies) {
        const bool moves = heap.motions.size() >= heap.first_free;
        const Vec2 v = random.vector(-2, 2);
        const float w = random.real_f(-3, 3);
        const float inverse_mass = random.real_f(0.1, 4);
        const float inverse_inertia = random.chance(0.1) ? 0 : random.real_f(0.1, 9);
        heap.motions.add(v, w, moves ? inverse_mass : 0, moves ? inverse_inertia : 0);
    }
}

ContactInput random_contact(Heap& heap, Random& random, BlockKind kind) {
    const auto free_row = [&] {
        return heap.first_free + random.below(heap.motions.size() - heap.first_free);
    };
    ContactInput c{};
    c.a = kWorldRow;
    c.b = free_row();
    if (kind == BlockKind::Carried) c.a = 1 + random.below(heap.first_free - 1);
    if (kind == BlockKind::TwoBodies) c.a = free_row();
    while (c.a == c.b) c.a = free_row();
    const Rotation q = Rotation::from_angle(random.real(-3, 3));
    c.normal = {q.c, q.s};
    c.count = random.chance(0.7) ? 2 : 1;
    const Vec2 middle = random.vector(-0.5, 0.5);
    const float width = random.chance(0.2) ? 0.001f : 0.3f;  // some too near each other to be told apart
    for (int k = 0; k < c.count; ++k) {
        // The points of a manifold lie on one line along its tangent.
        const Vec2 along = (k == 0 ? -width : width) * right_perp(c.normal);
        const float separation = random.real_f(-0.02, 0.01);
        c.points[k] = {middle + along, along - middle, separation, k, random.real_f(0, 0.5)};
    }
    c.friction = random.real_f(0, 1);
    c.friction_impulse = random.real_f(-0.2, 0.2);
    return c;
}

// The blocks as the contact stage makes them: manifolds in, arms and masses out.
void prepare(Heap& heap) {
    std::map<std::pair<int, int>, std::pair<PoseLanes, ManifoldLanes>> found;  // by bucket and block
    for (Placed& p : heap.placed) {
        const auto [at, is_new] = found.try_emplace({p.bucket, p.lane / kLanes});
        auto& [poses, manifold] = at->second;
        for (ManifoldPointLanes& point : manifold.points) {
            if (is_new) point.id.fill(kNoFeature);
        }
        const int lane = p.lane % kLanes;
        const Vec2 between = p.input.points[0].r_a - p.input.points[0].r_b;
        poses.dx[lane] = between.x;
        poses.dy[lane] = between.y;
        manifold.normal_x[lane] = p.input.normal.x;
        manifold.normal_y[lane] = p.input.normal.y;
        for (int i = 0; i < p.input.count; ++i) {
            manifold.points[i].x[lane] = p.input.points[i].r_a.x;
            manifold.points[i].y[lane] = p.input.points[i].r_a.y;
            manifold.points[i].separation[lane] = p.input.points[i].separation;
            manifold.points[i].id[lane] = p.input.points[i].feature;
        }
        heap.block(p).a[lane] = p.input.a;
        heap.block(p).b[lane] = p.input.b;
        heap.block(p).reports = heap.pairs(p).reports != 0;
    }
    heap.lanes.arrange();
    for (auto& [place, made] : found) {
        (void)prepare_block(made.first, made.second, heap.motions.velocity.data(), heap.motions.pose.data(),
                            heap.lanes.pairs(place.second).features, 1, heap.lanes.block(place.second),
                            heap.lanes.impacts(place.second));
    }
}

// Of some points, what statics says of them; of some of these, nothing else is known.
void estimate(Heap& heap, Random& random) {
    for (Placed& p : heap.placed) {
        for (int i = 0; i < p.scalar.count; ++i) {
            if (random.chance(0.5)) continue;
            ContactBlockPoint& point = heap.block(p).points[i];
            const float at_rest = random.real_f(0, 0.5);
            point.static_impulse[p.lane % kLanes] = p.scalar.points[i].static_impulse = at_rest;
            if (random.chance(0.5)) continue;
            point.impulse[p.lane % kLanes] = p.scalar.points[i].normal_impulse = kUnknownImpulse;
        }
    }
}

}  // namespace

WholeHeap::WholeHeap(Heap& heap) {
    heap.lanes.arrange();
    for (const int bucket : heap.lanes.buckets()) {
        std::vector<ContactBlock*>& blocks = blocks_.emplace_back();
        for (const int block : heap.lanes.blocks(bucket)) blocks.push_back(&heap.lanes.block(block));
        runs_.push_back({kind_of(bucket), blocks, color_of(bucket), domain_of(bucket)});
    }
}

Heap make_heap(unsigned seed, const std::vector<BlockKind>& kinds, int free_bodies, int contacts) {
    Random random(seed);
    Heap heap;
    add_bodies(heap, random, 8, free_bodies);
    std::vector<unsigned> colors(heap.motions.size(), 0);  // by row: bits of those it is moved in
    for (int i = 0; i < contacts; ++i) {
        const BlockKind kind = kinds[i % kinds.size()];
        Placed p;
        p.input = random_contact(heap, random, kind);
        const int other = kind == BlockKind::TwoBodies ? p.input.a : p.input.b;
        const int color = std::countr_one(colors[p.input.b] | colors[other]);
        REQUIRE(color < kColors);
        for (const int row : {p.input.b, other}) colors[row] |= 1u << color;

        const auto geometry = random.chance(0.5) ? PairGeometry::Boxes : PairGeometry::Hulls;
        p.bucket = colored_bucket(color, kind, geometry);
        PairLane pair;
        pair.contact = i;
        pair.reports = random.chance(0.02);
        p.lane = heap.lanes.add(p.bucket, pair);
        ContactMemory memory;
        for (int k = 0; k < p.input.count; ++k) {
            memory.features[k] = p.input.points[k].feature;
            memory.impulse[k] = p.input.points[k].impulse;
        }
        memory.friction_impulse = p.input.friction_impulse;
        heap.lanes.set_memory(p.lane, memory);
        p.input.restitution = i % 3 == 0 ? 0.05f * static_cast<float>(1 + i % 4) : 0;
        heap.lanes.set_material(p.lane, p.input.friction, p.input.restitution);
        p.scalar = make_contact(p.input, heap.motions, kHeapRules);
        heap.placed.push_back(p);
    }
    prepare(heap);
    estimate(heap, random);
    // Contacts of one colour do not meet, so the order inside it is free; the colours come in turn.
    std::stable_sort(heap.placed.begin(), heap.placed.end(),
                     [](const Placed& p, const Placed& q) { return p.bucket < q.bucket; });
    return heap;
}

}  // namespace cairn::physics::test
