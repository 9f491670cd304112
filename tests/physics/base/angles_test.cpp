// Many angles at once against one at a time, bit by bit, and against the C library.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include <cairn/physics/math.h>
#include <cairn/physics/simd.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

std::vector<Rotation> rotations_of_all_kinds() {
    std::vector<Rotation> rotations;
    for (const float c : {0.0f, -0.0f, 1.0f, -1.0f, 1e-30f, -1e-30f, 0.70710678f})
        for (const float s : {0.0f, -0.0f, 1.0f, -1.0f, 1e-30f, -1e-30f, 0.70710678f})
            rotations.push_back({c, s});
    test::Random random(1);
    for (int i = 0; i < 20'001; ++i) rotations.push_back(Rotation::from_angle(random.real(-3.2, 3.2)));
    return rotations;
}

TEST_CASE("angles of many rotations have the bits of each one's angle, at every width") {
    const std::vector<Rotation> rotations = rotations_of_all_kinds();
    const std::vector<SimdLevel> levels = available_simd_levels();
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        std::vector<float> angles(rotations.size());
        angles_rad(rotations, angles);
        int differing = 0;
        for (std::size_t i = 0; i < rotations.size(); ++i) {
            differing += std::bit_cast<std::uint32_t>(angles[i]) !=
                         std::bit_cast<std::uint32_t>(rotations[i].angle_rad());
        }
        INFO(name(level));
        CHECK(differing == 0);
    }
    force_simd_level(levels.back()).value();
}

TEST_CASE("any number of rotations has as many angles, and no more is written") {
    const std::vector<Rotation> rotations = rotations_of_all_kinds();
    for (std::size_t count = 0; count < 20; ++count) {
        std::vector<float> angles(count + 1, 77.0f);
        angles_rad(std::span(rotations).first(count), std::span(angles).first(count));
        CHECK(angles.back() == 77.0f);
        if (count > 0) CHECK(angles[count - 1] == rotations[count - 1].angle_rad());
    }
}

TEST_CASE("angles are those of the C library but for the last bit of a float") {
    const std::vector<Rotation> rotations = rotations_of_all_kinds();
    std::vector<float> angles(rotations.size());
    angles_rad(rotations, angles);
    double worst = 0;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        const double exact =
            std::atan2(static_cast<double>(rotations[i].s), static_cast<double>(rotations[i].c));
        if (exact != 0)
            worst = std::max(worst, std::fabs(static_cast<double>(angles[i]) - exact) / std::fabs(exact));
    }
    CHECK(worst < 6e-8);
}

}  // namespace
}  // namespace cairn::physics
