// Gaps along an axis that one of the two keeps are linear in time while nothing turns.
#include "continuous/passage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <cairn/physics/tuning.h>

namespace cairn::physics {
namespace {

// What turns by less in a step moves straight enough: a point 1 m from the centre goes 8 mm beside its chord.
constexpr float kStraightTurn_rad = 0.25f;

// Sine of the angle between the normals of a contact and of a side up to which the contact is on the side.
// What goes over a corner and is met from there on loses a millionth of its speed; with .014 a thousandth of
// it was lost.
constexpr float kOnSide = 0.001f;

// m. What lies on a floor is .03 to .07 mm deep in it, and so in the next one when its corner has just come
// over that.
constexpr float kLyingDepth_m = 0.05f * tuning::kLinearSlop_m;

// How far something turns, as far as that moves its rim: not that of a disc about its centre.
float turn_of(const Sweep& sweep, float duration_s) {
    const bool is_disc = sweep.shape->count() == 1 && sweep.shape->point(0) == sweep.local_center;
    return is_disc ? 0 : duration_s * std::fabs(sweep.spin);
}

// The core of a shape in the frame of another one, at a moment.
struct SeenCore {
    std::array<Vec2, kMaxPolygonVertices> points;
    int count;

    SeenCore(const Convex& shape, const RelativePose& pose) : count(shape.count()) {
        for (int i = 0; i < count; ++i) points[i] = pose.p + rotate(pose.q, shape.point(i));
    }

    struct Nearest {
        int corner;
        float distance;
    };
    // Along a direction.
    [[nodiscard]] Nearest least_along(Vec2 direction) const {
        Nearest least{0, dot(points[0], direction)};
        for (int i = 1; i < count; ++i) {
            const float distance = dot(points[i], direction);
            if (distance < least.distance) least = {i, distance};
        }
        return least;
    }
};

// How far the farthest point of the core lies along a direction of the world.
float most_along(const Convex& shape, const SweptPose& pose, Vec2 direction) {
    const Vec2 own = inverse_rotate(pose.rotation, direction);
    float most = dot(own, shape.point(0));
    for (int i = 1; i < shape.count(); ++i) most = std::max(most, dot(own, shape.point(i)));
    return most + dot(direction, pose.origin);
}

// The core of a shape on its way, in the frame of another one on its own.
class SeenWay {
  public:
    SeenWay(SweepEnds& own, SweepEnds& other)
        : own_(own),
          other_(other),
          pose_(relative_pose(own.first(), other.first())),
          first_(other.shape(), pose_) {}

    [[nodiscard]] const RelativePose& pose() const { return pose_; }
    [[nodiscard]] float radius() const { return other_.shape().radius(); }
    [[nodiscard]] const SeenCore& first() const { return first_; }
    [[nodiscard]] const SeenCore& last() {
        if (!last_) last_.emplace(other_.shape(), relative_pose(own_.last(), other_.last()));
        return *last_;
    }

    [[nodiscard]] bool stays_before_side(int side, float depth_m) {
        const Convex& own = own_.shape();
        const Vec2 normal = own.normals[side];
        const float surface = dot(normal, own.point(side)) + own.radius() + radius();
        return first().least_along(normal).distance - surface >= -std::min(depth_m, tuning::kLinearSlop_m) &&
               last().least_along(normal).distance - surface >= -depth_m;
    }

