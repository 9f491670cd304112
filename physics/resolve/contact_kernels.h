// The passes over blocks of contacts, in the widest SIMD that the machine and the user allow.
// The same bits at every level: lanes are independent, and no level fuses multiplications with additions.
#pragma once

#include <cstdint>
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

/// Blocks of one colour and kind.
struct ContactBlocks {
    std::span<ContactBlock* const> blocks;
    BlockKind kind = BlockKind::TwoBodies;
    /// Other threads work on the same bodies: what they wrote last is asked for in time, as it takes long to
    /// come. Where a thread has its bodies to itself that would cost 1 to 3 % for nothing.
    bool are_shared = false;
    /// By row, as Motions::standing: contacts of rows that stand are left out, and rows that get a kick do
    /// not stand any more. Null: all contacts act.
    std::uint8_t* standing = nullptr;
};

void solve_blocks(const ContactBlocks& run, VelocityRow* velocity, const ContactPassTime& time);
void relax_blocks(const ContactBlocks& run, VelocityRow* velocity, const PoseRow* pose,
                  const ContactPassTime& time);
/// Makes the first guess of a step and applies it once.
void warm_start_blocks(const ContactBlocks& run, VelocityRow* velocity, float step_ratio,
                       float friction_ratio);

}  // namespace cairn::physics
