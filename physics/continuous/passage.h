// How two shapes go past each other in a step, told from where they stand when it begins and when it ends.
#pragma once

#include "continuous/sweep.h"

namespace cairn::physics {

/// Of what moves straight and hardly turns. Of what turns farther than that nothing is said to be so.
class Passage {
  public:
    Passage(const Sweep& a, const Sweep& b, float duration_s);

    /// Whether they stay farther than gap_m from each other along an axis along which they are apart now.
    [[nodiscard]] bool keeps_apart(const AxisGap& seen, float gap_m) const;

    /// Whether one stays before a side of the other, and ends deeper behind it than depth_m at most; or stays
    /// beyond an end of a chain's segment, where the neighbour meets what comes.
    [[nodiscard]] bool goes_along(float depth_m) const;

    /// Whether two that are about to touch, with this normal from a to b, do so at the end of a side of one
    /// before which the other stays: to within .25 mm, which is more than what lies on a floor is deep in it.
    [[nodiscard]] bool goes_over_corner(Vec2 normal) const;

  private:
    struct Ends {
        SweptPose first;
        SweptPose last;
    };

    const Convex& a_;
    const Convex& b_;
    Ends of_a_;
    Ends of_b_;
    bool is_straight_;

    static Ends ends_of(const Sweep& sweep, float duration_s);
    static bool stays_outside(const Convex& own, const Ends& of_own, const Convex& other,
                              const Ends& of_other, float depth_m);
    static bool stays_before_another_side(const Convex& own, const Ends& of_own, const Convex& other,
                                          const Ends& of_other, Vec2 normal);
};

}  // namespace cairn::physics
