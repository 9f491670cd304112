// Chains in a world: joins are not felt, one side is solid, edits are as good as new chains, errors name
// points.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

constexpr Material kSmooth{.friction = 0};

struct Sliding {
    std::string name;
    Geometry geometry;
    float below_m;  // from its origin down to its lowest point
};

const std::vector<Sliding>& slidings() {
    static const std::vector<Sliding> all{{"box", Box{0.5f, 0.25f}, 0.25f},
                                          {"small box", Box{0.04f, 0.04f}, 0.04f},
                                          {"circle", Circle{{}, 0.25f}, 0.25f},
                                          {"capsule", Capsule{{-0.4f, 0}, {0.4f, 0}, 0.2f}, 0.2f},
                                          {"rounded box", Box{0.3f, 0.2f, {}, 0, 0.05f}, 0.25f}};
    return all;
}

// Points from x = high to x = low, so that the free side is up.
template <class Height>
std::vector<Vec2> ground_points(float low, float high, int segments, Height&& height) {
    std::vector<Vec2> points;
    for (int i = 0; i <= segments; ++i) {
        const float x = high + (low - high) * static_cast<float>(i) / static_cast<float>(segments);
        points.push_back({x, height(x)});
    }
    return points;
}

ChainId add_chain(World& world, const std::vector<Vec2>& points, const Material& material = {},
                  bool closed = false, BodyType type = BodyType::Static) {
    const BodyId body = world.create_body({.type = type}).value();
    return world.create_chain(body, {.points_m = points, .closed = closed, .materials = {&material, 1}})
        .value();
}

// A regular polygon, clockwise: a room.
std::vector<Vec2> room_points(int count, float radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const Rotation q = Rotation::from_angle(-2.0 * static_cast<double>(kPi) * i / count);
        points.push_back(rotate(q, {radius, 0}));
    }
    return points;
}

template <class T>
std::string message_of(const Result<T>& result) {
    return result ? "no error" : result.error().message;
}

}  // namespace

