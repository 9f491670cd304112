// Shapes that are made alike share what they are made of, and nothing else.
#include "world/shape_prototypes.h"

#include <catch2/catch.hpp>
#include <map>
#include <utility>
#include <vector>

#include "base/split_mix.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

Convex box(float half_m) {
    return make_convex(Box{half_m, half_m}).value();
}

}  // namespace

TEST_CASE("what is alike in all bits is one prototype, and anything else another") {
    ShapePrototypes prototypes;
    auto* const first = prototypes.take(box(0.5f), {});
    CHECK(prototypes.take(box(0.5f), {.user_data = 7}) == first);
    CHECK(prototypes.take(box(0.5f), {.filter = {.group = -1}}) == first);
    CHECK(first->users == 3);
    CHECK(prototypes.size() == 1);

    std::vector<ShapeDef> others(9);
    others[0].density_kg_m2 = 2;
    others[1].material.friction = 0.5f;
    others[2].material.kind = 1;
    others[3].filter.mask = 1;
    others[4].contact_events = true;
    others[5].hit_events = true;
    others[6].sensor = true;
    others[7].seen_by_sensors = false;
    others[8].one_way_normal = {0, 1};
    for (const ShapeDef& def : others) CHECK(prototypes.take(box(0.5f), def)->def.sensor == def.sensor);
    CHECK(prototypes.size() == 10);

    Convex moved = box(0.5f);
    moved.centroid.x = -0.0f;  // equal to 0, but not the same bits
    CHECK(prototypes.take(moved, {}) != first);
    CHECK(prototypes.take(box(0.25f), {}) != first);
    CHECK(prototypes.size() == 12);
}

TEST_CASE("a prototype lasts as long as a shape is made of it, and stays where it is") {
    ShapePrototypes prototypes;
    auto* const kept = prototypes.take(box(1), {});
    std::vector<ShapePrototype*> others;
    for (int i = 0; i < 1000; ++i)
        others.push_back(prototypes.take(box(2 + 0.01f * static_cast<float>(i)), {}));
    CHECK(prototypes.take(box(1), {}) == kept);
    for (auto* other : others) prototypes.release(other);
    CHECK(prototypes.size() == 1);
    CHECK(kept->convex.half_size == Vec2{1, 1});
    prototypes.release(kept);
    CHECK(prototypes.size() == 1);
    prototypes.release(kept);
    CHECK(prototypes.size() == 0);
}

TEST_CASE("prototypes that come and go are those that shapes are made of") {
    ShapePrototypes prototypes;
    std::map<int, std::pair<ShapePrototype*, int>> expected;  // by half size: the prototype, and its users
    SplitMix random(7);
    for (int i = 0; i < 20'000; ++i) {
        const int size = static_cast<int>(random.real(1, 300));
        auto& [known, users] = expected[size];
        if (users > 0 && random.real(0, 1) < 0.5) {
            prototypes.release(known);
            if (--users == 0) expected.erase(size);
            continue;
        }
        ShapePrototype* const taken = prototypes.take(box(0.01f * static_cast<float>(size)), {});
        REQUIRE((users == 0 || taken == known));
        known = taken;
        REQUIRE(taken->users == ++users);
        REQUIRE(taken->convex.half_size.x == 0.01f * static_cast<float>(size));
        REQUIRE(prototypes.size() == expected.size());
    }
    prototypes.clear();
    CHECK(prototypes.size() == 0);
    CHECK(prototypes.take(box(1), {})->users == 1);
}

TEST_CASE("shapes of one prototype keep their groups, through a snapshot, too") {
    World world;
    // The first two follow one another in a snapshot, and so do the last two, which are alike.
    const std::vector<std::int32_t> groups{-1, -2, 0, 3, 3};
    std::vector<ShapeId> ids;
    for (const std::int32_t group : groups) {
        const BodyId body = world.create_body({.type = BodyType::Dynamic}).value();
        ids.push_back(world.create_shape(body, Box{}, {.filter = {.group = group}}).value());
    }
    World restored;
    restored.restore(world.snapshot().value().bytes()).value();
    for (std::size_t i = 0; i < groups.size(); ++i) {
        CHECK(world.shape(ids[i])->filter().group == groups[i]);
        CHECK(restored.shape(restored.own(ids[i]))->filter().group == groups[i]);
    }
    Shape changed = *world.shape(ids[3]);
    changed.set_filter({.group = 7});
    CHECK(changed.filter().group == 7);
    CHECK(world.shape(ids[4])->filter().group == 3);
}

TEST_CASE("a change of one shape changes no other that was made alike") {
    World world;
    const BodyId body = world.create_body({.type = BodyType::Dynamic}).value();
    std::vector<ShapeId> ids;
    for (std::uint64_t i = 0; i < 3; ++i)
        ids.push_back(world.create_shape(body, Box{}, {.user_data = i}).value());
    Shape changed = *world.shape(ids[1]);
    const Outline outline = changed.outline();
    changed.set_density(3).value();
    changed.set_material({.friction = 0.1f}).value();
    changed.set_filter({.categories = 4});
    changed.set_one_way_normal({0, 2}).value();
    changed.set_seen_by_sensors(false);
    changed.set_user_data(9);
    CHECK(changed.density() == 3);
    CHECK(changed.material().friction == 0.1f);
    CHECK(changed.filter().categories == 4);
    CHECK(changed.one_way_normal() == Vec2{0, 1});
    CHECK(!changed.is_seen_by_sensors());
    CHECK(changed.user_data() == 9);
    CHECK(changed.outline().points_m == outline.points_m);
    for (const std::size_t i : {0, 2}) {
        const Shape same = *world.shape(ids[i]);
        CHECK(same.density() == 1);
        CHECK(same.material().friction == 0.6f);
        CHECK(same.filter().categories == 1);
        CHECK(same.one_way_normal() == Vec2{});
        CHECK(same.is_seen_by_sensors());
        CHECK(same.user_data() == i);
    }
    CHECK(world.body(body)->mass() == Approx(5));
}

}  // namespace cairn::physics
