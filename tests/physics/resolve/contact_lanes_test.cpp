// Contacts in lanes: their upkeep against a plain map, and their passes against the scalar form of the same
// contacts and against themselves at other SIMD levels.
#include "resolve/contact_lanes.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <iterator>
#include <map>
#include <numeric>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kH_s = 1.0f / 240;
const ContactRules kRules = make_contact_rules(kH_s, 3, 1);

struct Kept {
    int bucket = 0;
    int lane = 0;
    PairLane pair;
    ContactMemory memory;  // in colours
    float friction = 0;
    float mass = 0;  // stands for all that is made anew in each step
};

using Model = std::map<int, Kept>;  // by contact

constexpr std::array kAllGeometries{PairGeometry::Boxes, PairGeometry::Hulls, PairGeometry::Chains};
constexpr std::array kSomeBuckets{near_bucket(PairGeometry::Boxes), near_bucket(PairGeometry::Hulls),
                                  colored_bucket(0, BlockKind::TwoBodies, PairGeometry::Boxes),
                                  colored_bucket(0, BlockKind::OneBody, PairGeometry::Hulls),
                                  colored_bucket(kColors - 1, BlockKind::Carried, PairGeometry::Hulls)};

PairLane random_lane(Random& random, int contact) {
    PairLane lane;
    lane.contact = contact;
    lane.body_a = random.below(1000);
    lane.body_b = random.below(1000);
    lane.shape_a = random.below(1000);
    lane.shape_b = random.below(1000);
    lane.half_a = random.vector(0, 1);
    lane.half_b = random.vector(0, 1);
    lane.offset_a = random.vector(-1, 1);
    lane.offset_b = random.vector(-1, 1);
    lane.reports = random.chance(0.3);
    lane.remembers = random.chance(0.3);
    return lane;
}

bool holds(const PairBlock& pairs, int lane, const PairLane& expected) {
    const auto is = [lane](auto& x, auto& y, Vec2 v) { return Vec2{x[lane], y[lane]} == v; };
    const BoxLanes& boxes = pairs.boxes;
    return pairs.contact[lane] == expected.contact && pairs.body_a[lane] == expected.body_a &&
           pairs.body_b[lane] == expected.body_b && pairs.shape_a[lane] == expected.shape_a &&
           pairs.shape_b[lane] == expected.shape_b && is(boxes.half_ax, boxes.half_ay, expected.half_a) &&
           is(boxes.half_bx, boxes.half_by, expected.half_b) &&
           is(boxes.offset_ax, boxes.offset_ay, expected.offset_a) &&
           is(boxes.offset_bx, boxes.offset_by, expected.offset_b) &&
           (pairs.reports >> lane & 1) == (expected.reports ? 1 : 0) &&
           (pairs.remembers >> lane & 1) == (expected.remembers ? 1 : 0);
}

bool holds(const ContactMemory& found, const ContactMemory& expected) {
    return found.features == expected.features && found.impulse == expected.impulse &&
           found.friction_impulse == expected.friction_impulse;
}

bool is_inert(const ContactBlock& block, int lane) {
    bool inert = block.a[lane] == kWorldRow && block.b[lane] == kWorldRow && block.tangent_arm_a[lane] == 0 &&
                 block.tangent_arm_b[lane] == 0 && block.tangent_mass[lane] == 0 &&
                 block.friction_impulse[lane] == 0;
    for (const ContactBlockPoint& p : block.points) {
        inert = inert && p.arm_a[lane] == 0 && p.arm_b[lane] == 0 && p.mass[lane] == 0 &&
                p.impulse[lane] == 0 && p.static_impulse[lane] == 0 && p.separation[lane] > 0 &&
                p.start_separation[lane] > 0;
    }
    return inert;
}

const PairBlock& pairs_of(const ContactLanes& lanes, int bucket, int block) {
    return is_colored(bucket) ? lanes.pairs(block) : lanes.near_pairs(geometry_of(bucket)).at(block);
}