TEST_CASE("nothing feels the joins of a flat chain, at any speed") {
    for (const Sliding& sliding : slidings()) {
        for (const float speed : {-2.0f, 5.0f, 20.0f, 60.0f}) {
            World world;
            add_chain(world, ground_points(-60, 60, 480, [](float) { return 0.0f; }), kSmooth);
            const BodyId body =
                add(world,
                    {.position_m = {speed > 0 ? -30.0 : 30.0, static_cast<double>(sliding.below_m)},
                     .linear_velocity_m_s = {speed, 0}},
                    sliding.geometry, {.material = kSmooth});
            float highest = 0;
            // 50 m at 25 cm a segment: 200 joins; the slow ones cross 100.
            const int steps = std::min(1'500, static_cast<int>(60 * 50 / std::fabs(speed)));
            for (int i = 0; i < steps; ++i) {
                world.step(kStep_s).value();
                highest = std::max(
                    highest, std::fabs(static_cast<float>(world.body(body)->position().y) - sliding.below_m));
            }
            INFO(sliding.name << " at " << speed << " m/s");
            CHECK(world.body(body)->linear_velocity().x == Approx(speed).epsilon(1e-5));
            CHECK(std::fabs(world.body(body)->angular_velocity()) < 1e-3f);
            CHECK(highest < 0.0005f);
        }
    }
}

TEST_CASE("what slides over a smooth hill of 100 joins has its speed again on the other side") {
    // A parabola that falls by 1 m in 10 m to each side; bodies start and end at the same height. Joins turn
    // by about 0.2 degrees.
    const auto hill = [](float x) { return -0.01f * x * x; };
    for (const Sliding& sliding : slidings()) {
        World world;
        add_chain(world, ground_points(-40, 40, 800, hill), kSmooth);
        const float start = -5;
        const float slope = 0.02f * 5;
        const Vec2 along = normalized(Vec2{1, slope});
        const Vec2 at = Vec2{start, hill(start)} + sliding.below_m * left_perp(along);
        const BodyId body = add(world,
                                {.position_m = {at.x, at.y},
                                 .angle_rad = std::atan(static_cast<double>(slope)),
                                 .linear_velocity_m_s = 4.0f * along,
                                 .angular_velocity_rad_s = sliding.name == "circle" ? 0.0f : -0.02f * 4},
                                sliding.geometry, {.material = kSmooth});
        while (world.body(body)->position().x < -static_cast<double>(at.x)) world.step(kStep_s).value();
        INFO(sliding.name);
        CHECK(length(world.body(body)->linear_velocity()) == Approx(4).epsilon(0.01));
    }
}

TEST_CASE("what slides through a smooth valley of 100 joins keeps the energy that its facets leave it") {
    // Each facet that turns by t takes the share 1 - cos(t)^2 of the energy of an inelastic thing: here 1e-5
    // of it a join.
    const auto valley = [](float x) { return 0.01f * x * x; };
    for (const Sliding& sliding : slidings()) {
        World world;
        add_chain(world, ground_points(-40, 40, 800, valley), kSmooth);
        const float start = -5;
        const float slope = -0.02f * 5;
        const Vec2 along = normalized(Vec2{1, slope});
        const Vec2 at = Vec2{start, valley(start)} + sliding.below_m * left_perp(along);
        const BodyId body = add(world,
                                {.position_m = {at.x, at.y},
                                 .angle_rad = std::atan(static_cast<double>(slope)),
                                 .linear_velocity_m_s = 4.0f * along,
                                 .angular_velocity_rad_s = sliding.name == "circle" ? 0.0f : 0.02f * 4},
                                sliding.geometry, {.material = kSmooth});
        while (world.body(body)->position().x < -static_cast<double>(at.x)) world.step(kStep_s).value();
        INFO(sliding.name);
        CHECK(length(world.body(body)->linear_velocity()) == Approx(4).epsilon(0.01));
    }
}

TEST_CASE("a disc that rolls along a chain rolls as on one long box") {
    const auto roll = [](bool chain) {
        World world;
        if (chain) {
            add_chain(world, ground_points(-50, 50, 300, [](float) { return 0.0f; }));
        } else {
            add_ground(world);
        }
        const BodyId disc = add(
            world, {.position_m = {-20, 0.25}, .linear_velocity_m_s = {8, 0}, .angular_velocity_rad_s = -32},
            Circle{{}, 0.25f});
        run_for(world, 4);
        return world.body(disc)->position();
    };
    CHECK(roll(true).x == Approx(roll(false).x).margin(0.002));
    CHECK(roll(true).x == Approx(12).margin(0.01));
    CHECK(roll(true).y == Approx(0.25).margin(0.0005));
}

TEST_CASE("a stack on a chain stands and sleeps, also over a join") {
    World world;
    add_chain(world, ground_points(-5, 5, 20, [](float) { return 0.0f; }));
    for (int i = 0; i < 10; ++i) {
        add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f});
        add(world, {.position_m = {2.2, 0.25 + 0.5 * i}}, Box{0.25f, 0.25f});
    }
    run_for(world, 5);
    CHECK(world.counts().awake_bodies == 0);
    for (const BodyId id : world.bodies()) CHECK(std::fabs(world.body(id)->angle()) < 0.001f);
}

TEST_CASE("a clockwise chain is a room that keeps things in, at 1000 m/s too") {
    Random random(1);
    for (int round = 0; round < 20; ++round) {
        World world({.gravity_m_s2 = {}, .enable_sleep = false});
        const Material elastic{.friction = 0, .restitution = 1};
        add_chain(world, room_points(3 + round, 6), elastic, true);
        const Rotation direction = Rotation::from_angle(random.real(-4, 4));
        const float speed = round % 2 == 0 ? 1000 : 50;
        const BodyId disc = add(world,
                                {.position_m = {random.real(-1, 1), random.real(-1, 1)},
                                 .linear_velocity_m_s = rotate(direction, {speed, 0})},
                                Circle{{}, random.real_f(0.05, 0.15)}, {.material = elastic});
        run_for(world, 1);
        const Position p = world.body(disc)->position();
        INFO("a room of " << 3 + round << " walls");
        REQUIRE(std::hypot(p.x, p.y) < 6);
    }
}

