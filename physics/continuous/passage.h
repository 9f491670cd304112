// How two shapes go past each other in a step, told from where they stand when it begins and when it ends.
#pragma once

#include <optional>

#include "continuous/sweep.h"

namespace cairn::physics {

/// A sweep where it begins, and where it ends, which most questions do not come to.
class SweepEnds {
  public:
    SweepEnds(const Sweep& sweep, float duration_s)
        : sweep_(sweep),
          duration_s_(duration_s),
          first_{sweep.center - rotate(sweep.rotation, sweep.local_center), sweep.rotation} {}

    [[nodiscard]] const Convex& shape() const { return *sweep_.shape; }
    [[nodiscard]] const SweptPose& first() const { return first_; }
    [[nodiscard]] const SweptPose& last() {
        if (!last_) last_ = pose_at(sweep_, duration_s_);
        return *last_;
    }

  private:
    const Sweep& sweep_;
    float duration_s_;
    SweptPose first_;
    std::optional<SweptPose> last_;
};

/// Of what moves straight and hardly turns. Of what turns farther than that nothing is said to be so.
class Passage {
  public:
    /// The sweeps are to outlive it.
    Passage(const Sweep& a, const Sweep& b, float duration_s);

    /// Whether they stay farther than gap_m from each other along an axis along which they are apart now.
    [[nodiscard]] bool keeps_apart(const AxisGap& seen, float gap_m);

    /// Whether one stays before a side of the other, and ends deeper behind it than depth_m at most; or stays
    /// beyond an end of a chain's segment, where the neighbour meets what comes.
    [[nodiscard]] bool goes_along(float depth_m);

    /// Whether two that are about to touch, with this normal from a to b, do so at the end of a side of one
    /// before which the other stays: to within .25 mm, which is more than what lies on a floor is deep in it.
    [[nodiscard]] bool goes_over_corner(Vec2 normal);

  private:
    SweepEnds a_;
    SweepEnds b_;
    bool is_straight_;
};

}  // namespace cairn::physics
