// What falls asleep, and what wakes it.
#include <catch2/catch.hpp>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

std::vector<BodyId> add_stack(World& world, int count, double x = 0) {
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i)
        boxes.push_back(add(world, {.position_m = {x, 0.5 + i}}, Box{0.5f, 0.5f}));
    return boxes;
}

int awake_of(World& world, const std::vector<BodyId>& ids) {
    int awake = 0;
    for (const BodyId id : ids) awake += world.body(id)->is_awake() ? 1 : 0;
    return awake;
}

// A stack of three on the ground, asleep.
struct SleepingStack {
    World world;
    BodyId ground = add_ground(world);
    std::vector<BodyId> boxes = add_stack(world, 3);

    SleepingStack() {
        run_for(world, 5);
        REQUIRE(world.counts().awake_bodies == 0);
    }
};

}  // namespace

TEST_CASE("a body at rest falls asleep after half a second, not before") {
    World world({.gravity_m_s2 = {}});
    const BodyId ball = add(world, {}, Circle{});
    step_times(world, 29);
    CHECK(world.body(ball)->is_awake());
    step_times(world, 2);
    CHECK_FALSE(world.body(ball)->is_awake());
}

TEST_CASE("what hangs asleep on a kinematic body wakes when that begins to move or to turn") {
    enum class Kind { Distance, Revolute, Weld };
    for (const Kind kind : {Kind::Distance, Kind::Revolute, Kind::Weld}) {
        for (const bool turns : {false, true}) {
            World world;
            const BodyId anchor =
                add(world, {.type = BodyType::Kinematic, .position_m = {0, 10}}, Circle{{}, 0.1f});
            const BodyId hanging = add(
                world, {.position_m = {0, 8}, .linear_damping_1_s = 5, .angular_damping_1_s = 5}, Circle{});
            const JointDef def =
                kind == Kind::Distance ? JointDef(DistanceJointDef{.body_a = anchor,
                                                                   .body_b = hanging,
                                                                   .local_anchor_a_m = {0.5f, 0},
                                                                   .local_anchor_b_m = {0.5f, 0},
                                                                   .length_m = 2})
                : kind == Kind::Revolute
                    ? JointDef(RevoluteJointDef{.body_a = anchor,
                                                .body_b = hanging,
                                                .local_anchor_a_m = {0.5f, -1},
                                                .local_anchor_b_m = {0.5f, 1}})
                    : JointDef(WeldJointDef{.body_a = anchor, .body_b = hanging, .local_anchor_b_m = {0, 2}});
            (void)world.create_joint(def).value();
            for (int i = 0; i < 3000 && world.body(hanging)->is_awake(); ++i) step_times(world, 1);
            REQUIRE_FALSE(world.body(hanging)->is_awake());
            CAPTURE(kind, turns);
            // What is set to what it is wakes nobody.
            world.body(anchor)->set_linear_velocity({}).value();
            step_times(world, 1);
            REQUIRE_FALSE(world.body(hanging)->is_awake());
            if (turns) {
                world.body(anchor)->set_angular_velocity(1).value();
            } else {
                world.body(anchor)->set_linear_velocity({1, 0}).value();
            }
            const Position before = world.body(hanging)->position();
            step_times(world, 1);
            CHECK(world.body(hanging)->is_awake());
            run_for(world, 1);
            CHECK(length(world.body(hanging)->position() - before) > 0.2f);
        }
    }
}

TEST_CASE("in a world of many awake bodies they fall asleep in every fourth step") {
    // As many balls as `many`, of which one more comes to rest in each of four steps.
    const auto steps_of_falling_asleep = [](int many) {
        World world({.gravity_m_s2 = {}});
        for (int i = 0; i < many; ++i)
            add(world, {.position_m = {3.0 * i, 10}, .linear_velocity_m_s = {0, 1}}, Circle{});
        std::vector<BodyId> balls;
        std::vector<int> steps(4, 0);
        for (int step = 0; step < 60; ++step) {
            if (balls.size() < steps.size())
                balls.push_back(add(world, {.position_m = {3.0 * step, 0}}, Circle{}));
            step_times(world, 1);
            for (std::size_t i = 0; i < balls.size(); ++i)
                if (steps[i] == 0 && !world.body(balls[i])->is_awake()) steps[i] = step;
        }
        return steps;
    };
    const std::vector<int> few = steps_of_falling_asleep(1000);
    const std::vector<int> many = steps_of_falling_asleep(1100);
    for (std::size_t i = 0; i < few.size(); ++i) {
        CAPTURE(i, few[i], many[i]);
        CHECK(few[i] == few[0] + int(i));
        CHECK(many[i] % 4 == 0);
        CHECK(many[i] >= few[i]);
        CHECK(many[i] < few[i] + 4);
    }
}