TEST_CASE("an anticlockwise chain is an island that keeps things out") {
    World world;
    std::vector<Vec2> points = room_points(24, 3);
    std::reverse(points.begin(), points.end());
    add_chain(world, points, {.friction = 1}, true);
    const BodyId on_top = add(world, {.position_m = {0, 4}}, Box{0.5f, 0.5f});
    const BodyId inside = add(world, {.position_m = {0, 0}}, Circle{{}, 0.2f});
    run_for(world, 1);
    CHECK(world.body(on_top)->position().y > 3);
    // From inside, the island's outline is seen from behind: it is no obstacle.
    CHECK(world.body(inside)->position().y < -3.5);
}

TEST_CASE("what comes from behind passes a chain without a change of its way") {
    for (const float speed : {2.0f, 20.0f, 500.0f}) {
        for (const Sliding& sliding : slidings()) {
            World world({.gravity_m_s2 = {}});
            add_chain(world, ground_points(-5, 5, 40, [](float) { return 0.0f; }));
            const BodyId body =
                add(world, {.position_m = {0.1, -2}, .linear_velocity_m_s = {0, speed}}, sliding.geometry);
            const int steps = 1 + static_cast<int>(60 * 2 / speed);
            step_times(world, steps);
            INFO(sliding.name << " at " << speed << " m/s");
            // Up to where its middle is at the chain it is behind; then it is in front, and pushed out.
            CHECK(world.body(body)->position().y >=
                  Approx(-2 + speed * kStep_s * static_cast<float>(steps)).epsilon(1e-4));
            CHECK(std::fabs(world.body(body)->linear_velocity().x) < 1e-3f);
        }
    }
}

TEST_CASE("each segment is a shape that knows its chain, in queries and events") {
    World world;
    const ChainId id = add_chain(world, ground_points(-5, 5, 10, [](float) { return 0.0f; }));
    const Chain chain = world.chain(id).value();
    REQUIRE(chain.segment_count() == 10);
    CHECK(chain.points().size() == 11);
    CHECK(world.body(chain.body())->shapes().size() == 10);
    const auto hit = world.cast_ray({2.5, 3}, {0, -5}).value();
    REQUIRE(hit);
    CHECK(hit->normal == Vec2{0, 1});
    CHECK(world.shape(hit->shape)->chain() == id);
    CHECK(chain.index_of(hit->shape) == 2);
    CHECK(chain.segment(2).value() == hit->shape);
    CHECK_FALSE(world.cast_ray({2.5, -3}, {0, 5}).value());

    const BodyId ball = add(world, {.position_m = {-2.5, 0.3}}, Circle{{}, 0.25f}, {.contact_events = true});
    int begun = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        for (const ContactBegin& begin : world.contact_begins()) {
            ++begun;
            CHECK(chain.index_of(begin.shape_a) == 7);
        }
    }
    CHECK(begun == 1);
    CHECK_FALSE(world.body(ball)->is_awake());
    CHECK(world.shape(world.body(ball)->shapes()[0])->chain() == ChainId{});

    CHECK_THAT(message_of(world.destroy_shape(hit->shape)), Contains("segment of a chain"));
    world.destroy_chain(id).value();
    CHECK_FALSE(world.contains(id));
    CHECK_FALSE(world.contains(hit->shape));
    CHECK_THAT(message_of(world.chain(id)), Contains("the chain has been destroyed"));
    CHECK(world.body(ball)->is_awake());
    run_for(world, 1);
    CHECK(world.body(ball)->position().y < -2);
}

TEST_CASE("a chain goes with its body, and moves with it") {
    World world({.gravity_m_s2 = {0, -10}});
    const BodyId lift =
        world.create_body({.type = BodyType::Kinematic, .linear_velocity_m_s = {0, 1}}).value();
    const std::vector<Vec2> points = ground_points(-3, 3, 12, [](float) { return 0.0f; });
    const ChainId chain = world.create_chain(lift, {.points_m = points}).value();
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    run_for(world, 2);
    CHECK(world.body(box)->position().y == Approx(2.5).margin(0.01));
    world.destroy_body(lift).value();
    CHECK_FALSE(world.contains(chain));
    CHECK(world.counts().shapes == 1);
}

