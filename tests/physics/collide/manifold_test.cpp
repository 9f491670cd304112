// Manifolds of every pair of kinds against separations found by brute force.
#include "collide/manifold.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "physics/support/random_shapes.h"
#include "physics/support/rounded_hull.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr float kReach_m = tuning::kSpeculativeDistance_m;
// Cores nearer than this are treated as touching, and of two faces of about the same overlap either may
// count.
constexpr double kFaceTolerance_m = 0.1 * static_cast<double>(tuning::kLinearSlop_m);

struct Pair {
    Convex a;
    Convex b;
    RelativePose b_in_a;
    Separation expected;
};

// B turned by an angle, with its centroid at a distance from A's.
RelativePose pose_at(const Convex& a, const Convex& b, double distance, double direction, double angle) {
    const Rotation q = Rotation::from_angle(angle);
    const Vec2 offset{static_cast<float>(distance * std::cos(direction)),
                      static_cast<float>(distance * std::sin(direction))};
    return {a.centroid + offset - rotate(q, b.centroid), q};
}

// Two random shapes, moved along a random direction until their surfaces are `distance` apart.
Pair random_pair(Random& random, Form form_a, Form form_b, double distance) {
    Pair pair{random_convex(random, form_a), random_convex(random, form_b), {}, {}};
    const double direction = random.real(-4, 4);
    const double angle = random.real(-4, 4);
    const auto separation_at = [&](double s) {
        pair.b_in_a = pose_at(pair.a, pair.b, s, direction, angle);
        return separation(rounded_hull(pair.a), rounded_hull(pair.b, pair.b_in_a));
    };
    double near = 0;
    double far = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = (near + far) / 2;
        (separation_at(middle).distance > distance ? far : near) = middle;
    }
    pair.expected = separation_at(far);
    return pair;
}

float least_separation(const Manifold& m) {
    return m.count == 2 ? std::min(m.points[0].separation, m.points[1].separation) : m.points[0].separation;
}

RelativePose inverse(const RelativePose& pose) {
    return {-inverse_rotate(pose.q, pose.p), cairn::physics::inverse(pose.q)};
}

template <class Visit>
void for_each_pair_of_forms(Visit&& visit) {
    for (const Form a : kForms) {
        for (const Form b : kForms) {
            INFO("forms " << static_cast<int>(a) << " and " << static_cast<int>(b));
            visit(a, b);
        }
    }
    for (const Form form : kForms) {
        INFO("a segment and form " << static_cast<int>(form));
        visit(Form::Segment, form);
        visit(form, Form::Segment);
    }
}

}  // namespace

TEST_CASE("shapes that are apart have their true distance and direction in the manifold") {
    Random random(1);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 300; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(0.001, 0.019));
            const Manifold m = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            INFO("round " << round << ", distance " << pair.expected.distance);
            REQUIRE(m.count > 0);
            // Corner against corner is told from face against face at a factor 1.0001 of the squared core
            // distance: up to 5e-5 of that distance; float adds 1e-6.
            const double core_distance =
                pair.expected.distance + static_cast<double>(pair.a.radius() + pair.b.radius());
            const double tolerance = 2e-6 + 5e-5 * core_distance;
            REQUIRE(static_cast<double>(least_separation(m)) ==
                    Approx(pair.expected.distance).margin(tolerance).epsilon(0));
            REQUIRE(length(m.normal) == Approx(1).epsilon(1e-5));
            // The same factor in the cosine; and rounding of the points, seen from the distance of the cores.
            REQUIRE(dot(to_point(m.normal), pair.expected.normal) > 1 - 2e-4);
        }
    });
}

TEST_CASE("shapes whose rounding overlaps have their true depth in the manifold") {
    Random random(2);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 100; ++round) {
            Pair pair = random_pair(random, form_a, form_b, 0);
            const double radii = static_cast<double>(pair.a.radius() + pair.b.radius());
            if (radii == 0) break;
            // Deeper, but with the cores still 5 % of the radii (at least 1 mm) apart.
            pair.b_in_a.p = pair.b_in_a.p - static_cast<float>(random.real(0, 0.95) * radii) *
                                                Vec2{static_cast<float>(pair.expected.normal.x),
                                                     static_cast<float>(pair.expected.normal.y)};
            const Separation expected = separation(rounded_hull(pair.a), rounded_hull(pair.b, pair.b_in_a));
            INFO("round " << round << ", distance " << expected.distance);
            if (expected.cores_overlap) continue;
            const Manifold m = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            REQUIRE(m.count > 0);
            const double tolerance = 2e-6 + 5e-5 * (radii + expected.distance);
            REQUIRE(static_cast<double>(least_separation(m)) ==
                    Approx(expected.distance).margin(tolerance).epsilon(0));
        }
    });
}

