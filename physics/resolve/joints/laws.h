// Laws as the kinds of joints put them together.
#pragma once

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// What a joint is at the start of a step, before its laws are made.
struct JointStart {
    float h_s = 0;               // of a substep
    Rotation frame_a;            // in the world
    double whole_turns_rad = 0;  // that the angle of the joint has beyond the one in its constraint

    /// An angle of the definition as the directions count it: so that many turns cost no digits.
    [[nodiscard]] float angle(float angle_rad) const {
        return static_cast<float>(static_cast<double>(angle_rad) - whole_turns_rad);
    }
};

struct SpringSetting {
    float frequency_hz = 0;
    float damping_ratio = 0;
    float target = 0;
    float low = -kUnlimited;  // N or N m
    float high = kUnlimited;
};

/// No softer than the default.
inline bool is_rigid(const JointStiffness& stiffness) {
    return stiffness.frequency_hz >= JointStiffness{}.frequency_hz;
}

/// In substeps of h; what those cannot resolve is softened to what they can.
Softness softness_of(const JointStiffness& stiffness, float h_s);

/// Adds laws to a constraint. Directions and targets are those of the file of the kind.
class LawBuilder {
  public:
    LawBuilder(JointConstraint& constraint, float h_s) : c_(constraint), h_s_(h_s) {}

    void hold(int direction, int count, float target, const JointStiffness& stiffness);
    /// With 0 Hz there is no spring. Two directions share a round cap, `high`.
    void spring(int direction, int count, const SpringSetting& setting);
    void motor(int direction, float speed, float max_effort);
    void motor(int direction, Vec2 velocity, float max_effort);  // two directions, a round cap
    void limits(int direction, float lower, float upper, const JointStiffness& stiffness);

  private:
    JointLaw& add(LawKind kind, int direction, int count);

    JointConstraint& c_;
    float h_s_;
};

}  // namespace cairn::physics
