// Making laws, in the units of a substep.
#include "resolve/joints/laws.h"

#include <algorithm>
#include <cmath>

#include <cairn/physics/tuning.h>

#include "base/assert.h"

namespace cairn::physics {
Softness softness_of(const JointStiffness& stiffness, float h_s) {
    const float frequency = std::min(stiffness.frequency_hz, tuning::kMaxFrequencyShare / h_s);
    return make_soft(frequency, stiffness.damping_ratio, h_s);
}

JointLaw& LawBuilder::add(LawKind kind, int direction, int count) {
    CAIRN_ASSERT(c_.law_count < static_cast<int>(c_.laws.size()), "a joint has too many laws");
    JointLaw& law = c_.laws[static_cast<std::size_t>(c_.law_count++)];
    law = {};
    law.kind = kind;
    law.direction = static_cast<std::uint8_t>(direction);
    law.count = static_cast<std::uint8_t>(count);
    law.round = count > 1;
    return law;
}

void LawBuilder::hold(int direction, int count, float target, const JointStiffness& stiffness) {
    JointLaw& law = add(LawKind::Hold, direction, count);
    law.target = target;
    law.rigid = is_rigid(stiffness);
    law.softness = softness_of(stiffness, h_s_);
}

void LawBuilder::spring(int direction, int count, const SpringSetting& setting) {
    if (setting.frequency_hz == 0) return;
    JointLaw& law = add(LawKind::Spring, direction, count);
    law.target = setting.target;
    law.low = setting.low * h_s_;
    law.high = setting.high * h_s_;
    law.spring_frequency_hz = setting.frequency_hz;
    law.spring_damping_ratio = setting.damping_ratio;
    c_.has_spring = true;
}

void LawBuilder::motor(int direction, float speed, float max_effort) {
    JointLaw& law = add(LawKind::Motor, direction, 1);
    law.speed[0] = speed;
    law.high = max_effort * h_s_;
    law.low = -law.high;
}

void LawBuilder::motor(int direction, Vec2 velocity, float max_effort) {
    JointLaw& law = add(LawKind::Motor, direction, 2);
    law.speed = {velocity.x, velocity.y};
    law.high = max_effort * h_s_;
}

void LawBuilder::limits(int direction, float lower, float upper, const JointStiffness& stiffness) {
    const Softness softness = softness_of(stiffness, h_s_);
    if (std::isfinite(lower)) {
        JointLaw& law = add(LawKind::Lower, direction, 1);
        law.target = lower;
        law.softness = softness;
    }
    if (std::isfinite(upper)) {
        JointLaw& law = add(LawKind::Upper, direction, 1);
        law.target = upper;
        law.softness = softness;
    }
}

}  // namespace cairn::physics