TEST_CASE("what falls on a sleeper wakes it in the step in which it reaches it, however fast") {
    // From drops that are seen by the margins of boxes, by boxes that cover a way, and as fast bodies.
    for (const double drop_m : {0.02, 0.3, 1.0, 3.0, 9.0, 30.0}) {
        World world;
        add_ground(world);
        const BodyId sleeper = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
        run_for(world, 2);
        REQUIRE_FALSE(world.body(sleeper)->is_awake());
        const BodyId falling = add(world, {.position_m = {0, 1.5 + drop_m}}, Box{0.5f, 0.5f});
        INFO("dropped " << drop_m << " m");
        int touched_asleep = 0;
        bool touched = false;
        for (int i = 0; i < 300 && !touched; ++i) {
            step_times(world, 1);
            touched = world.body(falling)->position().y - world.body(sleeper)->position().y <= 1;
            if (touched && !world.body(sleeper)->is_awake()) ++touched_asleep;
            touched = touched || world.body(sleeper)->is_awake();
        }
        CHECK(touched);
        CHECK(touched_asleep == 0);
    }
}

TEST_CASE("what passes a sleeper without reaching it leaves it asleep") {
    World world({.gravity_m_s2 = {}});
    const BodyId sleeper = add(world, {}, Box{0.5f, 0.5f});
    run_for(world, 1);
    REQUIRE_FALSE(world.body(sleeper)->is_awake());
    // 5 cm beside it, at 6 m/s and at 60 m/s.
    for (const float speed_m_s : {6.0f, 60.0f}) {
        add(world, {.position_m = {-5, 1.05}, .linear_velocity_m_s = {speed_m_s, 0}}, Box{0.5f, 0.5f});
        run_for(world, 2);
        CHECK_FALSE(world.body(sleeper)->is_awake());
    }
}

TEST_CASE("a body stays awake while it is pushed out of an overlap, though it has no speed") {
    World world({.gravity_m_s2 = {}, .max_push_out_speed_m_s = 0.1f});
    add(world, {.type = BodyType::Static}, Box{0.5f, 0.5f});
    const BodyId pushed = add(world, {.position_m = {0.9, 0}}, Box{0.5f, 0.5f});
    run_for(world, 0.8);
    CHECK(world.body(pushed)->position().x < 0.99);  // on its way still
    CHECK(world.body(pushed)->is_awake());
    run_for(world, 2);
    CHECK(world.body(pushed)->position().x > 0.99);
    CHECK_FALSE(world.body(pushed)->is_awake());
}

TEST_CASE("a body that moves or turns faster than the sleep speed stays awake") {
    World world({.gravity_m_s2 = {}});
    const BodyId slow = add(world, {.position_m = {0, 0}, .linear_velocity_m_s = {0.04f, 0}}, Circle{});
    const BodyId fast = add(world, {.position_m = {0, 5}, .linear_velocity_m_s = {0.06f, 0}}, Circle{});
    // Its rim, 2 m from the centre, turns with 0.06 m/s.
    const BodyId turning =
        add(world, {.position_m = {0, 15}, .angular_velocity_rad_s = 0.03f}, Circle{{}, 2});
    run_for(world, 2);
    CHECK_FALSE(world.body(slow)->is_awake());
    CHECK(world.body(fast)->is_awake());
    CHECK(world.body(turning)->is_awake());
}

