// Numbers that all direct solutions share, whatever the structure.
#pragma once

namespace cairn::physics {

// Of J 1/M J^T: what makes joints that say the same thing twice solvable. Their gaps stay at round-off.
inline constexpr double kGive = 1e-10;
// The same for joints that contradict each other, as in a loop that was torn open: they meet in between.
inline constexpr double kGiveOfContradictions = 1e-4;
// Impulses of this many times all there is to move betray a contradiction.
inline constexpr double kMostLeverage = 100;
// m/s. Joints that were torn apart come together no faster.
inline constexpr double kMaxClosingSpeed_m_s = 40;
// The same where contacts may be what keeps them apart.
inline constexpr double kMaxClosingSpeedInContact_m_s = 8;

// m and rad. Errors beyond it are left to the velocities: a projection along rows of the Jacobian is local.
inline constexpr double kMaxProjected = 0.05;
// m and rad. Errors below it are within the rounding of positions.
inline constexpr double kNoError = 1e-7;
// A projection that leaves more of the error than this is undone.
inline constexpr double kWorthwhile = 0.3;
// rad. A body that turns more in a substep has rows that have turned away from what they were.
inline constexpr double kMaxTurn_rad = 0.35;
// rad. What whips keep their energy at: a part of a substep turns a body no farther.
inline constexpr double kResolvedTurn_rad = 0.02;
inline constexpr int kMaxParts = 32;
// The same where contacts press, which take energy anyway.
inline constexpr int kMaxPartsInContact = 4;
// m. Bodies that turn about a joint at their centre are resolved at any speed.
inline constexpr double kNoArm_m = 1e-3;

inline constexpr int kMaxEnlargements = 3;

// Factorizations for the solution of a substep, and as many for all its closing ones; where they are used up,
// each solution still has the fewest. Most need 2 to 10, and boxes that settle on taut bridges up to 100,
// which pays: with 40 they come to rest later. Where more are needed things collide too hard for exact
// friction.
inline constexpr int kMaxFactorizations = 120;
inline constexpr int kFewestFactorizations = 6;
// rad/s. In a singular pose roundings press the joints of a loop against each other with any impulse. Inertia
// by that would stop what turns faster, so it gets no more than it has.
inline constexpr double kTurning_rad_s = 1;

// Of the energy: more than this is not the error of one substep that is resolved.
inline constexpr double kEnergyTolerance = 0.01;
// m/s. Energies of bodies this slow are let alone.
inline constexpr double kSlow_m_s = 0.01;

}  // namespace cairn::physics
