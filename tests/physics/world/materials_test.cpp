// Materials: mixing by rule, rolling resistance, running surfaces; against closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "physics/support/making.h"
#include "world/material_mixing.h"

namespace cairn::physics {
namespace {

using Catch::Matchers::Contains;
using namespace test;

// How far a box slides that starts with 5 m/s on ground: v^2 / (2 mu g), of which mu is told.
double measured_friction(World& world, const Material& ground, const Material& box) {
    add_ground(world, {.material = ground});
    const BodyId id = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.5f, 0.1f},
                          {.material = box});
    run_for(world, 10);
    REQUIRE(world.body(id)->linear_velocity() == Vec2{});
    // Euler brakes at the start of a substep: half a substep's way is lost.
    return 25 / (2 * 10 * (world.body(id)->position().x + 5.0 / 240 / 2));
}

double measured_friction(MixRule rule) {
    World world;
    world.set_material_rule(3, 7, {.friction = rule}).value();
    return measured_friction(world, {.friction = 0.2f, .kind = 3}, {.friction = 0.8f, .kind = 7});
}

}  // namespace

TEST_CASE("each way of mixing gives its formula's value") {
    const auto mixed = [](Mixing mixing) { return mix({mixing, 0.3f}, 0.2f, 0.8f); };
    CHECK(mixed(Mixing::GeometricMean) == Approx(0.4));
    CHECK(mixed(Mixing::Average) == Approx(0.5));
    CHECK(mixed(Mixing::Minimum) == 0.2f);
    CHECK(mixed(Mixing::Maximum) == 0.8f);
    CHECK(mixed(Mixing::Multiply) == Approx(0.16));
    CHECK(mixed(Mixing::Fixed) == 0.3f);
}

TEST_CASE("a box stops where the mixed friction of the two kinds says, in either order") {
    CHECK(measured_friction({Mixing::Average}) == Approx(0.5).epsilon(2e-3));
    CHECK(measured_friction({Mixing::Minimum}) == Approx(0.2).epsilon(2e-3));
    CHECK(measured_friction({Mixing::Maximum}) == Approx(0.8).epsilon(2e-3));
    CHECK(measured_friction({Mixing::Fixed, 0.6f}) == Approx(0.6).epsilon(2e-3));
    World swapped;
    swapped.set_material_rule(7, 3, {.friction = {Mixing::Average}}).value();
    CHECK(measured_friction(swapped, {.friction = 0.2f, .kind = 3}, {.friction = 0.8f, .kind = 7}) ==
          Approx(0.5).epsilon(2e-3));
    World other;  // a rule for other kinds changes nothing: sqrt(0.2 0.8) = 0.4
    other.set_material_rule(3, 3, {.friction = {Mixing::Fixed, 1}}).value();
    other.set_material_rule(7, 7, {.friction = {Mixing::Fixed, 1}}).value();
    other.set_material_rule(0, 3, {.friction = {Mixing::Fixed, 1}}).value();
    CHECK(measured_friction(other, {.friction = 0.2f, .kind = 3}, {.friction = 0.8f, .kind = 7}) ==
          Approx(0.4).epsilon(2e-3));
}

TEST_CASE("a fixed restitution for two kinds is what their impact gives back") {
    World world({.gravity_m_s2 = {}});
    world.set_material_rule(1, 2, {.restitution = {Mixing::Fixed, 0.75f}}).value();
    add_ground(world, {.material = {.restitution = 0, .kind = 1}});
    const BodyId ball = add(world, {.position_m = {0, 1}, .linear_velocity_m_s = {0, -8}}, Circle{},
                            {.material = {.restitution = 0.1f, .kind = 2}});
    run_for(world, 0.5);
    CHECK(world.body(ball)->linear_velocity().y == Approx(6).epsilon(1e-3));
}

TEST_CASE("a rule that changes remixes what touches, and wakes it") {
    World world;
    const double slope = std::atan(0.5);
    add(world, {.type = BodyType::Static, .angle_rad = slope}, Box{100, 1, {0, -1}},
        {.material = {.friction = 1, .kind = 5}});
    const BodyId box =
        add(world, {.position_m = {-0.1 * std::sin(slope), 0.1 * std::cos(slope)}, .angle_rad = slope},
            Box{0.5f, 0.1f}, {.material = {.friction = 1, .kind = 6}});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(box)->is_awake());
    SECTION("to less friction: it slides with g (sin - mu cos)") {
        world.set_material_rule(6, 5, {.friction = {Mixing::Fixed, 0.25f}}).value();
        CHECK(world.body(box)->is_awake());
        run_for(world, 1);
        const double speed = static_cast<double>(length(world.body(box)->linear_velocity()));
        CHECK(speed == Approx(10 * (std::sin(slope) - 0.25 * std::cos(slope))).epsilon(0.01));
    }
    SECTION("to the same: it sleeps on") {
        world.set_material_rule(6, 5, {.friction = {Mixing::Average}}).value();
        CHECK_FALSE(world.body(box)->is_awake());
    }
    SECTION("the material of a shape does the same") {
        world.shape(world.body(box)->shapes()[0])->set_material({.friction = 0, .kind = 6}).value();
        CHECK(world.body(box)->is_awake());
        run_for(world, 1);
        CHECK(static_cast<double>(length(world.body(box)->linear_velocity())) ==
              Approx(10 * std::sin(slope)).epsilon(0.01));
    }
}

