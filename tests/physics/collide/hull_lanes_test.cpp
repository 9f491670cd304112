// Hulls in lanes against the routines for one pair at a time, and against distances found by GJK.
#include "collide/hull_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <vector>

#include <cairn/physics/simd.h>
#include <cairn/physics/tuning.h>

#include "collide/distance.h"
#include "collide/manifold.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kReach_m = tuning::kSpeculativeDistance_m;
// Cases in which the scalar routine decides otherwise when a shape is moved or turned by this are left out.
constexpr float kNudge = 1e-5f;  // m, rad
constexpr double kTolerance = 3e-5;
// m. A normal that joins points of two cores is as uncertain as this is against their distance.
constexpr double kRounding = 1e-6;

struct HullPair {
    Convex a;
    Convex b;
    Vec2 mass_a;  // centre of mass in the body's frame
    Vec2 mass_b;
    Rotation q_a;
    Rotation q_b;
    Vec2 between;  // from centre of mass to centre of mass, in world axes

    [[nodiscard]] RelativePose b_in_a() const {
        const Rotation turn = inverse(q_a) * q_b;
        return {mass_a + inverse_rotate(q_a, between) - rotate(turn, mass_b), turn};
    }
    [[nodiscard]] double distance() const {
        return static_cast<double>(distance_between(a, b, b_in_a()).distance);
    }
};

Convex random_shape(Random& random) {
    const float radius = random.chance(0.5) ? 0 : random.real_f(0.02, 0.4);
    switch (random.below(4)) {
        case 0:
            return make_convex(Circle{random.vector(-0.5, 0.5), random.real_f(0.05, 0.8)}).value();
        case 1: {
            const Vec2 at = random.vector(-0.5, 0.5);
            const Rotation turn = Rotation::from_angle(random.real(-4, 4));
            const Vec2 along = rotate(turn, {random.real_f(0.1, 1), 0});
            return make_convex(Capsule{at, at + along, random.real_f(0.05, 0.4)}).value();
        }
        case 2: {
            const Vec2 half = random.vector(0.05, 1);
            return make_convex(Box{half.x, half.y, random.vector(-0.5, 0.5), random.real_f(-1, 1), radius})
                .value();
        }
        default: {
            std::vector<Vec2> points(3 + static_cast<std::size_t>(random.below(6)));
            const float size = random.real_f(0.2, 1);
            double angle = random.real(0, 6);
            for (Vec2& p : points) {
                angle +=
                    random.real(0.7, 1) * 2 * static_cast<double>(kPi) / static_cast<double>(points.size());
                p = rotate(Rotation::from_angle(angle), {size, 0});
            }
            return make_convex(Polygon{.points_m = points, .radius_m = radius}).value();
        }
    }
}

enum class Placing { Far, Near, Deep, Flush };
constexpr std::array kPlacings{Placing::Far, Placing::Near, Placing::Deep, Placing::Flush};

// Moves b along a direction until the shapes are a distance apart; a negative one is a way back inwards.
void part(HullPair& pair, Vec2 direction, double distance_m) {
    double near = 0;
    double far = 10;
    for (int i = 0; i < 50; ++i) {
        const double middle = (near + far) / 2;
        pair.between = static_cast<float>(middle) * direction;
        (pair.distance() > std::max(distance_m, 0.0) ? far : near) = middle;
    }
    pair.between = static_cast<float>(far + std::min(distance_m, 0.0)) * direction;
}

HullPair random_pair(Random& random, Placing placing) {
    const auto turn = [&] { return Rotation::from_angle(random.real(-4, 4)); };
    HullPair pair{random_shape(random),
                  random_shape(random),
                  random.vector(-0.5, 0.5),
                  random.vector(-0.5, 0.5),
                  turn(),
                  turn(),
                  {}};
    const Rotation direction = turn();
    const Vec2 along{direction.c, direction.s};
    switch (placing) {
        case Placing::Far:
            pair.between = random.real_f(0, 6) * along;
            break;
        case Placing::Near:
            part(pair, along, random.real(-0.03, 0.03));
            break;
        case Placing::Deep:
            pair.between = random.real_f(0, 0.5) * along;
            break;
        case Placing::Flush: {  // an edge of b along an edge of a
            if (pair.a.count() < 2 || pair.b.count() < 2) break;
            const Vec2 n_a = pair.a.normals[static_cast<std::size_t>(random.below(pair.a.count()))];
            const Vec2 n_b = pair.b.normals[static_cast<std::size_t>(random.below(pair.b.count()))];
            const Rotation of_b{n_b.x, n_b.y};
            const Rotation against{-n_a.x, -n_a.y};
            pair.q_b = normalized(pair.q_a * against * inverse(of_b));
            part(pair, rotate(pair.q_a, n_a), random.real(-0.01, 0.025));
            break;
        }
    }
    return pair;
}

