// The phases of a substep. Glossary: J row of the Jacobian, p impulse of an equation, I~ inertia with
// geometric stiffness, C error.
#include "resolve/direct/direct_component.h"

#include <algorithm>
#include <cmath>

#include "resolve/direct/direct_tuning.h"
#include "resolve/direct/numbers.h"

namespace cairn::physics {
namespace {

using State = DirectEquation::State;

}  // namespace

void DirectComponent::read(const Motions& motions) {
    velocity_before_.resize(3 * rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        velocity_before_[3 * i] = d(motions.velocity[rows_[i]].v.x);
        velocity_before_[3 * i + 1] = d(motions.velocity[rows_[i]].v.y);
        velocity_before_[3 * i + 2] = d(motions.spin(rows_[i]));
    }
}

void DirectComponent::write(Motions& motions) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Motion m = motions.get(rows_[i]);
        m.v = {static_cast<float>(system_.velocity[3 * i]), static_cast<float>(system_.velocity[3 * i + 1])};
        m.w = static_cast<float>(system_.velocity[3 * i + 2]);
        motions.set(rows_[i], m);
    }
}

void DirectComponent::note_spins(const Motions& motions) {
    known_spins_.resize(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) known_spins_[i] = motions.spin(rows_[i]);
}

// What others turned the bodies by, they turned by the inertia of their own: as much angular momentum turns
// I~ less. Left as it is, it would be I~/I times as much.
void DirectComponent::weigh_spins(Motions& motions) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const DirectBody& body = system_.bodies[i];
        if (!body.turns || body.inertia <= body.own_inertia) continue;
        Motion m = motions.get(rows_[i]);
        if (m.w == known_spins_[i]) continue;
        m.w = known_spins_[i] + static_cast<float>(body.own_inertia / body.inertia) * (m.w - known_spins_[i]);
        motions.set(rows_[i], m);
    }
}

// What links give as forces, whatever the direction, in a phase.
template <class Set>
void DirectComponent::measure_pulls(const Set& set) {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const Member& m = system_.members[j];
        for (int l = m.first_link; l < m.last_link; ++l) {
            double x = 0, y = 0;
            for (int e = m.first_equation; e < m.last_equation; ++e) {
                const double* row = system_.j(static_cast<int>(j), l, e);
                const double p = system_.equations[at(e)].impulse;
                x += p * row[0];
                y += p * row[1];
            }
            set(links_[at(l)], std::sqrt(x * x + y * y));
        }
    }
}

void DirectComponent::sum_levers() {
    std::fill(levers_.begin(), levers_.end(), 0.0);
    for (std::size_t l = 0; l < links_.size(); ++l) {
        const Lever& lever = links_[l];
        levers_[at(system_.links[l].body)] += lever.arm * (lever.pulled + lever.closed);
    }
}

double DirectComponent::inertia_for(std::size_t body, double h) const {
    const double own = system_.bodies[body].own_inertia;
    const double needed = own + std::max(0.0, h * levers_[body] - 2 * own);
    const bool turns = is_loop_ && std::fabs(velocity_before_[3 * body + 2]) > kTurning_rad_s;
    return turns ? std::min(needed, system_.bodies[body].inertia) : needed;
}

bool DirectComponent::enlarge_inertia(double h) {
    bool enlarged = false;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        DirectBody& body = system_.bodies[i];
        const double needed = inertia_for(i, h);
        if (!body.turns || needed <= 2 * body.inertia) continue;
        body.inertia = needed;
        enlarged = true;
    }
    return enlarged;
}

void DirectComponent::note_spring_speeds() {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const Member& m = system_.members[j];
        for (int e = m.first_equation; e < m.last_equation; ++e)
            joint_rows_[at(e)].speed_before = system_.speed(static_cast<int>(j), e);
    }
}

