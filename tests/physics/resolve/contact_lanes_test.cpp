// Contacts in lanes: their upkeep against a plain map.
#include "resolve/contact_lanes.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <iterator>
#include <map>
#include <numeric>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

struct Kept {
    int bucket = 0;
    int lane = 0;
    PairLane pair;
    ContactMemory memory;  // in colours
    float friction = 0;
    float restitution = 0;
    float mass = 0;  // stands for all that is made anew in each step
};

using Model = std::map<int, Kept>;  // by contact

constexpr std::array kAllGeometries{PairGeometry::Boxes, PairGeometry::Hulls, PairGeometry::Chains};
constexpr std::array kSomeBuckets{near_bucket(PairGeometry::Boxes),
                                  near_bucket(PairGeometry::Hulls),
                                  colored_bucket(0, BlockKind::TwoBodies, PairGeometry::Boxes),
                                  colored_bucket(0, BlockKind::OneBody, PairGeometry::Hulls),
                                  colored_bucket(0, BlockKind::OneBody, PairGeometry::Hulls, 3),
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
    return lane;
}

// The same pair for a near bucket. What only near pairs have is taken from what those have no use for.
NearPair near_pair(const PairLane& lane) {
    NearPair pair;
    pair.contact = lane.contact;
    pair.body_a = lane.body_a;
    pair.body_b = lane.body_b;
    pair.shape_a = lane.shape_a;
    pair.shape_b = lane.shape_b;
    pair.offset_a = lane.offset_a;
    pair.offset_b = lane.offset_b;
    pair.reach_m = lane.half_a.x;
    pair.sight.gap_m = lane.half_b.x;
    pair.flags = lane.reports ? near_flag::kRemembers : 0;
    return pair;
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
           (pairs.reports >> lane & 1) == (expected.reports ? 1 : 0);
}