struct Packed {
    PoseLanes poses;
    BoxLanes offsets;
    HullLanes hulls;
};

void put(Packed& packed, int lane, const HullPair& pair) {
    packed.poses.dx[lane] = pair.between.x;
    packed.poses.dy[lane] = pair.between.y;
    packed.poses.cos_a[lane] = pair.q_a.c;
    packed.poses.sin_a[lane] = pair.q_a.s;
    packed.poses.cos_b[lane] = pair.q_b.c;
    packed.poses.sin_b[lane] = pair.q_b.s;
    packed.offsets.offset_ax[lane] = -pair.mass_a.x;
    packed.offsets.offset_ay[lane] = -pair.mass_a.y;
    packed.offsets.offset_bx[lane] = -pair.mass_b.x;
    packed.offsets.offset_by[lane] = -pair.mass_b.y;
    packed.hulls.a[lane] = &pair.a;
    packed.hulls.b[lane] = &pair.b;
}

int point_count(const ManifoldLanes& m, int lane) {
    return (m.points[0].id[lane] != kNoFeature ? 1 : 0) + (m.points[1].id[lane] != kNoFeature ? 1 : 0);
}

double margin(Vec2 a, Vec2 b) {
    return static_cast<double>(length(a - b));
}

bool is_alike(const Manifold& a, const Manifold& b) {
    if (a.count != b.count || (a.count > 0 && margin(a.normal, b.normal) > 1e-3)) return false;
    for (int i = 0; i < a.count; ++i) {
        if (a.points[i].id != b.points[i].id || margin(a.points[i].point, b.points[i].point) > 1e-3)
            return false;
    }
    return true;
}

// Whether float rounding may turn the answer over.
bool is_borderline(const HullPair& pair, const Manifold& answer) {
    const RelativePose pose = pair.b_in_a();
    const auto differs = [&](Vec2 shift, float turn, float reach_m) {
        const Rotation q = normalized(Rotation{pose.q.c - turn * pose.q.s, pose.q.s + turn * pose.q.c});
        return !is_alike(answer, collide(pair.a, pair.b, {pose.p + shift, q}, reach_m));
    };
    for (const float s : {-kNudge, kNudge}) {
        if (differs({s, 0}, 0, kReach_m) || differs({0, s}, 0, kReach_m)) return true;
        if (differs({}, s, kReach_m) || differs({}, 0, kReach_m + s)) return true;
    }
    return false;
}

void check_points(const HullPair& pair, const Manifold& expected, const ManifoldLanes& found, int lane) {
    REQUIRE(point_count(found, lane) == expected.count);
    if (expected.count == 0) return;
    const Vec2 normal{found.normal_x[lane], found.normal_y[lane]};
    const double cores_apart = pair.distance() + static_cast<double>(pair.a.radius() + pair.b.radius());
    const double uncertain = cores_apart > 0 ? kRounding / cores_apart : 0;
    REQUIRE(margin(normal, rotate(pair.q_a, expected.normal)) < std::max(kTolerance, uncertain));
    for (int i = 0; i < expected.count; ++i) {
        const ManifoldPointLanes& point = found.points[i];
        const Vec2 arm = rotate(pair.q_a, expected.points[i].point - pair.mass_a);
        REQUIRE(margin({point.x[lane], point.y[lane]}, arm) < kTolerance);
        REQUIRE(static_cast<double>(point.separation[lane]) ==
                Approx(static_cast<double>(expected.points[i].separation)).margin(kTolerance).epsilon(0));
        // The routines for circles tell no features apart.
        if (pair.a.count() > 1 && pair.b.count() > 1) REQUIRE(point.id[lane] == expected.points[i].id);
    }
}

template <class Visit>  // visit(pairs, packed, found, undecided)
void for_each_block(unsigned seed, Placing placing, int blocks, Visit&& visit) {
    Random random(seed);
    for (int block = 0; block < blocks; ++block) {
        std::vector<HullPair> pairs;
        for (int lane = 0; lane < kLanes; ++lane) pairs.push_back(random_pair(random, placing));
        Packed packed{};
        for (int lane = 0; lane < kLanes; ++lane) put(packed, lane, pairs[static_cast<std::size_t>(lane)]);
        ManifoldLanes found;
        const unsigned undecided =
            collide_hull_lanes(packed.poses, packed.offsets, packed.hulls, kReach_m, found);
        visit(pairs, packed, found, undecided);
    }
}

}  // namespace

