#include "world/stiff_springs.h"

#include <span>
#include <variant>

#include "world/world_state.h"

namespace cairn::physics {
namespace {

struct Tell {
    JointActs operator()(const RevoluteJointDef& def) const { return with_axis(def); }
    JointActs operator()(const PrismaticJointDef& def) const { return with_axis(def); }
    JointActs operator()(const WheelJointDef& def) const { return with_axis(def); }
    JointActs operator()(const DistanceJointDef& def) const {
        const bool limits = def.min_length_m > 0 || def.max_length_m < kUnlimited;
        return {def.enable_spring ? def.frequency_hz : 0, !def.enable_spring, def.enable_spring && limits};
    }
    JointActs operator()(const WeldJointDef& def) const { return at_point_and_angle(def); }
    JointActs operator()(const MotorJointDef& def) const { return at_point_and_angle(def); }
    JointActs operator()(const MouseJointDef& def) const { return {def.frequency_hz, false}; }
    JointActs operator()(const GearJointDef&) const { return {0, true}; }
    JointActs operator()(const PulleyJointDef&) const { return {0, true}; }
    JointActs operator()(const FrictionJointDef&) const { return {0, true}; }
    JointActs operator()(const FilterJointDef&) const { return {}; }

    template <class Def>
    static JointActs with_axis(const Def& def) {
        return {def.enable_spring ? def.frequency_hz : 0, true, def.enable_limit};
    }
    // What is no spring there is rigid, or driven.
    template <class Def>
    static JointActs at_point_and_angle(const Def& def) {
        return {std::max(def.linear_frequency_hz, def.angular_frequency_hz),
                def.linear_frequency_hz == 0 || def.angular_frequency_hz == 0};
    }
};

// At a point, or along a line. What rails hold is pushed together with their own springs (joint_solver.cpp).
bool pins(const JointConstraint& c) {
    const bool holds = std::any_of(c.laws.begin(), c.laws.begin() + c.law_count,
                                   [](const JointLaw& law) { return law.kind == LawKind::Hold; });
    return holds &&
           (c.kind == JointKind::Revolute || c.kind == JointKind::Weld || c.kind == JointKind::Distance);
}

bool has_rail(const JointConstraint& c) {
    return c.kind == JointKind::Wheel || c.kind == JointKind::Prismatic;
}

// Calls visit(law) for the stiff springs of a joint that is swept.
template <class Joint, class Visit>
void for_each_stiff(Joint& c, float most_hz, const Visit& visit) {
    if (!c.has_spring || c.direct || has_rail(c)) return;
    for (int l = 0; l < c.law_count; ++l) {
        auto& law = c.laws[static_cast<std::size_t>(l)];
        if (law.kind == LawKind::Spring && law.spring_frequency_hz > most_hz) visit(law);
    }
}

// By row.
void note_pinned(const Stores& stores, StepScratch& scratch) {
    scratch.pinned_rows.assign(static_cast<std::size_t>(scratch.motions.size()), 0);
    const auto note = [&](int row) { scratch.pinned_rows[static_cast<std::size_t>(row)] = 1; };
    for (const JointConstraint& c : scratch.joints) {
        if (pins(c)) std::for_each(c.rows.begin(), c.rows.begin() + c.bodies, note);
    }
    stores.joints.lanes.for_each_joint([&](int, const AnchorBlock& anchors, std::size_t lane) {
        if (kind_of(stores.joints.slots[anchors.joint[lane]]) != JointKind::Revolute) return;
        for (const int body : {anchors.body_a[lane], anchors.body_b[lane]})
            note(stores.bodies.places[body].row);
    });
}

}  // namespace

JointActs acts_of(const JointDef& def) {
    return std::visit(Tell{}, def);
}

void soften_stiff_springs(const Stores& stores, float h_s, StepScratch& scratch) {
    const float most_hz = most_swept_frequency(h_s);
    bool any = false;
    for (const JointConstraint& c : scratch.joints)
        for_each_stiff(c, most_hz, [&](const JointLaw&) { any = true; });
    if (!any) return;
    note_pinned(stores, scratch);
    const Motions& motions = scratch.motions;
    const auto is_pinned = [&](int row) {
        return scratch.pinned_rows[static_cast<std::size_t>(row)] != 0 &&
               (motions.velocity[row].inverse_mass > 0 || motions.inverse_inertia[row] > 0);
    };
    for (JointConstraint& c : scratch.joints) {
        for_each_stiff(c, most_hz, [&](JointLaw& law) {
            if (std::any_of(c.rows.begin(), c.rows.begin() + c.bodies, is_pinned))
                law.spring_frequency_hz = most_hz;
        });
    }
}

}  // namespace cairn::physics
