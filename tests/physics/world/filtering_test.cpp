// Which pairs collide: categories, masks, groups, joints, body types.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

// Whether a ball of one filter that is dropped on ground of another is caught.
bool collides(Filter ground, Filter ball) {
    World world;
    add_ground(world, {.filter = ground});
    const BodyId id = add(world, {.position_m = {0, 0.6}}, Circle{}, {.filter = ball});
    run_for(world, 1);
    return world.body(id)->position().y > 0.4;
}

}  // namespace

TEST_CASE("a pair collides when each one's categories meet the other's mask") {
    CHECK(collides({}, {}));
    CHECK(collides({.categories = 2, .mask = 4}, {.categories = 4, .mask = 2}));
    CHECK(collides({.categories = 6, .mask = 12}, {.categories = 8, .mask = 2}));
    CHECK_FALSE(collides({.categories = 2, .mask = 4}, {.categories = 4, .mask = 1}));
    CHECK_FALSE(collides({.categories = 2, .mask = 1}, {.categories = 4, .mask = 2}));
    CHECK_FALSE(collides({}, {.mask = 0}));
    CHECK_FALSE(collides({.categories = 0}, {}));
}

TEST_CASE("shapes of one group ignore the masks: positive always, negative never") {
    CHECK(collides({.mask = 0, .group = 3}, {.mask = 0, .group = 3}));
    CHECK_FALSE(collides({.group = -3}, {.group = -3}));
    CHECK(collides({.group = -3}, {.group = -4}));
    CHECK_FALSE(collides({.mask = 0, .group = 3}, {.mask = 0, .group = 4}));
}

TEST_CASE("a filter that changes takes effect on what already touches and on what overlaps") {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId ball = add(world, {.position_m = {0, 0.5}}, Circle{}, {.contact_events = true});
    run_for(world, 0.2);
    REQUIRE(world.counts().touching == 1);
    Shape shape = *world.shape(world.body(ball)->shapes()[0]);
    shape.set_filter({.mask = 0});
    CHECK(shape.filter().mask == 0);
    CHECK(world.counts().contacts == 0);
    step_times(world, 3);
    CHECK(world.body(ball)->position().y < 0.5);
    shape.set_filter({});
    run_for(world, 1);
    CHECK(world.counts().touching == 1);
    CHECK(world.body(ball)->position().y == Approx(0.5).margin(0.005));
    world.shape(world.body(ground)->shapes()[0])->set_filter({.categories = 0});
    run_for(world, 0.5);
    CHECK(world.body(ball)->position().y < 0);
}

TEST_CASE("what leaves a group below 0 meets it, also where it goes fast and comes from a snapshot") {
    World world({.gravity_m_s2 = {}});
    for (const float x : {0.0f, 0.3f})
        add(world, {.position_m = {x, 0}, .linear_velocity_m_s = {200, 0}}, Circle{},
            {.filter = {.group = -1}});
    step_times(world, 3);
    REQUIRE(world.counts().contacts == 0);
    World restored({.gravity_m_s2 = {}});
    restored.restore(world.snapshot().value().bytes()).value();
    step_times(restored, 1);
    CHECK(restored.counts().contacts == 0);
    for (World* w : {&world, &restored}) {
        const BodyId first = w->bodies().front();
        w->shape(w->body(first)->shapes()[0])->set_filter({.group = -2});
        step_times(*w, 1);
        CHECK(w->counts().contacts == 1);
        w->shape(w->body(first)->shapes()[0])->set_filter({.group = -1});
        step_times(*w, 1);
        CHECK(w->counts().contacts == 0);
    }
}

TEST_CASE("shapes of one body, and bodies that are not dynamic, never collide") {
    World world;
    const BodyId body = world.create_body({}).value();
    world.create_shape(body, Circle{}).value();
    world.create_shape(body, Circle{{0.1f, 0}, 0.5f}).value();
    add(world, {.type = BodyType::Static, .position_m = {10, 0}}, Circle{});
    add(world, {.type = BodyType::Kinematic, .position_m = {10, 0}}, Circle{});
    add(world, {.type = BodyType::Kinematic, .position_m = {10, 0.1}}, Circle{});
    step_times(world, 2);
    CHECK(world.counts().contacts == 0);
}

