// Preparation of blocks against make_contact, one contact at a time.
#include "resolve/prepare_kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/simd.h>
#include <cairn/physics/tuning.h>

#include "physics/support/random.h"
#include "resolve/contact_constraint.h"
#include "resolve/contact_kernels.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kFarApart_m = 1e9f;
// Borders of decisions are not looked at from nearer than this.
constexpr float kBorder = 1e-5f;

// Row 0 is the world; then bodies that nothing moves, bodies that do not turn, and free ones.
constexpr int kFirstMovable = 5;
constexpr int kFirstFree = 10;
constexpr int kRows = 40;

struct Prepared {
    PoseLanes poses{};
    ManifoldLanes manifold{};
    FeatureLanes old_features{};
    ContactBlock before{};
    FeatureLanes features{};
    ContactBlock block{};
    ImpactLanes impacts{};
    PreparedLanes bits;
};

Motions make_motions(Random& random) {
    Motions motions;
    motions.add({}, 0, 0, 0);
    while (motions.size() < kRows) {
        const double speed = random.chance(0.5) ? 0.2 : 3;
        const Vec2 v = random.vector(-speed, speed);
        const float w = random.real_f(-speed, speed);
        const float inverse_mass = random.real_f(0.1, 4);
        const float inverse_inertia = random.real_f(0.1, 9);
        const bool moves = motions.size() >= kFirstMovable;
        const bool turns = motions.size() >= kFirstFree;
        motions.add(v, moves && !turns ? 0 : w, moves ? inverse_mass : 0, turns ? inverse_inertia : 0);
    }
    return motions;
}

// Ids from so small a set that they often meet.
std::array<std::int32_t, 2> two_features(Random& random) {
    const std::int32_t first = 16 * random.below(3);
    return {first, first + 1 + random.below(2)};
}

void fill_used(Random& random, Prepared& p, int lane, int count) {
    p.before.a[lane] = random.chance(0.3) ? kWorldRow : random.below(kRows);
    do {
        p.before.b[lane] = kFirstMovable + random.below(kRows - kFirstMovable);
    } while (p.before.b[lane] == p.before.a[lane]);
    const Vec2 between = random.vector(-1, 1);
    p.poses.dx[lane] = between.x;
    p.poses.dy[lane] = between.y;
    const Rotation q = Rotation::from_angle(random.real(-4, 4));
    p.manifold.normal_x[lane] = q.c;
    p.manifold.normal_y[lane] = q.s;
    // Half the contacts lie on the line between the centres, as those of discs do.
    const Vec2 middle = random.chance(0.5) ? random.vector(-0.5, 0.5) : random.real_f(-1, 1) * Vec2{q.c, q.s};
    const float width = random.chance(0.5) ? 0.002f : 0.4f;
    const std::array<std::int32_t, 2> ids = two_features(random);
    for (int i = 0; i < 2; ++i) {
        const Vec2 at = middle + (i == 0 ? -width : width) * right_perp({q.c, q.s});
        p.manifold.points[i].x[lane] = at.x;
        p.manifold.points[i].y[lane] = at.y;
        p.manifold.points[i].separation[lane] = random.chance(0.1) ? 0 : random.real_f(-0.01, 0.02);
        p.manifold.points[i].id[lane] = i < count ? ids[i] : kNoFeature;
    }
}

// As the narrow phase leaves lanes that have no pair.
void fill_empty(Prepared& p, int lane) {
    p.before.a[lane] = p.before.b[lane] = kWorldRow;
    p.poses.dx[lane] = kFarApart_m;
    p.manifold.normal_x[lane] = 1;
    for (ManifoldPointLanes& point : p.manifold.points) {
        point.x[lane] = point.y[lane] = point.separation[lane] = kFarApart_m;
        point.id[lane] = kNoFeature;
    }
}

void fill_memory(Random& random, Prepared& p, int lane) {
    const int count = random.below(3);
    const std::array<std::int32_t, 2> ids = two_features(random);
    for (int i = 0; i < 2; ++i) {
        p.old_features[i][lane] = i < count ? ids[i] : kNoFeature;
        p.before.points[i].impulse[lane] = i < count ? random.real_f(0, 1) : 0;
        // Left by the last step, and to be overwritten.
        p.before.points[i].static_impulse[lane] = random.real_f(0, 1);
        p.before.total_impulse[i][lane] = random.real_f(0, 1);
    }
    p.before.friction[lane] = random.real_f(0, 1);
    p.before.friction_impulse[lane] = random.real_f(-1, 1);
}

