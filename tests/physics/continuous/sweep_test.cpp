// Times of impact against small steps along the way.
#include "continuous/sweep.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kDuration_s = 0.25f;
constexpr float kGap_m = 0.00125f;

Sweep random_sweep(Random& random, const Convex& shape, Vec2 center, Vec2 velocity) {
    Sweep sweep;
    sweep.shape = &shape;
    sweep.center = center;
    sweep.rotation = Rotation::from_angle(random.real(-4, 4));
    sweep.local_center = shape.centroid;
    sweep.velocity = velocity;
    sweep.spin = random.real_f(-6, 6);
    return sweep;
}

double gap_at(const Sweep& a, const Sweep& b, float time_s) {
    return separation(rounded_hull(*a.shape), rounded_hull(*b.shape, relative_pose_at(a, b, time_s)))
        .distance;
}

// How far b begins beyond the end of a along an axis.
double gap_along(const Sweep& a, const Sweep& b, Vec2 axis) {
    const auto reach = [](const Sweep& sweep, Vec2 along) {
        double most = -1e9;
        for (int i = 0; i < sweep.shape->count(); ++i) {
            const Vec2 arm = rotate(sweep.rotation, sweep.shape->point(i) - sweep.local_center);
            most = std::max(most, static_cast<double>(dot(sweep.center + arm, along)));
        }
        return most + static_cast<double>(sweep.shape->radius());
    };
    return -reach(b, -axis) - reach(a, axis);
}

}  // namespace

TEST_CASE("shapes that meet on their way do so at the time of impact, and no sooner") {
    Random random(1);
    int met = 0;
    int passed = 0;
    for (int round = 0; round < 1'500; ++round) {
        const Convex shape_a = random_solid(random);
        const Convex shape_b = random_solid(random);
        const Sweep a = random_sweep(random, shape_a, random.vector(-1, 1), random.vector(-5, 5));
        const Sweep b = random_sweep(random, shape_b, {random.real_f(3, 6), random.real_f(-2, 2)},
                                     {random.real_f(-40, 0), random.real_f(-5, 5)});
        if (gap_at(a, b, 0) < 0.01) continue;
        // From any axis along which they are apart.
        AxisGap seen;
        if (round % 3 != 0) {
            const Distance start = distance_between(shape_a, shape_b, relative_pose_at(a, b, 0));
            const double lean = round % 3 == 1 ? 0 : random.real(-0.5, 0.5);
            const Vec2 axis = rotate(Rotation::from_angle(lean) * a.rotation, start.normal);
            seen = {axis, static_cast<float>(gap_along(a, b, axis))};
        }
        const std::optional<float> time = time_of_impact(a, b, kDuration_s, kGap_m, seen);
        INFO("round " << round << ", time " << (time ? *time : -1.0f));
        // 45 m/s over 0.25 s in 800 steps: 14 mm each, and more by rotation; contacts shorter than that
        // escape.
        const int steps = 800;
        for (int i = 0; i <= steps; ++i) {
            const float t = kDuration_s * static_cast<float>(i) / steps;
            if (time && t >= *time) break;
            // The search aims at half the gap, so as not to creep towards it.
            REQUIRE(gap_at(a, b, t) > 0.5 * static_cast<double>(kGap_m) - 1e-5);
        }
        if (time) {
            // Near enough to be a contact.
            REQUIRE(gap_at(a, b, *time) < 2 * static_cast<double>(kGap_m));
            ++met;
        } else {
            ++passed;
        }
    }
    CHECK(met > 300);
    CHECK(passed > 200);
}

TEST_CASE("a ball that flies at a wall meets it after the gap over its speed") {
    const Convex ball = make_convex(Circle{{}, 0.5f}).value();
    const Convex wall = make_convex(Box{0.05f, 5}).value();
    const Sweep a{&wall, {}, {}, {}, {}, 0};
    const Sweep b{&ball, {-3, 0}, {}, {}, {100, 0}, 0};
    const auto time = time_of_impact(a, b, 0.1f, kGap_m);
    REQUIRE(time);
    CHECK(static_cast<double>(*time) == Approx((3 - 0.5 - 0.05) / 100).margin(2e-5));
    CHECK_FALSE(time_of_impact(a, b, 0.02f, kGap_m));
}

}  // namespace cairn::physics
