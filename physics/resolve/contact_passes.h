// The solver's passes over runs of blocks of contacts.
#pragma once

#include <cstdint>
#include <span>

#include "base/motion.h"
#include "base/task_pool.h"
#include "resolve/contact_block.h"
#include "resolve/contact_constraint.h"
#include "resolve/contact_lanes.h"

namespace cairn::physics {

/// Blocks of one domain, kind and colour: they may be solved in any order, and at once.
struct ContactRun {
    BlockKind kind = BlockKind::TwoBodies;
    std::span<ContactBlock* const> blocks;
    int color = 0;
    int domain = kInterface;
};

/// Which contacts act in a pass.
enum class Scope : std::uint8_t {
    All,
    Disturbed,  ///< not those between bodies that stand (base/standing.h), where such are looked for
};

/// Makes the first guesses of a step and applies them.
void warm_start(const ContactRun& run, Motions& motions, float step_ratio, float friction_ratio);
void solve(const ContactRun& run, Motions& motions, const ContactRules& rules, float h_s, Pass pass,
           Scope scope);

// The same for many runs. Those of the domains come first, in the order of their colours: a thread takes a
// whole domain. Then those of the interface, one colour after the other, since colours may share bodies;
// threads take parts of each.
void warm_start(std::span<const ContactRun> runs, Motions& motions, float step_ratio, float friction_ratio,
                TaskPool& tasks);
void solve(std::span<const ContactRun> runs, Motions& motions, const ContactRules& rules, float h_s,
           Pass pass, Scope scope, TaskPool& tasks);

}  // namespace cairn::physics
