// Ears are cut off one by one, the best shaped first, and the triangles joined again while they stay convex.
// Source: G. H. Meisters, "Polygons have ears", 1975; S. Hertel and K. Mehlhorn, "Fast triangulation of
// simple polygons", 1983 (joining leaves at most four times as many parts as there must be).
#include "bind/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include <cairn/physics/shape.h>
#include <cairn/physics/tuning.h>

namespace cairn::scripting {
namespace {

using physics::Vec2;
using Polygon = std::vector<std::size_t>;  ///< corners of the outline by index, anticlockwise

constexpr auto kSlop_m = static_cast<double>(physics::tuning::kLinearSlop_m);

struct Point {
    double x, y;
};

Point to_point(Vec2 p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
double length(Point a) {
    return std::sqrt(a.x * a.x + a.y * a.y);
}
/// Twice the area of the triangle; positive: c is on the left of the way from a to b.
double turn(Point a, Point b, Point c) {
    return cross(b - a, c - a);
}
double distance_to_segment(Point p, Point a, Point b) {
    const Point way = b - a;
    const double square = way.x * way.x + way.y * way.y;
    const Point to_p = p - a;
    const double share = square > 0 ? std::clamp((to_p.x * way.x + to_p.y * way.y) / square, 0.0, 1.0) : 0.0;
    return length({to_p.x - share * way.x, to_p.y - share * way.y});
}

bool cross_or_touch(Point a, Point b, Point c, Point d) {
    const double side_c = turn(a, b, c), side_d = turn(a, b, d);
    const double side_a = turn(c, d, a), side_b = turn(c, d, b);
    if (side_c * side_d < 0 && side_a * side_b < 0) return true;
    constexpr double kTouching_m = 1e-9;
    return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                     distance_to_segment(d, a, b)}) <= kTouching_m;
}

class Outline {
  public:
    /// Corners that are one to the physics are one here.
    explicit Outline(std::span<const Vec2> corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point p = to_point(corners[i]);
            if (!points_.empty() && length(p - points_.back()) <= kSlop_m) continue;
            points_.push_back(p);
            drawn_.push_back(i);
        }
        while (points_.size() > 1 && length(points_.back() - points_.front()) <= kSlop_m) {
            points_.pop_back();
            drawn_.pop_back();
        }
    }

    /// Whether all of it lies on a line.
    [[nodiscard]] bool is_flat() const { return hull().size() < 3; }
    /// Which of the given corners one is.
    [[nodiscard]] std::size_t drawn(std::size_t corner) const { return drawn_[corner]; }

