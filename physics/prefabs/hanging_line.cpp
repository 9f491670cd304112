// With half the arc's angle a and radius R, the way between the ends is d = 2 R sin a and a link is
// c = 2 R sin(a / n). So d / c = sin a / sin(a / n), which falls from n to 0 as a grows from 0 to pi: a is
// found by bisection.
#include "prefabs/hanging_line.h"

#include <cmath>

namespace cairn::physics {

std::vector<Position> hanging_line(Position from, Position to, double length_m, int count) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double distance = std::sqrt(dx * dx + dy * dy);
    const double links_apart = distance * count / length_m;
    const auto sine = [](double x) { return deterministic::sin(x); };

    double low = 0;
    double high = 3.14159265358979323846;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (sine(middle) / sine(middle / count) > links_apart ? low : high) = middle;
    }
    const double half = low;
    std::vector<Position> points{from};
    // To the left or right of the straight way, whichever is down.
    const double side = dx >= 0 ? 1 : -1;
    const double along_x = dx / distance;
    const double along_y = dy / distance;
    for (int i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / count;
        double along = distance * share;
        double below = 0;
        if (half > 1e-9) {
            const double radius = distance / (2 * sine(half));
            const double angle = half * (2 * share - 1);
            along = distance / 2 + radius * sine(angle);
            below = radius * (deterministic::cos(angle) - deterministic::cos(half));
        }
        points.push_back({from.x + along_x * along + side * along_y * below,
                          from.y + along_y * along - side * along_x * below});
    }
    points.push_back(to);
    return points;
}

}  // namespace cairn::physics