TEST_CASE("nothing falls asleep where sleep is off, or where a body may not sleep") {
    World sleepless({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId ball = add(sleepless, {}, Circle{});
    run_for(sleepless, 2);
    CHECK(sleepless.body(ball)->is_awake());

    World world;
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 3);
    world.body(boxes[2])->set_allow_sleep(false);
    CHECK_FALSE(world.body(boxes[2])->allows_sleep());
    run_for(world, 5);
    CHECK(awake_of(world, boxes) == 3);  // it keeps awake what it touches
    world.body(boxes[2])->set_allow_sleep(true);
    run_for(world, 2);
    CHECK(awake_of(world, boxes) == 0);
}

TEST_CASE("a sleeping stack does not move") {
    SleepingStack stack;
    const Transform top = stack.world.body(stack.boxes[2])->transform();
    step_times(stack.world, 600);
    CHECK(stack.world.body(stack.boxes[2])->transform() == top);
    CHECK(stack.world.body(stack.boxes[2])->linear_velocity() == Vec2{});
    CHECK(stack.world.counts().awake_bodies == 0);
}

TEST_CASE("a hit wakes the whole stack") {
    SleepingStack stack;
    add(stack.world, {.position_m = {-4, 2.5}, .linear_velocity_m_s = {10, 2}}, Circle{{}, 0.25f});
    int steps = 0;
    while (awake_of(stack.world, stack.boxes) == 0 && steps < 60) {
        stack.world.step(kStep_s).value();
        ++steps;
    }
    // 3.25 m at 10 m/s: about 20 steps.
    CHECK(steps >= 18);
    CHECK(steps <= 22);
    CHECK(awake_of(stack.world, stack.boxes) == 3);
}

TEST_CASE("what lies beside a hit stack sleeps on") {
    SleepingStack stack;
    const std::vector<BodyId> others = add_stack(stack.world, 3, 10);
    run_for(stack.world, 5);
    REQUIRE(stack.world.counts().awake_bodies == 0);
    stack.world.body(stack.boxes[1])->apply_impulse_to_center({1, 0}).value();
    CHECK(awake_of(stack.world, stack.boxes) == 3);
    CHECK(awake_of(stack.world, others) == 0);
}

TEST_CASE("removing what carries wakes what was carried, within the call") {
    SleepingStack stack;
    SECTION("the lowest box") {
        stack.world.destroy_body(stack.boxes[0]).value();
        CHECK(stack.world.body(stack.boxes[1])->is_awake());
        CHECK(stack.world.body(stack.boxes[2])->is_awake());
    }
    SECTION("the ground") {
        stack.world.destroy_body(stack.ground).value();
        CHECK(awake_of(stack.world, stack.boxes) == 3);
    }
    SECTION("the shape of the ground") {
        stack.world.destroy_shape(stack.world.body(stack.ground)->shapes()[0]).value();
        CHECK(awake_of(stack.world, stack.boxes) == 3);
    }
    SECTION("the filter that let the ground carry") {
        stack.world.shape(stack.world.body(stack.ground)->shapes()[0])->set_filter({.mask = 0});
        CHECK(awake_of(stack.world, stack.boxes) == 3);
    }
    SECTION("the place of the ground") {
        stack.world.body(stack.ground)->set_transform({0, -50}, 0).value();
        CHECK(awake_of(stack.world, stack.boxes) == 3);
    }
    const double before = stack.world.body(stack.boxes[2])->position().y;
    run_for(stack.world, 0.5);
    CHECK(stack.world.body(stack.boxes[2])->position().y < before - 0.5);
}

TEST_CASE("forces, impulses, velocities, teleports and gravity wake a body") {
    SleepingStack stack;
    Body box = *stack.world.body(stack.boxes[0]);
    SECTION("force") {
        box.apply_force_to_center({0, 1}).value();
    }
    SECTION("torque") {
        box.apply_torque(1).value();
    }
    SECTION("impulse") {
        box.apply_impulse_to_center({0, 1}).value();
    }
    SECTION("angular impulse") {
        box.apply_angular_impulse(1).value();
    }
    SECTION("linear velocity") {
        box.set_linear_velocity({0, 1}).value();
    }
    SECTION("angular velocity") {
        box.set_angular_velocity(1).value();
    }
    SECTION("teleport") {
        box.set_transform({0, 0.5}, 0).value();
    }
    SECTION("gravity scale") {
        box.set_gravity_scale(2).value();
    }
    SECTION("gravity") {
        stack.world.set_gravity({0, -5}).value();
    }
    SECTION("by hand") {
        box.set_awake(true);
    }
    CHECK(awake_of(stack.world, stack.boxes) == 3);
}

TEST_CASE("reading wakes nobody") {
    SleepingStack stack;
    const Body box = *stack.world.body(stack.boxes[1]);
    static_cast<void>(box.transform());
    static_cast<void>(box.velocity_at({0, 0}));
    static_cast<void>(box.shapes());
    static_cast<void>(stack.world.cast_ray({-5, 1}, {10, 0}));
    static_cast<void>(stack.world.shape_at({0, 1}));
    CHECK(stack.world.counts().awake_bodies == 0);
}

TEST_CASE("a platform that moves keeps awake what it carries, and what it carries moves with it") {
    World world;
    const BodyId lift =
        add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {0.02f, 0}}, Box{2, 0.25f});
    const BodyId box = add(world, {.position_m = {0, 0.75}}, Box{0.5f, 0.5f});
    run_for(world, 5);
    CHECK(world.body(box)->is_awake());
    CHECK(world.body(box)->position().x == Approx(0.1).margin(0.005));
    world.body(lift)->set_linear_velocity({}).value();
    run_for(world, 2);
    CHECK_FALSE(world.body(box)->is_awake());
    // Starting again, slowly, wakes what stands on it.
    world.body(lift)->set_linear_velocity({0, 0.02f}).value();
    run_for(world, 1);
    CHECK(world.body(box)->is_awake());
    CHECK(world.body(box)->position().y == Approx(0.77).margin(0.005));
}

