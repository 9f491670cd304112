// Springs that are too stiff to be swept beside what is held. The impulses of such springs and of pins, or of
// contacts, call for each other, and swept one after the other they feed each other: a plank on a hinge with
// a spring of 80 Hz flew off, and a vehicle on suspensions of 100 Hz turned over where it stood, at four
// substeps of 60 steps a second. So structures that have some are solved directly where something holds them,
// without loops of what is held and without limits (direct_structures.h). What stands on the ground on rails,
// vehicles and tables, has springs as stiff as asked for as well, but damped more. Else they are as stiff as
// a sweep can follow.
#pragma once

#include <algorithm>
#include <limits>

#include <cairn/physics/joint.h>

#include "resolve/joints/exact_spring.h"

namespace cairn::physics {

struct JointConstraint;
struct JointPlace;
struct StepScratch;
struct StepTime;
struct Stores;

/// What a joint does by its definition.
struct JointActs {
    float spring_hz = 0;  // of its stiffest spring; 0: it has none
    bool holds = false;   // or drives, or couples: all but to draw
    bool limits = false;  // how far it may go
};
JointActs acts_of(const JointDef& def);

/// Which springs are stiff, and for how long that stays so.
class StiffSprings {
  public:
    void forget() { *this = {}; }
    /// Whether a spring is stiff; it is kept in mind.
    bool note(float frequency_hz, float most_swept_hz) {
        const bool stiff = frequency_hz > most_swept_hz;
        if (stiff) {
            softest_stiff_hz_ = std::min(softest_stiff_hz_, frequency_hz);
        } else {
            stiffest_soft_hz_ = std::max(stiffest_soft_hz_, frequency_hz);
        }
        return stiff;
    }
    /// Whether the springs that were noted are all what they were with this bound, too.
    [[nodiscard]] bool hold_for(float most_swept_hz) const {
        return stiffest_soft_hz_ <= most_swept_hz && softest_stiff_hz_ > most_swept_hz;
    }

  private:
    float stiffest_soft_hz_ = 0;
    float softest_stiff_hz_ = std::numeric_limits<float>::infinity();
};

/// Of a joint whose springs are softened whatever acts beside them; 0: they are not stiff.
float softened_frequency(const JointDef& def, float most_swept_hz);

/// Of the constraints of a step: makes the stiff springs of those that are swept as soft as sweeps need them,
/// where anything else holds, drives or may touch one of their bodies that can be moved; or lets those bear
/// that are on rails, of which one body has contacts and is held by no other joint. What was softened
/// stiffens again by and by, when that is over, when the joint is solved directly, or in shorter substeps: at
/// once it would take up within a substep what it sagged by, and throw what lies on it.
void soften_stiff_springs(const Stores& stores, const StepTime& time, StepScratch& scratch);

/// For JointRecord::softened_hz at the end of a step. Of a spring that bears: the frequency of one that would
/// bear at rest what it bore last, but no softer than what is swept; 0 if that is about its own. The damping
/// may hold it far from where it should be, and solved in any other way it would throw what it bears.
float balanced_frequency(const JointConstraint& c, const JointPlace& place, const StepTime& time);

}  // namespace cairn::physics