void DirectComponent::start(const DirectScene& scene, std::span<const float> inertia_before) {
    const Motions& motions = scene.motions;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        DirectBody& body = system_.bodies[i];
        const int row = rows_[i];
        const float inverse_mass = motions.velocity[row].inverse_mass;
        const float inverse_inertia = motions.inverse_inertia[row];
        const std::uint8_t locked = motions.locked_axes(row);
        body.moves_x = inverse_mass > 0 && (locked & kLockedX) == 0;
        body.moves_y = inverse_mass > 0 && (locked & kLockedY) == 0;
        body.turns = inverse_inertia > 0;
        body.mass = inverse_mass > 0 ? 1 / d(inverse_mass) : 1;
        body.own_inertia = body.turns ? 1 / d(inverse_inertia) : 1;
        body.inertia = std::max(d(inertia_before[at(row)]), body.own_inertia);
    }
    place_joints(scene);
    place_contacts(scene);
    forget_states();
    note_spins(motions);
    read(motions);
    // The speed that the last substep was solved for, before its closing half kick: with that of the kick in
    // it, springs would sag too far.
    system_.velocity = velocity_before_;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Drive& drive = scene.drives[at(rows_[i])];
        system_.velocity[3 * i] -= d(0.5f * scene.h_s * drive.acceleration.x);
        system_.velocity[3 * i + 1] -= d(0.5f * scene.h_s * drive.acceleration.y);
        system_.velocity[3 * i + 2] -= d(0.5f * scene.h_s * drive.angular_acceleration);
    }
    note_spring_speeds();
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const JointConstraint& c = scene.joints[at(joints_[j].place)];
        const Member& m = system_.members[j];
        for (int i = m.first_equation; i < m.last_equation; ++i) {
            const JointRow& row = joint_rows_[at(i)];
            const JointLaw& law = c.laws[at(row.law)];
            system_.equations[at(i)].impulse =
                d(c.impulse[at(impulse_index(law.direction + row.part, role_of(law.kind)))]);
            system_.equations[at(i)].state = State::Acts;
        }
        const AnchorsNow anchors = anchors_now(c.anchors, motions);
        for (int i = 0; i < c.bodies; ++i) {
            const int link = joints_[j].links[at(i)];
            if (link >= 0)
                links_[at(link)].arm = i == 0 ? d(length(anchors.r_a)) : i == 1 ? d(length(anchors.r_b)) : 0;
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const ContactConstraint& c = scene.contacts[at(contacts_[k].place)];
        int i = member_of_contact(k).first_equation;
        for (int point = 0; point < c.count; ++point, ++i) {
            // An unknown impulse is that of rest.
            const ContactPointConstraint& p = c.points[at(point)];
            system_.equations[at(i)].impulse = d(p.normal_impulse < 0 ? p.static_impulse : p.normal_impulse);
        }
        system_.equations[at(i)].impulse = d(c.friction_impulse);
    }
    // About half of it was given while closing.
    measure_pulls([](Lever& lever, double pull) { lever.pulled = lever.closed = pull / 2; });
    sum_levers();
}

void DirectComponent::solve(const DirectScene& scene) {
    const double h = d(scene.h_s);
    factorizations_left_ = kMaxFactorizations;
    weigh_spins(scene.motions);
    read(scene.motions);
    inertia_before_.resize(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        inertia_before_[i] = system_.bodies[i].inertia;
        system_.bodies[i].inertia = inertia_for(i, h);
    }
    impulse_at_start_.resize(system_.equations.size());
    for (std::size_t i = 0; i < impulse_at_start_.size(); ++i)
        impulse_at_start_[i] = system_.equations[i].impulse;
    for (int enlargement = 0; enlargement <= kMaxEnlargements; ++enlargement) {
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            // Angular momentum stays.
            const double inertia = system_.bodies[i].inertia;
            if (inertia <= inertia_before_[i]) continue;
            velocity_before_[3 * i + 2] *= inertia_before_[i] / inertia;
            inertia_before_[i] = inertia;
        }
        satisfy(scene, Phase::Solve);
        measure_pulls([](Lever& lever, double pull) { lever.pulled = pull; });
        sum_levers();
        if (!enlarge_inertia(h)) break;
    }
    surplus_ = surplus(scene, kinetic_energy(velocity_before_), 1);
    note_spring_speeds();
    write(scene.motions);
    note_spins(scene.motions);
    sweep_contacts(scene, Phase::Solve);
    give_impulses(scene);
}

