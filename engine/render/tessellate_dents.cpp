// Polygons with dents: whether one is, and its triangles. Ears are cut off one by one.
// Source: G. H. Meisters, "Polygons have ears", 1975.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/tessellate.h"

namespace cairn::engine {
namespace {

/// A turn whose sine is less is none: the corners of arcs are rounded to floats.
constexpr float kStraight = 1e-4f;

/// Twice the area of the triangle; positive: c is on the side of the inside from a to b.
float turn(Vec2 a, Vec2 b, Vec2 c) {
    return cross(b - a, c - a);
}

bool holds(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

}  // namespace

bool is_convex(std::span<const Vec2> points) {
    std::vector<Vec2> sides;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 side = points[(i + 1) % points.size()] - points[i];
        if (length(side) > 0) sides.push_back(side * (1 / length(side)));
    }
    bool turns_left = false;
    bool turns_right = false;
    float whole = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Vec2 next = sides[(i + 1) % sides.size()];
        const float sine = cross(sides[i], next);
        turns_left = turns_left || sine > kStraight;
        turns_right = turns_right || sine < -kStraight;
        whole += std::atan2(sine, dot(sides[i], next));
    }
    if (!turns_left && !turns_right) return true;
    constexpr float kOnceAndAHalf = 3 * std::numbers::pi_v<float>;  // a pentagram turns twice
    return turns_left != turns_right && std::fabs(whole) < kOnceAndAHalf;
}

std::optional<std::pair<std::size_t, std::size_t>> find_crossing(std::span<const Vec2> points) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = points[i];
        const Vec2 b = points[(i + 1) % n];
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;
            const Vec2 c = points[j];
            const Vec2 d = points[(j + 1) % n];
            if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return {{i, j}};
        }
    }
    return std::nullopt;
}

std::vector<std::array<int, 3>> cut_into_triangles(std::span<const Vec2> corners) {
    std::vector<int> rest(corners.size());
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = static_cast<int>(i);
    const auto at = [&](int corner) { return corners[static_cast<std::size_t>(corner)]; };
    const auto is_ear = [&](int before, int tip, int after) {
        if (turn(at(before), at(tip), at(after)) <= 0) return false;
        return std::none_of(rest.begin(), rest.end(), [&](int other) {
            const bool is_own = other == before || other == tip || other == after;
            return !is_own && holds(at(before), at(tip), at(after), at(other));
        });
    };
    std::vector<std::array<int, 3>> triangles;
    // Where none is left, what remains lies on a line, or the sides meet.
    for (std::size_t tried = 0, i = 0; rest.size() >= 3 && tried < rest.size(); ++i, ++tried) {
        const std::size_t n = rest.size();
        i %= n;
        const std::array<int, 3> ear = {rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]};
        if (!is_ear(ear[0], ear[1], ear[2])) continue;
        triangles.push_back(ear);
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        tried = 0;
    }
    return triangles;
}

}  // namespace cairn::engine
