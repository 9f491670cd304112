// A pin: two points coincide; about it a motor and limits.
#pragma once

#include "resolve/joints/anchors.h"
#include "resolve/soft.h"

namespace cairn::physics {

struct RevoluteConstraint {
    JointAnchors anchors;
    int joint = 0;  // where the impulses go back to
    Softness softness;
    float angle_rad = 0;  // of b relative to a, at the start of the step
    bool limit = false;
    float lower_rad = 0;
    float upper_rad = 0;
    bool motor = false;
    float motor_speed_rad_s = 0;
    float max_motor_impulse = 0;  // N m s per substep
    float axial_mass = 0;
    Vec2 impulse;  // of one substep, as are the next
    float motor_impulse = 0;
    float lower_impulse = 0;
    float upper_impulse = 0;
};

void prepare_revolute(RevoluteConstraint& c, const Motions& motions);
void warm_start_revolute(const RevoluteConstraint& c, Motions& motions);
void solve_revolute(RevoluteConstraint& c, Motions& motions, float h_s, Pass pass);

}  // namespace cairn::physics