void prepare(Prepared& p, const Motions& motions) {
    p.block = p.before;
    p.features = p.old_features;
    p.bits = prepare_block(p.poses, p.manifold, motions.velocity.data(), motions.pose.data(), p.features, 1,
                           p.block, &p.impacts);
}

// A block of which the lanes have two points, one, none, or are empty.
Prepared make_prepared(Random& random, const Motions& motions) {
    Prepared p;
    for (int lane = 0; lane < kLanes; ++lane) {
        if (random.chance(0.15)) {
            fill_empty(p, lane);
        } else {
            fill_used(random, p, lane, random.chance(0.15) ? 0 : 1 + random.below(2));
        }
        fill_memory(random, p, lane);
    }
    prepare(p, motions);
    return p;
}

int count_points(const Prepared& p, int lane) {
    return (p.manifold.points[0].id[lane] != kNoFeature ? 1 : 0) +
           (p.manifold.points[1].id[lane] != kNoFeature ? 1 : 0);
}

ContactConstraint scalar_form(const Prepared& p, const Motions& motions, int lane) {
    ContactInput input{};
    input.a = p.before.a[lane];
    input.b = p.before.b[lane];
    input.normal = {p.manifold.normal_x[lane], p.manifold.normal_y[lane]};
    input.count = count_points(p, lane);
    const Vec2 between{p.poses.dx[lane], p.poses.dy[lane]};
    for (int i = 0; i < input.count; ++i) {
        const ManifoldPointLanes& from = p.manifold.points[i];
        const Vec2 r_a{from.x[lane], from.y[lane]};
        input.points[i] = {r_a, r_a - between, from.separation[lane], from.id[lane], 0};
    }
    return make_contact(input, motions, make_contact_rules(1.0f / 240, 3, 1));
}

template <class Visit>  // visit(motions, prepared, lane), for lanes with points
void for_each_contact(unsigned seed, Visit&& visit) {
    Random random(seed);
    for (int round = 0; round < 400; ++round) {
        const Motions motions = make_motions(random);
        const Prepared p = make_prepared(random, motions);
        for (int lane = 0; lane < kLanes; ++lane) {
            if (count_points(p, lane) > 0) visit(motions, p, lane);
        }
    }
}

auto approx(float expected) {
    return Approx(static_cast<double>(expected)).margin(3e-6).epsilon(1e-5);
}

std::vector<std::uint32_t> bits_of(const Prepared& p) {
    std::vector<std::uint32_t> bits{p.bits.apart, p.bits.swings};
    const auto add = [&](const auto& lanes) {
        for (const auto x : lanes) bits.push_back(std::bit_cast<std::uint32_t>(x));
    };
    add(p.block.normal_x);
    add(p.block.normal_y);
    for (int i = 0; i < 2; ++i) {
        const ContactBlockPoint& point = p.block.points[i];
        for (const auto* lanes : {&point.arm_a, &point.arm_b, &point.mass, &point.start_separation,
                                  &point.separation, &point.static_impulse, &point.impulse}) {
            add(*lanes);
        }
        add(p.block.total_impulse[i]);
        add(p.features[i]);
    }
    for (const auto* lanes : {&p.block.tangent_arm_a, &p.block.tangent_arm_b, &p.block.tangent_mass,
                              &p.block.friction, &p.block.friction_impulse}) {
        add(*lanes);
    }
    return bits;
}

}  // namespace

