// Where bodies are at the end of a step in which they bounce, or fly near what they bounce from.
#pragma once

#include "world/prepare.h"

namespace cairn::physics {

/// Stage, after the substeps and before impacts give back their speed: among the bodies of contacts that
/// could bounce, those that nothing pushed are where free flight takes them, and round ones that one impact
/// stopped are as far off again as they come in the rest of the step. Speeds are left alone.
void place_bounces(const BodyRows& awake, StepScratch& scratch, const StepTime& time,
                   const ContactRules& rules);

}  // namespace cairn::physics
