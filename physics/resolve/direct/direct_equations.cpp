// What the equations of a structure ask for in a phase of the substep, and what is done when that cannot be
// had.
#include <algorithm>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "resolve/direct/direct_component.h"
#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

// Give of contacts, as a part of J 1/M J^T; they say the same thing twice where a body stands on two of them
// and is held by a joint. As much, but no more than lets them sink with this speed under their load, m/s.
constexpr double kContactGive = 1e-3;
constexpr double kSinking_m_s = 1e-4;
// m. Contacts this deep or this far apart are let alone: errors of two that bear one body would be
// contradictions.
constexpr float kStill_m = 0.02f * tuning::kLinearSlop_m;

using State = DirectEquation::State;

// m. Contacts of joined bodies that are deeper than this push as softly as a sweep has them do: a joint may
// hold the body where they do not want it, and then the two give way to each other.
constexpr float kDeep_m = 4 * tuning::kLinearSlop_m;
// m. But those that bear a load push hard enough not to stay deeper than this.
constexpr double kDepthUnderLoad_m = 0.2 * tuning::kLinearSlop_m;

// What is round-off in an error would never let a structure rest.
double without_roundings(double error) {
    return error - std::clamp(error, -kNoError, kNoError);
}

// A guess by the last impulse.
State state_at_bounds(const DirectEquation& e, double impulse) {
    if (impulse <= 0.999 * e.low) return State::AtLow;
    if (impulse >= 0.999 * e.high) return State::AtHigh;
    return State::Acts;
}

// So much that a load, which may be none, makes the points close no faster than this.
double give_under(double load, double speed_m_s) {
    return load > 0 ? speed_m_s / load : kUnlimited;
}

double give_of_contact(const ContactPointConstraint& p, const DirectEquation& e) {
    const double load = std::max({e.impulse, e.before, d(p.static_impulse)});
    return std::min(kContactGive * e.inverse_mass, give_under(load, kSinking_m_s));
}

double give_when_deep(const ContactConstraint& c, const ContactPointConstraint& p, const DirectEquation& e) {
    const double soft = e.inverse_mass * d(c.softness.impulse_scale / c.softness.mass_scale);
    return std::min(soft, give_under(d(p.static_impulse), d(c.softness.bias_rate) * kDepthUnderLoad_m));
}

}  // namespace

const std::array<DirectComponent::Attempt, 3> DirectComponent::kAttempts{{
    {kGive, false},
    {kGive, true},
    {kGiveOfContradictions, true},
}};

void DirectComponent::describe(const JointLaw& law, JointRow& row, DirectEquation& e, double h,
                               Phase phase) const {
    const bool closing = phase == Phase::Close;
    const double most_m_s = contacts_.empty() ? kMaxClosingSpeed_m_s : kMaxClosingSpeedInContact_m_s;
    const State state_before = e.state;
    e.state = State::Acts;
    switch (law.kind) {
        case LawKind::Hold:
            e.wanted = closing ? 0 : -std::clamp(without_roundings(row.error) / h, -most_m_s, most_m_s);
            if (law.rigid) break;
            e.give = e.inverse_mass * d(law.softness.impulse_scale / law.softness.mass_scale);
            e.wanted = -d(law.softness.bias_rate) * row.error;
            if (closing) e.state = State::Idle;
            break;
        case LawKind::Spring: {
            const double own = d(row.part == 0 ? law.mobility.xx : law.mobility.yy);
            e.give = (own > 0 ? own : e.inverse_mass) / d(law.spring.d1);
            e.wanted = -(d(law.spring.d0) * row.speed_before + d(law.spring.stiffness_per_s) * row.error) /
                       d(law.spring.d1);
            if (closing) e.state = State::Idle;
            break;
        }
        case LawKind::Motor:
            e.wanted = d(law.speed[at(row.part)]);
            // The bound of a pair is found in solving: it has a length, and no low end.
            if (!closing && e.bound == DirectEquation::Bound::Range) e.state = state_at_bounds(e, e.impulse);
            // It does no more than it can.
            if (closing && state_before != State::Acts) e.state = State::Idle;
            break;
        case LawKind::Lower:
        case LawKind::Upper:
            e.wanted = std::min(-(closing ? std::max(row.error, 0.0) : row.error) / h, most_m_s);
            if (row.error > 0 && !(e.impulse > 0)) e.state = State::AtLow;
            break;
    }
}

// The state that was right in this phase of the last substep is the best guess: without it friction in forty
// hinges changed over in every solution.
void DirectComponent::recall(int equation, Phase phase) {
    const std::vector<State>& states = states_of(phase);
    DirectEquation& e = system_.equations[at(equation)];
    if (states.empty() || e.state == State::Idle) return;
    const State last = states[at(equation)];
    if (last != State::Idle && last != State::Given) e.state = last;
}

void DirectComponent::remember_states(Phase phase) {
    std::vector<State>& states = states_of(phase);
    states.clear();
    for (const DirectEquation& e : system_.equations) states.push_back(e.state);
}

void DirectComponent::forget_states() {
    for (std::vector<State>& states : states_) states.clear();
}

