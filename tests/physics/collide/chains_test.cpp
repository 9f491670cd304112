// Segments of chains: against the solid that they enclose, and at the joins where nothing must be felt.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"
#include "collide/ray_cast.h"
#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kReach_m = tuning::kSpeculativeDistance_m;

std::vector<Convex> closed_chain(const std::vector<Vec2>& points) {
    std::vector<Convex> segments;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        segments.push_back(
            make_chain_segment(points[(i + n - 1) % n], points[i], points[(i + 1) % n], points[(i + 2) % n]));
    }
    return segments;
}

// Along y = 0, with the free side up: points run from right to left.
std::vector<Convex> flat_chain(int count, float length) {
    std::vector<Convex> segments;
    const auto at = [&](int i) { return Vec2{-length * static_cast<float>(i), 0}; };
    for (int i = 0; i < count; ++i)
        segments.push_back(make_chain_segment(at(i - 1), at(i), at(i + 1), at(i + 2)));
    return segments;
}

struct Touches {
    int manifolds = 0;
    int points = 0;
    float least = std::numeric_limits<float>::infinity();
    Vec2 normal;  // of the least
};

Touches touches(const std::vector<Convex>& chain, const Convex& shape, const RelativePose& pose) {
    Touches all;
    for (const Convex& segment : chain) {
        const Manifold m = collide(segment, shape, pose, kReach_m);
        all.manifolds += m.count > 0 ? 1 : 0;
        all.points += m.count;
        for (int i = 0; i < m.count; ++i) {
            if (m.points[i].separation < all.least) {
                all.least = m.points[i].separation;
                all.normal = m.normal;
            }
        }
    }
    return all;
}

RelativePose pose_at(const Convex& a, const Convex& b, double distance, double direction, double angle) {
    const Rotation q = Rotation::from_angle(angle);
    const Vec2 offset{static_cast<float>(distance * std::cos(direction)),
                      static_cast<float>(distance * std::sin(direction))};
    return {a.centroid + offset - rotate(q, b.centroid), q};
}

}  // namespace

TEST_CASE("a chain around a convex solid meets others at the solid's distance and with its normal") {
    Random random(1);
    for (const Form form : kForms) {
        for (int round = 0; round < 400; ++round) {
            const Convex solid = random_polygon(random, 0);
            const Convex other = random_convex(random, form);
            const std::vector<Vec2> corners(solid.outline.points_m.begin(),
                                            solid.outline.points_m.begin() + solid.count());
            const std::vector<Convex> chain = closed_chain(corners);
            const double direction = random.real(-4, 4);
            const double angle = random.real(-4, 4);
            const double target = random.real(0.001, 0.019);
            RelativePose pose;
            double near = 0;
            double far = 10;
            for (int i = 0; i < 60; ++i) {
                const double middle = (near + far) / 2;
                pose = pose_at(solid, other, middle, direction, angle);
                (separation(rounded_hull(solid), rounded_hull(other, pose)).distance > target ? far : near) =
                    middle;
            }
            pose = pose_at(solid, other, far, direction, angle);
            const Separation expected = separation(rounded_hull(solid), rounded_hull(other, pose));
            const Touches found = touches(chain, other, pose);
            INFO("form " << static_cast<int>(form) << ", round " << round << ", distance "
                         << expected.distance);
            const double core_distance = expected.distance + static_cast<double>(other.radius());
            REQUIRE(found.manifolds > 0);
            REQUIRE(static_cast<double>(found.least) ==
                    Approx(expected.distance).margin(2e-6 + 5e-5 * core_distance).epsilon(0));
            REQUIRE(dot(to_point(found.normal), expected.normal) > 1 - 2e-4);
            // And from the other side of the pair.
            Touches swapped;
            const RelativePose back{-inverse_rotate(pose.q, pose.p), inverse(pose.q)};
            for (const Convex& segment : chain)
                swapped.points += collide(other, segment, back, kReach_m).count;
            REQUIRE(swapped.points == found.points);
        }
    }
}

TEST_CASE("on a flat chain every normal is the chain's, wherever a shape stands and however deep") {
    const std::vector<Convex> chain = flat_chain(40, 0.25f);
    Random random(2);
    for (const Form form : kForms) {
        for (int round = 0; round < 2'000; ++round) {
            const Convex shape = random_convex(random, form);
            const Rotation q = Rotation::from_angle(random.chance(0.3) ? 0 : random.real(-4, 4));
            float lowest = std::numeric_limits<float>::infinity();
            for (int i = 0; i < shape.count(); ++i)
                lowest = std::min(lowest, rotate(q, shape.point(i)).y - shape.radius());
            const float depth = random.real_f(-0.019, 0.02);
            const RelativePose pose{{random.real_f(-7, -3), -lowest - depth}, q};
            INFO("form " << static_cast<int>(form) << ", round " << round << ", depth " << depth);
            const Touches found = touches(chain, shape, pose);
            REQUIRE(found.manifolds > 0);
            REQUIRE(found.least == Approx(-depth).margin(2e-6));
            for (const Convex& segment : chain) {
                const Manifold m = collide(segment, shape, pose, kReach_m);
                if (m.count > 0) REQUIRE(dot(m.normal, {0, 1}) > 1 - 1e-6f);
            }
        }
    }
}

