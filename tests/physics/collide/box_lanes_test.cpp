// Boxes in lanes against the general routines, one pair at a time, and against distances found by GJK.
#include "collide/box_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <cairn/physics/simd.h>
#include <cairn/physics/tuning.h>

#include "collide/distance.h"
#include "physics/support/random.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kReach_m = tuning::kSpeculativeDistance_m;
// Cases in which the scalar routine decides otherwise when a box is moved or turned by this are left out:
// float coordinates of a few metres are good to about a tenth of it.
constexpr float kNudge = 4e-6f;  // m, rad
constexpr double kPointTolerance_m = 6e-6;
constexpr double kNormalTolerance = 1e-6;

// A box on each of two bodies; centres of mass lie anywhere, as those of compounds do.
struct BoxPair {
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
    [[nodiscard]] Vec2 between_boxes() const {
        return between + rotate(q_b, b.centroid - mass_b) - rotate(q_a, a.centroid - mass_a);
    }
    void put_box_b_at(Vec2 from_box_a) { between += from_box_a - between_boxes(); }
    [[nodiscard]] double distance() const {
        return static_cast<double>(distance_between(a, b, b_in_a()).distance);
    }
};

enum class Placing { Far, Near, Deep, Stacked, Corners };
constexpr std::array kPlacings{Placing::Far, Placing::Near, Placing::Deep, Placing::Stacked,
                               Placing::Corners};

// Moves b along a direction from a until the boxes are a distance apart; a negative one is a way back inwards
// from where they touch.
void part(BoxPair& pair, Vec2 direction, double distance_m) {
    double near = 0;
    double far = 10;
    for (int i = 0; i < 50; ++i) {
        const double middle = (near + far) / 2;
        pair.put_box_b_at(static_cast<float>(middle) * direction);
        (pair.distance() > std::max(distance_m, 0.0) ? far : near) = middle;
    }
    pair.put_box_b_at(static_cast<float>(far + std::min(distance_m, 0.0)) * direction);
}

Vec2 corner_towards(Vec2 half_size, Vec2 direction) {
    return {std::copysign(half_size.x, direction.x), std::copysign(half_size.y, direction.y)};
}

BoxPair random_pair(Random& random, Placing placing) {
    const auto box = [&] {
        const Vec2 half = random.vector(0.05, 1);
        return make_convex(Box{half.x, half.y, random.vector(-0.5, 0.5)}).value();
    };
    const auto turn = [&] { return Rotation::from_angle(random.real(-4, 4)); };
    BoxPair pair{box(), box(), random.vector(-0.5, 0.5), random.vector(-0.5, 0.5), turn(), turn(), {}};
    const Rotation direction = turn();
    const Vec2 along{direction.c, direction.s};
    const Rotation quarters = Rotation::from_angle(random.below(4) * static_cast<double>(kPi) / 2);
    switch (placing) {
        case Placing::Far:
            pair.put_box_b_at(random.real_f(0, 6) * along);
            break;
        case Placing::Near:
            part(pair, along, random.real(-0.03, 0.03));
            break;
        case Placing::Deep:
            pair.put_box_b_at(random.real_f(0, 0.5) * along);
            break;
        case Placing::Stacked:  // flush, or nearly so
            pair.q_b =
                pair.q_a * quarters * Rotation::from_angle(random.chance(0.5) ? 0 : random.real(-0.01, 0.01));
            part(pair, along, random.real(-0.01, 0.025));
            break;
        case Placing::Corners: {  // a corner of b outside a corner of a
            pair.q_b = pair.q_a * quarters * Rotation::from_angle(random.real(-0.7, 0.7));
            const Vec2 out =
                normalized(Vec2{random.chance(0.5) ? 1.0f : -1.0f, random.chance(0.5) ? 1.0f : -1.0f});
            const Vec2 corner_a = corner_towards(pair.a.half_size, out);
            const Rotation turn_b = inverse(pair.q_a) * pair.q_b;
            const Vec2 corner_b =
                rotate(turn_b, corner_towards(pair.b.half_size, inverse_rotate(turn_b, -out)));
            const float gap = random.real_f(0, 0.025);
            const Vec2 across = random.real_f(-0.8, 0.8) * left_perp(out);
            pair.put_box_b_at(rotate(pair.q_a, corner_a - corner_b + gap * (out + across)));
            break;
        }
    }
    return pair;
}

struct Packed {
    PoseLanes poses;
    BoxLanes boxes;
};

// As the narrow phase fills lanes that have no pair.
void put_nothing(Packed& packed, int lane) {
    packed.poses.dx[lane] = 1e9f;
    packed.poses.dy[lane] = packed.poses.sin_a[lane] = packed.poses.sin_b[lane] = 0;
    packed.poses.cos_a[lane] = packed.poses.cos_b[lane] = 1;
    for (auto* field : {&packed.boxes.half_ax, &packed.boxes.half_ay, &packed.boxes.half_bx,
                        &packed.boxes.half_by, &packed.boxes.offset_ax, &packed.boxes.offset_ay,
                        &packed.boxes.offset_bx, &packed.boxes.offset_by}) {
        (*field)[lane] = 0;
    }
}