// The blocks of a bucket in their order, and how many lanes of each are used.
std::vector<std::pair<int, int>> blocks_of(const ContactLanes& lanes, int bucket) {
    std::vector<std::pair<int, int>> blocks;
    if (is_colored(bucket)) {
        for (int block = lanes.first_block(bucket); block != kNone; block = lanes.link(block).next) {
            REQUIRE(lanes.link(block).bucket == bucket);
            blocks.emplace_back(block, lanes.link(block).used);
        }
    } else {
        const int count = lanes.near_count(geometry_of(bucket));
        for (int first = 0; first < count; first += kLanes) {
            blocks.emplace_back(first / kLanes, std::min(kLanes, count - first));
        }
    }
    return blocks;
}

void check_against(const ContactLanes& lanes, const Model& model) {
    std::array<int, kBuckets> counts{};
    for (const auto& [contact, kept] : model) {
        ++counts[kept.bucket];
        const int block = kept.lane / kLanes;
        const int lane = kept.lane % kLanes;
        INFO("contact " << contact << " in lane " << kept.lane << " of bucket " << kept.bucket);
        REQUIRE(holds(pairs_of(lanes, kept.bucket, block), lane, kept.pair));
        if (!is_colored(kept.bucket)) continue;
        REQUIRE(holds(lanes.memory(kept.lane), kept.memory));
        REQUIRE(lanes.block(block).friction[lane] == kept.friction);
        REQUIRE(lanes.block(block).points[0].mass[lane] == kept.mass);
    }
    for (const int i : kSomeBuckets) {
        const std::vector<std::pair<int, int>> blocks = blocks_of(lanes, i);
        REQUIRE(static_cast<int>(blocks.size()) == (counts[i] + kLanes - 1) / kLanes);
        int sum = 0;
        for (const auto& [block, used] : blocks) {
            sum += used;
            for (int lane = used; lane < kLanes; ++lane) {
                REQUIRE(holds(pairs_of(lanes, i, block), lane, PairLane{}));
                if (is_colored(i)) REQUIRE(is_inert(lanes.block(block), lane));
            }
        }
        REQUIRE(sum == counts[i]);
    }
}

int any_contact(Random& random, const Model& model) {
    return std::next(model.begin(), random.below(static_cast<int>(model.size())))->first;
}

void add(Random& random, int contact, ContactLanes& lanes, Model& model) {
    Kept kept;
    kept.bucket = kSomeBuckets[random.below(static_cast<int>(kSomeBuckets.size()))];
    kept.pair = random_lane(random, contact);
    kept.lane = lanes.add(kept.bucket, kept.pair);
    if (is_colored(kept.bucket)) {
        REQUIRE(holds(lanes.memory(kept.lane), ContactMemory{}));
        REQUIRE(is_inert(lanes.block(kept.lane / kLanes), kept.lane % kLanes));
    }
    model[contact] = kept;
}

void remove(Random& random, ContactLanes& lanes, Model& model) {
    const Kept gone = model.extract(any_contact(random, model)).mapped();
    const auto [last_block, used] = blocks_of(lanes, gone.bucket).back();
    const int last = last_block * kLanes + used - 1;
    const int moved = lanes.remove(gone.bucket, gone.lane);
    REQUIRE((moved == kNone) == (gone.lane == last));
    if (moved == kNone) return;
    REQUIRE(model.at(moved).bucket == gone.bucket);
    REQUIRE(model.at(moved).lane == last);
    model.at(moved).lane = gone.lane;
}

// What happens to a contact in a step.
void change(Random& random, ContactLanes& lanes, Model& model) {
    Kept& kept = model[any_contact(random, model)];
    if (!is_colored(kept.bucket)) return;
    for (int i = 0; i < 2; ++i) {
        kept.memory.features[i] = random.below(100);
        kept.memory.impulse[i] = random.real_f(0, 1);
    }
    kept.memory.friction_impulse = random.real_f(-1, 1);
    kept.friction = random.real_f(0, 1);
    kept.mass = random.real_f(0, 1);
    lanes.set_memory(kept.lane, kept.memory);
    lanes.set_friction(kept.lane, kept.friction);
    ContactBlock& block = lanes.block(kept.lane / kLanes);
    block.points[0].mass[kept.lane % kLanes] = kept.mass;
    block.a[kept.lane % kLanes] = random.below(100);
    block.tangent_arm_b[kept.lane % kLanes] = random.real_f(-1, 1);
}

