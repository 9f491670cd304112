// Many bodies at once: all or none, and nothing that grows with the square of their number.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"
#include "world/edge_list.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

std::vector<BodyDef> row_of_bodies(int count) {
    std::vector<BodyDef> defs;
    for (int i = 0; i < count; ++i) defs.push_back({.position_m = {1.3 * i, 0.5}});
    return defs;
}

std::vector<BodyId> create(World& world, const std::vector<BodyDef>& defs) {
    std::vector<BodyId> ids(defs.size());
    world.create_bodies(defs, ids).value();
    return ids;
}

// Boxes side by side on one ground, 20 km wide.
struct Crowd {
    World world;
    BodyId ground = add(world, {.type = BodyType::Static, .position_m = {5000, -1}}, Box{10000, 1});
    std::vector<BodyId> boxes;

    explicit Crowd(int count) : boxes(create(world, row_of_bodies(count))) {
        for (const BodyId box : boxes)
            world.create_shape(box, Box{0.5f, 0.5f}, {.contact_events = true}).value();
    }
};

// Records of an edge list that count how often one is looked at.
struct CountedRecords {
    struct Record {
        Edges edges;
    };
    std::vector<Record> records;
    mutable long looks = 0;

    Record& operator[](int i) { return ++looks, records[static_cast<std::size_t>(i)]; }
    const Record& operator[](int i) const { return ++looks, records[static_cast<std::size_t>(i)]; }
};

}  // namespace

TEST_CASE("bodies made at once are those made one by one") {
    World at_once;
    World singly;
    std::vector<BodyDef> defs = row_of_bodies(200);
    for (std::size_t i = 0; i < defs.size(); ++i) {
        defs[i].type = i % 5 == 0 ? BodyType::Static : i % 5 == 1 ? BodyType::Kinematic : BodyType::Dynamic;
        defs[i].linear_velocity_m_s = {0.1f * static_cast<float>(i), 1};
        defs[i].awake = i % 7 != 0;
        defs[i].user_data = i;
    }
    const std::vector<BodyId> ids = create(at_once, defs);
    for (std::size_t i = 0; i < defs.size(); ++i) {
        const BodyId id = singly.create_body(defs[i]).value();
        REQUIRE((ids[i].index1 == id.index1 && ids[i].generation == id.generation));
        CHECK(at_once.body(ids[i])->user_data() == i);
    }
    CHECK(at_once.state_hash() == singly.state_hash());
    run_for(at_once, 0.5);
    run_for(singly, 0.5);
    CHECK(at_once.state_hash() == singly.state_hash());
}

TEST_CASE("of bodies of which one is bad none is made, and the error tells which") {
    World world;
    World untouched;
    std::vector<BodyDef> defs = row_of_bodies(1000);
    std::vector<BodyId> ids(defs.size(), BodyId::make(7, 7, 7));
    defs[713].gravity_scale = std::numeric_limits<float>::quiet_NaN();
    CHECK_THAT(world.create_bodies(defs, ids).error().message,
               Contains("bodies[713]: body.gravity_scale is nan, but must be finite"));
    CHECK(listed(world.counts()) == std::array{0, 0, 0, 0, 0, 0});
    CHECK(std::all_of(ids.begin(), ids.end(), [](BodyId id) { return id == BodyId::make(7, 7, 7); }));
    ids.resize(999);
    CHECK_THAT(world.create_bodies(defs, ids).error().message, Contains("999") && Contains("1000"));
    CHECK(world.state_hash() == untouched.state_hash());
    CHECK(world.create_body({})->index1 == untouched.create_body({})->index1);
    CHECK(world.create_bodies({}, {}));
}

