// Places in lanes against places read one by one; and what is called apart, or not passed, against motions
// that are followed in many small steps.
#include "collide/place_lanes.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <cairn/physics/simd.h>
#include <cairn/physics/tuning.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr int kBodies = 40;
constexpr float kDt_s = 1.0f / 60;

// Bodies far from the origin, some of them not awake; lanes that name two of them each.
struct Crowd {
    explicit Crowd(std::uint64_t seed) : random(seed) {
        for (int body = 0; body < kBodies; ++body) {
            Place& place = places.emplace_back();
            place.center = Position{1e6, -3e5} + random.vector(-3, 3);
            place.rotation = Rotation::from_angle(random.real(-3, 3));
            place.row = body % 5 == 0 ? 0 : body + 1;
            place.flags = static_cast<std::uint32_t>(random.below(8));
            if (random.chance(0.5)) place.flags |= place_flag::kHasty;
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            body_a[lane] = random.below(kBodies);
            body_b[lane] = random.below(kBodies);
        }
        lanes = static_cast<unsigned>(random.below(1 << kLanes));
        // What is not wanted need not be a body.
        for (int lane = 0; lane < kLanes; ++lane) {
            if ((lanes >> lane & 1) == 0) body_a[lane] = body_b[lane] = -1;
        }
    }

    Random random;
    std::vector<Place> places;
    alignas(32) Lanes<std::int32_t> body_a{};
    alignas(32) Lanes<std::int32_t> body_b{};
    unsigned lanes = 0;
};

using NearPairs = std::array<NearPair, kLanes>;

NearPairs near_pairs(const Lanes<std::int32_t>& body_a, const Lanes<std::int32_t>& body_b) {
    NearPairs pairs;
    for (int lane = 0; lane < kLanes; ++lane) {
        pairs[lane].body_a = body_a[lane];
        pairs[lane].body_b = body_b[lane];
    }
    return pairs;
}

template <class Check>
void at_every_level(Check&& check) {
    for (const SimdLevel level : available_simd_levels()) {
        INFO(name(level));
        force_simd_level(level).value();
        check();
    }
    force_simd_level(available_simd_levels().back()).value();
}

// The point of a body at `arm` from its centre, `share` of the step later, as seen from where the centre was.
Vec2 moved_point(const Displacement& d, Vec2 arm, float angle, float share) {
    return share * d.moved + rotate(Rotation::from_angle(static_cast<double>(share * angle)), arm);
}

}  // namespace

TEST_CASE("places in lanes are those of the bodies, and lanes that nobody wants are far apart") {
    at_every_level([] {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const Crowd crowd(seed);
            BlockPlaces found;
            load_places(crowd.places.data(), crowd.body_a, crowd.body_b, crowd.lanes, found);
            unsigned hasty = 0;
            unsigned turn_far = 0;
            unsigned boxes_moved = 0;
            for (int lane = 0; lane < kLanes; ++lane) {
                if ((crowd.lanes >> lane & 1) == 0) {
                    REQUIRE(found.poses.dx[lane] >= 1e9f);
                    REQUIRE(found.row_a[lane] == 0);
                    REQUIRE(found.row_b[lane] == 0);
                    continue;
                }
                const Place& a = crowd.places[crowd.body_a[lane]];
                const Place& b = crowd.places[crowd.body_b[lane]];
                const Vec2 between = b.center - a.center;
                REQUIRE(found.poses.dx[lane] == between.x);
                REQUIRE(found.poses.dy[lane] == between.y);
                REQUIRE(found.poses.cos_a[lane] == a.rotation.c);
                REQUIRE(found.poses.sin_a[lane] == a.rotation.s);
                REQUIRE(found.poses.cos_b[lane] == b.rotation.c);
                REQUIRE(found.poses.sin_b[lane] == b.rotation.s);
                REQUIRE(found.row_a[lane] == a.row);
                REQUIRE(found.row_b[lane] == b.row);
                const std::uint32_t flags = a.flags | b.flags;
                hasty |= (flags & place_flag::kHasty) != 0 ? 1u << lane : 0;
                turn_far |= (flags & place_flag::kTurnsFar) != 0 ? 1u << lane : 0;
                boxes_moved |= (flags & place_flag::kBoxesMoved) != 0 ? 1u << lane : 0;
            }
            REQUIRE(found.hasty == hasty);
            REQUIRE(found.turn_far == turn_far);
            REQUIRE(found.boxes_moved == boxes_moved);
        }
    });
}