TEST_CASE("segments have the material that they were given") {
    World world;
    const BodyId body = world.create_body({.type = BodyType::Static}).value();
    const std::vector<Vec2> points = ground_points(-4, 4, 2, [](float) { return 0.0f; });
    const std::vector<Material> materials{{.friction = 0}, {.friction = 1}};
    const ChainId id = world.create_chain(body, {.points_m = points, .materials = materials}).value();
    Chain chain = world.chain(id).value();
    CHECK(chain.material(0).friction == 0);
    CHECK(chain.material(1).friction == 1);
    // On ice to the right, on rubber to the left.
    const BodyId right = add(world, {.position_m = {2, 0.25}, .linear_velocity_m_s = {1, 0}},
                             Box{0.25f, 0.25f}, {.material = {.friction = 1}});
    const BodyId left = add(world, {.position_m = {-2, 0.25}, .linear_velocity_m_s = {-1, 0}},
                            Box{0.25f, 0.25f}, {.material = {.friction = 1}});
    run_for(world, 0.5);
    CHECK(world.body(right)->linear_velocity().x == Approx(1).epsilon(1e-3));
    CHECK(std::fabs(world.body(left)->linear_velocity().x) < 0.01f);
    chain.set_material(0, {.friction = 1}).value();
    run_for(world, 0.5);
    CHECK(std::fabs(world.body(right)->linear_velocity().x) < 0.01f);
}

TEST_CASE("a chain that was edited is the same as one made with the points that it has now") {
    Random random(2);
    for (const bool closed : {false, true}) {
        World world;
        const BodyId body = world.create_body({.type = BodyType::Static}).value();
        std::vector<Vec2> points;
        for (int i = 0; i < 6; ++i) points.push_back(random.vector(-5, 5));
        Chain chain = *world.chain(world.create_chain(body, {.points_m = points, .closed = closed}).value());
        for (int round = 0; round < 400; ++round) {
            const int count = static_cast<int>(points.size());
            switch (random.below(4)) {
                case 0: {
                    const int index = random.below(count);
                    points[static_cast<std::size_t>(index)] = random.vector(-5, 5);
                    chain.set_point(index, points[static_cast<std::size_t>(index)]).value();
                    break;
                }
                case 1: {
                    const int index = random.below(count + 1);
                    std::vector<Vec2> added;
                    for (int i = random.below(4); i > 0; --i) added.push_back(random.vector(-5, 5));
                    chain.insert_points(index, added).value();
                    points.insert(points.begin() + index, added.begin(), added.end());
                    break;
                }
                case 2: {
                    const int first = random.below(count);
                    const int removed = std::min(random.below(4), count - first);
                    if (count - removed < 3) break;
                    chain.remove_points(first, removed).value();
                    points.erase(points.begin() + first, points.begin() + first + removed);
                    break;
                }
                default:
                    if (!closed && random.chance(0.2)) {
                        chain.set_ends(random.vector(6, 7), {}).value();
                        chain.set_ends({}, {}).value();
                    }
                    world.step(kStep_s).value();
            }
            INFO((closed ? "closed, " : "open, ") << "round " << round);
            REQUIRE(std::equal(points.begin(), points.end(), chain.points().begin(), chain.points().end()));
            const ChainId fresh = world.create_chain(body, {.points_m = points, .closed = closed}).value();
            const Chain same = world.chain(fresh).value();
            REQUIRE(same.segment_count() == chain.segment_count());
            for (int i = 0; i < same.segment_count(); ++i) {
                const ShapeId edited_id = chain.segment(i).value();
                const Outline& edited = world.shape(edited_id)->outline();
                const Outline& made = world.shape(same.segment(i).value())->outline();
                REQUIRE(edited.points_m == made.points_m);
                // And the broad phase finds it where it is.
                const Vec2 middle = 0.5f * (made.points_m[0] + made.points_m[1]);
                const Vec2 front = normalized(right_perp(made.points_m[1] - made.points_m[0]));
                const Vec2 from = middle + 0.001f * front;
                const auto hit = world.cast_ray({from.x, from.y}, -0.002f * front).value();
                REQUIRE(hit);
            }
            world.destroy_chain(fresh).value();
            REQUIRE(world.counts().shapes == chain.segment_count());
        }
    }
}

