// A warmed-up step allocates nothing.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/allocation_counter.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

long allocations_of_steps(World& world, int count) {
    const AllocationCounter counter;
    step_times(world, count);
    return counter.count();
}

// Everything back to where it was: the second run of the same motion meets the same needs.
struct Pose {
    BodyId body;
    Transform transform;
    Vec2 velocity;
    float spin;
};

std::vector<Pose> poses_of(World& world) {
    std::vector<Pose> poses;
    for (const BodyId id : world.bodies()) {
        const Body body = *world.body(id);
        poses.push_back({id, body.transform(), body.linear_velocity(), body.angular_velocity()});
    }
    return poses;
}

void restore(World& world, const std::vector<Pose>& poses) {
    for (const Pose& pose : poses) {
        Body body = *world.body(pose.body);
        if (body.type() == BodyType::Static) continue;
        const auto angle = static_cast<double>(pose.transform.q.angle_rad());
        body.set_transform(pose.transform.p, angle).value();
        body.set_linear_velocity(pose.velocity).value();
        body.set_angular_velocity(pose.spin).value();
    }
}

}  // namespace

TEST_CASE("the counter counts what is allocated while it lives, and nothing else") {
    // By its name: compilers may leave out what a new-expression asks for.
    void* const before = ::operator new(40);
    const AllocationCounter counter;
    CHECK(counter.count() == 0);
    void* const during = ::operator new(40);
    CHECK(counter.count() == 1);
    CHECK(before != during);
    ::operator delete(during);
    ::operator delete(before);
}

TEST_CASE("a standing pyramid steps without allocating") {
    World world({.enable_sleep = false});
    build_pyramid(world, 15);
    step_times(world, 120);
    CHECK(allocations_of_steps(world, 300) == 0);
}

TEST_CASE("balls that bounce step without allocating, events included") {
    World world({.enable_sleep = false});
    const ShapeDef elastic{.material = {.restitution = 1}, .contact_events = true, .hit_events = true};
    add_ground(world, elastic);
    std::vector<BodyId> balls;
    for (int i = 0; i < 60; ++i)
        balls.push_back(add(world, {.position_m = {1.0 * i - 30, 2}}, Circle{{}, 0.4f}, elastic));
    // First all at once: more contacts and events than that no later step can have. Then each in its own
    // time.
    run_for(world, 3);
    Random random(1);
    for (const BodyId ball : balls) {
        Body body = *world.body(ball);
        body.set_transform({body.position().x, random.real(1, 4)}, 0).value();
    }
    run_for(world, 2);
    int told = 0;
    {
        const AllocationCounter counter;
        for (int i = 0; i < 300; ++i) {
            world.step(kStep_s).value();
            told += static_cast<int>(world.contact_hits().size() + world.contact_begins().size() +
                                     world.contact_ends().size());
        }
        CHECK(counter.count() == 0);
    }
    CHECK(told > 300);
}

TEST_CASE("a pile, a chain and springs move without allocating once the worst has been seen") {
    using Build = void (*)(World&);
    const Build pile = [](World& world) { build_pile(world, 100, 2); };
    const Build chain = [](World& world) { build_chain(world, 20); };
    const Build springs = build_springs;
    for (const Build build : {pile, chain, springs}) {
        World world;
        build(world);
        const std::vector<Pose> start = poses_of(world);
        // All in one place, on the ground: more contacts than any motion has.
        for (const Pose& pose : start) {
            Body body = *world.body(pose.body);
            if (body.type() != BodyType::Static) body.set_transform({0, 0.3}, 0).value();
        }
        step_times(world, 3);
        // And all asleep at once.
        for (const BodyId id : world.bodies()) world.body(id)->set_awake(false);
        // And all shot at one place: more that will meet within a step.
        restore(world, start);
        for (const Pose& pose : start)
            world.body(pose.body)->set_linear_velocity(-5.0f * (pose.transform.p - Position{0, 3})).value();
        step_times(world, 30);
        for (int warm_up = 0; warm_up < 2; ++warm_up) {
            restore(world, start);
            step_times(world, 900);
        }
        restore(world, start);
        CHECK(allocations_of_steps(world, 900) == 0);
    }
}

TEST_CASE("falling asleep and waking allocate nothing after the first time") {
    World world;
    build_stack(world);
    const BodyId box = world.bodies().back();
    const auto cycle = [&] {
        step_times(world, 300);
        world.body(box)->apply_impulse_to_center({0.1f, 0}).value();
    };
    cycle();
    REQUIRE(world.counts().awake_bodies > 0);
    step_times(world, 300);
    REQUIRE(world.counts().awake_bodies == 0);
    const AllocationCounter counter;
    cycle();
    step_times(world, 300);
    CHECK(counter.count() == 0);
}

TEST_CASE("queries with one answer allocate nothing") {
    World world;
    build_pile(world, 100, 3);
    step_times(world, 60);
    const AllocationCounter counter;
    for (int i = 0; i < 100; ++i) {
        const double y = 0.1 * i;
        if (!world.cast_ray({-20, y}, {40, 0}) || !world.shape_at({0, y}) ||
            !world.cast_shape(Box{}, {{-20, y}, {}}, {40, 0}) || !world.closest_point({0, y}, 1)) {
            FAIL("a query failed");
        }
    }
    CHECK(counter.count() == 0);
}

}  // namespace cairn::physics