TEST_CASE("pairs are called apart when their discs are, for the whole step if one of them is hasty") {
    at_every_level([] {
        int close = 0;
        int apart = 0;
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            Crowd crowd(seed);
            std::vector<Advance> advances(kBodies + 1);
            for (std::size_t row = 1; row < advances.size(); ++row)
                advances[row].velocity_m_s = crowd.random.vector(-100, 100);
            NearPairs pairs = near_pairs(crowd.body_a, crowd.body_b);
            unsigned remembers = 0;
            for (int lane = 0; lane < kLanes; ++lane) {
                pairs[lane].reach_m = crowd.random.real_f(0, 3);
                if (crowd.random.chance(0.5)) continue;
                pairs[lane].flags = near_flag::kRemembers;
                remembers |= 1u << lane;
            }
            const NearLanes found =
                look_near(crowd.places.data(), pairs.data(), advances.data(), kDt_s, crowd.lanes);
            REQUIRE((found.close & ~crowd.lanes) == 0);
            REQUIRE(found.remembers == (remembers & crowd.lanes));
            for (int lane = 0; lane < kLanes; ++lane) {
                if ((crowd.lanes >> lane & 1) == 0) continue;
                const Place& a = crowd.places[crowd.body_a[lane]];
                const Place& b = crowd.places[crowd.body_b[lane]];
                const bool hasty = ((a.flags | b.flags) & place_flag::kHasty) != 0;
                const Vec2 velocity = advances[b.row].velocity_m_s - advances[a.row].velocity_m_s;
                float least = length(b.center - a.center);
                for (int i = 1; hasty && i <= 64; ++i) {
                    const float time_s = kDt_s * static_cast<float>(i) / 64;
                    least = std::min(least, length((b.center - a.center) + time_s * velocity));
                }
                const bool is_close = (found.close >> lane & 1) != 0;
                const bool come_near = least - pairs[lane].reach_m < tuning::kSpeculativeDistance_m - 1e-5f;
                if (come_near) REQUIRE(is_close);
                // Of what does not move, nothing else is close.
                const bool far = least - pairs[lane].reach_m > tuning::kSpeculativeDistance_m + 1e-5f;
                if (far && !hasty) REQUIRE_FALSE(is_close);
                (is_close ? close : apart) += 1;
            }
        }
        CHECK(close > 300);
        CHECK(apart > 300);
    });
}

