// Convex hull by the monotone chain. Source: Andrew 1979.
#include "collide/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory_resource>
#include <string>
#include <vector>

#include <cairn/physics/tuning.h>

#include "base/check.h"

namespace cairn::physics {
namespace {

// In lengths of the segment between a corner's neighbours. Flatter corners are of no use to the solver.
constexpr double kLeastProminence = 1e-4;

// Of few points they stand in memory of the caller's: polygons are made by the thousand.
using Points = std::pmr::vector<Vec2>;

// Twice the signed area of (o, a, b), in double so that slivers are judged rightly.
double turn(Vec2 o, Vec2 a, Vec2 b) {
    const double ax = static_cast<double>(a.x) - static_cast<double>(o.x);
    const double ay = static_cast<double>(a.y) - static_cast<double>(o.y);
    const double bx = static_cast<double>(b.x) - static_cast<double>(o.x);
    const double by = static_cast<double>(b.y) - static_cast<double>(o.y);
    return ax * by - ay * bx;
}

Points without_near_duplicates(std::span<const Vec2> points, float size, std::pmr::memory_resource& memory) {
    const float tolerance = std::min(tuning::kLinearSlop_m, 0.001f * size);
    Points kept(&memory);
    kept.reserve(points.size());
    for (const Vec2 p : points) {
        const bool near = std::any_of(kept.begin(), kept.end(),
                                      [&](Vec2 q) { return length_squared(p - q) <= tolerance * tolerance; });
        if (!near) kept.push_back(p);
    }
    return kept;
}

// One half of the hull: appends the points in the given order, dropping those that do not turn left.
void append_chain(Points& hull, const Points& ordered) {
    const std::size_t start = hull.size();
    for (const Vec2 p : ordered) {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
    }
    hull.pop_back();  // it begins the other half
}

// How far corner i stands out from the segment between its neighbours, in lengths of that segment. Measured
// from the segment and not from its line, beyond which the tip of a needle may reach far.
double prominence(const Points& hull, std::size_t i) {
    const Vec2 a = hull[(i + hull.size() - 1) % hull.size()];
    const Vec2 b = hull[(i + 1) % hull.size()];
    const auto difference = [](float to, float from) {
        return static_cast<double>(to) - static_cast<double>(from);
    };
    const double x = difference(b.x, a.x);
    const double y = difference(b.y, a.y);
    const double whole = x * x + y * y;
    const double along = (difference(hull[i].x, a.x) * x + difference(hull[i].y, a.y) * y) / whole;
    const double across = turn(a, hull[i], b) / whole;
    const double beyond = std::max({along - 1, -along, 0.0});
    return std::sqrt(across * across + beyond * beyond);
}

// Without corners that hardly stand out, the least first; what is left is convex still.
void drop_flat_corners(Points& hull) {
    while (hull.size() > 2) {
        std::size_t flattest = 0;
        for (std::size_t i = 1; i < hull.size(); ++i) {
            if (prominence(hull, i) < prominence(hull, flattest)) flattest = i;
        }
        if (prominence(hull, flattest) > kLeastProminence) return;
        hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(flattest));
    }
}

// Points about the segment from a to b, without an area.
Error sliver(const Points& points, Vec2 a, Vec2 b) {
    const double x = static_cast<double>(b.x) - static_cast<double>(a.x);
    const double y = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double length = std::sqrt(x * x + y * y);
    double right = 0;
    double left = 0;
    for (const Vec2 p : points) {
        const double across = turn(a, b, p) / length;
        right = std::min(right, across);
        left = std::max(left, across);
    }
    const auto text = [](double value) {
        return check::number(static_cast<double>(static_cast<float>(value))) + " m";
    };
    return Error{"polygon.points_m lie on one line: they are " + text(length) + " long and " +
                 text(left - right) + " wide, but must be at least " + text(kLeastProminence * length) +
                 " wide"};
}

}  // namespace

Result<Hull> make_hull(std::span<const Vec2> points) {
    Vec2 lower{INFINITY, INFINITY};
    Vec2 upper = -lower;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i])) {
            const std::string field = "polygon.points_m[" + std::to_string(i) + "]";
            return *check::finite(field.c_str(), points[i]);
        }
        lower = {std::min(lower.x, points[i].x), std::min(lower.y, points[i].y)};
        upper = {std::max(upper.x, points[i].x), std::max(upper.y, points[i].y)};
    }
    const float size = points.empty() ? 0 : std::max(upper.x - lower.x, upper.y - lower.y);

    constexpr std::size_t kFew = 32;
    alignas(Vec2) std::array<std::byte, (2 * kFew + 1) * sizeof(Vec2)> few;
    std::pmr::monotonic_buffer_resource memory(few.data(), few.size());
    Points ordered = without_near_duplicates(points, size, memory);
    if (ordered.size() < 3) {
        return Error{"polygon.points_m has " + std::to_string(ordered.size()) +
                     " distinct points, but must have at least 3"};
    }
    std::sort(ordered.begin(), ordered.end(),
              [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Points hull(&memory);
    hull.reserve(ordered.size() + 1);  // a half ends where the other begins
    append_chain(hull, ordered);
    std::reverse(ordered.begin(), ordered.end());
    append_chain(hull, ordered);
    drop_flat_corners(hull);

    if (hull.size() < 3) return sliver(ordered, hull[0], hull[1]);
    if (hull.size() > kMaxPolygonVertices) {
        return Error{"polygon.points_m has a hull of " + std::to_string(hull.size()) +
                     " corners, but at most " + std::to_string(kMaxPolygonVertices) + " are possible"};
    }
    Hull result;
    std::copy(hull.begin(), hull.end(), result.points.begin());
    result.count = static_cast<int>(hull.size());
    return result;
}

}  // namespace cairn::physics