bool holds(const NearPair& pair, const PairLane& expected) {
    return pair.contact == expected.contact && pair.body_a == expected.body_a &&
           pair.body_b == expected.body_b && pair.shape_a == expected.shape_a &&
           pair.shape_b == expected.shape_b && pair.offset_a == expected.offset_a &&
           pair.offset_b == expected.offset_b && pair.reach_m == expected.half_a.x &&
           pair.sight.gap_m == expected.half_b.x &&
           pair.flags == (expected.reports ? near_flag::kRemembers : 0);
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

bool holds(const ContactLanes& lanes, int bucket, int lane, const PairLane& expected) {
    if (is_colored(bucket)) return holds(lanes.pairs(lane / kLanes), lane % kLanes, expected);
    return holds(lanes.near_pairs(geometry_of(bucket)).at(static_cast<std::size_t>(lane)), expected);
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
        REQUIRE(holds(lanes, kept.bucket, kept.lane, kept.pair));
        if (!is_colored(kept.bucket)) continue;
        REQUIRE(holds(lanes.memory(kept.lane), kept.memory));
        REQUIRE(lanes.block(block).friction[lane] == kept.friction);
        const ImpactLanes* impacts = lanes.impacts(block);
        REQUIRE((impacts == nullptr ? 0 : impacts->restitution[lane]) == kept.restitution);
        REQUIRE(lanes.block(block).points[0].mass[lane] == kept.mass);
    }
    for (const int i : kSomeBuckets) {
        const std::vector<std::pair<int, int>> blocks = blocks_of(lanes, i);
        REQUIRE(static_cast<int>(blocks.size()) == (counts[i] + kLanes - 1) / kLanes);
        int sum = 0;
        for (const auto& [block, used] : blocks) {
            sum += used;
            for (int lane = used; lane < kLanes; ++lane) {
                REQUIRE(holds(lanes, i, block * kLanes + lane, PairLane{}));
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
    if (is_colored(kept.bucket)) {
        kept.lane = lanes.add(kept.bucket, kept.pair);
        REQUIRE(holds(lanes.memory(kept.lane), ContactMemory{}));
        REQUIRE(is_inert(lanes.block(kept.lane / kLanes), kept.lane % kLanes));
    } else {
        const PairGeometry geometry = geometry_of(kept.bucket);
        kept.lane = lanes.open_near(geometry);
        NearPair& pair = lanes.near_pairs(geometry)[kept.lane];
        REQUIRE(holds(pair, PairLane{}));
        pair = near_pair(kept.pair);
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

void move(Random& random, ContactLanes& lanes, Model& model) {
    Kept& kept = model[any_contact(random, model)];
    const int to = kSomeBuckets[random.below(static_cast<int>(kSomeBuckets.size()))];
    if (!is_colored(kept.bucket) || !is_colored(to) || to == kept.bucket) return;
    const auto [lane, filler] = lanes.move(kept.bucket, kept.lane, to);
    if (filler != kNone) model.at(filler).lane = kept.lane;
    kept.bucket = to;
    kept.lane = lane;
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
    kept.restitution = random.chance(0.1) ? random.real_f(0, 0.2) : 0;
    lanes.set_material(kept.lane, kept.friction, kept.restitution);
    ContactBlock& block = lanes.block(kept.lane / kLanes);
    block.points[0].mass[kept.lane % kLanes] = kept.mass;
    block.a[kept.lane % kLanes] = random.below(100);
    block.tangent_arm_b[kept.lane % kLanes] = random.real_f(-1, 1);
}

void sort(Random& random, ContactLanes& lanes, Model& model, LaneOrder& order) {
    std::vector<Place> places(1000);
    for (Place& place : places) place.row = random.below(500);
    lanes.sort(places, order, [&](int contact, int lane) { model.at(contact).lane = lane; });
    for (const int bucket : kSomeBuckets) {
        if (!is_colored(bucket)) continue;
        int last = 0;
        for (const auto& [block, used] : blocks_of(lanes, bucket)) {
            for (int lane = 0; lane < used; ++lane) {
                const int row_b = places[static_cast<std::size_t>(lanes.pairs(block).body_b[lane])].row;
                const int row_a = places[static_cast<std::size_t>(lanes.pairs(block).body_a[lane])].row;
                const int sum = kind_of(bucket) == BlockKind::OneBody ? 2 * row_b : row_a + row_b;
                REQUIRE(last <= sum);
                last = sum;
            }
        }
    }
    const std::uint64_t version = lanes.version();
    lanes.sort(places, order, [](int, int) { FAIL("they are in order already"); });
    CHECK(lanes.version() == version);
}

const std::vector<BlockKind> kAllKinds{BlockKind::TwoBodies, BlockKind::OneBody, BlockKind::Carried};

}  // namespace

TEST_CASE("lanes stay dense, and contacts keep what is theirs, whatever comes and goes") {
    Random random(1);
    ContactLanes lanes;
    Model model;
    LaneOrder order;
    for (int round = 0; round < 3000; ++round) {
        // It grows and shrinks in turn.
        const bool grows = round / 500 % 2 == 0;
        if (model.empty() || random.chance(grows ? 0.6 : 0.3)) {
            add(random, round, lanes, model);
        } else if (random.chance(0.5)) {
            remove(random, lanes, model);
        } else if (random.chance(0.3)) {
            move(random, lanes, model);
        } else {
            change(random, lanes, model);
        }
        if (round % 50 == 0) sort(random, lanes, model, order);
        if (round % 10 == 0) check_against(lanes, model);
    }
    while (!model.empty()) remove(random, lanes, model);
    check_against(lanes, model);
}

TEST_CASE("contacts that turn in a step go on doing so when others are removed, and others do not begin to") {
    Random random(2);
    constexpr int kBucket = colored_bucket(0, BlockKind::TwoBodies, PairGeometry::Hulls);
    ContactLanes lanes;
    std::map<int, int> lane_of;
    for (int contact = 0; contact < 100; ++contact)
        lane_of[contact] = lanes.add(kBucket, random_lane(random, contact));
    const auto turns = [](int contact) { return contact % 5 == 0; };
    lanes.make_room_for_turns();
    for (const auto& [contact, lane] : lane_of) {
        const auto bow = static_cast<float>(contact);
        if (turns(contact)) lanes.turn(lane / kLanes, lane % kLanes, bow, -bow);
    }
    while (!lane_of.empty()) {
        const auto gone = std::next(lane_of.begin(), random.below(static_cast<int>(lane_of.size())));
        const int freed = gone->second;
        lane_of.erase(gone);
        const int moved = lanes.remove(kBucket, freed);
        if (moved != kNone) lane_of[moved] = freed;
        int turning = 0;
        for (const auto& [contact, lane] : lane_of) {
            const TurnLanes* found = lanes.block(lane / kLanes).turning;
            const bool turns_here = found != nullptr && (found->used >> lane % kLanes & 1) != 0;
            REQUIRE(turns_here == turns(contact));
            if (!turns_here) continue;
            REQUIRE(found->bow_a[lane % kLanes] == static_cast<float>(contact));
            REQUIRE(found->bow_b[lane % kLanes] == -static_cast<float>(contact));
            ++turning;
        }
        // None in lanes without a contact.
        int used = 0;
        for (const auto& [block, count] : blocks_of(lanes, kBucket)) {
            const TurnLanes* found = lanes.block(block).turning;
            used += found == nullptr ? 0 : std::popcount(found->used);
        }
        REQUIRE(used == turning);
    }
    // A block that is used again knows nothing of that.
    const int lane = lanes.add(kBucket, random_lane(random, 0));
    CHECK(lanes.block(lane / kLanes).turning == nullptr);
}

TEST_CASE("every bucket is of one domain, colour, kind and geometry") {
    std::vector<int> seen;
    for (int domain = 0; domain <= kMostDomains; ++domain) {
        for (int color = 0; color < kColors; ++color) {
            for (const BlockKind kind : kAllKinds) {
                for (const PairGeometry geometry : kAllGeometries) {
                    const int bucket = colored_bucket(color, kind, geometry, domain);
                    CHECK(is_colored(bucket));
                    CHECK(domain_of(bucket) == domain);
                    CHECK(color_of(bucket) == color);
                    CHECK(kind_of(bucket) == kind);
                    CHECK(geometry_of(bucket) == geometry);
                    seen.push_back(bucket);
                }
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

}  // namespace cairn::physics