TEST_CASE("what sleeps on a platform that never does wakes when that begins to move") {
    // Alone, and with as many others as are solved together.
    const int count = GENERATE(1, 8, 11);
    World world;
    std::vector<BodyId> lifts;
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i) {
        const double x = 5 * i;
        const BodyDef lift{.type = BodyType::Kinematic, .position_m = {x, 0}, .allow_sleep = false};
        lifts.push_back(add(world, lift, Box{2, 0.25f}));
        boxes.push_back(add(world, {.position_m = {x, 0.75}}, Box{0.5f, 0.5f}));
    }
    run_for(world, 2);
    REQUIRE(awake_of(world, boxes) == 0);
    REQUIRE(awake_of(world, lifts) == count);
    world.body(lifts.front())->set_linear_velocity({0, 1}).value();
    run_for(world, 1);
    CHECK(world.body(boxes.front())->position().y == Approx(1.75).margin(0.005));
    CHECK(awake_of(world, boxes) == 1);
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        CHECK(world.body(boxes[i])->position().y == Approx(0.75).margin(0.005));
    }
}

TEST_CASE("what is put to sleep on a moving platform wakes again, at every SIMD level alike") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    std::vector<std::uint64_t> hashes;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        World world;
        const BodyId turntable = add(world, {.type = BodyType::Kinematic}, Box{2, 0.25f});
        const BodyId box = add(world, {.position_m = {1, 0.75}}, Box{0.5f, 0.5f});
        const BodyId other = add(world, {.position_m = {-1, 0.75}}, Box{0.5f, 0.5f});
        step_times(world, 20);
        world.body(turntable)->set_angular_velocity(0.5f).value();
        step_times(world, 20);
        world.body(box)->set_awake(false);
        CHECK_FALSE(world.body(box)->is_awake());
        step_times(world, 20);
        CHECK(awake_of(world, {box, other}) == 2);
        CHECK(world.body(box)->angle() == Approx(20.0 / 60).margin(0.02));
        CHECK(world.body(other)->angle() == Approx(20.0 / 60).margin(0.02));
        hashes.push_back(world.state_hash());
    }
    force_simd_level(levels.back()).value();
    CHECK(hashes == std::vector<std::uint64_t>(levels.size(), hashes.front()));
}