TEST_CASE("shapes whose cores overlap have the least push that parts them in the manifold") {
    Random random(3);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        if (form_a == Form::Circle && form_b == Form::Circle) return;
        for (int round = 0; round < 200; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(-0.5, -0.05));
            if (!pair.expected.cores_overlap) continue;
            const Manifold m = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            INFO("round " << round << ", depth " << pair.expected.distance);
            REQUIRE(m.count > 0);
            REQUIRE(static_cast<double>(least_separation(m)) ==
                    Approx(pair.expected.distance).margin(kFaceTolerance_m + 2e-6).epsilon(0));
        }
    });
}

TEST_CASE("shapes beyond the reach have no manifold") {
    Random random(4);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 100; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(0.0202, 1));
            REQUIRE(collide(pair.a, pair.b, pair.b_in_a, kReach_m).count == 0);
        }
    });
}

TEST_CASE("each point lies midway between the two surfaces") {
    Random random(5);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 100; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(0.001, 0.019));
            const Manifold m = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            const RoundedHull a = rounded_hull(pair.a);
            const RoundedHull b = rounded_hull(pair.b, pair.b_in_a);
            for (int i = 0; i < m.count; ++i) {
                const double half = static_cast<double>(m.points[i].separation) / 2;
                // Of the two surfaces, the incident edge's may slant away from the normal; the reference's
                // point is a foot of the perpendicular.
                const double to_a = signed_distance(a, to_point(m.points[i].point));
                const double to_b = signed_distance(b, to_point(m.points[i].point));
                REQUIRE(std::max(to_a, to_b) == Approx(half).margin(2e-5).epsilon(0));
                REQUIRE(std::min(to_a, to_b) <= half + 2e-5);
            }
        }
    });
}

TEST_CASE("a manifold is the same from both sides") {
    Random random(6);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 100; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(-0.1, 0.019));
            const Manifold ab = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            const Manifold ba = collide(pair.b, pair.a, inverse(pair.b_in_a), kReach_m);
            INFO("round " << round << ", distance " << pair.expected.distance);
            REQUIRE(ab.count > 0);
            REQUIRE(ba.count > 0);
            // With two faces about equally far, each side may take its own.
            REQUIRE(std::fabs(least_separation(ab) - least_separation(ba)) < kFaceTolerance_m + 2e-6);
            if (pair.expected.distance > 0.001) {
                const Vec2 back = -rotate(pair.b_in_a.q, ba.normal);
                REQUIRE(dot(ab.normal, back) > 1 - 4e-4f);
            }
        }
    });
}

TEST_CASE("two discs touch at one point on the line of their centres") {
    const Convex a = make_convex(Circle{{0, 0}, 1}).value();
    const Convex b = make_convex(Circle{{0, 0}, 0.5f}).value();
    const Manifold m = collide(a, b, {{0, 1.25f}, {}}, kReach_m);
    REQUIRE(m.count == 1);
    CHECK(m.normal == Vec2{0, 1});
    CHECK(m.points[0].separation == -0.25f);
    CHECK(m.points[0].point == Vec2{0, 0.875f});
}

TEST_CASE("discs with one centre still have a normal") {
    const Convex disc = make_convex(Circle{{0, 0}, 1}).value();
    const Manifold m = collide(disc, disc, {}, kReach_m);
    REQUIRE(m.count == 1);
    CHECK(length(m.normal) == 1);
    CHECK(m.points[0].separation == -2);
}

TEST_CASE("a box on a box touches at the two ends of their common edge") {
    const Convex ground = make_convex(Box{5, 1}).value();
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Manifold m = collide(ground, box, {{2, 1.49f}, {}}, kReach_m);
    REQUIRE(m.count == 2);
    CHECK(m.normal == Vec2{0, 1});
    std::array<float, 2> x{m.points[0].point.x, m.points[1].point.x};
    std::sort(x.begin(), x.end());
    CHECK(x[0] == Approx(1.5));
    CHECK(x[1] == Approx(2.5));
    for (const ManifoldPoint& p : m.points) {
        CHECK(p.separation == Approx(-0.01).margin(1e-6));
        CHECK(p.point.y == Approx(0.995).margin(1e-6));
    }
}

