// The passes over blocks of revolute and wheel joints, in the widest SIMD that the machine and the user
// allow. The same bits at every level: lanes are independent, and no level fuses multiplications with
// additions.
#pragma once

#include <span>

#include "base/motion.h"
#include "base/place.h"
#include "resolve/joints/joint_block.h"
#include "resolve/joints/pin_loads.h"
#include "resolve/soft.h"

namespace cairn::physics {

/// What may move in the joints of a block. Body b always can.
enum class JointBlockKind : std::uint8_t {
    TwoBodies,
    Anchored,  ///< a moves as it likes or not at all, and nothing pushes it
};
inline constexpr int kJointBlockKinds = 2;

struct JointPassTime {
    Softness softness;  // of plain pins; the others have their own
    float inverse_h_1_s = 0;
};

// Each works on blocks of one colour and kind, given by their places in the pool: of pins, of drives or of
// wheels.

/// Once per step: where the anchors are. Impulses of the last step are multiplied by impulse_ratio. The
/// result is whether some joint may be torn (resolve/joints/torn_joints.h).
bool place_joints(AnchorBlock* anchors, PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio);
bool place_joints(AnchorBlock* anchors, DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio);
bool place_joints(AnchorBlock* anchors, WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                  const Place* places, const Motions& motions, float impulse_ratio);

/// Once per step, when anchors are placed: pins with a load are soft about it.
void take_off_loads(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                    const VelocityRow* velocity, const PinLoads& loads);

/// At the start of a substep: how fast springs are before anything acts.
void note_joint_speeds(DriveBlock* pool, std::span<const int> blocks, const VelocityRow* velocity);
void note_joint_speeds(WheelBlock* pool, std::span<const int> blocks, const VelocityRow* velocity);

void warm_start_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity);
void warm_start_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity);
void warm_start_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                       VelocityRow* velocity);
/// Those of one colour at once; bodies that are in none of them keep their velocities to the bit.
void sweep_crowded_springs(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                           VelocityRow* velocity);
void sweep_crowded_springs(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind,
                           VelocityRow* velocity);
void solve_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time);
void solve_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time);
void solve_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const JointPassTime& time);
void relax_joints(PinBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time);
void relax_joints(DriveBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time);
void relax_joints(WheelBlock* pool, std::span<const int> blocks, JointBlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const JointPassTime& time);

}  // namespace cairn::physics
