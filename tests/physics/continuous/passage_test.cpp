// What is said to pass, against small steps along the way and against times of impact.
#include "continuous/passage.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include <cairn/physics/tuning.h>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kStep_s = 1.0f / 60;
constexpr float kGap_m = 0.00125f;
constexpr float kDepth_m = 2 * tuning::kLinearSlop_m;

Sweep sweep_of(const Convex& shape, Vec2 center, double angle, Vec2 velocity, float spin = 0) {
    return {&shape, center, Rotation::from_angle(angle), shape.centroid, velocity, spin};
}

double gap_at(const Sweep& a, const Sweep& b, float time_s) {
    return separation(rounded_hull(*a.shape), rounded_hull(*b.shape, relative_pose_at(a, b, time_s)))
        .distance;
}

}  // namespace

TEST_CASE("what keeps apart along an axis meets at no moment of the step") {
    Random random(1);
    int apart = 0;
    for (int round = 0; round < 3'000; ++round) {
        const Convex shape_a = random_solid(random);
        const Convex shape_b = random_solid(random);
        const Sweep a = sweep_of(shape_a, random.vector(-1, 1), random.real(-4, 4), random.vector(-20, 20));
        const Sweep b = sweep_of(shape_b, {random.real_f(1, 4), random.real_f(-2, 2)}, random.real(-4, 4),
                                 random.vector(-60, 60));
        const Distance start = distance_between(shape_a, shape_b, relative_pose_at(a, b, 0));
        if (start.distance <= kGap_m) continue;
        const AxisGap seen{rotate(a.rotation, start.normal), start.distance};
        const bool keeps = Passage(a, b, kStep_s).keeps_apart(seen, kGap_m);
        INFO("round " << round << ", said to keep apart: " << keeps);
        double least = start.distance;
        for (int i = 1; i <= 50; ++i)
            least = std::min(least, gap_at(a, b, kStep_s * static_cast<float>(i) / 50));
        if (keeps) REQUIRE(least > static_cast<double>(kGap_m) - 1e-5);
        // What moves away along the line of least distance is found.
        if (dot(b.velocity - a.velocity, seen.axis) >= 0) REQUIRE(keeps);
        apart += keeps ? 1 : 0;
    }
    REQUIRE(apart > 1'000);
}

TEST_CASE("what turns far in a step is not said to pass") {
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Sweep a = sweep_of(box, {}, 0, {});
    const AxisGap seen{{1, 0}, 2};
    const float fast = 0.3f / kStep_s;
    REQUIRE(Passage(a, sweep_of(box, {3, 0}, 0, {}), kStep_s).keeps_apart(seen, kGap_m));
    REQUIRE(Passage(a, sweep_of(box, {3, 0}, 0, {}), kStep_s).goes_along(kDepth_m));
    REQUIRE_FALSE(Passage(a, sweep_of(box, {3, 0}, 0, {}, fast), kStep_s).keeps_apart(seen, kGap_m));
    REQUIRE_FALSE(Passage(a, sweep_of(box, {3, 0}, 0, {}, fast), kStep_s).goes_along(kDepth_m));
}

TEST_CASE("what goes along a side of another ends no deeper than it may") {
    Random random(2);
    int along = 0;
    for (int round = 0; round < 4'000; ++round) {
        const Convex shape_a = random_solid(random);
        const Convex shape_b = random_solid(random);
        const Sweep a = sweep_of(shape_a, {}, random.real(-4, 4), {});
        const Sweep b = sweep_of(shape_b, random.vector(-2, 2), random.real(-4, 4), random.vector(-60, 60));
        if (gap_at(a, b, 0) <= 0 || !Passage(a, b, kStep_s).goes_along(kDepth_m)) continue;
        ++along;
        INFO("round " << round);
        for (int i = 1; i <= 50; ++i)
            REQUIRE(gap_at(a, b, kStep_s * static_cast<float>(i) / 50) >
                    -static_cast<double>(kDepth_m) - 1e-5);
    }
    REQUIRE(along > 1'000);
}

// The oracle is what would be made of the pair otherwise: the manifold at the time of impact.
TEST_CASE("what comes from beyond the end of a chain's segment is left to the neighbour as its manifold is") {
    Random random(3);
    int left = 0;
    int met = 0;
    for (int round = 0; round < 60'000; ++round) {
        const Vec2 before{-random.real_f(0.3f, 2), random.real_f(-0.5f, 0.5f)};
        const float length_m = random.real_f(0.3f, 2);
        const Vec2 after{length_m + random.real_f(0.3f, 2), random.real_f(-0.5f, 0.5f)};
        // From right to left: met from above.
        const Convex segment = make_chain_segment(after, {length_m, 0}, {0, 0}, before);
        const Convex shape = random_convex(random, kForms[static_cast<std::size_t>(random.below(4))]);
        const Sweep a = sweep_of(segment, segment.centroid, 0, {});
        const Sweep b = sweep_of(shape, {random.real_f(-1.5f, 0.2f), random.real_f(-0.2f, 0.8f)},
                                 random.real(-4, 4), {random.real_f(0, 80), random.real_f(-5, 5)});
        if (gap_at(a, b, 0) <= static_cast<double>(kGap_m)) continue;
        const std::optional<float> time = time_of_impact(a, b, kStep_s, kGap_m);
        const bool meets =
            time &&
            collide(segment, shape, relative_pose_at(a, b, *time), tuning::kSpeculativeDistance_m).count > 0;
        // What goes along a side goes as far from it as what is not met.
        const bool passes = Passage(a, b, kStep_s).goes_along(-kGap_m);
        INFO("round " << round << ", meets " << meets << ", at " << (time ? *time : -1));
        if (time && !meets && passes) ++left;
        if (meets) REQUIRE_FALSE(passes);
        met += meets ? 1 : 0;
    }
    REQUIRE(met > 1'000);
    REQUIRE(left > 1'000);
}

}  // namespace cairn::physics
