// Energy that nothing brought into a row of pins is taken back, as direct_energy.cpp tells.
#include <algorithm>
#include <cmath>

#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"
#include "resolve/direct/pin_chain.h"

namespace cairn::physics {

double PinChain::kinetic_energy(const PinRow::Speeds& v) const {
    return energy_product(line_, v, v, begin_, end_) / 2;
}

// What may differ for reasons of no interest.
double PinChain::indifferent_energy(const DirectScene& scene) const {
    double sum = 0;
    for (std::size_t k = begin_; k < end_; ++k) {
        const Vec2 kick = scene.h_s * scene.drives[at(rows_[k])].acceleration;
        sum += line_.mass[k] * (d(dot(kick, kick)) + kSlow_m_s * kSlow_m_s);
    }
    return sum / 2;
}

// Of the closing half kick, along the way that the bodies take there.
double PinChain::work_of_kick() const {
    return kicked_ ? energy_product(line_, line_.kick, line_.now, begin_, end_) : 0;
}

// By what cannot be moved, but moves; where it took energy out, nothing.
double PinChain::work_of_supports() const {
    const auto gained = [](double impulse, double before, double after) {
        return std::max(0.0, impulse * (before + after) / 2);
    };
    // Of the joint between a support and the body that it holds, where the impulse on that body is `sign` p.
    const auto work = [&](std::size_t support, std::size_t joint, std::size_t body, double sign, double arm_x,
                          double arm_y) {
        if (line_.before.x[support] == 0 && line_.before.y[support] == 0 && line_.before.w[support] == 0)
            return 0.0;
        const auto x = [&](const PinRow::Speeds& v) { return sign * (v.x[body] - v.w[body] * arm_y); };
        const auto y = [&](const PinRow::Speeds& v) { return sign * (v.y[body] + v.w[body] * arm_x); };
        return gained(line_.impulse_x[joint], x(line_.before), x(line_.now)) +
               gained(line_.impulse_y[joint], y(line_.before), y(line_.now));
    };
    double sum = 0;
    const std::size_t last = pins_.size() - 1;
    if (begin_ > 0) sum += work(0, 0, 1, 1, line_.factored.after_x[0], line_.factored.after_y[0]);
    if (end_ < rows_.size())
        sum += work(last + 1, last, last, -1, line_.factored.before_x[last], line_.factored.before_y[last]);
    return sum;
}

// After a solution.
double PinChain::surplus(const DirectScene& scene, double energy_before, int parts) const {
    const double gained = kinetic_energy(line_.now) - energy_before;
    if (gained <= kEnergyTolerance * energy_before / parts) return 0;
    if (gained <= (kEnergyTolerance * energy_before + indifferent_energy(scene)) / parts) return 0;
    return std::max(0.0, gained - work_of_supports());
}

// Slows the bodies down until they have lost so much energy, or all but that of their centre of mass.
void PinChain::take_back(double surplus) {
    double x = 0, y = 0;
    double common = 0;
    if (end_ - begin_ == rows_.size()) {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            x += line_.mass[k] * line_.now.x[k];
            y += line_.mass[k] * line_.now.y[k];
        }
        x /= whole_mass_;
        y /= whole_mass_;
        common = whole_mass_ * (x * x + y * y) / 2;
    }
    const double own = kinetic_energy(line_.now) - common;
    if (!(own > 0)) return;
    const double kept = std::sqrt(std::max(0.0, 1 - surplus / own));
    for (std::size_t k = begin_; k < end_; ++k) {
        line_.now.x[k] = x + kept * (line_.now.x[k] - x);
        line_.now.y[k] = y + kept * (line_.now.y[k] - y);
        line_.now.w[k] *= kept;
    }
}

}  // namespace cairn::physics