TEST_CASE("a pair that was seen apart is called close before its points are, wherever its bodies went") {
    at_every_level([] {
        int close = 0;
        int apart = 0;
        for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
            Crowd crowd(seed);
            Random& random = crowd.random;
            BlockPlaces before;
            load_places(crowd.places.data(), crowd.body_a, crowd.body_b, crowd.lanes, before);
            // A shape is one point of its body, which may be far from the centre.
            std::vector<Vec2> arms;
            for (int body = 0; body < kBodies; ++body) arms.push_back(random.vector(-2, 2));
            const auto point = [&](int body) {
                const Place& place = crowd.places[body];
                return place.center + rotate(place.rotation, arms[body]);
            };
            NearPairs pairs = near_pairs(crowd.body_a, crowd.body_b);
            for (int lane = 0; lane < kLanes; ++lane) {
                if ((crowd.lanes >> lane & 1) == 0) continue;
                const int a = crowd.body_a[lane];
                const int b = crowd.body_b[lane];
                pairs[lane].reach_m = length(arms[a]) + length(arms[b]);
                pairs[lane].sight = make_sight(before.poses, lane, length(point(b) - point(a)));
                pairs[lane].flags = near_flag::kSeen;
            }
            // All go a long way together, and some of it each by themselves.
            const float own = random.real_f(0, 0.5f);
            const Position about = crowd.places[0].center;
            const Rotation turn = Rotation::from_angle(random.real(-3, 3));
            std::vector<Advance> advances(kBodies + 1);
            for (Place& place : crowd.places) {
                place.center = about + rotate(turn, place.center - about) + random.vector(-own, own);
                place.rotation = turn * Rotation::from_angle(random.real(-own, own)) * place.rotation;
            }
            std::vector<float> spins(kBodies + 1);
            for (int body = 0; body < kBodies; ++body) {
                const int row = crowd.places[body].row;
                if (row == 0) continue;
                spins[row] = 20 * random.real_f(-own, own);
                advances[row] = {random.vector(-40 * own, 40 * own),
                                 std::fabs(spins[row]) * length(arms[body])};
            }
            const NearLanes found =
                look_near(crowd.places.data(), pairs.data(), advances.data(), kDt_s, crowd.lanes);
            for (int lane = 0; lane < kLanes; ++lane) {
                if ((crowd.lanes >> lane & 1) == 0) continue;
                const Place& a = crowd.places[crowd.body_a[lane]];
                const Place& b = crowd.places[crowd.body_b[lane]];
                const bool hasty = ((a.flags | b.flags) & place_flag::kHasty) != 0;
                const auto way = [&](int body, float share) {
                    const Place& place = crowd.places[body];
                    const Displacement moved{.moved = kDt_s * advances[place.row].velocity_m_s};
                    return moved_point(moved, rotate(place.rotation, arms[body]), kDt_s * spins[place.row],
                                       share);
                };
                float least = std::numeric_limits<float>::infinity();
                for (int i = 0; i <= (hasty ? 64 : 0); ++i) {
                    const float share = static_cast<float>(i) / 64;
                    least = std::min(least, length((b.center - a.center) + way(crowd.body_b[lane], share) -
                                                   way(crowd.body_a[lane], share)));
                }
                const bool is_close = (found.close >> lane & 1) != 0;
                if (least < tuning::kSpeculativeDistance_m) REQUIRE(is_close);
                (is_close ? close : apart) += 1;
            }
        }
        CHECK(close > 300);
        CHECK(apart > 300);
    });
}

TEST_CASE("what moves along with its neighbour is not looked at again") {
    at_every_level([] {
        std::vector<Place> places(2, Place{.flags = place_flag::kHasty});
        places[1].center = {1, 0};
        alignas(32) const Lanes<std::int32_t> body_a{};
        alignas(32) const Lanes<std::int32_t> body_b{1, 1, 1, 1, 1, 1, 1, 1};
        const std::vector<Advance> advances(1);
        BlockPlaces found;
        load_places(places.data(), body_a, body_b, 255, found);
        NearPairs pairs = near_pairs(body_a, body_b);
        for (int lane = 0; lane < kLanes; ++lane) {
            pairs[lane].reach_m = 3;  // their discs overlap
            pairs[lane].sight = make_sight(found.poses, lane, 2 * tuning::kSpeculativeDistance_m);
        }
        const auto close = [&](unsigned seen) {
            for (int lane = 0; lane < kLanes; ++lane)
                pairs[lane].flags = (seen >> lane & 1) != 0 ? near_flag::kSeen : 0;
            return look_near(places.data(), pairs.data(), advances.data(), kDt_s, 255).close;
        };
        CHECK(close(0) == 255);
        CHECK(close(5) == 250);
        const Rotation turn = Rotation::from_angle(2);
        for (Place& place : places) {
            place.center = Position{300, -700} + rotate(turn, place.center - Position{});
            place.rotation = turn;
        }
        CHECK(close(255) == 0);
        places[1].center = places[1].center + Vec2{1.1f * tuning::kSpeculativeDistance_m, 0};
        CHECK(close(255) == 255);
    });
}

