// The phases of a substep of a row of pins. Glossary: C error, I~ inertia with geometric stiffness, p impulse
// on the body after a joint; the one before it gets as much the other way.
#include "resolve/direct/pin_chain.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

bool same_bits(const Values& a, const Values& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_bits(const PinRow::Arms& a, const PinRow::Arms& b) {
    return same_bits(a.before_x, b.before_x) && same_bits(a.before_y, b.before_y) &&
           same_bits(a.after_x, b.after_x) && same_bits(a.after_y, b.after_y);
}

}  // namespace

void PinChain::read_poses(const Motions& motions, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
        const int row = rows_[k];
        line_.moved_x[k] = d(motions.pose[row].d.x);
        line_.moved_y[k] = d(motions.pose[row].d.y);
        line_.turned[k] = d(motions.angle(row));
    }
    turn(line_, first, last);
}

void PinChain::read(const Motions& motions) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const VelocityRow& velocity = motions.velocity[rows_[k]];
        line_.before.x[k] = d(velocity.v.x);
        line_.before.y[k] = d(velocity.v.y);
        line_.before.w[k] = d(velocity.w) * d(motions.pose[rows_[k]].k);
    }
}

// As DirectComponent::weigh_spins.
void PinChain::weigh_spins() {
    for (std::size_t k = begin_; k < end_; ++k) {
        double& w = line_.before.w[k];
        if (line_.inertia[k] > line_.own_inertia[k])
            w = line_.now.w[k] + line_.own_inertia[k] / line_.inertia[k] * (w - line_.now.w[k]);
    }
}

void PinChain::write(Motions& motions) const {
    for (std::size_t k = begin_; k < end_; ++k) {
        VelocityRow& velocity = motions.velocity[rows_[k]];
        velocity.v = {static_cast<float>(line_.now.x[k]), static_cast<float>(line_.now.y[k])};
        if (line_.inverse_own_inertia[k] > 0)
            velocity.w = static_cast<float>(line_.now.w[k]) / motions.pose[rows_[k]].k;
    }
}

// Of J as the pins are now, and of I~. What stands still has its factors.
void PinChain::factor(double give) {
    if (give == give_ && same_bits(line_.arms, line_.factored) &&
        same_bits(line_.inverse_inertia, factored_inertia_) &&
        same_bits(line_.inverse_mass, factored_mass_)) {
        return;
    }
    give_ = give;
    line_.factored = line_.arms;
    factored_inertia_ = line_.inverse_inertia;
    factored_mass_ = line_.inverse_mass;
    factors_.resize(static_cast<int>(pins_.size()));
    cairn::physics::assemble(line_, give, factors_);
    factors_.factor();
}

// No impulse can be much more than what stops all bodies at once, but where joints want two things.
double PinChain::most_impulse() const {
    double fastest = 0;
    for (std::size_t k = begin_; k < end_; ++k)
        fastest = std::max(fastest, std::fabs(line_.before.x[k]) + std::fabs(line_.before.y[k]));
    return kMostLeverage * whole_mass_ * (fastest + kMaxClosingSpeed_m_s);
}

// Velocities with which all errors close at this rate, 1/s; whether the impulses make sense.
bool PinChain::satisfy(double rate, double give) {
    factor(give);
    aim(line_, rate, kMaxClosingSpeed_m_s);
    factors_.solve(line_.impulse_x.data(), line_.impulse_y.data());
    const bool makes_sense = are_within(line_, kMostLeverage * whole_mass_ * kMaxClosingSpeed_m_s) ||
                             are_within(line_, most_impulse());
    line_.now = line_.before;
    if (makes_sense) push(line_, line_.now);
    return makes_sense;
}

void PinChain::satisfy(double rate) {
    for (const double give : {kGive, kGiveOfContradictions}) {
        if (satisfy(rate, give)) return;
    }
    // Not a number, or beyond all bounds: the joints rest in this substep.
    std::fill(line_.impulse_x.begin(), line_.impulse_x.end(), 0.0);
    std::fill(line_.impulse_y.begin(), line_.impulse_y.end(), 0.0);
}

void PinChain::solve(const DirectScene& scene) {
    const double h_s = d(scene.h_s);
    read(scene.motions);
    weigh_spins();
    choose_inertia(line_, h_s, fastest_rad_s_, begin_, end_);
    for (int enlargement = 0; enlargement <= kMaxEnlargements; ++enlargement) {
        settle_inertia(line_, begin_, end_);
        satisfy(1 / h_s);
        measure_pulls(line_, line_.pulled);
        sum_levers(line_);
        if (!enlarge_inertia(line_, h_s, fastest_rad_s_, begin_, end_)) break;
    }
    surplus_ = surplus(scene, kinetic_energy(line_.before), 1);
    write(scene.motions);
    std::fill(line_.sum_x.begin(), line_.sum_x.end(), 0.0);
    std::fill(line_.sum_y.begin(), line_.sum_y.end(), 0.0);
    add_impulses(line_);
}

