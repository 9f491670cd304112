// The part of the solver that needs nobody else: batches of contacts, each taken through all substeps at
// once.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

// In a step without substeps these do nothing.

/// Stage: what is solved in batches, and what is left for the passes over the whole world.
void cut_into_batches(Stores& stores, int substeps, StepScratch& scratch);
/// Stage: all substeps of all batches.
void solve_batches(StepScratch& scratch, int substeps, const ContactRules& rules, const StepTime& time,
                   TaskPool& tasks);
/// Stage, after the last substep of the rest: its impulses go to blocks that it shares with batches.
void return_rest(StepScratch& scratch, int substeps);

}  // namespace cairn::physics
