// Places of supports against the horizontal distance of the points themselves.
#include "resolve/support_lanes.h"

#include <catch2/catch.hpp>
#include <cmath>

#include <cairn/physics/simd.h>

#include "base/motion.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using test::Random;

struct Lane {
    Vec2 normal;
    std::array<Vec2, 2> r_a;  // from the centres of mass
    std::array<Vec2, 2> r_b;
    float k_a = 0;
    float k_b = 0;
    int count = 0;
    float friction = 0;
};

// A manifold lies along the tangent, so its points have the same tangential arm.
Lane random_lane(Random& random, Vec2 up) {
    Lane lane;
    const double steepest = random.chance(0.5) ? 0.3 : 1.5;
    const double tilt = random.real(-steepest, steepest) + (random.chance(0.5) ? 3.14159 : 0);
    lane.normal = rotate(Rotation::from_angle(tilt), up);
    const Vec2 tangent = right_perp(lane.normal);
    const Vec2 between = random.vector(-1, 1);
    lane.r_a[0] = random.vector(-1, 1);
    lane.r_a[1] = lane.r_a[0] + random.real_f(0.1, 1) * tangent;
    for (int i = 0; i < 2; ++i) lane.r_b[i] = lane.r_a[i] - between;
    lane.k_a = random.real_f(0.1, 2);
    lane.k_b = random.real_f(0.1, 2);
    lane.count = random.below(3);
    lane.friction = random.real_f(0, 1);
    return lane;
}

void put(const Lane& from, int lane, ContactBlock& block) {
    const Vec2 tangent = right_perp(from.normal);
    block.a[lane] = 2 * lane + 1;
    block.b[lane] = 2 * lane + 2;
    block.friction[lane] = from.friction;
    block.normal_x[lane] = from.normal.x;
    block.normal_y[lane] = from.normal.y;
    block.tangent_arm_a[lane] = from.k_a * cross(from.r_a[0], tangent);
    block.tangent_arm_b[lane] = from.k_b * cross(from.r_b[0], tangent);
    for (int i = 0; i < 2; ++i) {
        const bool used = i < from.count;
        block.points[i].mass[lane] = used ? 1.0f : 0.0f;
        block.points[i].arm_a[lane] = used ? from.k_a * cross(from.r_a[i], from.normal) : 0;
        block.points[i].arm_b[lane] = used ? from.k_b * cross(from.r_b[i], from.normal) : 0;
    }
}

}  // namespace

TEST_CASE("what stands on what, and at which horizontal distance, follows from the arms of a block") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    int found = 0;
    int slopes = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Random random(seed);
        const Vec2 up = rotate(Rotation::from_angle(random.real(-3, 3)), Vec2{0, 1});
        const BlockKind kind = random.chance(0.5) ? BlockKind::TwoBodies : BlockKind::OneBody;
        std::array<Lane, kLanes> lanes;
        ContactBlock block{};
        for (int i = 0; i < kLanes; ++i) {
            lanes[i] = random_lane(random, up);
            put(lanes[i], i, block);
            if (kind == BlockKind::OneBody) block.a[i] = kWorldRow;
        }
        for (const SimdLevel level : levels) {
            INFO(name(level) << ", seed " << seed);
            force_simd_level(level).value();
            SupportLanes supports;
            find_supports(block, kind, up, supports);
            force_simd_level(levels.back()).value();
            for (int i = 0; i < kLanes; ++i) {
                const Lane& lane = lanes[i];
                const float along = dot(lane.normal, up);
                const bool b_stands = along > 0;
                // The world stands on nothing; its slopes bear what does not slide, or has one point.
                const float across = std::fabs(dot(lane.normal, right_perp(up)));
                const bool is_slope = kind == BlockKind::OneBody && along > kSlope &&
                                      (lane.count == 1 || lane.friction * along >= across);
                const bool is_flat = kind == BlockKind::TwoBodies ? std::fabs(along) > kBearingBetween
                                                                  : b_stands && along > kBearing;
                const bool bears = lane.count > 0 && (is_flat || is_slope);
                slopes += bears && !is_flat ? 1 : 0;
                if (!bears) {
                    REQUIRE(supports.upper[i] == kWorldRow);
                    continue;
                }
                ++found;
                REQUIRE(supports.upper[i] == (b_stands ? block.b[i] : block.a[i]));
                REQUIRE(supports.lower[i] == (kind == BlockKind::OneBody ? kWorldRow
                                              : b_stands                 ? block.a[i]
                                                                         : block.b[i]));
                REQUIRE(supports.points[i] == lane.count);
                REQUIRE(supports.steepness[i] == Approx(std::fabs(along)));
                for (int k = 0; k < lane.count; ++k) {
                    const float x_a = lane.k_a * dot(lane.r_a[k], right_perp(up));
                    const float x_b = lane.k_b * dot(lane.r_b[k], right_perp(up));
                    REQUIRE(supports.x[k][i] == Approx(b_stands ? x_b : x_a).margin(1e-5));
                    REQUIRE(supports.x_below[k][i] == Approx(b_stands ? x_a : x_b).margin(1e-5));
                }
            }
        }
    }
    CHECK(found > 300);
    CHECK(slopes > 100);
}

}  // namespace cairn::physics