struct Placed {
    ContactInput input;
    int bucket = 0;
    int lane = 0;
    ContactConstraint scalar;
};

// Bodies of all masses, with contacts between random pairs; some touch the world, some a body that moves but
// is not moved.
struct Heap {
    Motions motions;
    int first_free = 1;  // rows from here on are moved by contacts
    ContactLanes lanes;
    std::vector<Placed> placed;  // in the order of their buckets

    [[nodiscard]] ContactBlock& block(const Placed& p) { return lanes.block(p.lane / kLanes); }
    [[nodiscard]] PairBlock& pairs(const Placed& p) { return lanes.pairs(p.lane / kLanes); }
};

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
                            heap.lanes.pairs(place.second).features, 1, heap.lanes.block(place.second));
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
        heap.lanes.set_friction(p.lane, p.input.friction);
        p.scalar = make_contact(p.input, heap.motions, kRules);
        heap.placed.push_back(p);
    }
    prepare(heap);
    estimate(heap, random);
    // Contacts of one colour do not meet, so the order inside it is free; the colours come in turn.
    std::stable_sort(heap.placed.begin(), heap.placed.end(),
                     [](const Placed& p, const Placed& q) { return p.bucket < q.bucket; });
    return heap;
}

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
    heap.lanes.warm_start(heap.motions, kStepRatio, kFrictionRatio, alone);
    run_passes(heap.motions, [&](Pass pass) { heap.lanes.solve(heap.motions, kRules, kH_s, pass, alone); });
}

Motions run_scalars(Heap& heap) {
    Motions motions = heap.motions;
    for (Placed& p : heap.placed) warm_start_contact(p.scalar, motions, kStepRatio, kFrictionRatio);
    run_passes(motions, [&](Pass pass) {
        for (Placed& p : heap.placed) solve_contact(p.scalar, motions, kRules, kH_s, pass);
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

const std::vector<BlockKind> kAllKinds{BlockKind::TwoBodies, BlockKind::OneBody, BlockKind::Carried};

}  // namespace

TEST_CASE("lanes stay dense, and contacts keep what is theirs, whatever comes and goes") {
    Random random(1);
    ContactLanes lanes;
    Model model;
    for (int round = 0; round < 3000; ++round) {
        // It grows and shrinks in turn.
        const bool grows = round / 500 % 2 == 0;
        if (model.empty() || random.chance(grows ? 0.6 : 0.3)) {
            add(random, round, lanes, model);
        } else if (random.chance(0.5)) {
            remove(random, lanes, model);
        } else {
            change(random, lanes, model);
        }
        if (round % 10 == 0) check_against(lanes, model);
    }
    while (!model.empty()) remove(random, lanes, model);
    check_against(lanes, model);
}

TEST_CASE("every bucket is of one colour, kind and geometry") {
    std::vector<int> seen;
    for (int color = 0; color < kColors; ++color) {
        for (const BlockKind kind : kAllKinds) {
            for (const PairGeometry geometry : kAllGeometries) {
                const int bucket = colored_bucket(color, kind, geometry);
                CHECK(is_colored(bucket));
                CHECK(color_of(bucket) == color);
                CHECK(kind_of(bucket) == kind);
                CHECK(geometry_of(bucket) == geometry);
                seen.push_back(bucket);
            }
        }
    }
    for (const PairGeometry geometry : kAllGeometries) {
        CHECK_FALSE(is_colored(near_bucket(geometry)));
        CHECK(geometry_of(near_bucket(geometry)) == geometry);
        seen.push_back(near_bucket(geometry));
    }
    std::sort(seen.begin(), seen.end());
    std::vector<int> all(kBuckets);
    std::iota(all.begin(), all.end(), 0);
    CHECK(seen == all);
}

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
    heap.lanes.warm_start(heap.motions, step_ratio, friction_ratio, alone);
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