TEST_CASE("a box that hangs over an edge touches from its corner to that edge") {
    const Convex table = make_convex(Box{1, 1}).value();
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Manifold m = collide(table, box, {{0.8f, 1.5f}, {}}, kReach_m);
    REQUIRE(m.count == 2);
    std::array<float, 2> x{m.points[0].point.x, m.points[1].point.x};
    std::sort(x.begin(), x.end());
    CHECK(x[0] == Approx(0.3).margin(1e-6));
    CHECK(x[1] == Approx(1).margin(1e-6));
}

TEST_CASE("a capsule lying on a box touches at two points, one standing on it at one") {
    const Convex ground = make_convex(Box{5, 1}).value();
    const Convex capsule = make_convex(Capsule{{-1, 0}, {1, 0}, 0.25f}).value();
    const Manifold lying = collide(ground, capsule, {{0, 1.25f}, {}}, kReach_m);
    REQUIRE(lying.count == 2);
    CHECK(lying.normal == Vec2{0, 1});
    const Manifold standing =
        collide(ground, capsule, {{0, 2.25f}, Rotation::from_angle(1.57079632679)}, kReach_m);
    REQUIRE(standing.count == 1);
    CHECK(standing.points[0].point.x == Approx(0).margin(1e-5));
    CHECK(standing.points[0].separation == Approx(0).margin(1e-5));
}

TEST_CASE("capsules and segments end to end on one line touch at their ends, or not at all") {
    const Convex capsule = make_convex(Capsule{{-1, 0}, {1, 0}, 0.25f}).value();
    const Convex segment = make_convex(Segment{{-1, 0}, {1, 0}}).value();
    for (const float tilt : {0.0f, 1e-5f, 1e-4f}) {
        INFO("a rise of " << tilt << " m");
        const Manifold ends = collide(capsule, capsule, {{2.51f, tilt}, {}}, kReach_m);
        REQUIRE(ends.count == 1);
        CHECK(ends.normal.x == Approx(1).margin(1e-6));
        CHECK(ends.points[0].separation == Approx(0.01).margin(1e-6));
        CHECK(collide(capsule, capsule, {{2.53f, tilt}, {}}, kReach_m).count == 0);
        const Manifold tip = collide(segment, capsule, {{2.25f, tilt}, {}}, kReach_m);
        REQUIRE(tip.count == 1);
        CHECK(tip.normal.x == Approx(1).margin(1e-6));
        CHECK(tip.points[0].separation == Approx(0).margin(1e-6));
    }
}

TEST_CASE("segments do not meet each other") {
    const Convex segment = make_convex(Segment{{-1, 0}, {1, 0}}).value();
    CHECK(collide(segment, segment, {{0, 0}, Rotation::from_angle(1)}, kReach_m).count == 0);
    CHECK(collide(segment, segment, {{0, 0.001f}, {}}, kReach_m).count == 0);
}

TEST_CASE("a segment is solid from both sides") {
    const Convex segment = make_convex(Segment{{-1, 0}, {1, 0}}).value();
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Convex disc = make_convex(Circle{{}, 0.5f}).value();
    for (const float side : {-1.0f, 1.0f}) {
        const Manifold flat = collide(segment, box, {{0, side * 0.49f}, {}}, kReach_m);
        REQUIRE(flat.count == 2);
        CHECK(flat.normal == Vec2{0, side});
        CHECK(flat.points[0].separation == Approx(-0.01).margin(1e-6));
        const Manifold round = collide(disc, segment, {{0, side * 0.49f}, {}}, kReach_m);
        REQUIRE(round.count == 1);
        CHECK(round.normal == Vec2{0, side});
        CHECK(round.points[0].separation == Approx(-0.01).margin(1e-6));
    }
}