TEST_CASE("hulls in lanes have the manifolds of hulls one by one") {
    std::array<int, 3> with_points{};  // how many pairs had so many
    int undecided_count = 0;
    int borderline = 0;
    for (const Placing placing : kPlacings) {
        for_each_block(
            1, placing, 500, [&](const auto& pairs, const auto&, const auto& found, unsigned undecided) {
                for (int lane = 0; lane < kLanes; ++lane) {
                    const HullPair& pair = pairs[static_cast<std::size_t>(lane)];
                    const Manifold expected = collide(pair.a, pair.b, pair.b_in_a(), kReach_m);
                    if ((undecided >> lane & 1) != 0) {
                        ++undecided_count;
                    } else if (is_borderline(pair, expected)) {
                        ++borderline;
                    } else {
                        INFO("placing " << static_cast<int>(placing) << ", distance " << pair.distance()
                                        << ", corners " << pair.a.count() << " and " << pair.b.count());
                        check_points(pair, expected, found, lane);
                        ++with_points[static_cast<std::size_t>(expected.count)];
                    }
                }
            });
    }
    CAPTURE(with_points[0], with_points[1], with_points[2], undecided_count, borderline);
    CHECK(with_points[0] > 2500);
    CHECK(with_points[1] > 4000);
    CHECK(with_points[2] > 2500);
    CHECK(undecided_count < 400);  // of 16000
    CHECK(borderline < 800);
}

TEST_CASE("a capsule that stands on end has one point in lanes, at its lower end, whichever comes first") {
    const Convex ground =
        make_convex(Polygon{.points_m = std::array{Vec2{-5, -1}, Vec2{5, -1}, Vec2{4, 0}, Vec2{-4, 0}}})
            .value();
    for (const float sign : {-1.0f, 1.0f}) {
        for (const float gap : {-0.05f, -0.001f, 0.0f, 0.015f}) {
            const Convex capsule = make_convex(Capsule{{0, -0.2f * sign}, {0, 0.2f * sign}, 0.1f}).value();
            const HullPair pair{ground, capsule, {}, {}, Rotation{}, Rotation{}, {0.5f, 0.3f + gap}};
            Packed packed{};
            for (int lane = 0; lane < kLanes; ++lane) put(packed, lane, pair);
            ManifoldLanes found;
            CHECK(collide_hull_lanes(packed.poses, packed.offsets, packed.hulls, kReach_m, found) == 0);
            REQUIRE(point_count(found, 0) == 1);
            CHECK(found.normal_y[0] == Approx(1));
            CHECK(found.points[0].separation[0] == Approx(gap).margin(1e-6));
            CHECK(found.points[0].x[0] == Approx(0.5f));
        }
    }
}

TEST_CASE("the gap of hulls in lanes is never more than their distance, and is seen along the normal") {
    int apart = 0;
    for (const Placing placing : kPlacings) {
        for_each_block(
            2, placing, 300, [&](const auto& pairs, const auto&, const auto& found, unsigned undecided) {
                for (int lane = 0; lane < kLanes; ++lane) {
                    const HullPair& pair = pairs[static_cast<std::size_t>(lane)];
                    if ((undecided >> lane & 1) != 0 || point_count(found, lane) != 0) continue;
                    const Vec2 normal{found.normal_x[lane], found.normal_y[lane]};
                    const double gap = static_cast<double>(found.gap[lane]);
                    REQUIRE(static_cast<double>(length(normal)) == Approx(1).margin(1e-5));
                    REQUIRE(gap <= pair.distance() + kTolerance);
                    // The points of each, along the normal.
                    const Vec2 axis = inverse_rotate(pair.q_a, normal);
                    const RelativePose pose = pair.b_in_a();
                    float end_of_a = -1e9f;
                    float start_of_b = 1e9f;
                    for (int i = 0; i < pair.a.count(); ++i)
                        end_of_a = std::max(end_of_a, dot(axis, pair.a.point(i)));
                    for (int i = 0; i < pair.b.count(); ++i)
                        start_of_b =
                            std::min(start_of_b, dot(axis, pose.p + rotate(pose.q, pair.b.point(i))));
                    const double seen =
                        static_cast<double>(start_of_b - end_of_a - pair.a.radius() - pair.b.radius());
                    REQUIRE(seen == Approx(gap).margin(6e-4).epsilon(0));
                    ++apart;
                }
            });
    }
    CHECK(apart > 2000);
}

TEST_CASE("every SIMD level finds the same bits for hulls in lanes") {
    using Bits = std::array<std::uint32_t, sizeof(ManifoldLanes) / sizeof(std::uint32_t)>;
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    for (const Placing placing : kPlacings) {
        for_each_block(
            4, placing, 100, [&](const auto&, const Packed& packed, const auto& best, unsigned undecided) {
                for (const SimdLevel level : levels) {
                    force_simd_level(level).value();
                    ManifoldLanes found;
                    const unsigned bits =
                        collide_hull_lanes(packed.poses, packed.offsets, packed.hulls, kReach_m, found);
                    force_simd_level(levels.back()).value();
                    CAPTURE(name(level));
                    REQUIRE(bits == undecided);
                    REQUIRE(std::bit_cast<Bits>(found) == std::bit_cast<Bits>(best));
                }
            });
    }
}

}  // namespace cairn::physics
