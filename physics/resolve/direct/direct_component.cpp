// The substep of a structure. Glossary: J row of the Jacobian, p impulse of an equation, I~ inertia with
// geometric stiffness, C error.
#include "resolve/direct/direct_component.h"

#include <algorithm>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "resolve/joints/kinds.h"

namespace cairn::physics {
namespace {

// Of J 1/M J^T: what makes joints that say the same thing twice solvable. Their gaps stay at round-off.
constexpr double kGive = 1e-10;
// The same for joints that contradict each other, as in a loop that was torn open: they meet in between.
constexpr double kGiveOfContradictions = 1e-4;
// And for contacts, which say the same thing twice where a body stands on two of them and is held by a joint:
// as much, but no more than lets them sink with this speed under their load, m/s.
constexpr double kContactGive = 1e-3;
constexpr double kSinking_m_s = 1e-4;
// m. Contacts this deep or this far apart are let alone: errors of two that bear one body would be
// contradictions.
constexpr float kStill_m = 0.02f * tuning::kLinearSlop_m;
// Impulses of this many times all there is to move betray a contradiction.
constexpr double kMostLeverage = 100;
// m/s. Joints that were torn apart come together no faster.
constexpr double kMaxClosingSpeed_m_s = 40;
// m and rad. Errors beyond it are left to the velocities: a projection along rows of the Jacobian is local.
constexpr double kMaxProjected = 0.05;
// m and rad. Errors below it are within the rounding of positions.
constexpr double kNoError = 1e-7;
// rad. A body that turns more in a substep has rows that have turned away from what they were.
constexpr double kMaxTurn_rad = 0.35;
// A projection that leaves more of the error than this is undone.
constexpr double kWorthwhile = 0.3;
constexpr int kMaxEnlargements = 3;

using State = DirectEquation::State;
using Bound = DirectEquation::Bound;

double d(float x) {
    return static_cast<double>(x);
}

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

bool moves(const Motions& motions, int row) {
    return motions.velocity[row].inverse_mass > 0 || motions.inverse_inertia[row] > 0;
}

void set_j(double* j, const DirectBody& body, Vec2 linear, float angular, double sign) {
    j[0] = body.moves_x ? sign * d(linear.x) : 0;
    j[1] = body.moves_y ? sign * d(linear.y) : 0;
    j[2] = body.turns ? sign * d(angular) : 0;
}

// Of bodies that move by themselves.
double speed_of_row(const Motions& motions, int row, Vec2 linear, float angular) {
    return d(dot(linear, motions.velocity[row].v)) + d(angular * motions.spin(row));
}

}  // namespace

const std::array<DirectComponent::Attempt, 3> DirectComponent::kAttempts{{
    {kGive, false},
    {kGive, true},
    {kGiveOfContradictions, true},
}};

// ---- Structure

int DirectComponent::find_body(int row, std::vector<int>& body_of_row) {
    int& body = body_of_row[at(row)];
    if (body < 0) {
        body = bodies();
        system_.add_body();
        rows_.push_back(row);
    }
    return body;
}

int DirectComponent::link_to(int row, const Motions& motions, std::vector<int>& body_of_row) {
    if (!moves(motions, row)) return -1;
    system_.add_link(find_body(row, body_of_row));
    return static_cast<int>(system_.links.size()) - 1;
}

void DirectComponent::assemble(std::span<const int> joints, std::span<const int> contacts,
                               const DirectScene& scene, std::vector<int>& body_of_row) {
    system_.clear();
    rows_.clear();
    joints_.clear();
    contacts_.clear();
    joint_rows_.clear();
    for (const int place : joints) {
        const JointConstraint& c = scene.joints[at(place)];
        system_.begin_member();
        JointMember& member = joints_.emplace_back();
        member.place = place;
        for (int i = 0; i < c.bodies; ++i)
            member.links[at(i)] = link_to(c.rows[at(i)], scene.motions, body_of_row);
        for (int l = 0; l < c.law_count; ++l) {
            const JointLaw& law = c.laws[at(l)];
            for (int part = 0; part < law.count; ++part) {
                DirectEquation& e = system_.equations[at(system_.add_equation())];
                switch (law.kind) {
                    case LawKind::Hold:
                        break;
                    case LawKind::Spring:
                    case LawKind::Motor:
                        e.bound = Bound::Range;
                        // The second one of a pair is bounded with the first.
                        if (law.round) e.bound = part == 0 ? Bound::Round : Bound::None;
                        break;
                    case LawKind::Lower:
                    case LawKind::Upper:
                        e.bound = Bound::Range;
                        break;
                }
                const bool pushes = law.kind == LawKind::Lower || law.kind == LawKind::Upper;
                e.low = pushes ? 0 : d(law.low);
                e.high = pushes ? kUnlimited : d(law.high);
                JointRow& row = joint_rows_.emplace_back();
                row.law = l;
                row.part = part;
                row.sign = law.kind == LawKind::Upper ? -1 : 1;
            }
        }
    }
    links_.assign(system_.links.size(), {});
    for (const int place : contacts) {
        const ContactConstraint& c = scene.contacts[at(place)];
        system_.begin_member();
        ContactMember& member = contacts_.emplace_back();
        member.place = place;
        member.links = {link_to(c.a, scene.motions, body_of_row), link_to(c.b, scene.motions, body_of_row)};
        const int first = static_cast<int>(system_.equations.size());
        for (int i = 0; i < c.count; ++i) {
            DirectEquation& e = system_.equations[at(system_.add_equation())];
            e.bound = Bound::Range;
            e.high = kUnlimited;
        }
        const auto add_friction = [&](float coefficient) {
            DirectEquation& e = system_.equations[at(system_.add_equation())];
            e.bound = Bound::Friction;
            e.coefficient = d(coefficient);
            e.first_push = first;
            e.last_push = first + c.count;
        };
        add_friction(c.friction);
        if (c.rolling_m > 0) add_friction(c.rolling_m);
    }
    for (const int row : rows_) body_of_row[at(row)] = -1;
    system_.arrange();
    levers_.assign(rows_.size(), 0);
}

// ---- Geometry

void DirectComponent::place_joints(const DirectScene& scene) {
    const Motions& motions = scene.motions;
    Directions directions;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const JointMember& joint = joints_[j];
        const JointConstraint& c = scene.joints[at(joint.place)];
        const Member& m = system_.members[j];
        place(c, scene.joints, motions, directions);
        const Vec2 arm_b = rotate(motions.turned[c.anchors.b], c.anchors.r_b);
        for (int e = m.first_equation; e < m.last_equation; ++e) {
            JointRow& row = joint_rows_[at(e)];
            const JointLaw& law = c.laws[at(row.law)];
            const Direction& direction = directions[at(law.direction + row.part)];
            row.error = row.sign * d(direction.q - law.target);
            const Jacobian& on_b = direction.j[at(c.b)];
            row.force = static_cast<float>(row.sign) * on_b.linear;
            row.torque = static_cast<float>(row.sign) * (on_b.angular - cross(arm_b, on_b.linear));
            double& drift = system_.equations[at(e)].drift;
            drift = 0;
            for (int i = 0; i < c.bodies; ++i) {
                const Jacobian& part = direction.j[at(i)];
                const int link = joint.links[at(i)];
                if (link >= 0) {
                    set_j(system_.j(static_cast<int>(j), link, e),
                          system_.bodies[at(system_.links[at(link)].body)], part.linear, part.angular,
                          row.sign);
                } else if (c.rows[at(i)] != kWorldRow) {
                    drift += row.sign * speed_of_row(motions, c.rows[at(i)], part.linear, part.angular);
                }
            }
        }
    }
}