    /// Two sides that meet though they are not neighbours, in words; empty: none do.
    [[nodiscard]] std::string crossing() const {
        const std::size_t n = points_.size();
        const auto side = [&](std::size_t i) {
            return "from corner " + std::to_string(drawn_[i] + 1) + " to " +
                   std::to_string(drawn_[(i + 1) % n] + 1);
        };
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 2; j < n; ++j) {
                if (i == 0 && j == n - 1) continue;
                if (!cross_or_touch(points_[i], points_[i + 1], points_[j], points_[(j + 1) % n])) continue;
                return "the side " + side(i) + " meets that " + side(j);
            }
        }
        return {};
    }

    /// Whether it is its own hull but for what nobody sees, and has few enough corners.
    [[nodiscard]] bool is_convex() const {
        const Polygon hull = this->hull();
        if (hull.size() > static_cast<std::size_t>(physics::kMaxPolygonVertices)) return false;
        return std::all_of(points_.begin(), points_.end(), [&](Point p) {
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < hull.size(); ++i)
                nearest = std::min(
                    nearest, distance_to_segment(p, points_[hull[i]], points_[hull[(i + 1) % hull.size()]]));
            return nearest <= kSlop_m;
        });
    }

    /// Of a simple outline.
    [[nodiscard]] std::vector<Polygon> parts() const {
        std::vector<Polygon> parts = triangles();
        while (join_two(parts)) continue;
        std::erase_if(parts, [&](const Polygon& part) { return width(part) <= kSlop_m; });
        return parts;
    }

  private:
    /// Without points on its sides. Source: A. M. Andrew, 1979.
    [[nodiscard]] Polygon hull() const {
        Polygon order(points_.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::tie(points_[a].x, points_[a].y, a) < std::tie(points_[b].x, points_[b].y, b);
        });
        if (order.size() < 3) return order;
        Polygon hull;
        const auto add_all = [&](std::size_t least) {
            for (const std::size_t i : order) {
                while (hull.size() >= least + 2 &&
                       turn(points_[hull[hull.size() - 2]], points_[hull.back()], points_[i]) <= 0) {
                    hull.pop_back();
                }
                hull.push_back(i);
            }
            hull.pop_back();
        };
        add_all(0);
        std::reverse(order.begin(), order.end());
        add_all(hull.size());
        return hull;
    }

    [[nodiscard]] double area() const {
        double twice = 0;
        for (std::size_t i = 0; i < points_.size(); ++i)
            twice += cross(points_[i] - points_[0], points_[(i + 1) % points_.size()] - points_[0]);
        return twice / 2;
    }

    /// How far a triangle is from being a needle: 0 for one without area.
    [[nodiscard]] double quality(std::size_t a, std::size_t b, std::size_t c) const {
        const Point p = points_[a], q = points_[b], r = points_[c];
        const double longest = std::max({length(q - p), length(r - q), length(p - r)});
        return longest > 0 ? turn(p, q, r) / (longest * longest) : 0;
    }

    [[nodiscard]] bool is_ear(const Polygon& rest, std::size_t before, std::size_t at,
                              std::size_t after) const {
        if (turn(points_[before], points_[at], points_[after]) <= 0) return false;
        return std::none_of(rest.begin(), rest.end(), [&](std::size_t other) {
            if (other == before || other == at || other == after) return false;
            const Point p = points_[other];
            return turn(points_[before], points_[at], p) >= 0 && turn(points_[at], points_[after], p) >= 0 &&
                   turn(points_[after], points_[before], p) >= 0;
        });
    }

    [[nodiscard]] std::vector<Polygon> triangles() const {
        Polygon rest(points_.size());
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = i;
        if (area() < 0) std::reverse(rest.begin(), rest.end());
        std::vector<Polygon> triangles;
        while (rest.size() >= 3) {
            const auto corner = [&](std::size_t i) { return rest[i % rest.size()]; };
            std::size_t best = rest.size();
            double best_quality = 0;
            for (std::size_t i = 0; i < rest.size(); ++i) {
                const std::size_t before = corner(i + rest.size() - 1), at = corner(i), after = corner(i + 1);
                const double shape = quality(before, at, after);
                if (shape <= best_quality || !is_ear(rest, before, at, after)) continue;
                best = i;
                best_quality = shape;
            }
            if (best == rest.size()) break;  // what is left lies on a line
            triangles.push_back({corner(best + rest.size() - 1), corner(best), corner(best + 1)});
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
        }
        return triangles;
    }

    [[nodiscard]] bool is_convex(const Polygon& part) const {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Point a = points_[part[i]], b = points_[part[(i + 1) % part.size()]],
                        c = points_[part[(i + 2) % part.size()]];
            if (turn(a, b, c) < 0) return false;
        }
        return true;
    }

    /// Two parts along the side that they share, if the whole is convex and has few enough corners.
    [[nodiscard]] Polygon joined(const Polygon& a, const Polygon& b) const {
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t j = 0; j < b.size(); ++j) {
                if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) continue;
                Polygon whole;
                for (std::size_t k = 0; k < a.size(); ++k) whole.push_back(a[(i + 1 + k) % a.size()]);
                for (std::size_t k = 2; k < b.size(); ++k) whole.push_back(b[(j + k) % b.size()]);
                const bool fits = whole.size() <= static_cast<std::size_t>(physics::kMaxPolygonVertices);
                return fits && is_convex(whole) ? whole : Polygon{};
            }
        }
        return {};
    }

    bool join_two(std::vector<Polygon>& parts) const {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            for (std::size_t j = i + 1; j < parts.size(); ++j) {
                Polygon whole = joined(parts[i], parts[j]);
                if (whole.empty()) continue;
                parts[i] = std::move(whole);
                parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
                return true;
            }
        }
        return false;
    }

    /// Its least extent.
    [[nodiscard]] double width(const Polygon& part) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Point a = points_[part[i]], b = points_[part[(i + 1) % part.size()]];
            double farthest = 0;
            for (const std::size_t corner : part)
                farthest = std::max(farthest, turn(a, b, points_[corner]) / length(b - a));
            least = std::min(least, farthest);
        }
        return least;
    }

    std::vector<Point> points_;
    std::vector<std::size_t> drawn_;
};

}  // namespace

physics::Result<std::vector<std::vector<Vec2>>> convex_parts(std::span<const Vec2> outline) {
    std::vector<std::vector<Vec2>> parts(1, {outline.begin(), outline.end()});
    const bool is_sane = std::all_of(outline.begin(), outline.end(), [](Vec2 p) { return is_finite(p); });
    if (outline.size() < 3 || !is_sane) return parts;
    if (outline.size() > kMostOutlineCorners) {
        return physics::Error{"points has " + std::to_string(outline.size()) +
                              " corners, but must have at most " + std::to_string(kMostOutlineCorners)};
    }
    const Outline drawn(outline);
    if (drawn.is_flat()) return parts;
    if (const std::string crossing = drawn.crossing(); !crossing.empty()) {
        return physics::Error{"points: " + crossing +
                              "; the corners must stand in the order in which they go round the outline"};
    }
    if (drawn.is_convex()) return parts;
    parts.clear();
    for (const Polygon& part : drawn.parts()) {
        std::vector<Vec2>& corners = parts.emplace_back();
        for (const std::size_t corner : part) corners.push_back(outline[drawn.drawn(corner)]);
    }
    if (parts.empty())
        return physics::Error{"points: the outline is thinner than 0.005 m, and must be wider"};
    return parts;
}

}  // namespace cairn::scripting