TEST_CASE("jointed bodies collide only when the joint says so, and again when it is gone") {
    for (const bool collide_connected : {false, true}) {
        World world({.gravity_m_s2 = {}, .enable_sleep = false});
        const BodyId a = add(world, {}, Box{0.5f, 0.5f});
        const BodyId b = add(world, {.position_m = {0.9, 0}}, Box{0.5f, 0.5f});
        const JointId joint = world
                                  .create_joint(RevoluteJointDef{.body_a = a,
                                                                 .body_b = b,
                                                                 .local_anchor_a_m = {0.9f, 0},
                                                                 .collide_connected = collide_connected})
                                  .value();
        step_times(world, 5);
        CHECK(world.counts().contacts == (collide_connected ? 1 : 0));
        world.destroy_joint(joint).value();
        step_times(world, 60);
        CHECK(world.body(b)->position().x - world.body(a)->position().x > 0.99);
    }
}

TEST_CASE("a joint made between touching bodies ends their touching") {
    World world({.gravity_m_s2 = {}});
    const BodyId a = add(world, {}, Box{0.5f, 0.5f}, {.contact_events = true});
    const BodyId b = add(world, {.position_m = {0.999, 0}}, Box{0.5f, 0.5f});
    step_times(world, 2);
    REQUIRE(world.counts().touching == 1);
    world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length_m = 1}).value();
    CHECK(world.counts().contacts == 0);
    world.step(kStep_s).value();
    CHECK(world.contact_ends().size() == 1);
}

TEST_CASE("with two joints between two bodies, one that forbids collision is enough") {
    World world({.gravity_m_s2 = {}});
    const BodyId a = add(world, {}, Box{0.5f, 0.5f});
    const BodyId b = add(world, {.position_m = {0.95, 0}}, Box{0.5f, 0.5f});
    const auto rod = [&](bool collide_connected) {
        return world
            .create_joint(DistanceJointDef{
                .body_a = a, .body_b = b, .length_m = 0.95f, .collide_connected = collide_connected})
            .value();
    };
    rod(true);
    const JointId forbidding = rod(false);
    step_times(world, 2);
    CHECK(world.counts().contacts == 0);
    world.destroy_joint(forbidding).value();
    step_times(world, 2);
    CHECK(world.counts().contacts == 1);
}

namespace {

// A host that notes what it is asked and refuses pairs with one of the shapes that it was told.
struct Host {
    std::vector<std::pair<ShapeId, ShapeId>> asked{};
    std::vector<ShapeId> refused{};

    [[nodiscard]] PairFilter filter() { return {&answer, this}; }

    static bool answer(void* context, ShapeId a, ShapeId b) {
        Host& host = *static_cast<Host*>(context);
        host.asked.emplace_back(a, b);
        for (const ShapeId shape : host.refused) {
            if (shape == a || shape == b) return false;
        }
        return true;
    }
};

ShapeId shape_of(const World& world, BodyId body) {
    return world.body(body)->shapes()[0];
}

}  // namespace

TEST_CASE("the host is asked once for each pair that filters allow, while it stays together") {
    Host host;
    World world({.enable_sleep = false});
    world.set_pair_filter(host.filter());
    add_ground(world);
    for (int i = 0; i < 20; ++i) add(world, {.position_m = {1.5 * i, 0.5}}, Box{0.5f, 0.5f});
    add(world, {.position_m = {0, 2.5}}, Circle{}, {.filter = {.mask = 0}});
    run_for(world, 1);
    CHECK(host.asked.size() == 20);
    const std::set<std::uint64_t> distinct = [&] {
        std::set<std::uint64_t> boxes;
        for (const auto& [a, b] : host.asked) boxes.insert(b.bits());
        return boxes;
    }();
    CHECK(distinct.size() == 20);
}

