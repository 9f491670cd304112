#include "world/stiff_springs.h"

#include <span>
#include <variant>

#include "world/prepare.h"
#include "world/special_contacts.h"
#include "world/world_state.h"

namespace cairn::physics {
namespace {

// Springs that were softened stiffen e-fold in a second at least, and by that lift what weighs on them at
// first by twice its sag in a second; and faster where that would be slower than .5 m/s.
constexpr float kStiffening_1_s = 1;
constexpr float kLift_m_s = 0.5f;
constexpr double kMostExponent = 3;  // in a step

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

// Calls visit(law) for the springs of a joint that are stiffer than this.
template <class Joint, class Visit>
void for_each_stiffer(Joint& c, float hz, const Visit& visit) {
    for (int l = 0; l < c.law_count; ++l) {
        auto& law = c.laws[static_cast<std::size_t>(l)];
        if (law.kind == LawKind::Spring && law.spring_frequency_hz > hz) visit(law);
    }
}

float stiffest_hz(const JointConstraint& c) {
    float most = 0;
    if (c.has_spring) {
        for_each_stiffer(c, 0, [&](const JointLaw& law) { most = std::max(most, law.spring_frequency_hz); });
    }
    return most;
}

void soften(JointLaw& law, float most_hz) {
    const SpringTone tone = softened({law.spring_frequency_hz, law.spring_damping_ratio}, most_hz);
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

bool acts(const ContactRecord& contact) {
    return !special::has(contact, special::kRefused | special::kPassing);
}

// Whether something else holds a body that the spring moves: another joint, or what the body may touch.
bool disturbs_others(const Stores& stores, const JointConstraint& c, const StepScratch& scratch) {
    const JointRecord& record = stores.joints.slots[c.joint];
    const int own = holds(c) ? 1 : 0;
    const auto is_held = [&](int body) {
        const BodyRecord& held = stores.bodies.slots[body];
        if (held.inverse_mass == 0 && held.inverse_inertia == 0) return false;
        const int row = stores.bodies.places[body].row;
        bool is = scratch.holds_of_row[static_cast<std::size_t>(row)] > own;
        for_each_edge(stores.contacts.slots, held.first_contact,
                      [&](int contact, int) { is = is || acts(stores.contacts.slots[contact]); });
        return is;
    };
    return is_held(record.body_a) || is_held(record.body_b);
}

// By the stretch, of angles at an arm of a metre.
float stiffening_rate(const JointConstraint& c, const JointPlace& place) {
    float stretch = 0;
    for_each_stiffer(c, c.softened_hz, [&](const JointLaw& law) {
        for (int i = 0; i < law.count; ++i)
            stretch = std::max(stretch, std::fabs(place.directions[law.direction + i].q - law.target));
    });
    return std::max(kStiffening_1_s, kLift_m_s / (2 * std::max(stretch, 1e-6f)));
}

float grown(float frequency_hz, float rate_1_s, float dt_s) {
    const double exponent =
        std::min(static_cast<double>(rate_1_s) * static_cast<double>(dt_s), kMostExponent);
    return frequency_hz * static_cast<float>(deterministic::exp(exponent));
}

bool must_be_soft(const Stores& stores, const JointConstraint& c, float most_hz, const StepScratch& scratch) {
    if (c.direct) return false;
    bool any_is_stiff = false;
    bool must = false;
    for_each_stiffer(c, most_hz, [&](const JointLaw& law) {
        any_is_stiff = true;
        must = must || disturbs_itself(c, law);
    });
    return must || (any_is_stiff && disturbs_others(stores, c, scratch));
}

}  // namespace

JointActs acts_of(const JointDef& def) {
    return std::visit(Tell{}, def);
}

float softened_frequency(const JointDef& def, float most_swept_hz) {
    return acts_of(def).spring_hz > most_swept_hz ? most_swept_hz : 0;
}

void soften_stiff_springs(const Stores& stores, const StepTime& time, StepScratch& scratch) {
    const float most_hz = time.most_swept_hz;
    const auto may_be_soft = [&](const JointConstraint& c) {
        return c.softened_hz > 0 || (!c.direct && stiffest_hz(c) > most_hz);
    };
    std::vector<JointConstraint>& joints = scratch.joints;
    if (std::none_of(joints.begin(), joints.end(), may_be_soft)) return;
    count_holds(stores, scratch);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        JointConstraint& c = joints[i];
        if (!may_be_soft(c)) continue;
        if (must_be_soft(stores, c, most_hz, scratch)) {
            const float stiffened_hz = grown(c.softened_hz, kStiffening_1_s, time.dt_s);
            c.softened_hz = stiffened_hz > 0 ? std::min(stiffened_hz, most_hz) : most_hz;
        } else if (c.softened_hz > 0) {
            const float rate = c.direct ? stiffening_rate(c, scratch.joint_places[i]) : kStiffening_1_s;
            const float stiffened_hz = grown(c.softened_hz, rate, time.dt_s);
            c.softened_hz = stiffened_hz < stiffest_hz(c) ? stiffened_hz : 0;
        }
        if (c.softened_hz > 0)
            for_each_stiffer(c, c.softened_hz, [&](JointLaw& law) { soften(law, c.softened_hz); });
    }
}

}  // namespace cairn::physics
