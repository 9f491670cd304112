// A rounded convex shape is its core polygon, a rectangle on each edge and a circular sector at each corner.
// Their closed forms add up to exact mass properties; circles and capsules are the cases with one and two
// corners.
#include "collide/mass.h"

#include <algorithm>

namespace cairn::physics {
namespace {

struct Point {
    double x, y;
};

Point to_double(Vec2 a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y)};
}

// A part with its own centre and inertia about that centre, moved to the common origin (parallel axes).
MassSum part(double mass, Point center, double central_inertia) {
    return {mass, mass * center.x, mass * center.y,
            central_inertia + mass * (center.x * center.x + center.y * center.y)};
}

// The triangle (0, a, b), signed. Source: second moments of a triangle about one corner.
MassSum triangle(Point a, Point b, double density) {
    const double mass = density * (a.x * b.y - a.y * b.x) / 2;
    const double second = a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y + a.x * b.x + a.y * b.y;
    return {mass, mass * (a.x + b.x) / 3, mass * (a.y + b.y) / 3, mass * second / 6};
}

MassSum edge_rectangle(Point a, Point b, Point normal, double radius, double density) {
    const double along = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    const double mass = density * along * radius;
    const Point center{(a.x + b.x + normal.x * radius) / 2, (a.y + b.y + normal.y * radius) / 2};
    return part(mass, center, mass * (along * along + radius * radius) / 12);
}

// The sector at `apex` between two edge normals, `angle` apart, pointing along `bisector`.
MassSum corner_sector(Point apex, Point bisector, double angle, double radius, double density) {
    if (angle <= 0) return {};
    const double mass = density * angle * radius * radius / 2;
    const double offset = 4 * radius * deterministic::sin(angle / 2) / (3 * angle);
    const double central = mass * (radius * radius / 2 - offset * offset);
    return part(mass, {apex.x + offset * bisector.x, apex.y + offset * bisector.y}, central);
}

}  // namespace

MassSum mass_of(const Convex& shape, double density) {
    MassSum sum;
    const double radius = static_cast<double>(shape.radius());
    const int n = shape.count();
    if (n == 1) {
        const double mass = density * deterministic::acos(-1) * radius * radius;
        return part(mass, to_double(shape.point(0)), mass * radius * radius / 2);
    }
    if (shape.is_line()) return sum;
    for (int i = 0; i < n; ++i) {
        const Point a = to_double(shape.point(i));
        const Point b = to_double(shape.point(shape.next(i)));
        const Point normal = to_double(shape.normals[i]);
        sum += triangle(a, b, density);
        if (radius == 0) continue;
        sum += edge_rectangle(a, b, normal, radius, density);
        const Point before = to_double(shape.normals[i == 0 ? n - 1 : i - 1]);
        const double turn = deterministic::atan2(before.x * normal.y - before.y * normal.x,
                                                 before.x * normal.x + before.y * normal.y);
        // The two edges of a capsule are opposite: the turn is half a circle, of either sign.
        const double angle = std::fabs(turn);
        const double half = angle / 2;
        const Point bisector{before.x * deterministic::cos(half) - before.y * deterministic::sin(half),
                             before.x * deterministic::sin(half) + before.y * deterministic::cos(half)};
        sum += corner_sector(a, bisector, angle, radius, density);
    }
    return sum;
}

}  // namespace cairn::physics