TEST_CASE("rules are kept, and unset ones are the usual one") {
    World world;
    CHECK(world.material_rule(0, 0)->friction.mixing == Mixing::GeometricMean);
    CHECK(world.material_rule(63, 0)->restitution.mixing == Mixing::Maximum);
    world.set_material_rule(63, 2, {.friction = {Mixing::Fixed, 0.5f}, .restitution = {Mixing::Minimum}})
        .value();
    CHECK(world.material_rule(2, 63)->friction.fixed == 0.5f);
    CHECK(world.material_rule(2, 63)->restitution.mixing == Mixing::Minimum);
    CHECK(world.material_rule(2, 62)->restitution.mixing == Mixing::Maximum);
}

TEST_CASE("kinds and values out of range are refused by name") {
    World world;
    const auto message = [&](int a, int b, MaterialRule rule) {
        return world.set_material_rule(a, b, rule).error().message;
    };
    CHECK_THAT(message(-1, 0, {}), Contains("material_rule.kind_a is -1, but must be from 0 to 63"));
    CHECK_THAT(message(0, 64, {}), Contains("material_rule.kind_b is 64"));
    CHECK_THAT(message(0, 0, {.friction = {Mixing::Fixed, -1}}),
               Contains("material_rule.friction.fixed is -1"));
    CHECK_THAT(message(0, 0, {.friction = {Mixing::Fixed, std::nanf("")}}),
               Contains("material_rule.friction.fixed is nan"));
    CHECK_THAT(message(0, 0, {.restitution = {Mixing::Fixed, 1.5f}}),
               Contains("material_rule.restitution.fixed is 1.5"));
    CHECK_THAT(message(0, 0, {.friction = {static_cast<Mixing>(9)}}),
               Contains("material_rule.friction.mixing is 9"));
    CHECK_FALSE(world.material_rule(0, -3));
    CHECK(world.set_material_rule(63, 63, {}));
}

TEST_CASE("a rolling disc slows down by 2/3 of its resistance times g") {
    // The disc rolls: f friction at the rim, T = c r N the resistance. m a = -f, I a / r = f r - T, I = m r^2
    // / 2, N = m g; hence a = -c g / (1 + I / (m r^2)).
    for (const float resistance : {0.02f, 0.05f, 0.1f}) {
        for (const float radius : {0.25f, 1.0f}) {
            World world;
            add_ground(world);
            const BodyId disc = add(world,
                                    {.position_m = {-40, static_cast<double>(radius)},
                                     .linear_velocity_m_s = {6, 0},
                                     .angular_velocity_rad_s = -6 / radius},
                                    Circle{{}, radius}, {.material = {.rolling_resistance = resistance}});
            run_for(world, 0.1);
            const float before = world.body(disc)->linear_velocity().x;
            run_for(world, 1);
            const float after = world.body(disc)->linear_velocity().x;
            INFO("c = " << resistance << ", r = " << radius);
            CHECK(before - after == Approx(10 * resistance / 1.5f).epsilon(5e-3));
            CHECK(world.body(disc)->angular_velocity() * radius == Approx(-after).epsilon(5e-3));
        }
    }
}