TEST_CASE("of handles of which one is bad no body is destroyed, and the error tells which") {
    World world;
    std::vector<BodyId> ids = create(world, row_of_bodies(100));
    World other;
    const BodyId foreign = other.create_body({}).value();
    const BodyId gone = world.create_body({}).value();
    world.destroy_body(gone).value();
    const std::uint64_t hash = world.state_hash();
    const auto message = [&](std::size_t at, BodyId bad) {
        std::vector<BodyId> list = ids;
        list[at] = bad;
        return world.destroy_bodies(list).error().message;
    };
    CHECK_THAT(message(42, BodyId{}), Contains("bodies[42]: the body handle is null"));
    CHECK_THAT(message(99, gone), Contains("bodies[99]: the body has been destroyed"));
    CHECK_THAT(message(0, foreign), Contains("bodies[0]: the body belongs to another world"));
    CHECK_THAT(message(60, ids[20]), Contains("bodies[60] is the same body as bodies[20]"));
    CHECK_THAT(message(20, ids[60]), Contains("bodies[60] is the same body as bodies[20]"));
    CHECK(world.state_hash() == hash);
    CHECK(world.counts().bodies == 100);
    CHECK(world.destroy_bodies({}));
    world.destroy_bodies(ids).value();
    CHECK(world.counts().bodies == 0);
}

TEST_CASE("10,000 bodies on one ground: one question per pair, and ground or bodies can go at once") {
    struct Host {
        int asked = 0;
        static bool answer(void* self, ShapeId, ShapeId) { return ++static_cast<Host*>(self)->asked > 0; }
    } host;
    constexpr int kCount = 10'000;
    Crowd crowd(kCount);
    World& world = crowd.world;
    world.set_pair_filter({&Host::answer, &host});
    step_times(world, 5);
    CHECK(host.asked == kCount);
    CHECK(world.counts().contacts == kCount);
    CHECK(world.counts().touching == kCount);
    int ends = 0;
    SECTION("the ground") {
        world.destroy_body(crowd.ground).value();
        CHECK(world.counts().contacts == 0);
        CHECK(world.counts().awake_bodies == kCount);
        world.step(kStep_s).value();
        ends = static_cast<int>(world.contact_ends().size());
        CHECK(world.body(crowd.boxes.front())->linear_velocity().y < 0);
        CHECK(world.body(crowd.boxes.back())->linear_velocity().y < 0);
    }
    SECTION("the bodies, in any order, and new ones take their place") {
        Random random(1);
        for (std::size_t i = crowd.boxes.size(); i > 1; --i) {
            std::swap(crowd.boxes[i - 1],
                      crowd.boxes[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
        }
        world.destroy_bodies(crowd.boxes).value();
        CHECK(listed(world.counts()) == std::array{1, 0, 1, 0, 0, 0});
        const std::vector<BodyId> fresh = create(world, row_of_bodies(kCount));
        for (const BodyId box : fresh) world.create_shape(box, Box{0.5f, 0.5f}).value();
        world.step(kStep_s).value();
        ends = static_cast<int>(world.contact_ends().size());
        CHECK(host.asked == 2 * kCount);
        CHECK(world.counts().contacts == kCount);
        for (const BodyId old : crowd.boxes) REQUIRE_FALSE(world.contains(old));
    }
    CHECK(ends == kCount);
}

TEST_CASE("leaving a list of contacts takes the same few looks, however long the list is") {
    for (const int count : {100, 10'000}) {
        CountedRecords records{std::vector<CountedRecords::Record>(static_cast<std::size_t>(count))};
        int head = kNone;
        for (int i = 0; i < count; ++i) link_edge(records, head, i, 0);
        std::vector<int> order;
        for (int i = 0; i < count; ++i) order.push_back(i);
        Random random(3);
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
        }
        CHECK(records.looks <= 2L * count);
        records.looks = 0;
        for (const int record : order) unlink_edge(records, head, record, 0);
        CHECK(head == kNone);
        CHECK(records.looks <= 3L * count);
    }
}

TEST_CASE("all that events name may be destroyed at once while they are read") {
    Crowd crowd(50);
    World& world = crowd.world;
    world.step(kStep_s).value();
    REQUIRE(world.contact_begins().size() == 50);
    int refused = 0;
    for (const ContactBegin& event : world.contact_begins()) {
        const std::array both{event.body_a, event.body_b};
        if (!world.destroy_bodies(both)) ++refused;  // the ground went with the first
    }
    CHECK(refused == 49);
    CHECK(world.counts().bodies == 49);
    world.step(kStep_s).value();
    CHECK(world.contact_ends().size() == 50);
}

}  // namespace cairn::physics
