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

// Or drives, or stops.
bool holds(const JointConstraint& c) {
    return std::any_of(c.laws.begin(), c.laws.begin() + c.law_count,
                       [](const JointLaw& law) { return law.kind != LawKind::Spring; });
}

// Whether what the joint does elsewhere calls for the spring. On rails both are pushed together
// (joint_solver.cpp); limits lie along their spring.
bool disturbs_itself(const JointConstraint& c, const JointLaw& spring) {
    if (c.kind == JointKind::Wheel || c.kind == JointKind::Prismatic) return false;
    return std::any_of(c.laws.begin(), c.laws.begin() + c.law_count,
                       [&](const JointLaw& law) { return law.direction != spring.direction; });
}

bool is_stiff(const JointLaw& law, float most_hz) {
    return law.kind == LawKind::Spring && law.spring_frequency_hz > most_hz;
}

bool has_stiff_spring(const JointConstraint& c, float most_hz) {
    return c.has_spring && !c.direct &&
           std::any_of(c.laws.begin(), c.laws.begin() + c.law_count,
                       [&](const JointLaw& law) { return is_stiff(law, most_hz); });
}

void soften(JointLaw& law, float h_s) {
    const SpringTone tone = softened({law.spring_frequency_hz, law.spring_damping_ratio}, h_s);
    law.spring_frequency_hz = tone.frequency_hz;
    law.spring_damping_ratio = tone.damping_ratio;
}

// How many joints hold each row, of which more than two are two.
void count_holds(const Stores& stores, StepScratch& scratch) {
    scratch.holds_of_row.assign(static_cast<std::size_t>(scratch.motions.size()), 0);
    const auto note = [&](int row) {
        char& holds = scratch.holds_of_row[static_cast<std::size_t>(row)];
        holds = static_cast<char>(std::min(holds + 1, 2));
    };
    for (const JointConstraint& c : scratch.joints) {
        if (holds(c)) std::for_each(c.rows.begin(), c.rows.begin() + c.bodies, note);
    }
    stores.joints.lanes.for_each_joint([&](int, const AnchorBlock& anchors, std::size_t lane) {
        for (const int body : {anchors.body_a[lane], anchors.body_b[lane]})
            note(stores.bodies.places[body].row);
    });
}

// Whether something else holds a body that the spring moves: another joint, or what the body may touch.
bool disturbs_others(const Stores& stores, const JointConstraint& c, const StepScratch& scratch) {
    const JointRecord& record = stores.joints.slots[c.joint];
    const int own = holds(c) ? 1 : 0;
    const auto is_held = [&](int body) {
        const BodyRecord& held = stores.bodies.slots[body];
        if (held.inverse_mass == 0 && held.inverse_inertia == 0) return false;
        const int row = stores.bodies.places[body].row;
        return held.first_contact != kNone || scratch.holds_of_row[static_cast<std::size_t>(row)] > own;
    };
    return is_held(record.body_a) || is_held(record.body_b);
}

}  // namespace

JointActs acts_of(const JointDef& def) {
    return std::visit(Tell{}, def);
}

void soften_stiff_springs(const Stores& stores, float h_s, StepScratch& scratch) {
    const float most_hz = most_swept_frequency(h_s);
    std::vector<JointConstraint>& joints = scratch.joints;
    if (std::none_of(joints.begin(), joints.end(),
                     [&](const JointConstraint& c) { return has_stiff_spring(c, most_hz); }))
        return;
    count_holds(stores, scratch);
    for (JointConstraint& c : joints) {
        if (!has_stiff_spring(c, most_hz)) continue;
        for (int l = 0; l < c.law_count; ++l) {
            JointLaw& law = c.laws[static_cast<std::size_t>(l)];
            if (is_stiff(law, most_hz) && (disturbs_itself(c, law) || disturbs_others(stores, c, scratch)))
                soften(law, h_s);
        }
    }
}

}  // namespace cairn::physics
