// What eight bodies do at once against the formulas, body by body.
#include "world/body_lanes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/random.h"
#include "world/fast_bodies.h"

namespace cairn::physics {
namespace {

using test::Random;

constexpr float kDt_s = 1.0f / 60;
constexpr int kBodies = 19;  // two full eights, and three

struct Crowd {
    BodyStore bodies{1};
    Motions motions;
    std::vector<Advance> advances;

    explicit Crowd(Random& random) {
        motions.add({}, 0, 0, 0);
        advances.push_back({});
        for (int i = 0; i < kBodies; ++i) {
            BodyRecord record;
            record.type = random.chance(0.2) ? BodyType::Kinematic : BodyType::Dynamic;
            // Dynamic bodies may be of infinite mass, too.
            const bool has_mass = record.type == BodyType::Dynamic && random.chance(0.8);
            record.allow_sleep = random.chance(0.7);
            record.inverse_mass = has_mass ? random.real_f(0.1, 10) : 0;
            record.inverse_inertia = has_mass ? random.real_f(0.1, 10) : 0;
            record.extent_m = random.chance(0.2) ? 0.001f : random.real_f(0.1, 2);
            record.turn_arm_m = random.real_f(0, 1) * record.extent_m;
            record.inner_radius_m = random.real_f(0.05, 0.5) * record.extent_m;
            record.gravity_scale = random.real_f(-1, 2);
            record.sleep_speed_m_s = 0.05f;
            const int body = bodies.slots.insert(record);
            bodies.add_row(body, RowSet::Awake);
            Place& place = bodies.places[static_cast<std::size_t>(body)];
            place.center = {random.real(-9, 9), random.real(-9, 9)};
            place.rotation = Rotation::from_angle(random.real(-3, 3));
            const bool is_slow = random.chance(0.5);
            const double speed = is_slow ? 0.04 : 20;
            BodyRows& rows = bodies.rows(RowSet::Awake);
            rows.velocity[static_cast<std::size_t>(i)] = random.vector(-speed, speed);
            rows.spin[static_cast<std::size_t>(i)] = random.real_f(-2 * speed, 2 * speed);
            rows.rest_time[static_cast<std::size_t>(i)] = random.real_f(0, 1);
            rows.force[static_cast<std::size_t>(i)] = random.vector(-1, 1);
            rows.torque[static_cast<std::size_t>(i)] = random.real_f(-1, 1);
            rows.box_slack[static_cast<std::size_t>(i)] = random.real_f(0, 0.3);
            if (random.chance(0.6)) place.flags |= place_flag::kHasty;
            if (random.chance(0.6) && (place.flags & place_flag::kHasty) != 0)
                place.flags |= place_flag::kFast;
            motions.add(random.vector(-speed, speed), random.real_f(-speed, speed), record.inverse_mass,
                        record.inverse_inertia);
            motions.pose.back().d = kDt_s * random.vector(-speed, speed);
            motions.pose.back().theta = kDt_s * random.real_f(-2 * speed, 2 * speed);
            advances.push_back({random.vector(-speed, speed)});
        }
    }
};

TEST_CASE("what a step is expected to do with bodies, eight at once") {
    const Vec2 gravity{1, -10};
    constexpr float kSeen_m = 0.02f;
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Random random(3);
        Crowd crowd(random);
        const BodyRows& awake = crowd.bodies.rows(RowSet::Awake);
        for (int first = 0; first < kBodies; first += kLanes) {
            const BodyLanes lanes = body_lanes(crowd.bodies, first, kBodies);
            REQUIRE(lanes.count == std::min(kLanes, kBodies - first));
            AheadLanes ahead;
            look_ahead(crowd.bodies, lanes, gravity, kDt_s, kSeen_m, ahead);
            for (int lane = 0; lane < lanes.count; ++lane) {
                const auto row = static_cast<std::size_t>(first + lane);
                const BodyRecord& record = crowd.bodies.slots[awake.body[row]];
                const Vec2 falling =
                    record.inverse_mass > 0 ? 0.5f * kDt_s * record.gravity_scale * gravity : Vec2{};
                const Vec2 velocity = awake.velocity[row] + falling;
                const float turning = std::fabs(awake.spin[row]) * record.turn_arm_m;
                const float farthest = kDt_s * (length(velocity) + turning);
                INFO(name(level) << ", row " << row);
                CHECK(ahead.advances[lane].velocity_m_s == velocity);
                CHECK(ahead.advances[lane].turning_m_s == turning);
                const float calm_way = std::min(0.5f * record.inner_radius_m, 0.03f);
                CHECK(ahead.advances[lane].calm_way_m == calm_way);
                CHECK((ahead.hasty >> lane & 1) == (farthest > calm_way ? 1 : 0));
                CHECK((ahead.fast >> lane & 1) == (farthest > 0.5f * record.inner_radius_m ? 1 : 0));
                CHECK((ahead.seen_late >> lane & 1) == (farthest > kSeen_m ? 1 : 0));
                CHECK((ahead.far_ways >> lane & 1) == (kDt_s * length(velocity) > record.extent_m ? 1 : 0));
                CHECK(Vec2{ahead.way_x[lane], ahead.way_y[lane]} == kDt_s * velocity);
                CHECK(ahead.turn[lane] == kDt_s * awake.spin[row]);
                CHECK(ahead.rounding[lane] == 1e-6f * (length(kDt_s * velocity) + record.extent_m));
                // The arc of the farthest point is this far from its chord, and float loses what it loses.
                const float bulge = record.turn_arm_m * (1 - std::cos(0.5f * ahead.turn[lane]));
                const float room = ahead.room[lane] - ahead.rounding[lane];
                CHECK(room >= bulge - 1e-7f);
                CHECK(room <= 1.1f * bulge + 1e-7f);
            }
        }
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("bodies take their places, eight at once") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    const bool sleep_enabled = GENERATE(true, false);
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Random random(5);
        Crowd crowd(random);
        const BodyRows before = crowd.bodies.rows(RowSet::Awake);
        const std::vector<Place> places_before = crowd.bodies.places;
        for (int first = 0; first < kBodies; first += kLanes) {
            const BodyLanes lanes = body_lanes(crowd.bodies, first, kBodies);
            const PlaceOutcome outcome =
                take_places(crowd.bodies, lanes, crowd.motions, crowd.advances, kDt_s, sleep_enabled);
            const auto beyond = [&](LaneBits bits) { return bits >> lanes.count; };
            CHECK(beyond(outcome.hurled) == 0);
            CHECK(beyond(outcome.box_left) == 0);
            CHECK(beyond(outcome.rest_by_rule) == 0);
            for (int lane = 0; lane < lanes.count; ++lane) {
                const auto row = static_cast<std::size_t>(first + lane);
                const BodyRows& now = crowd.bodies.rows(RowSet::Awake);
                const auto body = static_cast<std::size_t>(now.body[row]);
                const BodyRecord& record = crowd.bodies.slots[now.body[row]];
                const int motion = first + lane + 1;
                const Vec2 moved = crowd.motions.pose[row + 1].d;
                const float turned = crowd.motions.angle(motion);
                const bool fast = (places_before[body].flags & place_flag::kFast) != 0;
                const bool hasty = (places_before[body].flags & place_flag::kHasty) != 0;
                INFO(name(level) << ", row " << row);
                CHECK(now.moved[row] == moved);
                CHECK(now.rotation_before[row] == places_before[body].rotation);
                CHECK(now.velocity[row] == crowd.motions.velocity[row + 1].v);
                CHECK(now.spin[row] == crowd.motions.spin(motion));
                CHECK(crowd.bodies.places[body].center == places_before[body].center + moved);
                CHECK(crowd.bodies.places[body].rotation ==
                      normalized(Rotation::from_small_angle(turned) * places_before[body].rotation));
                CHECK(now.force[row] == Vec2{});
                CHECK(now.torque[row] == 0);

                const Vec2 aside = hasty ? moved - kDt_s * crowd.advances[row + 1].velocity_m_s : moved;
                const float turned_aside = hasty ? turned - kDt_s * before.spin[row] : turned;
                const float went = length(aside) + std::fabs(turned_aside) * record.turn_arm_m;
                CHECK(now.box_slack[row] == before.box_slack[row] - went);
                CHECK((outcome.box_left >> lane & 1) == (now.box_slack[row] > 0 ? 0 : 1));
                const float all = length(moved) + std::fabs(turned) * record.turn_arm_m;
                const bool hurled = !fast && all > 0.5f * record.inner_radius_m;
                CHECK((outcome.hurled >> lane & 1) == (hurled ? 1 : 0));

                const bool by_rule = record.type == BodyType::Kinematic || record.extent_m < 0.005f;
                CHECK((outcome.rest_by_rule >> lane & 1) == (sleep_enabled && by_rule ? 1 : 0));
                const float speed =
                    std::max(length(now.velocity[row]), std::fabs(now.spin[row]) * record.extent_m);
                const float way = std::max(length(moved), std::fabs(turned) * record.extent_m);
                const bool rests = record.allow_sleep && speed < record.sleep_speed_m_s &&
                                   way < kDt_s * record.sleep_speed_m_s;
                if (!sleep_enabled)
                    CHECK(now.rest_time[row] == 0);
                else if (by_rule)
                    CHECK(now.rest_time[row] == before.rest_time[row]);
                else
                    CHECK(now.rest_time[row] == (rests ? before.rest_time[row] + kDt_s : 0));
            }
        }
    }
    force_simd_level(levels.back()).value();
}

}  // namespace
}  // namespace cairn::physics