TEST_CASE("two bodies in the same place are close") {
    at_every_level([] {
        const std::vector<Place> places(2, Place{.flags = place_flag::kHasty});
        const std::vector<Advance> advances(1);
        alignas(32) const Lanes<std::int32_t> body_a{};
        alignas(32) const Lanes<std::int32_t> body_b{1, 1, 1, 1, 1, 1, 1, 1};
        const NearPairs pairs = near_pairs(body_a, body_b);
        CHECK(look_near(places.data(), pairs.data(), advances.data(), kDt_s, 255).close == 255);
    });
}

TEST_CASE("a shape's centre that gets into the other body's disc is among what may have passed") {
    at_every_level([] {
        int passed = 0;
        int spared = 0;
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            Crowd crowd(seed);
            std::vector<Displacement> displacements(kBodies + 1);
            std::vector<float> angles(kBodies + 1);
            for (std::size_t row = 1; row < displacements.size(); ++row) {
                Displacement& d = displacements[row];
                d.moved = crowd.random.vector(-2, 2);
                angles[row] = crowd.random.real_f(-1, 1);
                d.chord = 2 * std::fabs(std::sin(0.5f * angles[row]));
                d.extent_m = crowd.random.real_f(0.1, 1);
                d.arm_m = crowd.random.real_f(0, 0.5);
                d.least_way_m = crowd.random.real_f(0, 0.2);
            }
            const unsigned found = find_passed(crowd.places.data(), crowd.body_a, crowd.body_b,
                                               displacements.data(), crowd.lanes);
            REQUIRE((found & ~crowd.lanes) == 0);
            const auto meets = [&](const Place& one, const Place& other, float direction) {
                const Displacement& d = displacements[one.row];
                const Displacement& e = displacements[other.row];
                const Vec2 apart = (other.center - one.center) - (e.moved - d.moved);
                const Vec2 arm =
                    d.arm_m * rotate(Rotation::from_angle(static_cast<double>(direction)), Vec2{1, 0});
                bool inside = false;
                for (int i = 0; i <= 64; ++i) {
                    const float share = static_cast<float>(i) / 64;
                    const Vec2 at = moved_point(d, arm, angles[one.row], share);
                    const Vec2 from_other = at - (apart + share * e.moved);
                    inside |= length(from_other) < e.extent_m - 1e-4f;
                }
                return inside &&
                       length(moved_point(d, arm, angles[one.row], 1) - arm) > d.least_way_m + 1e-4f;
            };
            for (int lane = 0; lane < kLanes; ++lane) {
                if ((crowd.lanes >> lane & 1) == 0) continue;
                const Place& a = crowd.places[crowd.body_a[lane]];
                const Place& b = crowd.places[crowd.body_b[lane]];
                const bool fast = ((a.flags | b.flags) & place_flag::kFast) != 0;
                const bool is_found = (found >> lane & 1) != 0;
                if (!fast) REQUIRE_FALSE(is_found);
                (is_found ? passed : spared) += 1;
                if (!fast || a.row == 0 || b.row == 0 || a.row == b.row) continue;
                // As seen from the other, the way may be short although each moved far; such pairs are no
                // ground for a check.
                const Vec2 relative = displacements[b.row].moved - displacements[a.row].moved;
                if (length(relative) < 0.5f) continue;
                for (int i = 0; i < 8; ++i) {
                    const float direction = 0.8f * static_cast<float>(i);
                    if (meets(a, b, direction) || meets(b, a, direction)) REQUIRE(is_found);
                }
            }
        }
        CHECK(passed > 300);
        CHECK(spared > 300);
    });
}

}  // namespace cairn::physics
