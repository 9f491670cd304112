// Prediction of contacts for fast bodies.
#include "world/fast_bodies.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "collide/ray_cast.h"
#include "world/filtering.h"
#include "world/finalize.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// m. Sweeps end with this gap: near enough to be a contact, wide enough for the distance to have a direction.
constexpr float kImpactGap_m = 0.25f * tuning::kLinearSlop_m;

// The mean velocity over the step if nothing is met.
Vec2 expected_velocity(const BodyStore& bodies, int body, Vec2 gravity, float dt_s) {
    const BodyRecord& record = bodies.slots[body];
    const Vec2 v = bodies.rows_of(body).velocity[record.row];
    const bool falls = record.set == RowSet::Awake && record.inverse_mass > 0;
    return falls ? v + 0.5f * dt_s * record.gravity_scale * gravity : v;
}

// A body is fast when a step takes a point of it further than half of what is solid about its thinnest shape.
bool is_fast(const BodyStore& bodies, int body, Vec2 gravity, float dt_s) {
    const BodyRecord& record = bodies.slots[body];
    if (record.set != RowSet::Awake) return false;
    const float spin = bodies.rows(RowSet::Awake).spin[record.row];
    const float reach =
        length(expected_velocity(bodies, body, gravity, dt_s)) + std::fabs(spin) * record.extent_m;
    return dt_s * reach > 0.5f * record.inner_radius_m;
}

Sweep make_sweep(const Stores& stores, int shape, Position origin, Vec2 gravity, float dt_s) {
    const int body = stores.shapes[shape].body;
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    return {&stores.shapes[shape].convex,
            rows.center[record.row] - origin,
            rows.rotation[record.row],
            record.mass.center_m,
            expected_velocity(stores.bodies, body, gravity, dt_s),
            rows.spin[record.row]};
}

// How far the solver will see a point moved that it knows by this arm, when the body has moved on by time_s.
Vec2 moved(const Sweep& sweep, Vec2 arm, float time_s) {
    const Rotation turned = Rotation::from_angle(static_cast<double>(sweep.spin * time_s));
    return time_s * sweep.velocity + rotate(turned, arm) - arm;
}

// The way of a point during the last step against another shape, as seen from that shape: what moved along
// with the point, or was pushed ahead of it, was not passed.
std::optional<LocalRayHit> cast_relative_way(const Stores& stores, int shape, Position from, Vec2 way) {
    const int body = stores.shapes[shape].body;
    const BodyRecord& record = stores.bodies.slots[body];
    const Transform now = stores.bodies.transform(body);
    const Convex& convex = stores.shapes[shape].convex;
    if (record.set != RowSet::Awake)
        return cast_ray(convex, inverse_transform_point(now, from), inverse_rotate(now.q, way));
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const Rotation q = awake.rotation_before[record.row];
    const Position center = awake.center[record.row] + -awake.moved[record.row];
    const Vec2 start = inverse_transform_point({center + -rotate(q, record.mass.center_m), q}, from);
    return cast_ray(convex, start, inverse_transform_point(now, from + way) - start);
}

// How much of its last way a body could go before the centre of one of its shapes met the surface of another
// body's shape, less the thickness of its own; 1 when nothing was met.
float free_share_of_way(const Stores& stores, int body) {
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const BodyRecord& record = stores.bodies.slots[body];
    const Transform now = stores.bodies.transform(body);
    const Vec2 moved = awake.moved[record.row];
    const Rotation q_before = awake.rotation_before[record.row];
    const Position center_before = awake.center[record.row] + -moved;
    float share = 1;
    for (int s = record.first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
        const Convex& convex = stores.shapes[s].convex;
        const Position from = center_before + rotate(q_before, convex.centroid - record.mass.center_m);
        const Vec2 way = transform_point(now, convex.centroid) - from;
        const float long_way = length(way);
        if (long_way == 0) continue;
        const auto visit = [&](int other) {
            if (!may_collide(stores, s, other) || lets_pass(stores, s, other)) return 1.0f;
            const auto hit = cast_relative_way(stores, other, from, way);
            if (hit) share = std::min(share, std::max(hit->fraction - inner_radius(convex) / long_way, 0.0f));
            return 1.0f;
        };
        for (const Layer layer : kLayers) stores.broad.tree(layer).cast_ray(from, way, visit);
    }
    return share;
}

}  // namespace