// Normals and arms stay as they are at the start of the step.
void DirectComponent::place_contacts(const DirectScene& scene) {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const ContactMember& contact = contacts_[k];
        const ContactConstraint& c = scene.contacts[at(contact.place)];
        const int member = static_cast<int>(joints_.size() + k);
        int e = system_.members[at(member)].first_equation;
        const auto set_row = [&](Vec2 axis, float angular_a, float angular_b) {
            double& drift = system_.equations[at(e)].drift;
            drift = 0;
            for (const int i : {0, 1}) {
                const Vec2 linear = i == 0 ? -axis : axis;
                const float angular = i == 0 ? angular_a : angular_b;
                const int link = contact.links[at(i)];
                const int row = i == 0 ? c.a : c.b;
                if (link >= 0) {
                    set_j(system_.j(member, link, e), system_.bodies[at(system_.links[at(link)].body)],
                          linear, angular, 1);
                } else {
                    drift += speed_of_row(scene.motions, row, linear, angular);
                }
            }
            ++e;
        };
        for (int i = 0; i < c.count; ++i) {
            const ContactPointConstraint& p = c.points[at(i)];
            set_row(c.normal, -cross(p.r_a, c.normal), cross(p.r_b, c.normal));
        }
        const Vec2 tangent = right_perp(c.normal);
        set_row(tangent, -cross(c.friction_r_a, tangent), cross(c.friction_r_b, tangent));
        if (c.rolling_m > 0) set_row({}, -1, 1);
    }
}

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

