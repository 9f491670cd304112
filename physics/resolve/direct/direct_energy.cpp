// Joints that hold do no work, and contacts take energy: what a substep has gained beyond what motors,
// springs and moving supports did to it was made by errors, and is taken back.
//
// Where it comes from: a structure that is nearly taut (a straight bridge, a loop in a singular pose) must
// move far to the side to mend a small error along it. The bias of the solution and the projection of
// positions ask for that way within one substep, and its velocity stays. What impulses p did in a solution is
// known exactly, p (u_before + u_after)/2 with u = J v of each equation. Taken back is motion relative to the
// centre of mass, so that momentum stays, or all motion where something holds the structure: both are along
// all joints, which thus go on holding.
#include <algorithm>
#include <cmath>

#include "resolve/direct/direct_component.h"
#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"

namespace cairn::physics {
double DirectComponent::kinetic_energy(std::span<const double> velocity) const {
    double sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const DirectBody& body = system_.bodies[i];
        const double* v = velocity.data() + 3 * i;
        sum += body.mass * (v[0] * v[0] + v[1] * v[1]);
        if (body.turns) sum += body.inertia * v[2] * v[2];
    }
    return sum / 2;
}

// What may differ for reasons of no interest.
double DirectComponent::indifferent_energy(const DirectScene& scene) const {
    double sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Vec2 kick = scene.h_s * scene.drives[at(rows_[i])].acceleration;
        sum += system_.bodies[i].mass * (d(dot(kick, kick)) + kSlow_m_s * kSlow_m_s);
    }
    return sum / 2;
}

// What the closing solution starts from, had the positions met their joints.
void DirectComponent::note_energy(const Motions& motions) {
    read(motions);
    energy_ = std::max(0.0, kinetic_energy(velocity_before_) - surplus_);
    surplus_ = 0;
}

// Of the closing half kick, along the way that the bodies take there.
double DirectComponent::work_of_kick(const DirectScene& scene, int parts) const {
    double sum = 0;
    if (!kicked_) return sum;
    const double half_s = d(scene.h_s) * parts / 2;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const DirectBody& body = system_.bodies[i];
        const Drive& drive = scene.drives[at(rows_[i])];
        const double* v = system_.velocity.data() + 3 * i;
        sum += body.mass * (d(drive.acceleration.x) * v[0] + d(drive.acceleration.y) * v[1]);
        if (body.turns) sum += body.own_inertia * d(drive.angular_acceleration) * v[2];
    }
    return half_s * sum;
}

// Whether an equation asks for motion by itself, instead of for less of it.
bool DirectComponent::is_driven(const DirectScene& scene, std::size_t member, int equation) const {
    if (member >= joints_.size()) {
        const ContactMember& contact = contacts_[member - joints_.size()];
        return scene.contacts[at(contact.place)].surface_speed_m_s != 0;
    }
    const JointConstraint& c = scene.joints[at(joints_[member].place)];
    const LawKind kind = c.laws[at(joint_rows_[at(equation)].law)].kind;
    return kind == LawKind::Motor || kind == LawKind::Spring;
}

// By motors, springs, and what moves outside of the structure; where it took energy out, nothing.
double DirectComponent::work_done(const DirectScene& scene) const {
    double sum = 0;
    for (std::size_t m = 0; m < system_.members.size(); ++m) {
        const Member& member = system_.members[m];
        for (int i = member.first_equation; i < member.last_equation; ++i) {
            const DirectEquation& e = system_.equations[at(i)];
            if (e.impulse == 0) continue;
            if (e.drift == 0 && !is_driven(scene, m, i)) continue;
            double before = 0;
            double after = 0;
            for (int l = member.first_link; l < member.last_link; ++l) {
                const double* j = system_.j(static_cast<int>(m), l, i);
                const auto body = at(3 * system_.links[at(l)].body);
                for (std::size_t k = 0; k < 3; ++k) {
                    before += j[k] * velocity_before_[body + k];
                    after += j[k] * system_.velocity[body + k];
                }
            }
            sum += std::max(0.0, e.impulse * (before + after) / 2);
        }
    }
    return sum;
}

// After a solution.
double DirectComponent::surplus(const DirectScene& scene, double energy_before, int parts) const {
    const double gained = kinetic_energy(system_.velocity) - energy_before;
    if (gained <= kEnergyTolerance * energy_before / parts) return 0;
    if (gained <= (kEnergyTolerance * energy_before + indifferent_energy(scene)) / parts) return 0;
    return std::max(0.0, gained - work_done(scene));
}

bool DirectComponent::is_free() const {
    return std::all_of(joints_.begin(), joints_.end(),
                       [](const JointMember& joint) { return joint.links[0] >= 0 && joint.links[1] >= 0; });
}

// Slows the bodies down until they have lost so much energy, or all but that of their centre of mass.
void DirectComponent::take_back(double surplus) {
    std::vector<double>& v = system_.velocity;
    double mass = 0, x = 0, y = 0;
    if (is_free()) {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            mass += system_.bodies[i].mass;
            x += system_.bodies[i].mass * v[3 * i];
            y += system_.bodies[i].mass * v[3 * i + 1];
        }
        x /= mass;
        y /= mass;
    }
    const double common = mass * (x * x + y * y) / 2;
    const double own = kinetic_energy(v) - common;
    if (!(own > 0)) return;
    const double kept = std::sqrt(std::max(0.0, 1 - surplus / own));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const DirectBody& body = system_.bodies[i];
        if (body.moves_x) v[3 * i] = x + kept * (v[3 * i] - x);
        if (body.moves_y) v[3 * i + 1] = y + kept * (v[3 * i + 1] - y);
        if (body.turns) v[3 * i + 2] *= kept;
    }
}

}  // namespace cairn::physics
