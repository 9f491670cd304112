// The passes over blocks of contacts, in the widest SIMD that the machine and the user allow.
// The same bits at every level: lanes are independent, and no level fuses multiplications with additions.
#pragma once

#include <span>

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

// Each works on blocks of one colour and kind.
void solve_blocks(std::span<ContactBlock* const> blocks, BlockKind kind, VelocityRow* velocity,
                  const ContactPassTime& time);
void relax_blocks(std::span<ContactBlock* const> blocks, BlockKind kind, VelocityRow* velocity,
                  const PoseRow* pose, const ContactPassTime& time);
/// Makes the first guess of a step and applies it once.
void warm_start_blocks(std::span<ContactBlock* const> blocks, BlockKind kind, VelocityRow* velocity,
                       float step_ratio, float friction_ratio);

}  // namespace cairn::physics