void put(Packed& packed, int lane, const BoxPair& pair) {
    packed.poses.dx[lane] = pair.between.x;
    packed.poses.dy[lane] = pair.between.y;
    packed.poses.cos_a[lane] = pair.q_a.c;
    packed.poses.sin_a[lane] = pair.q_a.s;
    packed.poses.cos_b[lane] = pair.q_b.c;
    packed.poses.sin_b[lane] = pair.q_b.s;
    packed.boxes.half_ax[lane] = pair.a.half_size.x;
    packed.boxes.half_ay[lane] = pair.a.half_size.y;
    packed.boxes.half_bx[lane] = pair.b.half_size.x;
    packed.boxes.half_by[lane] = pair.b.half_size.y;
    packed.boxes.offset_ax[lane] = pair.a.centroid.x - pair.mass_a.x;
    packed.boxes.offset_ay[lane] = pair.a.centroid.y - pair.mass_a.y;
    packed.boxes.offset_bx[lane] = pair.b.centroid.x - pair.mass_b.x;
    packed.boxes.offset_by[lane] = pair.b.centroid.y - pair.mass_b.y;
}

int point_count(const ManifoldLanes& m, int lane) {
    return (m.points[0].id[lane] != kNoFeature ? 1 : 0) + (m.points[1].id[lane] != kNoFeature ? 1 : 0);
}

Manifold collide_one(const BoxPair& pair, const RelativePose& b_in_a, float reach_m) {
    return collide(pair.a, pair.b, b_in_a, reach_m);
}

bool decides_alike(const Manifold& a, const Manifold& b) {
    if (a.count != b.count) return false;
    for (int i = 0; i < a.count; ++i) {
        if (a.points[i].id != b.points[i].id) return false;
    }
    return true;
}

// Whether float rounding may turn the answer over.
bool is_borderline(const BoxPair& pair, const Manifold& answer) {
    const RelativePose pose = pair.b_in_a();
    const auto differs = [&](Vec2 shift, float turn, float reach_m) {
        const Rotation q = normalized(Rotation{pose.q.c - turn * pose.q.s, pose.q.s + turn * pose.q.c});
        return !decides_alike(answer, collide_one(pair, {pose.p + shift, q}, reach_m));
    };
    for (const float s : {-kNudge, kNudge}) {
        if (differs({s, 0}, 0, kReach_m) || differs({0, s}, 0, kReach_m)) return true;
        if (differs({}, s, kReach_m) || differs({}, 0, kReach_m + s)) return true;
    }
    return false;
}

// From a direction between corners on, its rounding is that of their places by how far they are apart.
double normal_tolerance(const Manifold& m) {
    const bool between_corners = m.count == 1 && (m.points[0].id >> 13 & 1) != 0;
    if (!between_corners) return kNormalTolerance;
    return std::max(kNormalTolerance, 2e-6 / static_cast<double>(m.points[0].separation));
}

double margin(Vec2 a, Vec2 b) {
    return static_cast<double>(length(a - b));
}

void check_points(const BoxPair& pair, const Manifold& expected, const ManifoldLanes& found, int lane) {
    REQUIRE(point_count(found, lane) == expected.count);
    if (expected.count == 0) return;
    const Vec2 normal{found.normal_x[lane], found.normal_y[lane]};
    REQUIRE(margin(normal, rotate(pair.q_a, expected.normal)) < normal_tolerance(expected));
    for (int i = 0; i < expected.count; ++i) {
        const ManifoldPointLanes& point = found.points[i];
        REQUIRE(point.id[lane] == expected.points[i].id);
        const Vec2 arm = rotate(pair.q_a, expected.points[i].point - pair.mass_a);
        REQUIRE(margin({point.x[lane], point.y[lane]}, arm) < kPointTolerance_m);
        REQUIRE(
            static_cast<double>(point.separation[lane]) ==
            Approx(static_cast<double>(expected.points[i].separation)).margin(kPointTolerance_m).epsilon(0));
    }
}

// The gap between the boxes' corners along a direction, by brute force in double.
double gap_along(const BoxPair& pair, Vec2 normal_in_world) {
    const test::Point n = test::to_point(inverse_rotate(pair.q_a, normal_in_world));
    double end_of_a = -std::numeric_limits<double>::infinity();
    double start_of_b = std::numeric_limits<double>::infinity();
    for (const test::Point p : test::rounded_hull(pair.a).core)
        end_of_a = std::max(end_of_a, test::dot(p, n));
    for (const test::Point p : test::rounded_hull(pair.b, pair.b_in_a()).core)
        start_of_b = std::min(start_of_b, test::dot(p, n));
    return start_of_b - end_of_a;
}

