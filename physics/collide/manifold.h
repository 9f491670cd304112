// Where two convex shapes touch: up to two points with one normal.
// Invariant: everything is in the frame of shape A's body; the normal is unit and points from A to B; ids
// name the features that made a point and stay the same while those features meet, so impulses can be carried
// over.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <cairn/physics/tuning.h>

#include "collide/convex.h"

namespace cairn::physics {

struct ManifoldPoint {
    Vec2 point;            // midway between the two surfaces
    float separation = 0;  // along the normal; negative when overlapping
    std::uint16_t id = 0;
};

struct Manifold {
    Vec2 normal;
    int count = 0;
    std::array<ManifoldPoint, 2> points{};
};

/// Pose of B in the frame of A.
struct RelativePose {
    Vec2 p;
    Rotation q;
};

/// Of points nearer than this, the direction from the one to the other is lost in rounding.
inline constexpr float kAllButTouching_m = 1e-2f * tuning::kLinearSlop_m;

// While cores are nearer than this a face counts that is about as near as the axis says, so that it lasts as
// they press together. Of two answers that differ by less the one that fits is taken.
inline constexpr float kAboutEqual_m = 0.1f * tuning::kLinearSlop_m;

// What rounding may make of a distance. Cores that overlap by less may be apart: of needles and lines, whose
// normals all point to their sides, the axes tell little. B is the reference only if it is better by more
// than this. Not by what can be felt: where the reference changes the separations would jump by as much, and
// two boxes of a heap that press together there would hop from the one to the other for ever.
inline constexpr float kRounding_m = 1e-3f * tuning::kLinearSlop_m;

/// Names an end of where two edges meet. Seen from B, A's edge runs the other way, so the first end is the
/// last one. The name does not tell which of them was the reference, so that impulses outlast a change.
inline std::uint16_t feature_id(bool flipped, int reference_edge, int facing_edge, int end) {
    const int edge_a = flipped ? facing_edge : reference_edge;
    const int edge_b = flipped ? reference_edge : facing_edge;
    return static_cast<std::uint16_t>(edge_a << 8 | edge_b << 4 | (flipped ? 1 - end : end));
}

/// Points whose separation is at most `reach_m`. Shapes may be of any kinds; one file for each pair of kinds.
/// Lines do not meet each other.
Manifold collide(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m);

Manifold collide_circles(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m);
/// A is a capsule, segment (not of a chain) or polygon, B a circle.
Manifold collide_hull_and_circle(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m);
/// Both are boxes, which need no search for axes. Nothing when only the general routine can tell where they
/// meet.
std::optional<Manifold> collide_boxes(const Convex& a, const Convex& b, const RelativePose& b_in_a,
                                      float reach_m);
/// Both are capsules, segments (not of a chain) or polygons, and not both segments.
Manifold collide_hulls(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m);

/// A is a segment of a chain. Of two neighbours that share a corner, only the one that begins there meets
/// what touches the corner; nothing behind the chain meets it.
Manifold collide_chain_and_circle(const Convex& a, const Convex& b, const RelativePose& b_in_a,
                                  float reach_m);
/// A is a segment of a chain, B a capsule or polygon.
Manifold collide_chain_and_hull(const Convex& a, const Convex& b, const RelativePose& b_in_a, float reach_m);

/// Whether a point, in the shape's frame, is behind a segment of a chain: nearer to the back of the chain
/// than to its front there. Other shapes have no back.
bool is_behind(const Convex& shape, Vec2 point);

/// m. A hair's breadth past a join of a chain both segments answer, so that rounding cannot let anything
/// through.
inline constexpr float kSharedAtJoin_m = 0.02f * tuning::kLinearSlop_m;

/// Whether a segment of a chain never meets what is beyond one of its ends, 0 or 1, by more than
/// kSharedAtJoin_m.
bool leaves_to_neighbour(const Convex& segment, int end);

}  // namespace cairn::physics
