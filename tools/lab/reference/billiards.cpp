#include "reference/billiards.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace cairn::lab::reference {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// When two balls that approach each other touch: |d + v t| = 2 r.
double time_to_hit(const Ball& a, const Ball& b, double radius_m) {
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const double vx = b.vx_m_s - a.vx_m_s, vy = b.vy_m_s - a.vy_m_s;
    const double approach = dx * vx + dy * vy, v2 = vx * vx + vy * vy;
    if (approach >= 0) return kNever;
    const double root = approach * approach - v2 * (dx * dx + dy * dy - 4 * radius_m * radius_m);
    return root < 0 ? kNever : (-approach - std::sqrt(root)) / v2;
}

struct Hit {
    double after_s = kNever;
    std::size_t a = 0, b = 0;
};

Hit next_hit(const std::vector<Ball>& balls, double radius_m) {
    Hit first;
    for (std::size_t a = 0; a < balls.size(); ++a) {
        for (std::size_t b = a + 1; b < balls.size(); ++b) {
            const double t = time_to_hit(balls[a], balls[b], radius_m);
            if (t < first.after_s) first = {t, a, b};
        }
    }
    return first;
}

void move(std::vector<Ball>& balls, double t_s) {
    for (Ball& ball : balls) {
        ball.x_m += ball.vx_m_s * t_s;
        ball.y_m += ball.vy_m_s * t_s;
    }
}

// Equal masses exchange their velocities along the line of centres.
void collide(Ball& a, Ball& b) {
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m, d = std::hypot(dx, dy);
    const double nx = dx / d, ny = dy / d;
    const double along = (b.vx_m_s - a.vx_m_s) * nx + (b.vy_m_s - a.vy_m_s) * ny;
    a.vx_m_s += along * nx;
    a.vy_m_s += along * ny;
    b.vx_m_s -= along * nx;
    b.vy_m_s -= along * ny;
}

}  // namespace

double play(std::vector<Ball>& balls, double radius_m, int hits) {
    double time = 0;
    for (int i = 0; i < hits; ++i) {
        const Hit hit = next_hit(balls, radius_m);
        if (hit.after_s == kNever) break;
        move(balls, hit.after_s);
        collide(balls[hit.a], balls[hit.b]);
        time += hit.after_s;
    }
    const Hit next = next_hit(balls, radius_m);
    const double rest = next.after_s == kNever ? 1 : next.after_s / 2;
    move(balls, rest);
    return time + rest;
}

}  // namespace cairn::lab::reference