TEST_CASE("arms and masses of lanes are those of the scalar form") {
    int compared = 0;
    for_each_contact(1, [&](const Motions& motions, const Prepared& p, int lane) {
        ++compared;
        const ContactConstraint c = scalar_form(p, motions, lane);
        const float k_a = motions.pose[c.a].k;
        const float k_b = motions.pose[c.b].k;
        REQUIRE(p.block.normal_x[lane] == c.normal.x);
        REQUIRE(p.block.normal_y[lane] == c.normal.y);
        for (int i = 0; i < c.count; ++i) {
            const ContactBlockPoint& point = p.block.points[i];
            REQUIRE(point.arm_a[lane] == approx(k_a * cross(c.points[i].r_a, c.normal)));
            REQUIRE(point.arm_b[lane] == approx(k_b * cross(c.points[i].r_b, c.normal)));
            REQUIRE(point.mass[lane] == approx(c.points[i].normal_mass));
            REQUIRE(point.start_separation[lane] == c.points[i].separation);
            REQUIRE(point.separation[lane] == c.points[i].separation);
            REQUIRE(point.static_impulse[lane] == 0);
            REQUIRE(p.block.total_impulse[i][lane] == 0);
        }
        const Vec2 tangent = right_perp(c.normal);
        REQUIRE(p.block.tangent_arm_a[lane] == approx(k_a * cross(c.friction_r_a, tangent)));
        REQUIRE(p.block.tangent_arm_b[lane] == approx(k_b * cross(c.friction_r_b, tangent)));
        REQUIRE(p.block.tangent_mass[lane] == approx(c.tangent_mass));
        REQUIRE(p.block.friction[lane] == p.before.friction[lane]);
    });
    CHECK(compared > 2000);
}

TEST_CASE("a point that was there in the last step starts with its impulse, whichever of the two it was") {
    int found = 0;
    for_each_contact(2, [&](const Motions&, const Prepared& p, int lane) {
        for (int i = 0; i < 2; ++i) {
            const std::int32_t id = p.manifold.points[i].id[lane];
            REQUIRE(p.features[i][lane] == id);
            if (id == kNoFeature) continue;
            for (int old = 0; old < 2; ++old) {
                if (p.old_features[old][lane] != id) continue;
                ++found;
                REQUIRE(p.block.points[i].impulse[lane] == p.before.points[old].impulse[lane]);
            }
        }
    });
    CHECK(found > 400);
}

TEST_CASE("a new point that is closed and at rest starts with an unknown impulse, any other with none") {
    int unknown = 0;
    int none = 0;
    for_each_contact(3, [&](const Motions& motions, const Prepared& p, int lane) {
        const ContactConstraint c = scalar_form(p, motions, lane);
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& point = c.points[i];
            if (point.feature == p.old_features[0][lane] || point.feature == p.old_features[1][lane])
                continue;
            const float speed = std::fabs(point.closing_velocity);
            if (std::fabs(speed - kRestSpeed_m_s) < kBorder) continue;
            const bool rests = point.separation <= 0.1f * tuning::kLinearSlop_m && speed < kRestSpeed_m_s;
            REQUIRE(p.block.points[i].impulse[lane] == (rests ? kUnknownImpulse : 0));
            ++(rests ? unknown : none);
        }
    });
    CHECK(unknown > 200);
    CHECK(none > 1000);
}

TEST_CASE("closing velocities are noted where a lane of the block bounces") {
    Random random(8);
    int noted = 0;
    for (int round = 0; round < 200; ++round) {
        const Motions motions = make_motions(random);
        Prepared p = make_prepared(random, motions);
        for (const auto& velocities : p.impacts.closing_velocity) {
            REQUIRE(std::ranges::all_of(velocities, [](float v) { return v == 0; }));
        }
        // One of four: lanes stand in one register, or in several.
        for (std::size_t lane = 0; lane < kLanes; lane += 4) p.impacts.restitution[lane] = 0.1f;
        prepare(p, motions);
        for (std::size_t lane = 0; lane < kLanes; lane += 4) {
            const ContactConstraint c = scalar_form(p, motions, static_cast<int>(lane));
            for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
                const auto expected = static_cast<double>(c.points[i].closing_velocity);
                REQUIRE(static_cast<double>(p.impacts.closing_velocity[i][lane]) ==
                        Approx(expected).margin(1e-5));
                ++noted;
            }
        }
    }
    CHECK(noted > 100);
}

TEST_CASE(
    "friction is remembered while a point of the last step is there, and dropped with the last of them") {
    int kept = 0;
    int dropped = 0;
    for_each_contact(4, [&](const Motions&, const Prepared& p, int lane) {
        bool any = false;
        for (const ManifoldPointLanes& point : p.manifold.points) {
            const std::int32_t id = point.id[lane];
            any =
                any || (id != kNoFeature && (id == p.old_features[0][lane] || id == p.old_features[1][lane]));
        }
        REQUIRE(p.block.friction_impulse[lane] == (any ? p.before.friction_impulse[lane] : 0));
        ++(any ? kept : dropped);
    });
    CHECK(kept > 400);
    CHECK(dropped > 400);
}