template <class Visit>  // visit(pairs, packed, found, undecided)
void for_each_block(unsigned seed, Placing placing, int blocks, Visit&& visit) {
    Random random(seed);
    for (int block = 0; block < blocks; ++block) {
        std::vector<BoxPair> pairs;
        Packed packed;
        for (int lane = 0; lane < kLanes; ++lane) {
            pairs.push_back(random_pair(random, placing));
            put(packed, lane, pairs.back());
        }
        ManifoldLanes found;
        const unsigned undecided = collide_box_lanes(packed.poses, packed.boxes, kReach_m, found);
        visit(pairs, packed, found, undecided);
    }
}

}  // namespace

TEST_CASE("boxes in lanes have the manifolds of boxes one by one") {
    std::array<int, 3> with_points{};  // how many pairs had so many
    int between_corners = 0;
    int undecided_count = 0;
    int borderline = 0;
    for (const Placing placing : kPlacings) {
        for_each_block(
            1, placing, 500, [&](const auto& pairs, const auto&, const auto& found, unsigned undecided) {
                for (int lane = 0; lane < kLanes; ++lane) {
                    const BoxPair& pair = pairs[lane];
                    const Manifold expected = collide_one(pair, pair.b_in_a(), kReach_m);
                    if (is_borderline(pair, expected)) {
                        ++borderline;
                        continue;
                    }
                    INFO("placing " << static_cast<int>(placing) << ", distance " << pair.distance());
                    if ((undecided >> lane & 1) != 0) {
                        REQUIRE(!collide_boxes(pair.a, pair.b, pair.b_in_a(), kReach_m));
                        ++undecided_count;
                        continue;
                    }
                    check_points(pair, expected, found, lane);
                    ++with_points[expected.count];
                    if (expected.count == 1 && (expected.points[0].id >> 13 & 1) != 0) ++between_corners;
                }
            });
    }
    CAPTURE(with_points[0], with_points[1], with_points[2], between_corners, undecided_count, borderline);
    CHECK(with_points[0] > 3000);
    CHECK(with_points[1] > 1000);
    CHECK(with_points[2] > 5000);
    CHECK(between_corners > 500);
    CHECK(undecided_count < 200);  // of 20000: another side is about as near, or corners touch
    CHECK(borderline < 200);
}

TEST_CASE("the gap of boxes in lanes is never more than their distance, and is seen along the normal") {
    int apart = 0;
    for (const Placing placing : kPlacings) {
        for_each_block(
            2, placing, 300, [&](const auto& pairs, const auto&, const auto& found, unsigned undecided) {
                for (int lane = 0; lane < kLanes; ++lane) {
                    const BoxPair& pair = pairs[lane];
                    const auto gap = static_cast<double>(found.gap[lane]);
                    REQUIRE(gap <= pair.distance() + kPointTolerance_m);
                    if ((undecided >> lane & 1) != 0 || point_count(found, lane) != 0) continue;
                    ++apart;
                    const Vec2 normal{found.normal_x[lane], found.normal_y[lane]};
                    REQUIRE(static_cast<double>(length(normal)) == Approx(1).margin(kNormalTolerance));
                    REQUIRE(gap_along(pair, normal) ==
                            Approx(gap).margin(static_cast<double>(kAboutEqual_m)).epsilon(0));
                }
            });
    }
    CHECK(apart > 2000);
}

TEST_CASE("lanes without a pair have no points and are decided, whatever lies beside them") {
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        Packed packed;
        const unsigned used = static_cast<unsigned>(random.below(1 << kLanes));
        for (int lane = 0; lane < kLanes; ++lane) {
            put(packed, lane, random_pair(random, Placing::Corners));
            if ((used >> lane & 1) == 0) put_nothing(packed, lane);
        }
        ManifoldLanes found;
        const unsigned undecided = collide_box_lanes(packed.poses, packed.boxes, kReach_m, found);
        REQUIRE((undecided & ~used) == 0);
        for (int lane = 0; lane < kLanes; ++lane) {
            if ((used >> lane & 1) == 0) REQUIRE(point_count(found, lane) == 0);
        }
    }
}

TEST_CASE("every SIMD level finds the same bits for boxes in lanes") {
    using Bits = std::array<std::uint32_t, sizeof(ManifoldLanes) / sizeof(std::uint32_t)>;
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    for (const Placing placing : kPlacings) {
        for_each_block(
            4, placing, 100, [&](const auto&, const Packed& packed, const auto& best, unsigned undecided) {
                for (const SimdLevel level : levels) {
                    force_simd_level(level).value();
                    ManifoldLanes found;
                    const unsigned bits = collide_box_lanes(packed.poses, packed.boxes, kReach_m, found);
                    force_simd_level(levels.back()).value();
                    CAPTURE(name(level));
                    REQUIRE(bits == undecided);
                    REQUIRE(std::bit_cast<Bits>(found) == std::bit_cast<Bits>(best));
                }
            });
    }
}

}  // namespace cairn::physics
