// What a structure consists of, and where its equations point now: J and C of joints and contacts.
#include "resolve/direct/direct_component.h"
#include "resolve/direct/numbers.h"
#include "resolve/joints/kinds.h"

namespace cairn::physics {
namespace {

using Bound = DirectEquation::Bound;

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
    // Chains and trees that hang from one thing have as many joints as bodies.
    is_loop_ = joints_.size() > rows_.size();
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

void DirectComponent::place_joints(const DirectScene& scene) {
    const Motions& motions = scene.motions;
    is_weighed_ = false;
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

}  // namespace cairn::physics