TEST_CASE("a disc on a slope stays while the slope is less than its resistance, and rolls when it is more") {
    // It rolls when the torque of the weight about the line of contact, m g r sin, exceeds c r m g cos.
    for (const float resistance : {0.05f, 0.2f}) {
        for (const bool steeper : {false, true}) {
            World world({.enable_sleep = false});
            const double slope = std::atan(static_cast<double>(resistance) * (steeper ? 1.2 : 0.8));
            add(world, {.type = BodyType::Static, .angle_rad = slope}, Box{100, 1, {0, -1}});
            const BodyId disc =
                add(world, {.position_m = {-0.5 * std::sin(slope), 0.5 * std::cos(slope)}}, Circle{{}, 0.5f},
                    {.material = {.friction = 1, .rolling_resistance = resistance}});
            run_for(world, 5);
            const double way = std::hypot(world.body(disc)->position().x + 0.5 * std::sin(slope),
                                          world.body(disc)->position().y - 0.5 * std::cos(slope));
            INFO("c = " << resistance << ", steeper " << steeper << ", way " << way);
            if (steeper) {
                const double rate =
                    10 * (std::sin(slope) - static_cast<double>(resistance) * std::cos(slope)) / 1.5;
                CHECK(way == Approx(0.5 * rate * 25).epsilon(0.02));
            } else {
                CHECK(way < 1e-3);
            }
        }
    }
}

TEST_CASE("resistance to rolling holds for the wider rounding, and not for sharp corners") {
    World world;
    add_ground(world, {.material = {.friction = 0.5f, .rolling_resistance = 0.5f}});
    const BodyId box = add(world, {.position_m = {0, 0.1}, .linear_velocity_m_s = {5, 0}}, Box{0.5f, 0.1f},
                           {.material = {.friction = 0.5f}});
    run_for(world, 4);
    CHECK(world.body(box)->position().x ==
          Approx(25.0 / (2 * 0.5 * 10)).epsilon(0).margin(5.0 / 240 / 2 + 1e-4));
}

TEST_CASE("a conveyor carries a box to its speed over v^2 / (2 mu g), and no further") {
    for (const float speed : {2.0f, -3.0f}) {
        for (const float mu : {0.25f, 0.6f}) {
            World world;
            add_ground(world, {.material = {.friction = mu, .surface_speed_m_s = speed}});
            const BodyId box =
                add(world, {.position_m = {0, 0.1}}, Box{0.5f, 0.1f}, {.material = {.friction = mu}});
            const double v = std::fabs(static_cast<double>(speed));
            const double time = v / (static_cast<double>(mu) * 10);
            const int steps = static_cast<int>(std::ceil(time * 60)) + 2;
            step_times(world, steps);
            INFO("speed = " << speed << ", mu = " << mu);
            CHECK(world.body(box)->linear_velocity().x == Approx(speed).epsilon(1e-4));
            // The slipping is over: box and belt are v^2 / (2 mu g) apart and stay so.
            const auto behind = [&] {
                return std::fabs(v * static_cast<double>(world.step_count()) / 60 -
                                 std::fabs(world.body(box)->position().x));
            };
            CHECK(behind() ==
                  Approx(v * v / (2 * static_cast<double>(mu) * 10)).epsilon(0).margin(v / 240 + 1e-3));
            const double then = behind();
            run_for(world, 2);
            CHECK(behind() == Approx(then).epsilon(0).margin(1e-3));
            CHECK(world.body(box)->is_awake());
            CHECK(world.body(box)->position().y == Approx(0.1).margin(1e-3));
        }
    }
}

TEST_CASE(
    "a surface runs clockwise round its shape: a tracked body drives to the right, a ceiling to the left") {
    World world;
    add_ground(world);
    const BodyId tracked =
        add(world, {.position_m = {0, 0.25}}, Box{0.5f, 0.25f}, {.material = {.surface_speed_m_s = 2}});
    run_for(world, 2);
    CHECK(world.body(tracked)->linear_velocity().x == Approx(2).epsilon(1e-3));

    World upward({.gravity_m_s2 = {0, 10}});
    add(upward, {.type = BodyType::Static, .position_m = {0, 1}}, Box{100, 1},
        {.material = {.surface_speed_m_s = 2}});
    const BodyId hanging = add(upward, {.position_m = {0, -0.25}}, Box{0.5f, 0.25f});
    run_for(upward, 2);
    CHECK(upward.body(hanging)->linear_velocity().x == Approx(-2).epsilon(1e-3));
}

TEST_CASE("a belt that starts wakes what lies on it, and one that stops lets it come to rest") {
    World world;
    const BodyId ground = add_ground(world);
    const BodyId box = add(world, {.position_m = {0, 0.1}}, Box{0.5f, 0.1f});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(box)->is_awake());
    Shape belt = *world.shape(world.body(ground)->shapes()[0]);
    belt.set_material({.surface_speed_m_s = 1}).value();
    run_for(world, 1);
    CHECK(world.body(box)->linear_velocity().x == Approx(1).epsilon(1e-3));
    belt.set_material({}).value();
    run_for(world, 2);
    CHECK(world.body(box)->linear_velocity() == Vec2{});
    CHECK_FALSE(world.body(box)->is_awake());
}

}  // namespace cairn::physics