void DirectComponent::give_impulses(const DirectScene& scene) {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        JointConstraint& c = scene.joints[at(joints_[j].place)];
        const Member& m = system_.members[j];
        for (int i = m.first_equation; i < m.last_equation; ++i) {
            const JointRow& row = joint_rows_[at(i)];
            const DirectEquation& e = system_.equations[at(i)];
            const JointLaw& law = c.laws[at(row.law)];
            c.impulse[at(impulse_index(law.direction + row.part, role_of(law.kind)))] =
                static_cast<float>(e.before + e.impulse);
            const auto given = static_cast<float>(e.impulse);
            c.total_impulse += given * row.force;
            c.total_angular_impulse += given * row.torque;
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        ContactConstraint& c = scene.contacts[at(contacts_[k].place)];
        int i = member_of_contact(k).first_equation;
        for (int point = 0; point < c.count; ++point, ++i) {
            const DirectEquation& e = system_.equations[at(i)];
            ContactPointConstraint& p = c.points[at(point)];
            p.normal_impulse = static_cast<float>(e.before + e.impulse);
            p.total_normal_impulse += static_cast<float>(e.impulse);
        }
        c.friction_impulse =
            static_cast<float>(system_.equations[at(i)].before + system_.equations[at(i)].impulse);
    }
}

double DirectComponent::greatest_error(const DirectScene& scene) const {
    double greatest = 0;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const JointConstraint& c = scene.joints[at(joints_[j].place)];
        const Member& m = system_.members[j];
        for (int i = m.first_equation; i < m.last_equation; ++i) {
            const JointLaw& law = c.laws[at(joint_rows_[at(i)].law)];
            if (system_.equations[at(i)].state != State::Acts || law.kind != LawKind::Hold || !law.rigid)
                continue;
            greatest = std::max(greatest, std::fabs(joint_rows_[at(i)].error));
        }
    }
    return greatest;
}

// Moves the bodies by what the equations say about the errors of what is held; whether that was worth while.
// Velocities follow, so that they are those of the way that was really gone: then what is lost on the way
// from one tangent to the chord is won again on that to the next tangent, and a pendulum keeps its energy
// (RATTLE: Andersen 1983).
bool DirectComponent::project(const DirectScene& scene) {
    const double before = greatest_error(scene);
    if (before < kNoError || before > kMaxProjected) return false;
    x_.assign(at(system_.unknowns()), 0);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const JointConstraint& c = scene.joints[at(joints_[j].place)];
        const Member& m = system_.members[j];
        double* x = x_.data() + system_.place_of_member(static_cast<int>(j));
        for (int i = m.first_equation; i < m.last_equation; ++i, ++x) {
            const JointLaw& law = c.laws[at(joint_rows_[at(i)].law)];
            if (system_.equations[at(i)].state == State::Acts && law.kind == LawKind::Hold && law.rigid)
                *x = -joint_rows_[at(i)].error;
        }
    }
    system_.solve(x_);
    Motions& motions = scene.motions;
    const auto shift = [&](double sign) {
        const double faster = sign / d(scene.h_s);
        for (int i = 0; i < bodies(); ++i) {
            const int row = rows_[at(i)];
            const double* x = x_.data() + system_.place_of_body(i);
            PoseRow& pose = motions.pose[row];
            pose.d += Vec2{static_cast<float>(sign * x[0]), static_cast<float>(sign * x[1])};
            if (system_.bodies[at(i)].turns) pose.theta += static_cast<float>(sign * x[2]) / pose.k;
            Motion m = motions.get(row);
            m.v += Vec2{static_cast<float>(faster * x[0]), static_cast<float>(faster * x[1])};
            m.w += static_cast<float>(faster * x[2]);
            motions.set(row, m);
            motions.turned[row] = Rotation::from_small_angle(motions.angle(row));
        }
        place_joints(scene);
    };
    shift(1);
    if (greatest_error(scene) <= kWorthwhile * before) return true;
    shift(-1);
    return false;
}

