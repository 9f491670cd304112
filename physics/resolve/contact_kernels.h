// The passes over blocks of contacts, in the widest SIMD that the machine and the user allow.
// The same bits at every level: lanes are independent, and no level fuses multiplications with additions.
#pragma once

#include "base/motion.h"
#include "resolve/contact_block.h"
#include "resolve/contact_constraint.h"
#include "resolve/soft.h"

namespace cairn::physics {

/// What the kernels need to know of a substep.
struct ContactPassTime {
    Softness softness;
    float inverse_h_1_s = 0;
    float max_push_out_speed_m_s = 0;
};

/// Whether both bodies of a block may move, or only b.
enum class BlockKind { TwoBodies, OneBody };

// Each works on the blocks of one colour and kind: `first` in the pool and those that follow it.
void solve_blocks(ContactBlock* pool, int first, BlockKind kind, VelocityRow* velocity,
                  const ContactPassTime& time);
void relax_blocks(ContactBlock* pool, int first, BlockKind kind, VelocityRow* velocity, const PoseRow* pose,
                  const ContactPassTime& time);
/// Applies the remembered impulses once, as the first guess of a step.
void warm_start_blocks(const ContactBlock* pool, int first, BlockKind kind, VelocityRow* velocity);

}  // namespace cairn::physics