void DirectComponent::describe_contact(const DirectScene& scene, std::size_t contact, Phase phase) {
    ContactConstraint& c = scene.contacts[at(contacts_[contact].place)];
    const bool closing = phase == Phase::Close;
    int i = member_of_contact(contact).first_equation;
    double pressed = 0;
    double give = kUnlimited;
    for (int point = 0; point < c.count; ++point, ++i) {
        ContactPointConstraint& p = c.points[at(point)];
        DirectEquation& e = system_.equations[at(i)];
        const float s = separation_now(c, p, scene.motions);
        p.end_separation = s;
        const bool loaded = e.impulse > 0;
        e.give = give_of_contact(p, e);
        give = std::min(give, e.give);
        if (loaded && s < (closing ? tuning::kLinearSlop_m : kStill_m)) {
            e.wanted = 0;
        } else if (s > 0) {
            e.wanted = -d(s) / d(scene.h_s);
            // What the solution pushed is let go as far as it parts the bodies: more would pull them
            // together, where its energy has been taken back since.
            if (closing && loaded) {
                const int member = static_cast<int>(joints_.size() + contact);
                e.wanted = std::clamp(system_.speed(member, i, velocity_before_), e.wanted, 0.0);
            }
        } else {
            e.wanted = 0;
        }
        if (!closing && s < -kStill_m) {
            e.wanted =
                d(std::min(-c.softness.bias_rate * (s + kStill_m), scene.rules.max_push_out_speed_m_s));
            if (s < -kDeep_m && !joints_.empty()) e.give = give_when_deep(c, p, e);
        }
        e.state = s > 0 && !loaded ? State::AtLow : State::Acts;
        recall(i, phase);
        pressed += e.impulse;
    }
    for (int first = i; i < member_of_contact(contact).last_equation; ++i) {
        DirectEquation& e = system_.equations[at(i)];
        e.wanted = i == first ? d(c.surface_speed_m_s) : 0;
        e.give = give;
        // Give lets what rests on a slope creep with give times impulse. Where the impulse of rest is aimed
        // at it stands still: half of that of the last substep, as the other half was given while closing.
        if (!closing) e.wanted += give * e.impulse / 2;
        e.high = e.coefficient * pressed;
        e.low = -e.high;
        e.state = state_at_bounds(e, closing ? e.before : e.impulse);
        recall(i, phase);
        if (e.coefficient == 0) e.state = State::Idle;
    }
}

void DirectComponent::describe(const DirectScene& scene, Phase phase) {
    if (!is_weighed_) system_.weigh();
    is_weighed_ = true;
    for (DirectEquation& e : system_.equations) {
        if (phase == Phase::Solve) e.before = 0;
        e.give = attempt_.joints * e.inverse_mass;
    }
    const double h = d(scene.h_s);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const JointConstraint& c = scene.joints[at(joints_[j].place)];
        const Member& m = system_.members[j];
        for (int e = m.first_equation; e < m.last_equation; ++e) {
            describe(c.laws[at(joint_rows_[at(e)].law)], joint_rows_[at(e)], system_.equations[at(e)], h,
                     phase);
            if (system_.equations[at(e)].bound == DirectEquation::Bound::Range) recall(e, phase);
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) describe_contact(scene, k, phase);
    if (attempt_.sweeps_contacts) {
        for (std::size_t i = joint_rows_.size(); i < system_.equations.size(); ++i) {
            system_.equations[i].state = State::Idle;
            system_.equations[i].inverse_mass = 0;  // and stays so
        }
        is_weighed_ = false;
    }
    for (DirectEquation& e : system_.equations) {
        if (!(e.inverse_mass > 0)) e.state = State::Idle;
    }
}

// No impulse can be much more than what stops all bodies at once, but where joints want two things.
bool DirectComponent::is_contradictory() const {
    double mass = 0;
    double fastest = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        mass += system_.bodies[i].mass;
        fastest =
            std::max(fastest, std::fabs(velocity_before_[3 * i]) + std::fabs(velocity_before_[3 * i + 1]));
    }
    const double most = kMostLeverage * mass * (fastest + kMaxClosingSpeed_m_s);
    // Torques have another unit; arms are of the order of metres.
    return std::any_of(system_.equations.begin(), system_.equations.end(),
                       [&](const DirectEquation& e) { return !(std::fabs(e.impulse) <= most); });
}

// Finds velocities and impulses, with limits and caps as they turn out.
void DirectComponent::satisfy(const DirectScene& scene, Phase phase) {
    for (const Attempt& attempt : kAttempts) {
        attempt_ = attempt;
        for (std::size_t i = 0; i < impulse_at_start_.size(); ++i)
            system_.equations[i].impulse = impulse_at_start_[i];
        describe(scene, phase);
        factorizations_left_ -=
            system_.satisfy(velocity_before_, std::max(factorizations_left_, kFewestFactorizations));
        if (!is_contradictory()) return remember_states(phase);
    }
    forget_states();
    // Not a number, or beyond all bounds: the joints rest in this substep.
    system_.velocity = velocity_before_;
    for (DirectEquation& e : system_.equations) e.impulse = 0;
}

// When no solution was found with them.
void DirectComponent::sweep_contacts(const DirectScene& scene, Phase phase) {
    if (!attempt_.sweeps_contacts) return;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        ContactConstraint& c = scene.contacts[at(contacts_[k].place)];
        const auto equation = [&](int i) -> DirectEquation& {
            return system_.equations[at(member_of_contact(k).first_equation + i)];
        };
        const std::array<float, 2> totals{c.points[0].total_normal_impulse, c.points[1].total_normal_impulse};
        for (int i = 0; i < c.count; ++i)
            c.points[at(i)].normal_impulse = static_cast<float>(equation(i).before);
        c.friction_impulse = static_cast<float>(equation(c.count).before);
        solve_contact(c, scene.motions, scene.rules, scene.h_s,
                      phase == Phase::Solve ? Pass::Biased : Pass::Relax);
        for (int i = 0; i < c.count; ++i) {
            equation(i).impulse = d(c.points[at(i)].normal_impulse) - equation(i).before;
            c.points[at(i)].total_normal_impulse = totals[at(i)];
        }
        equation(c.count).impulse = d(c.friction_impulse) - equation(c.count).before;
    }
}

}  // namespace cairn::physics