TEST_CASE("what hangs on a moving platform by a joint cannot be put to sleep") {
    World world;
    const BodyId platform =
        add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {1, 0}}, Box{2, 0.25f});
    const BodyId held = add(world, {.position_m = {0, -2}}, Box{0.5f, 0.5f});
    world.create_joint(DistanceJointDef{.body_a = platform, .body_b = held, .length_m = 2}).value();
    step_times(world, 20);
    world.body(held)->set_awake(false);
    CHECK(world.body(held)->is_awake());
    world.body(platform)->set_linear_velocity({}).value();
    world.body(held)->set_awake(false);
    CHECK_FALSE(world.body(held)->is_awake());
    // A joint that only keeps from colliding holds nothing.
    const BodyId beside = add(world, {.position_m = {5, -2}}, Box{0.5f, 0.5f});
    world.create_joint(FilterJointDef{.body_a = platform, .body_b = beside}).value();
    world.body(platform)->set_linear_velocity({1, 0}).value();
    world.body(beside)->set_awake(false);
    CHECK_FALSE(world.body(beside)->is_awake());
}

TEST_CASE("a platform that runs into sleepers wakes and pushes them") {
    SleepingStack stack;
    add(stack.world, {.type = BodyType::Kinematic, .position_m = {-3, 0.5}, .linear_velocity_m_s = {2, 0}},
        Box{0.5f, 0.4f});
    run_for(stack.world, 0.9);
    CHECK(awake_of(stack.world, stack.boxes) == 0);
    run_for(stack.world, 1);
    CHECK(awake_of(stack.world, stack.boxes) == 3);
    CHECK(stack.world.body(stack.boxes[0])->position().x > 0.5);
}

TEST_CASE("a static body moved to where something sleeps wakes it") {
    World world;
    add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 0.5}}, Box{0.5f, 0.5f});
    const BodyId wall = add(world, {.type = BodyType::Static, .position_m = {20, 0.5}}, Box{0.5f, 0.5f});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(box)->is_awake());
    world.body(wall)->set_transform({-0.8, 0.5}, 0).value();
    CHECK(world.body(box)->is_awake());
    run_for(world, 2);
    CHECK(world.body(box)->position().x > 0.15);  // pushed out of the wall
}

TEST_CASE("putting one body to sleep puts all to sleep that touches it") {
    World world;
    add_ground(world);
    const std::vector<BodyId> boxes = add_stack(world, 3);
    const std::vector<BodyId> others = add_stack(world, 3, 10);
    step_times(world, 2);
    world.body(boxes[2])->set_awake(false);
    CHECK(awake_of(world, boxes) == 0);
    CHECK(awake_of(world, others) == 3);
    world.body(boxes[0])->set_awake(true);
    CHECK(awake_of(world, boxes) == 3);
}

TEST_CASE("bodies joined together sleep and wake together, though they do not touch") {
    World world({.gravity_m_s2 = {}});
    const BodyId a = add(world, {}, Circle{});
    const BodyId b = add(world, {.position_m = {3, 0}}, Circle{});
    const BodyId other = add(world, {.position_m = {6, 0}}, Circle{});
    const JointId rod = world.create_joint(DistanceJointDef{.body_a = a, .body_b = b, .length_m = 3}).value();
    run_for(world, 2);
    REQUIRE(world.counts().awake_bodies == 0);
    world.body(a)->set_awake(true);
    CHECK(awake_of(world, {a, b, other}) == 2);
    run_for(world, 2);
    SECTION("destroying the joint wakes both") {
        world.destroy_joint(rod).value();
    }
    SECTION("changing the joint wakes both") {
        world.joint(rod)->set_length(2).value();
    }
    CHECK(awake_of(world, {a, b, other}) == 2);
}

TEST_CASE("a body made asleep stays asleep in the air until something touches it") {
    World world;
    add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 5}, .awake = false}, Box{0.5f, 0.5f});
    run_for(world, 3);
    CHECK_FALSE(world.body(box)->is_awake());
    CHECK(world.body(box)->position() == Position{0, 5});
    add(world, {.position_m = {0, 6.1}}, Circle{});
    run_for(world, 1);
    CHECK(world.body(box)->position().y < 4.5);
}