// Whether a contact did, in the last solution.
bool DirectComponent::has_pressed() const {
    return std::any_of(system_.equations.begin() + joint_rows(), system_.equations.end(),
                       [](const DirectEquation& e) { return e.impulse != 0; });
}

// How many parts of the substep structures need that turn fast: an error of a tangent grows with the square
// of the turn, and whips lose their energy to it.
int DirectComponent::parts_needed(const DirectScene& scene) const {
    double most_turned = 0;
    for (std::size_t l = 0; l < links_.size(); ++l) {
        if (links_[l].arm < kNoArm_m) continue;
        const int row = rows_[at(system_.links[l].body)];
        most_turned = std::max(most_turned, std::fabs(d(scene.h_s * scene.motions.spin(row))));
    }
    const int most = has_pressed() ? kMaxPartsInContact : kMaxParts;
    int parts = 1;
    while (parts < most && most_turned > kResolvedTurn_rad * parts) parts *= 2;
    return parts;
}

// Gravity acts at the ends of the substep, whatever its parts: in between, bodies move freely along their
// joints. (Source: Tuckerman, Berne and Martyna, "Reversible Multiple Time Scale Molecular Dynamics", 1992.)
void DirectComponent::move(const DirectScene& scene) {
    const int parts = parts_needed(scene);
    factorizations_left_ = kMaxFactorizations;
    DirectScene part = scene;
    part.h_s /= static_cast<float>(parts);
    for (int i = 1; i <= parts; ++i) {
        weigh_spins(scene.motions);
        note_energy(scene.motions);
        advance(part);
        kicked_ = i == parts;
        if (kicked_) kick(scene);
        close(part, parts);
    }
    if (parts == 1) return;
    // What turning needed pulled in parts, gravity over the whole substep.
    for (Lever& lever : links_)
        lever.closed =
            std::min(lever.closed, lever.pulled) + std::max(0.0, lever.closed - lever.pulled) / parts;
    sum_levers();
}

void DirectComponent::advance(const DirectScene& scene) {
    Motions& motions = scene.motions;
    double most_turned = 0;
    for (const int row : rows_) {
        motions.pose[row].d += scene.h_s * motions.velocity[row].v;
        motions.pose[row].theta += scene.h_s * motions.velocity[row].w;
        motions.turned[row] = Rotation::from_small_angle(motions.angle(row));
        most_turned = std::max(most_turned, std::fabs(d(scene.h_s * motions.spin(row))));
    }
    place_joints(scene);
    if (most_turned > kMaxTurn_rad) return;
    if (project(scene)) project(scene);
}

void DirectComponent::kick(const DirectScene& scene) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const DirectBody& body = system_.bodies[i];
        const Drive& drive = scene.drives[at(rows_[i])];
        Motion m = scene.motions.get(rows_[i]);
        m.v += 0.5f * scene.h_s * drive.acceleration;
        m.w += 0.5f * scene.h_s * static_cast<float>(body.own_inertia / body.inertia) *
               drive.angular_acceleration;
        scene.motions.set(rows_[i], m);
    }
}

void DirectComponent::close(const DirectScene& scene, int parts) {
    Motions& motions = scene.motions;
    read(motions);
    for (std::size_t i = 0; i < system_.equations.size(); ++i) {
        DirectEquation& e = system_.equations[i];
        e.before = impulse_at_start_[i] = e.impulse;
    }
    satisfy(scene, Phase::Close);
    measure_pulls([](Lever& lever, double pull) { lever.closed = pull; });
    sum_levers();
    const double gained = surplus(scene, energy_ + work_of_kick(scene, parts), parts);
    if (gained > 0) take_back(gained);
    write(motions);
    note_spins(motions);
    sweep_contacts(scene, Phase::Close);
    give_impulses(scene);
    for (DirectEquation& e : system_.equations) e.impulse += e.before;
}

}  // namespace cairn::physics
