#include "accuracy/problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cairn::lab {

int Setting::steps(double duration_s) const {
    return static_cast<int>(std::lround(duration_s / static_cast<double>(dt_s)));
}

std::span<const Problem> all_problems() {
    static const std::vector<Problem> problems = [] {
        std::vector<Problem> all;
        add_flight(all);
        add_bounces(all);
        add_friction(all);
        add_pendulums(all);
        add_oscillators(all);
        add_collisions(all);
        add_structures(all);
        add_piles(all);
        std::stable_sort(all.begin(), all.end(),
                         [](const Problem& a, const Problem& b) { return a.number < b.number; });
        return all;
    }();
    return problems;
}

std::unique_ptr<Rig> rig_of(const Setting& setting, Vec2 gravity_m_s2) {
    auto rig = std::make_unique<Rig>(setting.kind, setting.world(gravity_m_s2));
    rig->without_books();
    return rig;
}

double bisect(double low, double high, double tolerance, const std::function<bool(double)>& holds) {
    const double least = tolerance * (high - low);
    while (high - low > least) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

double apex(double before, double highest, double after) {
    const double bend = before - 2 * highest + after;
    const double slope = 0.5 * (after - before);
    return bend < 0 ? highest - 0.5 * slope * slope / bend : highest;
}

double wrapped(double angle_rad) {
    return angle_rad - 2 * std::numbers::pi * std::ceil(angle_rad / (2 * std::numbers::pi) - 0.5);
}

}  // namespace cairn::lab
