// The way that the centre of a shape took in the last step, or in what was left of it from a moment on, and
// how far it could go of it before it met another shape.
#pragma once

#include <optional>

#include "collide/ray_cast.h"
#include "world/fast_bodies.h"

namespace cairn::physics {

/// Of a way, how far float may put what lies along it aside.
inline constexpr float kWayRounding = 1e-6f;

/// What a body did from some moment of the last step to its end.
struct LastMotion {
    Vec2 moved;
    Rotation rotation_before;
};

/// Where bodies were at a moment of the last step, by its share of the step. Of those that were turned aside
/// the ways have two pieces (world/bent_ways.h), which are given in the order of the bodies; what else moved
/// went straight.
class Moment {
  public:
    Moment() = default;  // when the step began
    Moment(float share, std::span<const Bend> bends) : share_(share), bends_(bends) {}

    [[nodiscard]] LastMotion motion_since(const Stores& stores, int body) const {
        const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
        const std::size_t row = static_cast<std::size_t>(stores.bodies.places[body].row) - 1;
        const LastMotion whole{awake.moved[row], awake.rotation_before[row]};
        return share_ == 0 ? whole : part(stores, body, whole);
    }

  private:
    [[nodiscard]] LastMotion part(const Stores& stores, int body, const LastMotion& whole) const;

    float share_ = 0;
    std::span<const Bend> bends_;
};

/// How much of its last way a shape could go before its centre met the surface of the other shape, less its
/// own thickness; 1 when it met nothing.
class Way {
  public:
    Way(const Stores& stores, int shape, const Moment& since = {}, float fast_share = kFastShare)
        : stores_(stores), shape_(shape), convex_(stores.shapes[shape].convex()), since_(since) {
        const int body = stores.shapes[shape].body;
        const BodyRecord& record = stores.bodies.slots[body];
        const auto [moved, rotation_before] = since.motion_since(stores, body);
        const Vec2 arm = convex_.centroid - record.mass.center_m;
        from_ = stores.bodies.places[body].center + -moved + rotate(rotation_before, arm);
        way_ = transform_point(stores.bodies.transform(body), convex_.centroid) - from_;
        length_ = length(way_);
        least_way_ = fast_share * record.inner_radius_m;
        farthest_way_ = record.inner_radius_m / kWayRounding;
    }

    [[nodiscard]] Position from() const { return from_; }
    [[nodiscard]] Vec2 way() const { return way_; }

    /// Not where it is too short to have taken the centre through anything, nor where it is so long that
    /// float cannot tell what lies beside it.
    [[nodiscard]] bool is_looked_at() const { return length_ > least_way_ && length_ <= farthest_way_; }

    [[nodiscard]] float free_share(int other) const { return is_looked_at() ? free_share_past(other) : 1; }

  private:
    [[nodiscard]] float free_share_past(int other) const;

    const Stores& stores_;
    int shape_;
    const Convex& convex_;
    Moment since_;
    Position from_;
    Vec2 way_;
    float length_ = 0;
    float least_way_ = 0;
    float farthest_way_ = 0;
};

}  // namespace cairn::physics