TEST_CASE("an edit wakes what rests on the chain, and the new form holds in the same step") {
    World world;
    const ChainId id = add_chain(world, ground_points(-5, 5, 10, [](float) { return 0.0f; }));
    const BodyId box = add(world, {.position_m = {0.5, 0.25}}, Box{0.25f, 0.25f});
    const BodyId far = add(world, {.position_m = {-4.5, 0.25}}, Box{0.25f, 0.25f});
    run_for(world, 2);
    REQUIRE(world.counts().awake_bodies == 0);
    Chain chain = world.chain(id).value();
    // Segment 4 leads from (1, 0) to (0, 0): its two ends rise by 10 cm, into the box.
    chain.set_point(4, {1, 0.1f}).value();
    chain.set_point(5, {0, 0.1f}).value();
    CHECK(world.body(box)->is_awake());
    CHECK_FALSE(world.body(far)->is_awake());
    run_for(world, 2);
    CHECK(world.body(box)->position().y == Approx(0.35).margin(0.001));
    // A trapdoor: the points under the box go far down.
    chain.set_point(4, {1, -5}).value();
    chain.set_point(5, {0, -5}).value();
    run_for(world, 0.5);
    CHECK(world.body(box)->position().y < -0.5);
    CHECK_FALSE(world.body(far)->is_awake());
}

TEST_CASE("a chain that goes on in another one is joined without a bump") {
    for (const Sliding& sliding : slidings()) {
        World world;
        const std::vector<Vec2> right{{20, 0}, {10, 0}, {0, 0}};
        const std::vector<Vec2> left{{0, 0}, {-10, 0}, {-20, 0}};
        const BodyId body = world.create_body({.type = BodyType::Static}).value();
        const Material smooth = kSmooth;
        world.create_chain(body, {.points_m = right, .after_m = left[1], .materials = {&smooth, 1}}).value();
        world.create_chain(body, {.points_m = left, .before_m = right[1], .materials = {&smooth, 1}}).value();
        const BodyId slider = add(
            world, {.position_m = {-8, static_cast<double>(sliding.below_m)}, .linear_velocity_m_s = {8, 0}},
            sliding.geometry, {.material = kSmooth});
        run_for(world, 2);
        INFO(sliding.name);
        CHECK(world.body(slider)->linear_velocity().x == Approx(8).epsilon(1e-5));
        CHECK(world.body(slider)->position().y == Approx(sliding.below_m).margin(0.0005));
    }
}

TEST_CASE("100,000 points make a chain, hold things, and go again") {
    World world;
    const int count = 100'000;
    const ChainId id =
        add_chain(world, ground_points(-10'000, 10'000, count - 1, [](float) { return 0.0f; }));
    std::vector<BodyId> boxes;
    for (int i = -50; i < 50; ++i)
        boxes.push_back(add(world, {.position_m = {190.0 * i, 0.3}}, Box{0.25f, 0.25f}));
    run_for(world, 1);
    for (const BodyId box : boxes) CHECK(world.body(box)->position().y == Approx(0.25).margin(0.005));
    Chain chain = world.chain(id).value();
    chain.remove_points(10, count - 20).value();
    CHECK(world.counts().shapes == 100 + 19);
    world.destroy_chain(id).value();
    CHECK(world.counts().shapes == 100);
    run_for(world, 0.5);
    for (const BodyId box : boxes) CHECK(world.body(box)->position().y < -0.5);
}