  private:
    SweepEnds& own_;
    SweepEnds& other_;
    RelativePose pose_;
    SeenCore first_;
    std::optional<SeenCore> last_;
};

// A corner that slides over the seam of two floors meets the side of the second, but is never deep in it.
// What ends the step a little deep gets its contact in the next one.
bool stays_before_a_side(const Convex& own, SeenWay& way, float depth_m) {
    for (int side = 0; side < own.count(); ++side) {
        if (way.stays_before_side(side, depth_m)) return true;
    }
    return false;
}

// Of that edge of the other's core which faces the segment, the corner that is nearest to its end.
int facing_corner(const Convex& other, const RelativePose& pose, Vec2 normal, Vec2 outward) {
    const Vec2 facing = inverse_rotate(pose.q, normal);
    int edge = 0;
    for (int i = 1; i < other.count(); ++i) {
        if (dot(other.normals[i], facing) < dot(other.normals[edge], facing)) edge = i;
    }
    const int next = other.count() > 1 ? other.next(edge) : edge;
    const Vec2 along = rotate(pose.q, other.point(next) - other.point(edge));
    return dot(along, outward) < 0 ? next : edge;
}

// What comes from beyond an end may meet the end first, which the neighbour holds: its contact with the
// segment begins when it is over it. That is so where of what faces the segment the corner is below the face,
// and the foremost corner is not: what is between the two meets the end while the first is still beyond it.
bool comes_from_beyond(const Convex& segment, const Convex& other, SeenWay& way) {
    const SeenCore& first = way.first();
    const Vec2 normal = segment.normals[0];
    const Vec2 along = left_perp(normal);
    const float surface = dot(segment.point(0), normal);
    for (const int end : {0, 1}) {
        if (!leaves_to_neighbour(segment, end)) continue;
        const Vec2 outward = end == 0 ? -along : along;
        const float beyond = dot(segment.point(end), outward) + kSharedAtJoin_m;
        const int foremost = first.least_along(outward).corner;
        if (dot(first.points[foremost], outward) <= beyond) continue;
        if (way.last().least_along(outward).distance > beyond) return true;
        const int corner = facing_corner(other, way.pose(), normal, outward);
        const auto meets_end = [&](const SeenCore& at) {
            return dot(at.points[corner], normal) - surface < way.radius() &&
                   dot(at.points[foremost], normal) - surface >= -way.radius();
        };
        if (meets_end(first) && meets_end(way.last())) return true;
    }
    return false;
}

bool stays_outside(SweepEnds& own, SweepEnds& other, float depth_m) {
    if (own.shape().count() == 1) return false;
    SeenWay way(own, other);
    if (own.shape().is_chained() && comes_from_beyond(own.shape(), other.shape(), way)) return true;
    return stays_before_a_side(own.shape(), way, depth_m);
}

// The contact with this normal, from the owner of the sides, is not on that side: so it is at its end.
bool stays_before_another_side(SweepEnds& own, SweepEnds& other, Vec2 normal) {
    const Convex& shape = own.shape();
    if (shape.count() == 1) return false;
    SeenWay way(own, other);
    for (int side = 0; side < shape.count(); ++side) {
        const Vec2 out = rotate(own.first().rotation, shape.normals[side]);
        const bool is_on_side = dot(out, normal) > 0 && std::fabs(cross(out, normal)) < kOnSide;
        if (!is_on_side && way.stays_before_side(side, kLyingDepth_m)) return true;
    }
    return false;
}

}  // namespace

Passage::Passage(const Sweep& a, const Sweep& b, float duration_s)
    : a_(a, duration_s),
      b_(b, duration_s),
      is_straight_(turn_of(a, duration_s) + turn_of(b, duration_s) <= kStraightTurn_rad) {}

bool Passage::keeps_apart(const AxisGap& seen, float gap_m) {
    if (!is_straight_ || !(seen.gap_m > gap_m)) return false;
    const float between =
        -most_along(b_.shape(), b_.last(), -seen.axis) - most_along(a_.shape(), a_.last(), seen.axis);
    return between - a_.shape().radius() - b_.shape().radius() > gap_m;
}

bool Passage::goes_along(float depth_m) {
    return is_straight_ && (stays_outside(a_, b_, depth_m) || stays_outside(b_, a_, depth_m));
}

bool Passage::goes_over_corner(Vec2 normal) {
    return is_straight_ &&
           (stays_before_another_side(a_, b_, normal) || stays_before_another_side(b_, a_, -normal));
}

}  // namespace cairn::physics