TEST_CASE("a pair that the host refuses passes through, is not asked about again, and wakes nobody") {
    Host host;
    World world;
    world.set_pair_filter(host.filter());
    add_ground(world);
    const BodyId sleeper = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f}, {.contact_events = true});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(sleeper)->is_awake());
    const BodyId ghost =
        add(world, {.position_m = {-3, 0.5}, .linear_velocity_m_s = {3, 0}, .gravity_scale = 0}, Circle{},
            {.filter = {.categories = 2}});
    host.refused = {shape_of(world, ghost)};
    host.asked.clear();
    run_for(world, 2);
    CHECK(world.body(ghost)->position().x == Approx(3).margin(1e-3));
    CHECK_FALSE(world.body(sleeper)->is_awake());
    CHECK(host.asked.size() == 2);  // the ground and the sleeper
    // A pair that parted and meets again is a new one.
    world.body(ghost)->set_transform({-10, 20}, 0).value();
    world.step(kStep_s).value();
    world.body(ghost)->set_transform({0, 0.5}, 0).value();
    world.step(kStep_s).value();
    CHECK(host.asked.size() == 4);
    CHECK(world.contact_begins().empty());
}

TEST_CASE("a pair that the host refuses is passed at any speed") {
    for (const bool refused : {false, true}) {
        Host host;
        World world({.gravity_m_s2 = {}});
        world.set_pair_filter(host.filter());
        const BodyId wall = add(world, {.type = BodyType::Static}, Box{0.05f, 5});
        if (refused) host.refused = {shape_of(world, wall)};
        const BodyId ball =
            add(world, {.position_m = {-5, 0}, .linear_velocity_m_s = {900, 0}}, Circle{{}, 0.1f});
        run_for(world, 1);
        CHECK((world.body(ball)->position().x > 800) == refused);
    }
}

TEST_CASE("the host is asked again about a shape that is refiltered") {
    Host host;
    World world({.enable_sleep = false});
    world.set_pair_filter(host.filter());
    const BodyId ground = add_ground(world);
    const BodyId ball = add(world, {.position_m = {0, 0.5}}, Circle{}, {.contact_events = true});
    run_for(world, 0.5);
    REQUIRE(world.counts().touching == 1);
    host.refused = {shape_of(world, ground)};
    run_for(world, 0.5);
    CHECK(world.counts().touching == 1);  // the answer stands
    CHECK(host.asked.size() == 1);
    world.shape(shape_of(world, ball))->set_filter({});
    world.step(kStep_s).value();
    CHECK(host.asked.size() == 2);
    CHECK(world.contact_ends().size() == 1);
    run_for(world, 0.5);
    CHECK(world.body(ball)->position().y < 0);
    host.refused.clear();
    world.body(ball)->set_transform({0, 0.5}, 0).value();
    world.body(ball)->set_linear_velocity({}).value();
    world.shape(shape_of(world, ground))->set_filter({});
    run_for(world, 0.5);
    CHECK(world.body(ball)->position().y == Approx(0.5).margin(0.005));
}

TEST_CASE("the host is asked in the same order in the same world, smaller shape first") {
    Host first;
    Host second;
    for (Host* host : {&first, &second}) {
        World world;
        world.set_pair_filter(host->filter());
        add_ground(world);
        for (int i = 0; i < 60; ++i)
            add(world, {.position_m = {0.3 * (i % 10), 0.6 + 0.5 * (i / 10)}}, Circle{{}, 0.2f});
        run_for(world, 2);
    }
    REQUIRE(first.asked.size() == second.asked.size());
    REQUIRE(first.asked.size() > 100);
    for (std::size_t i = 0; i < first.asked.size(); ++i) {
        CHECK(first.asked[i].first.index1 == second.asked[i].first.index1);
        CHECK(first.asked[i].second.index1 == second.asked[i].second.index1);
        CHECK(first.asked[i].first.index1 < first.asked[i].second.index1);
    }
}

TEST_CASE("without a filter of the host every pair may collide again") {
    Host host;
    World world;
    world.set_pair_filter(host.filter());
    const BodyId ground = add_ground(world);
    host.refused = {shape_of(world, ground)};
    world.set_pair_filter({});
    const BodyId ball = add(world, {.position_m = {0, 0.5}}, Circle{});
    run_for(world, 1);
    CHECK(host.asked.empty());
    CHECK(world.body(ball)->position().y == Approx(0.5).margin(0.005));
}

