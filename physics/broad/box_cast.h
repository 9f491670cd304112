// A segment, or a box that moves along one, against boxes.
// In double, because far from the world's origin float could not place the segment. Source: slab test, Kay
// and Kajiya 1986.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/aabb.h"

namespace cairn::physics {

class BoxCast {
  public:
    BoxCast(Position center, Vec2 half_extents, Vec2 translation)
        : center_(center),
          half_extents_(half_extents),
          translation_(translation),
          inverse_x_(1 / static_cast<double>(translation.x)),
          inverse_y_(1 / static_cast<double>(translation.y)) {}

    /// Encloses all that is swept up to the fraction, and is finite.
    [[nodiscard]] Aabb bounds(float fraction) const {
        const auto [low_x, high_x] = swept(center_.x, half_extents_.x, translation_.x, fraction);
        const auto [low_y, high_y] = swept(center_.y, half_extents_.y, translation_.y, fraction);
        constexpr float kMost = std::numeric_limits<float>::max();
        return {{std::max(round_down(low_x), -kMost), std::max(round_down(low_y), -kMost)},
                {std::min(round_up(high_x), kMost), std::min(round_up(high_y), kMost)}};
    }

    /// The fraction of the translation at which the box is first met; infinity when it never is.
    [[nodiscard]] double enter(const Aabb& box) const {
        double enter = 0;
        double leave = 1;
        const bool met =
            clip(center_.x, half_extents_.x, inverse_x_, box.lower.x, box.upper.x, enter, leave) &&
            clip(center_.y, half_extents_.y, inverse_y_, box.lower.y, box.upper.y, enter, leave);
        return met ? enter : std::numeric_limits<double>::infinity();
    }

    /// Whether the line of the way of the centre meets the box, however far along it is.
    [[nodiscard]] bool crosses_line(const Aabb& box) const {
        const double along_x = translation_.x;
        const double along_y = translation_.y;
        // Twice the box's centre and extents, the latter seen along the line's normal.
        const double x = static_cast<double>(box.lower.x) + static_cast<double>(box.upper.x) - 2 * center_.x;
        const double y = static_cast<double>(box.lower.y) + static_cast<double>(box.upper.y) - 2 * center_.y;
        const double width = static_cast<double>(box.upper.x) - static_cast<double>(box.lower.x);
        const double height = static_cast<double>(box.upper.y) - static_cast<double>(box.lower.y);
        return std::abs(along_x * y - along_y * x) <= std::abs(along_y) * width + std::abs(along_x) * height;
    }

  private:
    static std::pair<double, double> swept(double from, float half_extent, float along, float fraction) {
        const double way = static_cast<double>(std::min(fraction, 1.0f)) * static_cast<double>(along);
        return {from + std::min(way, 0.0) - static_cast<double>(half_extent),
                from + std::max(way, 0.0) + static_cast<double>(half_extent)};
    }

    static bool clip(double from, float half_extent, double inverse, float low, float high, double& enter,
                     double& leave) {
        const double first = (static_cast<double>(low) - static_cast<double>(half_extent)) - from;
        const double last = (static_cast<double>(high) + static_cast<double>(half_extent)) - from;
        if (std::isinf(inverse)) return first <= 0 && last >= 0;
        double t1 = first * inverse;
        double t2 = last * inverse;
        if (t1 > t2) std::swap(t1, t2);
        enter = std::max(enter, t1);
        leave = std::min(leave, t2);
        return enter <= leave;
    }

    Position center_;
    Vec2 half_extents_;
    Vec2 translation_;
    double inverse_x_;  // of the translation; infinite where that is 0
    double inverse_y_;
};

}  // namespace cairn::physics