// ---- Equations

void DirectComponent::describe(const JointLaw& law, JointRow& row, DirectEquation& e, double h,
                               Phase phase) const {
    const bool closing = phase == Phase::Close;
    const State state_before = e.state;
    e.state = State::Acts;
    switch (law.kind) {
        case LawKind::Hold:
            e.wanted = closing ? 0 : -std::clamp(row.error / h, -kMaxClosingSpeed_m_s, kMaxClosingSpeed_m_s);
            if (law.rigid) break;
            e.give = e.inverse_mass * d(law.softness.impulse_scale / law.softness.mass_scale);
            e.wanted = -d(law.softness.bias_rate) * row.error;
            if (closing) e.state = State::Idle;
            break;
        case LawKind::Spring:
            e.give = e.inverse_mass / d(law.spring.d1);
            e.wanted = -(d(law.spring.d0) * row.speed_before + d(law.spring.stiffness_per_s) * row.error) /
                       d(law.spring.d1);
            if (closing) e.state = State::Idle;
            break;
        case LawKind::Motor:
            e.wanted = d(law.speed[at(row.part)]);
            // It does no more than it can.
            if (closing && (state_before == State::AtLow || state_before == State::AtHigh))
                e.state = State::Idle;
            break;
        case LawKind::Lower:
        case LawKind::Upper:
            e.wanted = std::min(-(closing ? std::max(row.error, 0.0) : row.error) / h, kMaxClosingSpeed_m_s);
            if (row.error > 0 && !(e.impulse > 0)) e.state = State::AtLow;
            break;
    }
}

double give_of_contact(const ContactPointConstraint& p, const DirectEquation& e) {
    const double load = std::max({e.impulse, e.before, d(p.static_impulse)});
    return std::min(kContactGive * e.inverse_mass, kSinking_m_s / load);
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
        } else {
            e.wanted = 0;
        }
        if (!closing && s < -kStill_m) {
            e.wanted =
                d(std::min(-c.softness.bias_rate * (s + kStill_m), scene.rules.max_push_out_speed_m_s));
        }
        e.state = s > 0 && !loaded ? State::AtLow : State::Acts;
        pressed += e.impulse;
    }
    for (int first = i; i < member_of_contact(contact).last_equation; ++i) {
        DirectEquation& e = system_.equations[at(i)];
        e.wanted = i == first ? d(c.surface_speed_m_s) : 0;
        e.give = give;
        e.high = e.coefficient * pressed;
        e.low = -e.high;
        const double last = phase == Phase::Solve ? e.impulse : e.before;
        e.state = State::Acts;
        if (last <= 0.999 * e.low) e.state = State::AtLow;
        if (last >= 0.999 * e.high) e.state = State::AtHigh;
        if (e.coefficient == 0) e.state = State::Idle;
    }
}

void DirectComponent::describe(const DirectScene& scene, Phase phase) {
    system_.weigh();
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
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) describe_contact(scene, k, phase);
    if (attempt_.sweeps_contacts) {
        for (std::size_t i = joint_rows_.size(); i < system_.equations.size(); ++i) {
            system_.equations[i].state = State::Idle;
            system_.equations[i].inverse_mass = 0;  // and stays so
        }
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
        const bool keeps_bounds = system_.satisfy(velocity_before_);
        if (keeps_bounds && !is_contradictory()) return;
    }
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

// ---- Inertia

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
    return own + std::max(0.0, h * levers_[body] - 2 * own);
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

// ---- The phases

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
    note_spring_speeds();
    write(scene.motions);
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

void DirectComponent::move(const DirectScene& scene) {
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

void DirectComponent::close(const DirectScene& scene) {
    Motions& motions = scene.motions;
    for (const int row : rows_) {
        Motion m = motions.get(row);
        const Drive& drive = scene.drives[at(row)];
        m.v += 0.5f * scene.h_s * drive.acceleration;
        m.w += 0.5f * scene.h_s * drive.angular_acceleration;
        motions.set(row, m);
    }
    read(motions);
    for (std::size_t i = 0; i < system_.equations.size(); ++i) {
        DirectEquation& e = system_.equations[i];
        e.before = impulse_at_start_[i] = e.impulse;
    }
    satisfy(scene, Phase::Close);
    measure_pulls([](Lever& lever, double pull) { lever.closed = pull; });
    sum_levers();
    write(motions);
    sweep_contacts(scene, Phase::Close);
    give_impulses(scene);
    for (DirectEquation& e : system_.equations) e.impulse += e.before;
}

}  // namespace cairn::physics