TEST_CASE("no circle falls between two segments, and a corner that juts out has one owner") {
    Random random(3);
    for (int round = 0; round < 20'000; ++round) {
        // A corner at the origin that turns by up to 170 degrees either way; the free side is above.
        const double turn = random.real(-2.9, 2.9);
        const Vec2 before = rotate(Rotation::from_angle(0), {1, 0});
        const Vec2 after = rotate(Rotation::from_angle(turn), {-1, 0});
        const std::vector<Convex> chain{make_chain_segment(std::nullopt, before, {0, 0}, after),
                                        make_chain_segment(before, {0, 0}, after, std::nullopt)};
        const bool juts_out = turn > 0.001;
        if (std::fabs(turn) < 0.002) continue;
        const Convex disc = make_convex(Circle{{}, 0.2f}).value();
        // A centre over the corner: between the two normals.
        const double share = random.real(0.02, 0.98);
        const Vec2 direction = rotate(Rotation::from_angle(share * turn), {0, 1});
        const RelativePose pose{0.19f * direction, {}};
        const Touches found = touches(chain, disc, pose);
        INFO("a turn of " << turn << ", share " << share);
        if (juts_out) {
            REQUIRE(found.manifolds == 1);
            REQUIRE(found.least == Approx(-0.01).margin(1e-6));
            REQUIRE(dot(found.normal, direction) > 1 - 1e-5f);
        } else if (dot(chain[0].normals[0], direction) > 0.2f && dot(chain[1].normals[0], direction) > 0.2f) {
            REQUIRE(found.manifolds == 2);
        }
    }
    // Exactly over joins of a flat chain, and by one unit in the last place beside.
    const std::vector<Convex> chain = flat_chain(400, 0.1f);
    const Convex disc = make_convex(Circle{{}, 0.2f}).value();
    for (int i = 5; i < 395; ++i) {
        const float join = chain[static_cast<std::size_t>(i)].point(0).x;
        for (const float x : {join, std::nextafter(join, 0.0f), std::nextafter(join, -100.0f)}) {
            const Touches found = touches(chain, disc, {{x, 0.199f}, {}});
            REQUIRE(found.manifolds >= 1);
            REQUIRE(found.normal.y > 1 - 1e-6f);
        }
    }
}

TEST_CASE("what is behind a chain, or has sunk through it by more than half, is not met") {
    const std::vector<Convex> chain = flat_chain(10, 0.5f);
    Random random(4);
    for (const Form form : kForms) {
        for (int round = 0; round < 500; ++round) {
            const Convex shape = random_convex(random, form);
            const Rotation q = Rotation::from_angle(random.real(-4, 4));
            const Vec2 center{random.real_f(-4, -1), random.real_f(-2, -0.001)};
            const RelativePose pose{center - rotate(q, shape.centroid), q};
            REQUIRE(touches(chain, shape, pose).manifolds == 0);
        }
    }
}

TEST_CASE("a free end is solid round its corner, but not from behind") {
    const Convex segment = make_chain_segment(std::nullopt, {1, 0}, {-1, 0}, std::nullopt);
    const Convex disc = make_convex(Circle{{}, 0.2f}).value();
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 up_and_out = normalized(Vec2{side, 1});
        const Vec2 tip{side, 0};
        const Manifold round = collide(segment, disc, {tip + 0.2f * up_and_out, {}}, kReach_m);
        REQUIRE(round.count == 1);
        CHECK(dot(round.normal, up_and_out) > 1 - 1e-6f);
        CHECK(round.points[0].separation == Approx(0).margin(1e-6));
        const Vec2 down_and_out = normalized(Vec2{side, -1});
        CHECK(collide(segment, disc, {tip + 0.2f * down_and_out, {}}, kReach_m).count == 0);
    }
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Manifold beside = collide(segment, box, {{1.49f, 0.2f}, {}}, kReach_m);
    REQUIRE(beside.count >= 1);
    CHECK(beside.normal.x == Approx(1).margin(1e-6));
    CHECK(beside.points[0].separation == Approx(-0.01).margin(1e-6));
    // The two ends are alike, also for what is lower than the segment but reaches above it.
    for (const float height : {0.2f, -0.2f, -0.6f}) {
        const Manifold first = collide(segment, box, {{1.49f, height}, {}}, kReach_m);
        const Manifold last = collide(segment, box, {{-1.49f, height}, {}}, kReach_m);
        INFO("height " << height);
        REQUIRE(first.count == last.count);
        CHECK(first.normal.x == Approx(-last.normal.x).margin(1e-6));
        CHECK(first.count == (height > -0.5f ? 1 : 0));
    }
}

TEST_CASE("a ray meets a chain from its front only") {
    const Convex segment = make_chain_segment(std::nullopt, {1, 0}, {-1, 0}, std::nullopt);
    const auto hit = cast_ray(segment, {0.5f, 1}, {0, -4});
    REQUIRE(hit);
    CHECK(hit->fraction == 0.25f);
    CHECK(hit->normal == Vec2{0, 1});
    CHECK_FALSE(cast_ray(segment, {0.5f, -1}, {0, 4}));
}

TEST_CASE("a disc so far away that the square of the way is infinite does not meet a chain") {
    const Convex segment = make_chain_segment(std::nullopt, {1, 0}, {-1, 0}, std::nullopt);
    const Convex disc = make_convex(Circle{}).value();
    for (const Vec2 far : {Vec2{3e19f, 3e19f}, Vec2{-3e19f, 3e19f}, Vec2{0, 3e19f}}) {
        CHECK(collide(segment, disc, {far, {}}, kReach_m).count == 0);
    }
}

}  // namespace cairn::physics