TEST_CASE("a box that slides along another keeps the ids of its points") {
    const Convex ground = make_convex(Box{5, 1}).value();
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const Manifold first = collide(ground, box, {{-2, 1.5f}, {}}, kReach_m);
    REQUIRE(first.count == 2);
    CHECK(first.points[0].id != first.points[1].id);
    for (float x = -2; x < 2; x += 0.01f) {
        // It also rocks a little and sinks in and rises.
        const double rock = 0.005 * std::sin(50.0 * static_cast<double>(x));
        const float height = 1.5f + 0.004f * std::cos(30 * x);
        const Manifold m = collide(ground, box, {{x, height}, Rotation::from_angle(rock)}, kReach_m);
        REQUIRE(m.count == 2);
        CHECK(m.points[0].id == first.points[0].id);
        CHECK(m.points[1].id == first.points[1].id);
    }
}

TEST_CASE("two sides that rock against each other keep their ids and do not jump") {
    // B juts out over A: leaning to the left its corner presses on A, and leaning to the right A's corner on
    // it. Neither is to be felt when it takes over, so separations go no further than the sides do.
    constexpr double kRocks_rad = 0.02;
    constexpr double kTurn_rad = 1e-5;
    const Convex box = make_convex(Box{0.5f, 0.5f}).value();
    const std::array corners{Vec2{-0.5f, -0.5f}, Vec2{0.5f, -0.5f}, Vec2{0.5f, 0.5f}, Vec2{-0.5f, 0.5f}};
    const Convex quad = make_convex(Polygon{corners}).value();
    for (const Convex& form : {box, quad}) {
        const auto at = [&](double angle) {
            return collide(form, form, {{0.4f, 0.999f}, Rotation::from_angle(angle)}, kReach_m);
        };
        Manifold before = at(-kRocks_rad);
        REQUIRE(before.count == 2);
        CHECK(before.points[0].id != before.points[1].id);
        const auto end_of = [](const Manifold& m, std::uint16_t id) { return m.points[0].id == id ? 0 : 1; };
        const std::uint16_t first = before.points[0].id;
        const std::uint16_t second = before.points[1].id;
        float jump_m = 0;
        for (double angle = -kRocks_rad; angle < kRocks_rad; angle += kTurn_rad) {
            const Manifold m = at(angle);
            REQUIRE(m.count == 2);
            REQUIRE(m.points[end_of(m, first)].id == first);
            REQUIRE(m.points[end_of(m, second)].id == second);
            for (const std::uint16_t id : {first, second}) {
                const ManifoldPoint& now = m.points[end_of(m, id)];
                const ManifoldPoint& last = before.points[end_of(before, id)];
                jump_m = std::max(jump_m, std::fabs(now.separation - last.separation));
            }
            before = m;
        }
        // A corner of a box goes by its diameter times the turn, and the reference changes at differences of
        // 5 um.
        CHECK(jump_m < 1.5 * kTurn_rad + 6e-6);
    }
}

TEST_CASE("a motion too small to see keeps the ids of nearly all random contacts") {
    Random random(7);
    int compared = 0;
    int changed = 0;
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        for (int round = 0; round < 200; ++round) {
            const Pair pair = random_pair(random, form_a, form_b, random.real(-0.02, 0.015));
            RelativePose moved = pair.b_in_a;
            moved.p += random.vector(-1e-6, 1e-6);
            const Manifold before = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            const Manifold after = collide(pair.a, pair.b, moved, kReach_m);
            ++compared;
            bool same = before.count == after.count;
            for (int i = 0; same && i < before.count; ++i) same = before.points[i].id == after.points[i].id;
            changed += same ? 0 : 1;
        }
    });
    // Features change on a set of measure zero: a micrometre of motion in contacts of centimetres meets it
    // about once in ten thousand.
    CHECK(compared == 9600);
    CHECK(changed <= 9);
}

TEST_CASE("capsules that cross at a right angle touch, whichever end of the one lies in the other") {
    const Convex upright = make_convex(Capsule{{0.3f, -1}, {0.3f, 2}, 1}).value();
    for (const bool reversed : {false, true}) {
        const Vec2 near{0.28f, 0.3f};
        const Vec2 far{2, 0.3f};
        const Convex level = make_convex(Capsule{reversed ? far : near, reversed ? near : far, 0.5f}).value();
        for (const bool swapped : {false, true}) {
            INFO("reversed " << reversed << ", swapped " << swapped);
            const Manifold m =
                swapped ? collide(level, upright, {}, kReach_m) : collide(upright, level, {}, kReach_m);
            REQUIRE(m.count == 1);
            // The cores part when one is pushed by 2 cm.
            CHECK(m.points[0].separation == Approx(-1.52f));
            CHECK(dot(m.normal, {swapped ? -1.0f : 1.0f, 0}) == Approx(1));
        }
    }
}

