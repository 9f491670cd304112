// The part of an outline that faces something, in small pieces: for what acts on surfaces, as pressure does.
// Invariant: the areas of the pieces (outward normal times length) add up exactly to that of the facing part,
// arcs included, whatever the number of pieces; a piece that is cut by the edge of the facing part ends
// there.
#pragma once

#include <algorithm>

#include "collide/convex.h"

namespace cairn::physics {

struct OutlinePiece {
    Vec2 point;  // in its middle, in the body's frame
    Vec2 area;   // its normal times its length, m
};

namespace detail {

// Pieces of an edge, and the angle of a piece of an arc: forces that change along them are met to about 1 %.
inline constexpr int kEdgePieces = 8;
inline constexpr float kArcPiece_rad = kPi / 8;

// The arc about `center` from normal `a` on to `b`, at most pi/8 further, where it faces against `flow`.
template <class Visit>
void visit_arc_piece(Vec2 center, float radius, Vec2 a, Vec2 b, Vec2 flow, Visit&& visit) {
    const bool a_faces = dot(a, flow) < 0;
    const bool b_faces = dot(b, flow) < 0;
    if (!a_faces && !b_faces) return;
    if (a_faces != b_faces) {
        // Of the two normals square to the flow, the one between a and b.
        const Vec2 across = normalized(left_perp(flow));
        const Vec2 edge = dot(across, a + b) > 0 ? across : -across;
        (a_faces ? b : a) = edge;
    }
    visit(OutlinePiece{center + radius * normalized(a + b), radius * (right_perp(b) - right_perp(a))});
}

}  // namespace detail

/// flow_at(point) is the direction, of any length, of what comes there; asked in the middle of each piece of
/// an edge and at the centre of each arc. visit(piece) for what faces against it.
template <class FlowAt, class Visit>
void visit_facing_pieces(const Convex& shape, FlowAt&& flow_at, Visit&& visit) {
    for (int i = 0; i < shape.count() && shape.count() > 1; ++i) {
        const Vec2 from = shape.point(i) + shape.radius() * shape.normals[i];
        const Vec2 edge = shape.point(shape.next(i)) - shape.point(i);
        const Vec2 area = (length(edge) / detail::kEdgePieces) * shape.normals[i];
        for (int k = 0; k < detail::kEdgePieces; ++k) {
            const Vec2 middle = from + ((static_cast<float>(k) + 0.5f) / detail::kEdgePieces) * edge;
            if (dot(shape.normals[i], flow_at(middle)) < 0) visit(OutlinePiece{middle, area});
        }
    }
    if (shape.radius() <= 0) return;
    for (int i = 0; i < shape.count(); ++i) {
        const Vec2 flow = flow_at(shape.point(i));
        const bool is_disc = shape.count() == 1;
        Vec2 normal = is_disc ? Vec2{1, 0} : shape.normals[i == 0 ? shape.count() - 1 : i - 1];
        const Vec2 last = is_disc ? normal : shape.normals[i];
        float angle = 2 * kPi;
        if (!is_disc) {
            // Opposite edges, as a capsule's, are half a turn apart, of either sign.
            angle = std::fabs(Rotation{dot(normal, last), cross(normal, last)}.angle_rad());
        }
        const float pieces = std::max(1.0f, std::ceil(angle / detail::kArcPiece_rad - 1e-3f));
        const Rotation turn = Rotation::from_angle(static_cast<double>(angle / pieces));
        for (float k = 1; k <= pieces; ++k) {
            const Vec2 next = k < pieces ? rotate(turn, normal) : last;
            detail::visit_arc_piece(shape.point(i), shape.radius(), normal, next, flow, visit);
            normal = next;
        }
    }
}

}  // namespace cairn::physics
