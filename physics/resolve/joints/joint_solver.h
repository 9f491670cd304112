// The sweeping solver for joints: one joint after another, each by itself, several times per step.
#pragma once

#include <span>
#include <vector>

#include "resolve/joints/joint_constraint.h"

namespace cairn::physics {

/// Once per step, when all constraints are described and no body has moved yet.
void place_joints(std::span<const JointConstraint> joints, const Motions& motions,
                  std::vector<JointPlace>& places);

// Next, after weigh_springs (spring_mobility.h), spring constants, which depend on the springs around.
// `loads` are by row; those of joints in lanes are added between the two. The result of the second is whether
// some are crowded.
void add_spring_loads(std::span<const JointConstraint> joints, std::span<const JointPlace> places,
                      const Motions& motions, std::vector<SpringLoad>& loads);
bool make_springs(std::span<JointConstraint> joints, float h_s, const std::vector<SpringLoad>& loads);

/// Once made, gives the bodies of springs in their first step the speeds that these go on from.
void start_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places, float h_s,
                   Motions& motions);

/// At the start of each substep, before anything acts: how fast springs are.
void note_spring_speeds(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                        const Motions& motions);

/// The impulses of the last substep, as the first guess for this one.
void warm_start_joints(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                       Motions& motions);

/// Crowded springs start each substep from nothing, and are swept by themselves before all other joints,
/// forth and back so many times. Alike ones are bounded after one already; mixtures of soft and stiff ones
/// were seen to grow after one, and not after four. What hangs on springs of 60 Hz, one below the other, sags
/// as it should to 2 % after eight, and to 12 % after four.
inline constexpr int kCrowdedSweeps = 8;
void sweep_crowded_springs(std::span<JointConstraint> joints, std::span<const JointPlace> places,
                           Motions& motions, bool back);

/// Before relaxing, bodies have moved on: joints take their places anew.
void solve_joints(std::span<JointConstraint> joints, std::span<JointPlace> places, Motions& motions,
                  float h_s, Pass pass);

}  // namespace cairn::physics
