// Contacts of bodies that have not moved are not looked at again. The oracle is a world that is restored
// before each step, and so knows nothing of the step before: both must be in the same state, to the bit,
// whatever changes.
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

// Stacks of bricks on a chain, a box on a slope, one on a kinematic lift and one on another static body: all
// stand.
struct Yard {
    World world{WorldDef{.joint_solver = JointSolver::Direct, .enable_sleep = false, .threads = 2}};
    BodyId ground, ledge, lift, slope;
    ChainId chain;
    std::vector<BodyId> bricks;
    BodyId on_ledge, on_lift, on_slope;

    Yard() {
        ground = world.create_body({.type = BodyType::Static}).value();
        const std::array<Vec2, 4> points{Vec2{20, 0}, Vec2{5, 0}, Vec2{-5, 0}, Vec2{-20, 0}};
        chain = world.create_chain(ground, {.points_m = points}).value();
        for (int row = 0; row < 8; ++row) {
            for (int i = 0; i < 6; ++i)
                bricks.push_back(
                    add(world, {.position_m = {-3 + 1.1 * i, 0.25 + 0.5 * row}}, Box{0.5f, 0.25f}));
        }
        ledge = add(world, {.type = BodyType::Static, .position_m = {10, 3}}, Box{1, 1});
        on_ledge = add(world, {.position_m = {10, 4.5}}, Box{0.5f, 0.5f});
        lift = add(world, {.type = BodyType::Kinematic, .position_m = {15, 3}}, Box{2, 0.2f});
        on_lift = add(world, {.position_m = {15, 3.7}}, Box{0.5f, 0.5f});
        slope =
            add(world, {.type = BodyType::Static, .position_m = {-12, 5}, .angle_rad = 0.2}, Box{3, 0.2f});
        on_slope = add(world, {.position_m = {-12 - 0.7 * 0.19867, 5 + 0.7 * 0.98007}, .angle_rad = 0.2},
                       Box{0.5f, 0.5f});
    }

    [[nodiscard]] Shape shape_of(BodyId body) {
        return world.shape(world.body(body)->shapes().front()).value();
    }
};

struct Edit {
    std::string what;
    std::function<void(Yard&)> make;
};

const std::vector<Edit> kEdits{
    {"nothing", [](Yard&) {}},
    {"a static body goes up by a millimetre",
     [](Yard& y) {
         y.world.body(y.ledge)->set_transform({10, 3.001}, 0).value();
     }},
    {"a static square makes a quarter turn",
     [](Yard& y) {
         y.world.body(y.ledge)->set_transform({10, 3}, 1.5707963267948966).value();
     }},
    {"a static body goes from under a box",
     [](Yard& y) {
         y.world.body(y.ledge)->set_transform({10, 1}, 0).value();
     }},
    {"a box is put a tenth of a millimetre aside",
     [](Yard& y) {
         const Position at = y.world.body(y.bricks[3])->position();
         y.world.body(y.bricks[3])->set_transform({at.x + 1e-4, at.y}, 0).value();
     }},
    {"a lift starts",
     [](Yard& y) {
         y.world.body(y.lift)->set_linear_velocity({0, 0.5f}).value();
     }},
    {"a lift starts slowly",
     [](Yard& y) {
         y.world.body(y.lift)->set_linear_velocity({0, 1e-6f}).value();
     }},
    {"a brick weighs more", [](Yard& y) { y.shape_of(y.bricks[20]).set_density(5).value(); }},
    {"a brick has no weight", [](Yard& y) { y.world.body(y.bricks[45])->set_gravity_scale(0).value(); }},
    {"a brick is lifted by its weight",
     [](Yard& y) { y.world.body(y.bricks[45])->set_gravity_scale(-1).value(); }},
    {"gravity leans",
     [](Yard& y) {
         y.world.set_gravity({0.5f, -10}).value();
     }},
    {"gravity ends",
     [](Yard& y) {
         y.world.set_gravity({0, 0}).value();
     }},
    {"a slope becomes slippery", [](Yard& y) { y.shape_of(y.slope).set_material({.friction = 0}).value(); }},
    {"a ledge becomes a conveyor",
     [](Yard& y) { y.shape_of(y.ledge).set_material({.surface_speed_m_s = 1}).value(); }},
    {"a box lets things bounce",
     [](Yard& y) { y.shape_of(y.on_ledge).set_material({.restitution = 0.1f}).value(); }},
    {"a box meets nothing", [](Yard& y) { y.shape_of(y.on_lift).set_filter({.mask = 0}); }},
    {"a corner of the ground sinks",
     [](Yard& y) {
         y.world.chain(y.chain)->set_point(2, {-5, -0.5f}).value();
     }},
    {"a brick goes", [](Yard& y) { y.world.destroy_body(y.bricks[2]).value(); }},
    {"a brick is pushed",
     [](Yard& y) {
         y.world.body(y.bricks[30])->apply_impulse_to_center({1, 0}).value();
     }},
    {"a box is damped", [](Yard& y) { y.world.body(y.on_ledge)->set_linear_damping(100).value(); }},
    {"a step takes half the time", [](Yard& y) { step_times(y.world, 1, 0.5f * kStep_s); }},
    {"a tiny push",
     [](Yard& y) {
         y.world.body(y.on_ledge)->set_linear_velocity({1e-6f, 0}).value();
     }},
    {"a force that is held",
     [](Yard& y) {
         y.world.body(y.bricks[30])->apply_force_to_center({0.5f, 0}).value();
     }},
    {"a box turns far, but is not fast",
     [](Yard& y) { y.world.body(y.on_ledge)->set_angular_velocity(16).value(); }},
    {"a brick spins fast", [](Yard& y) { y.world.body(y.bricks[46])->set_angular_velocity(40).value(); }},
    {"a brick may not turn", [](Yard& y) { y.world.body(y.bricks[20])->set_locks({.rotation = true}); }},
    {"a brick is hung from another",
     [](Yard& y) {
         y.world
             .create_joint(
                 WeldJointDef{.body_a = y.bricks[39], .body_b = y.bricks[45], .collide_connected = true})
             .value();
     }},
    {"a disc with rolling resistance is put beside, and goes again",
     [](Yard& y) {
         const BodyId disc = add(y.world, {.position_m = {-12, 5.61}}, Circle{{}, 0.4f},
                                 {.material = {.rolling_resistance = 0.1f}});
         step_times(y.world, 3);
         y.world.destroy_body(disc).value();
     }},
    {"a heavy box falls from above",
     [](Yard& y) {
         add(y.world, {.position_m = {0, 8}}, Box{0.5f, 0.5f}, {.density_kg_m2 = 50});
     }},
};

}  // namespace

TEST_CASE("what was known of bodies that stand is not used beyond what changed") {
    for (const Edit& edit : kEdits) {
        INFO(edit.what);
        Yard yard;
        Yard forgetful;
        Snapshot state;
        for (int step = 0; step < 140; ++step) {
            INFO("step " << step);
            if (step == 90) {
                edit.make(yard);
                edit.make(forgetful);
            }
            forgetful.world.snapshot(state).value();
            forgetful.world.restore(state.bytes()).value();
            step_times(yard.world, 1);
            step_times(forgetful.world, 1);
            REQUIRE(yard.world.state_hash() == forgetful.world.state_hash());
        }
    }
}

}  // namespace cairn::physics
