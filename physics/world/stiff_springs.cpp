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

// Of springs that bear.
constexpr float kLeastStretch_m = 1e-6f;
constexpr float kNearBalance = 0.9f;

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

bool is_rail(const JointConstraint& c) {
    return c.kind == JointKind::Wheel || c.kind == JointKind::Prismatic;
}

// Whether what the joint does elsewhere calls for the spring. On rails both are pushed together
// (joint_solver.cpp); limits lie along their spring.
bool disturbs_itself(const JointConstraint& c, const JointLaw& spring) {
    if (is_rail(c)) return false;
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

SpringTone tone_of(const JointLaw& law) {
    return {law.spring_frequency_hz, law.spring_damping_ratio};
}

void tune(JointLaw& law, const SpringTone& tone) {
    law.spring_frequency_hz = tone.frequency_hz;
    law.spring_damping_ratio = tone.damping_ratio;
}

void soften(JointLaw& law, float most_hz) {
    tune(law, softened(tone_of(law), most_hz));
}

void let_bear(JointLaw& law, float most_hz) {
    tune(law, bearing_tone(tone_of(law), most_hz));
    law.bears = true;
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

// What else acts on the bodies that a spring moves.
struct Disturbed {
    bool is = false;      // another joint holds one of them, or it may touch something
    bool stands = false;  // one of them may touch something, and no other joint holds it
};

Disturbed what_is_disturbed(const Stores& stores, const JointConstraint& c, const StepScratch& scratch) {
    const JointRecord& record = stores.joints.slots[c.joint];
    const int own = holds(c) ? 1 : 0;
    Disturbed disturbed;
    for (const int body : {record.body_a, record.body_b}) {
        const BodyRecord& moved = stores.bodies.slots[body];
        if (moved.inverse_mass == 0 && moved.inverse_inertia == 0) continue;
        const int row = stores.bodies.places[body].row;
        const bool is_held = scratch.holds_of_row[static_cast<std::size_t>(row)] > own;
        bool touches = false;
        for_each_edge(stores.contacts.slots, moved.first_contact,
                      [&](int contact, int) { touches = touches || acts(stores.contacts.slots[contact]); });
        disturbed.is = disturbed.is || is_held || touches;
        disturbed.stands = disturbed.stands || (touches && !is_held);
    }
    return disturbed;
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

// Whether the joint bore on a limit in the last substep. Limits give, and a spring of any stiffness would
// push through them.
bool is_stopped(const JointConstraint& c) {
    return std::any_of(c.laws.begin(), c.laws.begin() + c.law_count, [&](const JointLaw& law) {
        const bool is_limit = law.kind == LawKind::Lower || law.kind == LawKind::Upper;
        return is_limit &&
               c.impulse[static_cast<std::size_t>(impulse_index(law.direction, role_of(law.kind)))] != 0;
    });
}

// How the stiff springs of a joint are solved.
enum class Way {
    AsAsked,  // by their poles, or directly
    Bearing,  // as stiff as asked for, and damped more
    Soft,     // as stiff as a sweep can follow
};

Way way_of(const Stores& stores, const JointConstraint& c, float most_hz, const StepScratch& scratch) {
    if (c.direct) return Way::AsAsked;
    bool any_is_stiff = false;
    bool must_be_soft = false;
    for_each_stiffer(c, most_hz, [&](const JointLaw& law) {
        any_is_stiff = true;
        must_be_soft = must_be_soft || disturbs_itself(c, law);
    });
    if (must_be_soft) return Way::Soft;
    if (!any_is_stiff) return Way::AsAsked;
    const Disturbed disturbed = what_is_disturbed(stores, c, scratch);
    if (is_rail(c) && disturbed.stands && !is_stopped(c)) return Way::Bearing;
    return disturbed.is ? Way::Soft : Way::AsAsked;
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
        const Way way = way_of(stores, c, most_hz, scratch);
        if (way == Way::Soft) {
            const float stiffened_hz = grown(c.softened_hz, kStiffening_1_s, time.dt_s);
            c.softened_hz = stiffened_hz > 0 ? std::min(stiffened_hz, most_hz) : most_hz;
        } else if (way == Way::Bearing) {
            for_each_stiffer(c, most_hz, [&](JointLaw& law) { let_bear(law, most_hz); });
            continue;
        } else if (c.softened_hz > 0) {
            const float rate = c.direct ? stiffening_rate(c, scratch.joint_places[i]) : kStiffening_1_s;
            const float stiffened_hz = grown(c.softened_hz, rate, time.dt_s);
            c.softened_hz = stiffened_hz < stiffest_hz(c) ? stiffened_hz : 0;
        }
        if (c.softened_hz > 0)
            for_each_stiffer(c, c.softened_hz, [&](JointLaw& law) { soften(law, c.softened_hz); });
    }
}

float balanced_frequency(const JointConstraint& c, const JointPlace& place, const StepTime& time) {
    float balanced_hz = c.softened_hz;
    for_each_stiffer(c, 0, [&](const JointLaw& law) {
        if (!law.bears) return;
        const auto at = static_cast<std::size_t>(law.direction);
        const float stretch = place.directions[at].q - law.target;
        balanced_hz = 0;
        if (std::fabs(stretch) < kLeastStretch_m) return;
        // F = k x with k = w^2/K; below 0 the damping pushes the other way.
        const auto role = static_cast<std::size_t>(impulse_index(law.direction, role_of(law.kind)));
        const float square = -c.impulse[role] * place.inverse_mass[at][at] / (time.h_s * stretch);
        const float hz = std::sqrt(std::max(square, 0.0f)) / (2 * kPi);
        if (hz < kNearBalance * law.spring_frequency_hz) balanced_hz = std::max(hz, time.most_swept_hz);
    });
    return balanced_hz;
}

}  // namespace cairn::physics
