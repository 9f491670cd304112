// What each contact would bear if everything stood still: an estimate, made once per step from the top down.
// A soft contact gives way under load by F/(m w^2); about a statics estimate it gives way only under what the
// estimate misses, so stacks neither sink nor buckle under their own weight.
#pragma once

#include <cstdint>

#include "world/prepare.h"

namespace cairn::physics {

/// Stage, in parts: sets `static_impulse` of the points of all contacts of this step, N s per substep; 0
/// where nothing can be said.
class StaticsEstimate {
  public:
    /// What each contact says of supports, on all threads.
    StaticsEstimate(Stores& stores, Vec2 gravity_m_s2, const StepTime& time, StepScratch& scratch,
                    TaskPool& tasks);
    /// Hands the loads down, from body to body; on one thread, so other stages may run beside it that read
    /// and write neither contacts nor their scratch. Once; not needed before `finish`.
    void share_loads();
    /// Tells the contacts. Once; more often does nothing.
    void finish(TaskPool& tasks);

  private:
    enum class Next : std::uint8_t { ShareLoads, Tell, Nothing };

    Stores& stores_;
    StepScratch& scratch_;
    Vec2 gravity_m_s2_;
    float h_s_;
    Next next_ = Next::Nothing;
};

}  // namespace cairn::physics