// As DirectComponent::project: along J of the factors, and velocities follow.
bool PinChain::project(double h_s) {
    const double before = greatest_error_;
    if (before < kNoError || before > kMaxProjected) return false;
    for (std::size_t j = 0; j < pins_.size(); ++j) {
        line_.impulse_x[j] = -line_.error_x[j];
        line_.impulse_y[j] = -line_.error_y[j];
    }
    factors_.solve(line_.impulse_x.data(), line_.impulse_y.data());
    PinRow::Speeds& way = line_.now;
    for (Values* values : {&way.x, &way.y, &way.w}) std::fill(values->begin(), values->end(), 0.0);
    push(line_, way);
    const auto shift = [&](double sign) {
        for (std::size_t k = begin_; k < end_; ++k) {
            line_.moved_x[k] += sign * way.x[k];
            line_.moved_y[k] += sign * way.y[k];
            line_.turned[k] += sign * way.w[k];
        }
        turn(line_, begin_, end_);
        greatest_error_ = place(line_);
    };
    shift(1);
    if (greatest_error_ > kWorthwhile * before) {
        shift(-1);
        return false;
    }
    for (std::size_t k = begin_; k < end_; ++k) {
        line_.before.x[k] += way.x[k] / h_s;
        line_.before.y[k] += way.y[k] / h_s;
        line_.before.w[k] += way.w[k] / h_s;
    }
    return true;
}

// As DirectComponent::parts_needed.
int PinChain::parts_needed(double h_s) const {
    if (h_s * fastest_spin(line_, begin_, end_) <= kResolvedTurn_rad) return 1;
    double most_turned = 0;
    for (std::size_t k = begin_; k < end_; ++k) {
        const double arm =
            std::max(k > 0 ? line_.arm_after[k - 1] : 0, k < pins_.size() ? line_.arm_before[k] : 0);
        if (arm >= kNoArm_m) most_turned = std::max(most_turned, std::fabs(h_s * line_.before.w[k]));
    }
    int parts = 1;
    while (parts < kMaxParts && most_turned > kResolvedTurn_rad * parts) parts *= 2;
    return parts;
}

// What cannot be moved has gone its way for the whole substep.
void PinChain::move(const DirectScene& scene) {
    read(scene.motions);
    weigh_spins();
    read_poses(scene.motions, 0, begin_);
    read_poses(scene.motions, end_, rows_.size());
    const int parts = parts_needed(d(scene.h_s));
    DirectScene part = scene;
    part.h_s /= static_cast<float>(parts);
    for (int i = 1; i <= parts; ++i) {
        energy_ = std::max(0.0, kinetic_energy(line_.before) - surplus_);
        surplus_ = 0;
        advance_by(d(part.h_s));
        kicked_ = i == parts;
        if (kicked_) kick(line_, begin_, end_);
        close(part, parts);
        if (!kicked_) std::swap(line_.before, line_.now);
    }
    write(scene.motions);
    write_poses(scene.motions);
    // What turning needed pulled in parts, gravity over the whole substep.
    if (parts > 1) {
        for (std::size_t j = 0; j < pins_.size(); ++j)
            line_.closed[j] = std::min(line_.closed[j], line_.pulled[j]) +
                              std::max(0.0, line_.closed[j] - line_.pulled[j]) / parts;
    }
    sum_levers(line_);
}

void PinChain::write_poses(Motions& motions) const {
    for (std::size_t k = begin_; k < end_; ++k) {
        PoseRow& pose = motions.pose[rows_[k]];
        pose.d = {static_cast<float>(line_.moved_x[k]), static_cast<float>(line_.moved_y[k])};
        if (line_.inverse_own_inertia[k] == 0) continue;
        pose.theta = static_cast<float>(line_.turned[k]) / pose.k;
        motions.turned[rows_[k]] = {static_cast<float>(line_.cosine[k]), static_cast<float>(line_.sine[k])};
    }
}

void PinChain::advance_by(double h_s) {
    const double fastest = fastest_spin(line_, begin_, end_);
    advance(line_, h_s, begin_, end_);
    greatest_error_ = place(line_);
    if (h_s * fastest > kMaxTurn_rad) return;
    if (project(h_s)) project(h_s);
}

void PinChain::close(const DirectScene& scene, int parts) {
    satisfy(0);
    measure_pulls(line_, line_.closed);
    const double gained = surplus(scene, energy_ + work_of_kick(), parts);
    if (gained > 0) take_back(gained);
    add_impulses(line_);
}

}  // namespace cairn::physics