TEST_CASE("bits say which lanes have no points, and which have points beside the line between the centres") {
    Random random(5);
    int apart = 0;
    int swinging = 0;
    int steady = 0;
    for (int round = 0; round < 400; ++round) {
        const Motions motions = make_motions(random);
        const Prepared p = make_prepared(random, motions);
        REQUIRE((p.bits.apart >> kLanes) == 0);
        for (int lane = 0; lane < kLanes; ++lane) {
            const int count = count_points(p, lane);
            REQUIRE((p.bits.apart >> lane & 1) == (count == 0 ? 1 : 0));
            apart += count == 0 ? 1 : 0;
            const ContactConstraint c = scalar_form(p, motions, lane);
            float lever = 0;  // m
            for (int i = 0; i < count; ++i) {
                lever = std::max({lever, std::fabs(cross(c.points[i].r_a, c.normal)),
                                  std::fabs(cross(c.points[i].r_b, c.normal))});
            }
            if (std::fabs(lever - tuning::kLinearSlop_m) < kBorder) continue;
            const bool swings = lever > tuning::kLinearSlop_m;
            REQUIRE((p.bits.swings >> lane & 1) == (swings ? 1 : 0));
            ++(swings ? swinging : steady);
        }
    }
    CHECK(apart > 400);
    CHECK(swinging > 400);
    CHECK(steady > 400);
}

TEST_CASE("lanes and points without a contact do nothing") {
    Random random(6);
    const ContactPassTime time{make_soft(30, 10, 1.0f / 240), 240, 3};
    for (int round = 0; round < 100; ++round) {
        Motions motions = make_motions(random);
        Prepared p;
        for (int lane = 0; lane < kLanes; ++lane) {
            // Pairs that have parted keep their rows; none of them stands in two lanes.
            if (random.chance(0.5)) {
                fill_empty(p, lane);
            } else {
                fill_used(random, p, lane, 0);
                p.before.a[lane] = kFirstMovable + 2 * lane;
                p.before.b[lane] = kFirstMovable + 2 * lane + 1;
            }
            fill_memory(random, p, lane);
        }
        prepare(p, motions);
        for (int lane = 0; lane < kLanes; ++lane) {
            for (const ContactBlockPoint& point : p.block.points) {
                REQUIRE(point.arm_a[lane] == 0);
                REQUIRE(point.arm_b[lane] == 0);
                REQUIRE(point.mass[lane] == 0);
                REQUIRE(point.impulse[lane] == 0);
                REQUIRE(point.static_impulse[lane] == 0);
                REQUIRE(point.separation[lane] > 0);
            }
            REQUIRE(p.block.tangent_arm_a[lane] == 0);
            REQUIRE(p.block.tangent_arm_b[lane] == 0);
            REQUIRE(p.block.tangent_mass[lane] == 0);
            REQUIRE(p.block.friction_impulse[lane] == 0);
        }
        const std::vector<VelocityRow> before = motions.velocity;
        const std::array<ContactBlock*, 1> first{&p.block};
        warm_start_blocks({first}, motions.velocity.data(), 1.2f, 1.2f);
        solve_blocks({first}, motions.velocity.data(), time);
        relax_blocks({first}, motions.velocity.data(), motions.pose.data(), time);
        for (int row = 0; row < kRows; ++row) {
            REQUIRE(motions.velocity[row].v == before[row].v);
            REQUIRE(motions.velocity[row].w == before[row].w);
            REQUIRE(motions.velocity[row].inverse_mass == before[row].inverse_mass);
        }
    }
}

TEST_CASE("every SIMD level prepares the same bits") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    REQUIRE(!levels.empty());
    Random random(7);
    for (int round = 0; round < 100; ++round) {
        const Motions motions = make_motions(random);
        Prepared p = make_prepared(random, motions);
        const std::vector<std::uint32_t> best = bits_of(p);
        for (const SimdLevel level : levels) {
            force_simd_level(level).value();
            prepare(p, motions);
            force_simd_level(levels.back()).value();
            CAPTURE(name(level));
            REQUIRE(bits_of(p) == best);
        }
    }
}

}  // namespace cairn::physics