TEST_CASE("cores a hair apart, corner to corner, keep their contact and its depth") {
    // What fuzzing found: the two cores are less than 1 mm apart, and the deep end of the one lies past the
    // end of the other's edge.
    const Convex steep = make_convex(Capsule{{-2, 0.49955f}, {-1.99951f, -1.99951f}, 0.01f}).value();
    const std::array notched{Vec2{-2, -2}, Vec2{2, -2}, Vec2{2, 2}, Vec2{0.999985f, 2}, Vec2{-2, -1.25005f}};
    const Convex tiny = make_convex(Capsule{{-2, -1.98437f}, {-1.99994f, -2}, 0.01f}).value();
    const std::array crate{Vec2{-2, -2}, Vec2{1.98444f, -2}, Vec2{2, 2}, Vec2{-1.98279f, 2}};
    const Convex line = make_convex(Segment{{-2, -2}, {-1.99218738f, -2}}).value();
    const std::array sharp{Vec2{-2, -2}, Vec2{1.754879f, -1.54045928f}, Vec2{1.75481796f, 0.532631397f},
                           Vec2{-0.0298771858f, -0.0312199593f}, Vec2{-2, -1.21873808f}};
    const RelativePose beside{{-4, -4}, {}};
    const RelativePose turned{{-4, -4}, {-1, 0}};
    struct Case {
        const Convex& a;
        Convex b;
        RelativePose b_in_a;
    };
    const std::array cases{Case{steep, make_convex(Polygon{notched}).value(), beside},
                           Case{tiny, make_convex(Polygon{crate}).value(), beside},
                           Case{line, make_convex(Polygon{sharp}).value(), turned}};
    for (const Case& c : cases) {
        INFO("case " << &c - cases.data());
        const double expected = separation(rounded_hull(c.a), rounded_hull(c.b, c.b_in_a)).distance;
        const Manifold ab = collide(c.a, c.b, c.b_in_a, kReach_m);
        const Manifold ba = collide(c.b, c.a, inverse(c.b_in_a), kReach_m);
        REQUIRE(ab.count > 0);
        REQUIRE(ba.count > 0);
        const Approx depth = Approx(expected).margin(kFaceTolerance_m).epsilon(0);
        CHECK(static_cast<double>(least_separation(ab)) == depth);
        CHECK(static_cast<double>(least_separation(ba)) == depth);
    }
}

TEST_CASE("cores at any small distance or overlap have their true depth") {
    Random random(8);
    for_each_pair_of_forms([&](Form form_a, Form form_b) {
        if (form_a == Form::Circle && form_b == Form::Circle) return;
        for (int round = 0; round < 300; ++round) {
            Pair pair = random_pair(random, form_a, form_b, 0);
            const float radii = pair.a.radius() + pair.b.radius();
            const Vec2 normal{static_cast<float>(pair.expected.normal.x),
                              static_cast<float>(pair.expected.normal.y)};
            pair.b_in_a.p -= (radii + random.real_f(-1e-3, 1e-3)) * normal;
            const Separation expected = separation(rounded_hull(pair.a), rounded_hull(pair.b, pair.b_in_a));
            const Manifold m = collide(pair.a, pair.b, pair.b_in_a, kReach_m);
            INFO("round " << round << ", distance " << expected.distance << ", radii " << radii);
            REQUIRE(m.count > 0);
            REQUIRE(static_cast<double>(least_separation(m)) ==
                    Approx(expected.distance).margin(kFaceTolerance_m + 2e-6).epsilon(0));
        }
    });
}

TEST_CASE("a disc whose centre all but lies on a line is pushed off it, and not along it") {
    const Convex disc = make_convex(Circle{{}, 0.5f}).value();
    Random random(9);
    for (int round = 0; round < 1'000; ++round) {
        const Vec2 a = random.vector(-2, 2);
        const Convex line = make_convex(Segment{a, a + random.vector(0.5, 2)}).value();
        const float along = random.real_f(0.1, 0.9);
        const Vec2 center = line.point(0) + along * (line.point(1) - line.point(0));
        const Manifold m = collide(line, disc, {center, {}}, kReach_m);
        INFO("round " << round);
        REQUIRE(m.count == 1);
        REQUIRE(std::fabs(dot(m.normal, line.normals[0])) > 0.999f);
    }
}

}  // namespace cairn::physics
