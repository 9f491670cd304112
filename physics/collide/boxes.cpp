// Box against box. The extent of a box along any axis is a sum of absolute values, so the axis of least
// overlap is found without visiting corners; the facing side of the other box is then clipped as in
// hulls.cpp.
#include <algorithm>

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"

namespace cairn::physics {
namespace {

// The other box as seen from the reference box, whose centre is the origin.
struct View {
    Vec2 half;  // of the reference
    Vec2 other_half;
    Vec2 offset;      // centre of the other
    Rotation turn;    // of the other
    Vec2 separation;  // along the two axes of the reference
};

View look(Vec2 half, Vec2 other_half, Vec2 offset, Rotation turn) {
    const float c = std::fabs(turn.c);
    const float s = std::fabs(turn.s);
    const Vec2 extent{other_half.x * c + other_half.y * s, other_half.x * s + other_half.y * c};
    return {half,
            other_half,
            offset,
            turn,
            {std::fabs(offset.x) - half.x - extent.x, std::fabs(offset.y) - half.y - extent.y}};
}

float largest(Vec2 a) {
    return std::max(a.x, a.y);
}

struct Contact {
    Vec2 normal;  // of the reference
    int count = 0;
    std::array<ManifoldPoint, 2> points{};
    bool is_nearest = false;  // the least distance is in front of the reference side
};

// The side of the reference that the other box is farthest in front of, against the side of the other that
// faces it.
Contact clip(const View& view, bool flipped, float reach) {
    const bool along_x = view.separation.x >= view.separation.y;
    const float side = (along_x ? view.offset.x : view.offset.y) < 0 ? -1.0f : 1.0f;
    const Vec2 normal = along_x ? Vec2{side, 0} : Vec2{0, side};
    const Vec2 tangent = left_perp(normal);
    const float depth = along_x ? view.half.x : view.half.y;
    const float width = along_x ? view.half.y : view.half.x;

    // The facing side of the other, from its low to its high end along the tangent.
    const Vec2 facing = inverse_rotate(view.turn, -normal);
    const bool face_x = std::fabs(facing.x) > std::fabs(facing.y);
    const float face_side = (face_x ? facing.x : facing.y) < 0 ? -1.0f : 1.0f;
    const Vec2 face_normal = face_x ? Vec2{face_side, 0} : Vec2{0, face_side};
    const Vec2 face_center{face_normal.x * view.other_half.x, face_normal.y * view.other_half.y};
    const Vec2 along = (face_x ? view.other_half.y : view.other_half.x) * left_perp(face_normal);
    const Vec2 low_end = view.offset + rotate(view.turn, face_center + along);
    const Vec2 high_end = view.offset + rotate(view.turn, face_center - along);
    const float low = dot(low_end, tangent);
    const float high = dot(high_end, tangent);
    const float low_gap = dot(low_end, normal) - depth;
    const float high_gap = dot(high_end, normal) - depth;

    const float slope = (high_gap - low_gap) / std::max(high - low, 1e-9f);
    const std::array<float, 2> at{std::clamp(low, -width, width), std::clamp(high, -width, width)};
    Contact contact;
    contact.normal = normal;
    float nearest = low_gap;
    for (int end = 0; end < 2; ++end) {
        const float gap = end == 0 ? low_gap + (at[0] - low) * slope : high_gap - (high - at[1]) * slope;
        nearest = end == 0 ? gap : std::min(nearest, gap);
        if (gap > reach) continue;
        const int side_id = (along_x ? 0 : 2) + (side > 0 ? 1 : 0);
        const int face_id = (face_x ? 0 : 2) + (face_side > 0 ? 1 : 0);
        contact.points[contact.count++] = {at[end] * tangent + (depth + 0.5f * gap) * normal, gap,
                                           feature_id(flipped, side_id, face_id, end)};
    }
    const bool beside = high < -width || low > width;
    contact.is_nearest = !beside && nearest <= largest(view.separation) + 1e-3f * tuning::kLinearSlop_m;
    return contact;
}

}  // namespace

std::optional<Manifold> collide_boxes(const Convex& a, const Convex& b, const RelativePose& b_in_a,
                                      float reach_m) {
    const Vec2 offset = b_in_a.p + rotate(b_in_a.q, b.centroid) - a.centroid;
    const View from_a = look(a.half_size, b.half_size, offset, b_in_a.q);
    if (largest(from_a.separation) > reach_m) return Manifold{};
    const View from_b = look(b.half_size, a.half_size, -inverse_rotate(b_in_a.q, offset), inverse(b_in_a.q));
    if (largest(from_b.separation) > reach_m) return Manifold{};

    const bool flipped = largest(from_b.separation) > largest(from_a.separation) + kRounding_m;
    const Contact contact = clip(flipped ? from_b : from_a, flipped, reach_m);
    const bool apart = std::max(largest(from_a.separation), largest(from_b.separation)) > kAboutEqual_m;
    if (apart && !contact.is_nearest) return {};

    Manifold m;
    m.normal = flipped ? -rotate(b_in_a.q, contact.normal) : contact.normal;
    m.count = contact.count;
    for (int i = 0; i < contact.count; ++i) {
        m.points[i] = contact.points[i];
        const Vec2 p = contact.points[i].point;
        m.points[i].point = a.centroid + (flipped ? offset + rotate(b_in_a.q, p) : p);
    }
    return m;
}

}  // namespace cairn::physics