void cover_fast_ways(Stores& stores, Vec2 gravity_m_s2, float dt_s, std::vector<int>& fast) {
    fast.clear();
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    for (int row = 0; row < awake.size(); ++row) {
        const int body = awake.body[row];
        if (!is_fast(stores.bodies, body, gravity_m_s2, dt_s)) continue;
        fast.push_back(body);
        const Vec2 way = dt_s * expected_velocity(stores.bodies, body, gravity_m_s2, dt_s);
        const Transform xf = stores.bodies.transform(body);
        const float turn = dt_s * std::fabs(awake.spin[row]);
        for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
            ShapeRecord& shape = stores.shapes[s];
            const Aabb now = bounds(shape.convex, xf);
            // Turning moves a point by no more than its arm times the angle.
            const float swing =
                turn * farthest_distance(shape.convex, stores.bodies.slots[body].mass.center_m);
            const Aabb then = bounds(shape.convex, {xf.p + way, xf.q});
            const Aabb all = grown(merged(now, then), swing);
            if (contains(shape.fat_box, grown(all, tuning::kAabbReach_m))) continue;
            shape.fat_box = grown(all, shape.margin_m);
            stores.broad.move(s, shape.fat_box);
        }
    }
}

void hold_fast_bodies(Stores& stores, std::span<const int> fast) {
    for (const int body : fast) {
        if (!stores.bodies.is_awake(body) || stores.bodies.slots[body].type != BodyType::Dynamic) continue;
        const float share = free_share_of_way(stores, body);
        if (share == 1) continue;
        BodyRows& awake = stores.bodies.rows(RowSet::Awake);
        const int row = stores.bodies.slots[body].row;
        const Vec2 moved = awake.moved[row];
        awake.center[row] = awake.center[row] + (share - 1) * moved;
        awake.moved[row] = share * moved;
        update_boxes(stores, body);
    }
}

void predict_contact(const Stores& stores, ContactRecord& contact, Vec2 gravity_m_s2, float dt_s) {
    if (!is_fast(stores.bodies, contact.body_a, gravity_m_s2, dt_s) &&
        !is_fast(stores.bodies, contact.body_b, gravity_m_s2, dt_s)) {
        return;
    }
    const Position origin =
        stores.bodies.rows_of(contact.body_a).center[stores.bodies.slots[contact.body_a].row];
    const Sweep a = make_sweep(stores, contact.shape_a, origin, gravity_m_s2, dt_s);
    const Sweep b = make_sweep(stores, contact.shape_b, origin, gravity_m_s2, dt_s);
    const std::optional<float> time = time_of_impact(a, b, dt_s, kImpactGap_m);
    if (!time) return;

    const Manifold m =
        collide(*a.shape, *b.shape, relative_pose_at(a, b, *time), tuning::kSpeculativeDistance_m);
    const SweptPose pose_a = pose_at(a, *time);
    contact.normal = rotate(pose_a.rotation, m.normal);
    contact.count = m.count;
    for (int i = 0; i < m.count; ++i) {
        const Vec2 at = pose_a.origin + rotate(pose_a.rotation, m.points[i].point);
        ContactPoint p;
        // The arms are those of the impact, so that both bodies feel the impulse in one place. The gap is
        // chosen such that the one which the solver sees at the impact is the true one.
        p.r_a = at - (a.center + *time * a.velocity);
        p.r_b = at - (b.center + *time * b.velocity);
        p.id = m.points[i].id;
        p.separation =
            m.points[i].separation - dot(moved(b, p.r_b, *time) - moved(a, p.r_a, *time), contact.normal);
        contact.points[i] = p;
    }
}

}  // namespace cairn::physics
