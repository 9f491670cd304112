// Ways of the last step.
#include "world/last_way.h"

#include <algorithm>

#include "world/sweep_guard.h"

namespace cairn::physics {
namespace {

// Whether a straight way stays farther from the origin than the reach.
bool stays_outside(Vec2 from, Vec2 way, float reach) {
    const float whole = length_squared(way);
    const float share = whole > 0 ? std::clamp(-dot(from, way) / whole, 0.0f, 1.0f) : 0;
    const float rounding = kWayRounding * (length(from) + length(way));
    return length(from + share * way) > reach + rounding;
}

// The way of a point since a moment of the last step against another shape, as seen from that shape: what
// moved along with the point, or was pushed ahead of it, was not passed. Ways up to the least one are not
// looked at.
std::optional<LocalRayHit> cast_relative_way(const Stores& stores, int shape, const Moment& since,
                                             Position from, Vec2 way, float least_way) {
    const int body = stores.shapes[shape].body;
    const Place& place = stores.bodies.places[body];
    if (place.row == kWorldRow) {
        const Transform now = stores.bodies.transform(body);
        return cast_ray(stores.shapes[shape].convex(), inverse_transform_point(now, from),
                        inverse_rotate(now.q, way));
    }
    const auto [moved, rotation_before] = since.motion_since(stores, body);
    // In the frame of what whirls nothing goes straight: it counts as having stood as it does now.
    const bool whirls = (place.flags & place_flag::kWhirls) != 0;
    const Rotation q = whirls ? place.rotation : rotation_before;
    const Position center = place.center + -moved;
    // Turning moves a point by the chord of the angle.
    const float chord = length(Vec2{place.rotation.c - q.c, place.rotation.s - q.s});
    const Vec2 seen = from - center;
    const Vec2 straight_way = way - moved;
    if (length(straight_way) + chord * length(seen) <= least_way) return {};
    const BodyRecord& record = stores.bodies.slots[body];
    if (stays_outside(seen, straight_way, record.extent_m + chord * length(seen + straight_way))) return {};
    const Transform now = stores.bodies.transform(body);
    const Convex& convex = stores.shapes[shape].convex();
    const Vec2 start = inverse_transform_point({center + -rotate(q, record.mass.center_m), q}, from);
    const Vec2 relative_way = inverse_transform_point(now, from + way) - start;
    if (length(relative_way) <= least_way) return {};
    return cast_ray(convex, start, relative_way);
}

}  // namespace

LastMotion Moment::part(const Stores& stores, int body, const LastMotion& whole) const {
    const auto& [moved, before] = whole;
    const auto bend = std::ranges::lower_bound(bends_, body, {}, &Bend::body);
    if (bend != bends_.end() && bend->body == body) {
        if (share_ <= bend->share) {
            // It was on its way there, all of which is known but how it turned; little, unless it is at its
            // end.
            const float until = share_ / bend->share;
            return {moved - until * bend->moved, until == 1 ? bend->rotation : before};
        }
        const float since = (1 - share_) / (1 - bend->share);
        return {since * (moved - bend->moved), bend->rotation};
    }
    const double turned_rad = (inverse(before) * stores.bodies.places[body].rotation).angle_rad();
    return {(1 - share_) * moved,
            normalized(Rotation::from_angle(static_cast<double>(share_) * turned_rad) * before)};
}

float Way::free_share_past(int other) const {
    if (is_carried(stores_, shape_, other)) return 1;
    const auto hit = cast_relative_way(stores_, other, since_, from_, way_, least_way_);
    return hit ? std::max(hit->fraction - inner_radius(convex_) / length_, 0.0f) : 1;
}

}  // namespace cairn::physics
