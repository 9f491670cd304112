// Queries of each kind over 10,000 shapes that stand still. A step is 100 queries of each kind; those that
// answer with a list allocate it.
#include <chrono>

#include "random.h"
#include "scene.h"

namespace cairn::bench {

using measure::Random;

using physics::BodyType;
using physics::Box;
using physics::Capsule;
using physics::Circle;
using physics::Geometry;
using physics::Position;
using physics::Rotation;
using physics::Transform;
using physics::Vec2;
using physics::World;

namespace {

constexpr int kShapes = 10000;
constexpr double kHalfWidth_m = 250;  // half the shapes have a neighbour within 2 m
constexpr int kQueriesPerStep = 100;

Position random_point(Random& random) {
    return {random.real(-kHalfWidth_m, kHalfWidth_m), random.real(-kHalfWidth_m, kHalfWidth_m)};
}

Vec2 random_vector(Random& random, double most_m) {
    return {static_cast<float>(random.real(-most_m, most_m)),
            static_cast<float>(random.real(-most_m, most_m))};
}

// Each gives a number that depends on the answer.
std::uint64_t cast_ray(const World& world, Random& random) {
    const Position origin = random_point(random);
    const auto hit = world.cast_ray(origin, random_vector(random, 50)).value();
    return hit ? hit->shape.index1 : 0;
}

std::uint64_t find_shape_at(const World& world, Random& random) {
    const auto shape = world.shape_at(random_point(random)).value();
    return shape ? shape->index1 : 0;
}

// A disc of half a metre on its way.
std::uint64_t cast_circle(const World& world, Random& random) {
    const Transform start{random_point(random), {}};
    const auto hit = world.cast_shape(Circle{}, start, random_vector(random, 50)).value();
    return hit ? hit->shape.index1 : 0;
}

// The number of shapes in a box of 10 m.
std::uint64_t find_in_box(const World& world, Random& random) {
    const Position corner = random_point(random);
    return world.shapes_in_box(corner, corner + Vec2{10, 10}).value().size();
}

// The same for a slanting rectangle.
std::uint64_t find_overlapping(const World& world, Random& random) {
    const Transform pose{random_point(random), Rotation::from_angle(random.real(-3, 3))};
    return world.shapes_overlapping(Box{5, 5}, pose).value().size();
}

std::uint64_t find_closest_point(const World& world, Random& random) {
    const auto point = world.closest_point(random_point(random), 5).value();
    return point ? point->shape.index1 : 0;
}

struct Kind {
    const char* name;
    std::uint64_t (*ask)(const World& world, Random& random);
};
constexpr Kind kKinds[] = {{"cast_ray", cast_ray},
                           {"cast_shape", cast_circle},
                           {"shape_at", find_shape_at},
                           {"shapes_in_box", find_in_box},
                           {"shapes_overlapping", find_overlapping},
                           {"closest_point", find_closest_point}};

void ask_all(const World& world, int step, Findings& findings) {
    using Clock = std::chrono::steady_clock;
    findings.costs.resize(std::size(kKinds));
    for (std::size_t k = 0; k < std::size(kKinds); ++k) {
        Random random(static_cast<std::uint64_t>(step) * std::size(kKinds) + k);
        const Clock::time_point start = Clock::now();
        for (int i = 0; i < kQueriesPerStep; ++i) {
            findings.digest = findings.digest * 31 + kKinds[k].ask(world, random);
        }
        const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        // The mean over the steps so far.
        Findings::Cost& cost = findings.costs[k];
        cost.what = kKinds[k].name;
        cost.ns_each += (ns / kQueriesPerStep - cost.ns_each) / (step + 1);
    }
}

}  // namespace

Scene query_mix() {
    return {.name = "query_mix",
            .summary = "100 queries of each kind a step, over 10,000 shapes at rest",
            .world = {.gravity_m_s2 = {}},
            .steps = 500,
            .build = [](Engine& engine) -> BeforeStep {
                Random random(1);
                const Geometry kinds[] = {Circle{{}, 0.4f}, Capsule{{-0.3f, 0}, {0.3f, 0}, 0.2f},
                                          Box{0.4f, 0.3f}};
                for (int i = 0; i < kShapes; ++i) {
                    // Half are scenery, half are bodies that sleep.
                    const BodyType type = i % 2 == 0 ? BodyType::Static : BodyType::Dynamic;
                    const Position place = random_point(random);
                    engine.add(
                        {.type = type, .position_m = place, .angle_rad = random.real(-3, 3), .awake = false},
                        kinds[i % 3]);
                }
                return [](Engine& run, int step, Findings& findings) {
                    if (World* world = run.cairn_world()) ask_all(*world, step, findings);
                };
            }};
}

}  // namespace cairn::bench
