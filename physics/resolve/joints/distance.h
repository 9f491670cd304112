// A rod, or a spring with a shortest and a longest length.
#pragma once

#include "resolve/joints/anchors.h"
#include "resolve/soft.h"

namespace cairn::physics {

struct DistanceConstraint {
    JointAnchors anchors;
    int joint = 0;      // where the impulses go back to
    Softness softness;  // of the rod and of the limits
    Softness spring_softness;
    bool spring = false;
    bool limit = false;
    float length_m = 0;
    float min_length_m = 0;
    float max_length_m = 0;
    Vec2 axis;          // unit, from anchor a to anchor b, at the start of the step
    float impulse = 0;  // of rod or spring in one substep, positive: pushes apart
    float lower_impulse = 0;
    float upper_impulse = 0;
};

void prepare_distance(DistanceConstraint& c);
void warm_start_distance(const DistanceConstraint& c, Motions& motions);
void solve_distance(DistanceConstraint& c, Motions& motions, float h_s, Pass pass);

}  // namespace cairn::physics