TEST_CASE("bad chains and bad edits are refused, with the point by its index") {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    World world;
    const BodyId body = world.create_body({.type = BodyType::Static}).value();
    const auto error = [&](std::vector<Vec2> points, bool closed = false) {
        return message_of(world.create_chain(body, {.points_m = points, .closed = closed}));
    };
    CHECK_THAT(error({}), Contains("chain.points_m has 0 points") && Contains("at least 2"));
    CHECK_THAT(error({{0, 0}}), Contains("chain.points_m has 1 points"));
    CHECK_THAT(error({{0, 0}, {1, 0}}, true), Contains("at least 3 to be closed"));
    CHECK_THAT(error({{0, 0}, {1, 0}, {1, kNaN}}), Contains("chain.points_m[2] is (1, nan)"));
    CHECK_THAT(error({{0, 0}, {2e6f, 0}}), Contains("chain.points_m[1] is 2e+06") && Contains("within 1e6"));
    CHECK_THAT(
        error({{0, 0}, {1, 0}, {1, 0.004f}}),
        Contains("from chain.points_m[1] to chain.points_m[2] is 0.004") && Contains("at least 0.005"));
    CHECK_THAT(error({{0, 0}, {1, 0}, {0, 0.001f}}, true),
               Contains("from chain.points_m[2] to chain.points_m[0] is 0.001"));
    CHECK_THAT(message_of(world.create_chain(BodyId{}, {})), Contains("the body handle is null"));

    const std::vector<Vec2> points{{3, 0}, {2, 0}, {1, 0}, {0, 0}};
    const std::vector<Material> two(2);
    CHECK_THAT(message_of(world.create_chain(body, {.points_m = points, .materials = two})),
               Contains("chain.materials has 2 entries") && Contains("or 3 (one for each segment)"));
    std::vector<Material> bad(3);
    bad[1].friction = -1;
    CHECK_THAT(message_of(world.create_chain(body, {.points_m = points, .materials = bad})),
               Contains("chain.materials[1]: material.friction is -1"));
    CHECK_THAT(message_of(world.create_chain(body, {.points_m = points, .before_m = Vec2{3, 0.001f}})),
               Contains("from chain.before_m to chain.points_m[0] is 0.001"));
    CHECK_THAT(
        message_of(world.create_chain(body, {.points_m = points, .closed = true, .after_m = Vec2{-1, 0}})),
        Contains("a closed chain has no ends"));
    CHECK(world.counts().shapes == 0);

    const ChainId id = world.create_chain(body, {.points_m = points}).value();
    Chain chain = world.chain(id).value();
    CHECK_THAT(message_of(chain.set_point(4, {0, 0})), Contains("the index of the point is 4"));
    CHECK_THAT(message_of(chain.set_point(-1, {0, 0})), Contains("is -1") && Contains("from 0 to 3"));
    CHECK_THAT(message_of(chain.set_point(1, {kNaN, 0})), Contains("chain.points_m[1] is (nan, 0)"));
    CHECK_THAT(message_of(chain.set_point(1, {1, 0.002f})),
               Contains("from chain.points_m[1] to chain.points_m[2] is 0.002"));
    const std::vector<Vec2> inserted{{2.5f, 1}, {2.5f, 1.001f}};
    CHECK_THAT(message_of(chain.insert_points(1, inserted)), Contains("from points_m[0] to points_m[1]"));
    CHECK_THAT(message_of(chain.insert_points(5, inserted)),
               Contains("the index of the first new point is 5"));
    CHECK_THAT(message_of(chain.remove_points(0, 3)), Contains("has 1 points, but must have at least 2"));
    CHECK_THAT(message_of(chain.remove_points(2, 3)), Contains("the count of points is 3"));
    CHECK_THAT(message_of(chain.segment(3)), Contains("the index of the segment is 3"));
    CHECK_THAT(message_of(chain.set_material(0, {.friction = kNaN})), Contains("material.friction is nan"));
    CHECK_THAT(message_of(chain.set_ends(Vec2{3, 0}, {})), Contains("chain.before_m"));
    CHECK(std::equal(points.begin(), points.end(), chain.points().begin(), chain.points().end()));
    World stranger;
    CHECK_THAT(message_of(stranger.chain(id)), Contains("the chain belongs to another world"));
}

}  // namespace cairn::physics