TEST_CASE("a whole building made asleep stands untouched, and falls when hit") {
    World world;
    add_ground(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 5; ++i)
        boxes.push_back(add(world, {.position_m = {0, 0.5 + i}, .awake = false}, Box{0.5f, 0.5f}));
    const std::vector<Transform> before{world.body(boxes[0])->transform(), world.body(boxes[4])->transform()};
    run_for(world, 10);
    CHECK(world.counts().awake_bodies == 0);
    CHECK(world.body(boxes[0])->transform() == before[0]);
    CHECK(world.body(boxes[4])->transform() == before[1]);
    add(world, {.position_m = {-5, 4.5}, .linear_velocity_m_s = {20, 2}}, Circle{}, {.density_kg_m2 = 5});
    run_for(world, 3);
    CHECK(world.body(boxes[4])->position().y < 4);
}

// Contacts with rolling resistance, and of locked bodies on platforms, have no lanes.
TEST_CASE("what hits a sleeper passes on its momentum, whether or not their contact has a lane") {
    for (const float rolling_resistance : {0.0f, 0.01f}) {
        for (const float speed : {0.5f, 1.2f, 10.0f}) {
            World world({.gravity_m_s2 = {}});
            const ShapeDef disc{.material = {.restitution = 1, .rolling_resistance = rolling_resistance}};
            const BodyId sleeper = add(world, {.awake = false}, Circle{{}, 0.5f}, disc);
            const BodyId bird = add(world, {.position_m = {-1.5, 0}, .linear_velocity_m_s = {speed, 0}},
                                    Circle{{}, 0.5f}, disc);
            REQUIRE_FALSE(world.body(sleeper)->is_awake());
            run_for(world, 4);
            INFO("rolling resistance " << rolling_resistance << ", " << speed << " m/s");
            const float v_sleeper = world.body(sleeper)->linear_velocity().x;
            const float v_bird = world.body(bird)->linear_velocity().x;
            CHECK(v_sleeper > 0.4f * speed);
            CHECK(v_sleeper + v_bird == Approx(speed).epsilon(1e-5));
        }
    }
}

TEST_CASE("a sleeper with a locked axis is pushed by its platform as one that is awake") {
    const auto lifted = [](bool sleeps) {
        World world;
        const BodyId platform =
            world.create_body({.type = BodyType::Kinematic, .allow_sleep = false}).value();
        world.create_shape(platform, Box{4, 0.5f, {0, -0.5f}}).value();
        const BodyId box = add(world, {.position_m = {0.3, 0.5}, .locks = {.x = true}, .allow_sleep = sleeps},
                               Box{0.5f, 0.5f});
        run_for(world, 3);
        REQUIRE(world.body(box)->is_awake() != sleeps);
        world.body(platform)->set_angular_velocity(2).value();
        step_times(world, 3);
        return world.body(box)->position().y;
    };
    CHECK(lifted(true) == Approx(lifted(false)).epsilon(1e-4));
}

TEST_CASE("a body sleeps when all of it is slower than its own speed of rest, and never at 0") {
    World world({.gravity_m_s2 = {}});
    const auto drift = [&](double y, float speed, float spin, float sleep_speed) {
        return add(world,
                   {.position_m = {0, y},
                    .linear_velocity_m_s = {speed, 0},
                    .angular_velocity_rad_s = spin,
                    .sleep_speed_m_s = sleep_speed},
                   Circle{{}, 0.5f});
    };
    const BodyId slower = drift(0, 0.19f, 0, 0.2f);
    const BodyId faster = drift(5, 0.21f, 0, 0.2f);
    const BodyId turning = drift(10, 0, 0.42f, 0.2f);  // its rim has 0.21 m/s
    const BodyId resting = drift(15, 0, 0, 0);
    const BodyId usual = drift(20, 0.04f, 0, BodyDef{}.sleep_speed_m_s);
    run_for(world, 0.4);
    CHECK(world.counts().awake_bodies == 5);
    run_for(world, 2);
    CHECK_FALSE(world.body(slower)->is_awake());
    CHECK(world.body(faster)->is_awake());
    CHECK(world.body(turning)->is_awake());
    CHECK(world.body(resting)->is_awake());
    CHECK_FALSE(world.body(usual)->is_awake());
    world.body(faster)->set_sleep_speed(0.3f).value();
    CHECK(world.body(faster)->sleep_speed() == 0.3f);
    run_for(world, 1);
    CHECK_FALSE(world.body(faster)->is_awake());
}

}  // namespace cairn::physics