TEST_CASE("the host is asked of hundreds of new pairs in one order, and on the thread that steps") {
    struct Asked {
        std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs{};
        std::set<std::thread::id> threads{};

        static bool answer(void* context, ShapeId a, ShapeId b) {
            Asked& self = *static_cast<Asked*>(context);
            self.pairs.emplace_back(std::min<std::uint64_t>(a.index1, b.index1),
                                    std::max<std::uint64_t>(a.index1, b.index1));
            self.threads.insert(std::this_thread::get_id());
            return true;
        }
    };
    constexpr int kBalls = 40;
    const auto asked_with = [](int threads) {
        Asked asked;
        World world({.threads = threads});
        world.set_pair_filter({&Asked::answer, &asked});
        for (int i = 0; i < kBalls; ++i) add(world, {.position_m = {0.01 * i, 0}}, Circle{{}, 0.5f});
        world.step(kStep_s).value();
        CHECK(asked.threads == std::set{std::this_thread::get_id()});
        CHECK(std::set(asked.pairs.begin(), asked.pairs.end()).size() == asked.pairs.size());
        CHECK(world.counts().contacts == kBalls * (kBalls - 1) / 2);
        return asked.pairs;
    };
    const auto pairs = asked_with(1);
    CHECK(pairs.size() == kBalls * (kBalls - 1) / 2);
    CHECK(asked_with(3) == pairs);
}

TEST_CASE("the world refuses to be changed by the host's filter, and goes on") {
    struct Meddler {
        World& world;
        BodyId ball{};
        std::vector<std::string> messages{};

        static bool answer(void* context, ShapeId, ShapeId shape) {
            Meddler& self = *static_cast<Meddler*>(context);
            World& world = self.world;
            const auto note = [&](const auto& result) {
                self.messages.push_back(result ? "done" : result.error().message);
            };
            note(world.destroy_body(self.ball));
            note(world.destroy_bodies(std::array{self.ball}));
            note(world.destroy_shape(shape));
            note(world.create_body({}));
            note(world.create_bodies({}, {}));
            note(world.create_shape(self.ball, Circle{}));
            note(world.create_joint(RevoluteJointDef{}));
            note(world.create_joint(DistanceJointDef{}));
            note(world.destroy_joint({}));
            note(world.step(kStep_s));
            note(world.set_gravity({}));
            return true;
        }
    };
    World world;
    Meddler meddler{world};
    world.set_pair_filter({&Meddler::answer, &meddler});
    add_ground(world);
    meddler.ball = add(world, {.position_m = {0, 0.5}}, Circle{});
    run_for(world, 1);
    REQUIRE(meddler.messages.size() == 11);
    for (const std::string& message : meddler.messages) CHECK_THAT(message, Contains("within a step"));
    CHECK(world.body(meddler.ball)->position().y == Approx(0.5).margin(0.005));
    CHECK(world.step_count() == 60);
    CHECK(world.create_body({}));
}

TEST_CASE("a filter of a query cannot make or destroy anything, and is told so") {
    World world;
    add_ground(world);
    std::vector<BodyId> balls;
    for (int i = 0; i < 20; ++i)
        balls.push_back(add(world, {.position_m = {1.0 * i, 0.4}}, Circle{{}, 0.4f}));
    std::vector<std::string> messages;
    const auto meddle = [&](ShapeId shape, BodyId body) {
        const auto note = [&](const auto& result) {
            messages.push_back(result ? "done" : result.error().message);
        };
        note(world.destroy_body(body));
        note(world.destroy_shape(shape));
        note(world.create_body({}));
        note(world.create_shape(body, Circle{}));
        note(world.create_joint(DistanceJointDef{}));
        note(world.step(kStep_s));
        return true;
    };
    const QueryFilter filter{.accepts = meddle};
    CHECK(world.cast_ray_all({-5, 0.4}, {40, 0}, filter).value().size() == balls.size());
    CHECK(world.shapes_overlapping(Box{50, 0.1f}, {{0, 0.5}}, filter).value().size() == balls.size());
    CHECK(world.shape_at({3, 0.4}, filter).value().has_value());
    CHECK(world.closest_points({3, 3}, 5, filter).value().size() > 5);
    world.explode({.center_m = {3, 3}, .radius_m = 5, .filter = filter}).value();
    REQUIRE(messages.size() > 6 * 45);
    for (const std::string& message : messages) CHECK_THAT(message, Contains("within a query"));
    CHECK(world.counts().bodies == 21);
    CHECK(world.create_body({}));
}

}  // namespace cairn::physics
