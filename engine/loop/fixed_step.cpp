// The accumulator of the fixed step. Invariant: 0 <= accumulated_s_ < step_s_ between calls.
#include <cassert>
#include <cmath>

#include <cairn/engine/fixed_step.h>

namespace cairn::engine {

FixedStep::FixedStep(double step_s, int max_updates) : step_s_(step_s), max_updates_(max_updates) {
    assert(step_s > 0 && max_updates >= 1);
}

FixedStep::Frame FixedStep::advance(double elapsed_s) {
    if (std::isfinite(elapsed_s) && elapsed_s > 0) accumulated_s_ += elapsed_s;

    const double due = std::floor(accumulated_s_ / step_s_);
    Frame frame;
    if (due > max_updates_) {
        // The spiral of death: updates that take longer than real time call for ever more updates. Drop the
        // debt.
        frame.updates = max_updates_;
        accumulated_s_ = 0;
    } else {
        frame.updates = static_cast<int>(due);
        accumulated_s_ -= due * step_s_;
        // The division and the subtraction round differently: the rest can be off the interval by a rounding
        // error.
        if (accumulated_s_ < 0 || accumulated_s_ >= step_s_) accumulated_s_ = 0;
    }
    frame.alpha = accumulated_s_ / step_s_;
    return frame;
}

}  // namespace cairn::engine
