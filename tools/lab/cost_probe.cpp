// cairn-cost-probe BODIES STEPS [EXTRA]: stacks of boxes with a disc on top, which use no optional feature,
// and two spare bodies far away with which EXTRA does something: nothing, joint, sensor, bullet or report.
// Prints one line of JSON. tools/lab/cost runs it under callgrind, which counts what happens within
// `cairn_cost_step`.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <cairn/physics/features.h>
#include <cairn/physics/mover.h>
#include <cairn/physics/prefabs/pendulum.h>
#include <cairn/physics/world.h>

#include "memory_meter.h"

// Highway measures a timer as it is loaded, by an instruction that valgrind refuses where the processor does
// not report it (rdtscp, as under some hypervisors). Nothing here asks for that timer, and this definition is
// found before the library's.
namespace hwy::platform {
std::uint64_t TimerResolution();
std::uint64_t TimerResolution() {
    return 1;
}
}  // namespace hwy::platform

// By this name it is known to callgrind.
extern "C" [[gnu::noinline]] void cairn_cost_step(cairn::physics::World& world) {
    world.step(1.0f / 60).value();
}

namespace {

using namespace cairn::physics;
using cairn::measure::allocations;
using cairn::measure::live_bytes;

constexpr int kStackHeight = 10;
constexpr int kStacksPerFloor = 100;
constexpr int kUncountedSteps = 5;  // the first finds every pair at once, the next ones settle the lists

enum class Extra { Nothing, Joint, Sensor, Bullet, Report };

void add_stacks(World& world, int bodies) {
    const BodyId ground = world.create_body({.type = BodyType::Static}).value();
    for (int i = 0; i < bodies; ++i) {
        const int stack = i / kStackHeight;
        const int level = i % kStackHeight;
        const int floor_m = 14 * (stack / kStacksPerFloor);
        const int place = stack % kStacksPerFloor;
        if (level == 0 && place == 0) {
            const Box slab{101, 1, {0, static_cast<float>(floor_m) - 1}};
            world.create_shape(ground, slab).value();
        }
        const BodyId body =
            world.create_body({.position_m = {2.0 * place - kStacksPerFloor + 1, floor_m + level + 0.5}})
                .value();
        const Geometry shape =
            level + 1 < kStackHeight ? Geometry(Box{0.5f, 0.5f}) : Geometry(Circle{{}, 0.5f});
        world.create_shape(body, shape).value();
    }
}

void add_spare(World& world, Extra extra) {
    BodyDef def{.position_m = {300, 5}, .gravity_scale = 0};
    const BodyId a = world.create_body(def).value();
    def.position_m.x += 3;
    if (extra == Extra::Bullet) def.linear_velocity_m_s = {0, 300};
    const BodyId b = world.create_body(def).value();
    for (const BodyId body : {a, b}) world.create_shape(body, Circle{{}, 0.5f}).value();
    if (extra == Extra::Joint)
        world.create_joint(RevoluteJointDef{.body_a = a, .body_b = b, .local_anchor_a_m = {3, 0}}).value();
    if (extra == Extra::Sensor) world.create_shape(a, Circle{{}, 1}, {.sensor = true}).value();
}

Extra extra_of(const std::string& text) {
    if (text == "joint") return Extra::Joint;
    if (text == "sensor") return Extra::Sensor;
    if (text == "bullet") return Extra::Bullet;
    if (text == "report") return Extra::Report;
    return Extra::Nothing;
}

/// What the world says to the use of a feature: nothing when it has it.
std::string answer_to(Feature feature) {
    World world;
    const BodyId a = world.create_body({}).value();
    const BodyId b = world.create_body({}).value();
    const auto message = [](const auto& result) { return result ? std::string() : result.error().message; };
    switch (feature) {
        case Feature::Joints:
            return message(world.create_joint(RevoluteJointDef{.body_a = a, .body_b = b}));
        case Feature::DirectSolver:
            return message(World::create({.joint_solver = JointSolver::Direct}));
        case Feature::Sensors:
            return message(world.create_shape(a, Circle{}, {.sensor = true}));
        case Feature::Chains: {
            const Vec2 points_m[] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
            return message(world.create_chain(a, {.points_m = points_m}));
        }
        case Feature::Events:
            return message(world.create_shape(a, Circle{}, {.contact_events = true}));
        case Feature::Fracture:
            world.create_shape(a, Box{1, 1}).value();
            return message(world.cut_body(a, {0, -3}, {0, 3}));
        case Feature::Restitution:
            return message(world.create_shape(a, Circle{}, {.material = {.restitution = 0.5f}}));
        case Feature::RollingResistance:
            return message(world.create_shape(a, Circle{}, {.material = {.rolling_resistance = 0.1f}}));
        case Feature::SurfaceSpeed:
            return message(world.create_shape(a, Circle{}, {.material = {.surface_speed_m_s = 1}}));
        case Feature::Effects:
            return message(world.explode({.radius_m = 1, .impulse_ns_m = 1}));
        case Feature::Mover:
            return message(Mover::create({}, {}));
        case Feature::Snapshots:
            return message(world.snapshot());
        case Feature::Prefabs:
            return message(create_pendulum(world, {}));
    }
    return {};
}

void print_refusals() {
    std::string text;
    for (const Feature feature : kFeatures) {
        text += text.empty() ? "{" : ",";
        text += "\"" + std::string(name(feature)) + "\":\"" + answer_to(feature) + "\"";
    }
    std::puts((text + "}").c_str());
}

std::int64_t bytes_of_empty_world() {
    const std::int64_t before = live_bytes();
    const World world;
    return live_bytes() - before;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "refusals") {
        print_refusals();
        return 0;
    }
    if (argc < 3) {
        std::fputs(
            "cairn-cost-probe: error: give BODIES, STEPS, and nothing, joint, sensor, bullet or report\n",
            stderr);
        return 1;
    }
    const int bodies = std::atoi(argv[1]);
    const int steps = std::atoi(argv[2]);
    const Extra extra = extra_of(argc > 3 ? argv[3] : "nothing");
    const std::int64_t empty = bytes_of_empty_world();
    const std::int64_t before = live_bytes();
    World world({.enable_sleep = false});
    add_stacks(world, bodies);
    add_spare(world, extra);
    for (int i = 0; i < kUncountedSteps; ++i) world.step(1.0f / 60).value();
    const std::int64_t allocations_before = allocations();
    double asked_j = 0;  // or the compiler would leave the asking out
    for (int i = 0; i < steps; ++i) {
        cairn_cost_step(world);
        if (extra == Extra::Report) asked_j += world.report().kinetic_energy_j;
    }
    std::printf(
        "{\"bodies\":%d,\"hash\":\"%016llx\",\"empty_world_bytes\":%lld,\"world_bytes\":%lld,"
        "\"allocations\":%lld,\"asked_j\":%g}\n",
        world.counts().bodies, static_cast<unsigned long long>(world.state_hash()),
        static_cast<long long>(empty), static_cast<long long>(live_bytes() - before),
        static_cast<long long>(allocations() - allocations_before), asked_j);
    return 0;
}
