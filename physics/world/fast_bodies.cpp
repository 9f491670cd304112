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

// What a thread takes at once.
constexpr int kBodiesPerChunk = 64;

// Of what is solid about the thinnest shape: moving further than this in a step is fast.
constexpr float kFastShare = 0.5f;

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
    return dt_s * reach > kFastShare * record.inner_radius_m;
}

// Of the point that turning moves most, m/s.
float turning_speed(const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    const float spin = bodies.rows_of(body).spin[record.row];
    return spin == 0 ? 0 : std::fabs(spin) * record.extent_m;
}

Sweep make_sweep(const Stores& stores, int shape, Position origin, Vec2 gravity, float dt_s) {
    const int body = stores.shapes[shape].body;
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const Place& place = stores.bodies.places[body];
    return {&stores.shapes[shape].convex,
            place.center - origin,
            place.rotation,
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
// with the point, or was pushed ahead of it, was not passed. Ways up to the least one are not looked at.
std::optional<LocalRayHit> cast_relative_way(const Stores& stores, int shape, Position from, Vec2 way,
                                             float least_way) {
    const int body = stores.shapes[shape].body;
    const Place& place = stores.bodies.places[body];
    if (place.row == kWorldRow) {
        const Transform now = stores.bodies.transform(body);
        return cast_ray(stores.shapes[shape].convex, inverse_transform_point(now, from),
                        inverse_rotate(now.q, way));
    }
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    const Vec2 moved = awake.moved[place.row - 1];
    const Rotation q = awake.rotation_before[place.row - 1];
    const Position center = place.center + -moved;
    // Turning moves a point by the chord of the angle.
    const float chord = length(Vec2{place.rotation.c - q.c, place.rotation.s - q.s});
    if (length(way - moved) + chord * length(from - center) <= least_way) return {};
    const BodyRecord& record = stores.bodies.slots[body];
    const Transform now = stores.bodies.transform(body);
    const Convex& convex = stores.shapes[shape].convex;
    const Vec2 start = inverse_transform_point({center + -rotate(q, record.mass.center_m), q}, from);
    const Vec2 relative_way = inverse_transform_point(now, from + way) - start;
    if (length(relative_way) <= least_way) return {};
    return cast_ray(convex, start, relative_way);
}

// How much of its last way a shape could go before its centre met the surface of the other shape, less its
// own thickness; 1 when it met nothing.
class Way {
  public:
    Way(const Stores& stores, int shape)
        : stores_(stores), convex_(stores.shapes[shape].convex), shape_(shape) {
        const int body = stores.shapes[shape].body;
        const BodyRecord& record = stores.bodies.slots[body];
        const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
        const Vec2 arm = convex_.centroid - record.mass.center_m;
        from_ = stores.bodies.places[body].center + -awake.moved[record.row] +
                rotate(awake.rotation_before[record.row], arm);
        way_ = transform_point(stores.bodies.transform(body), convex_.centroid) - from_;
        length_ = length(way_);
        least_way_ = kFastShare * record.inner_radius_m;
    }

    [[nodiscard]] int shape() const { return shape_; }
    [[nodiscard]] Position from() const { return from_; }
    [[nodiscard]] Vec2 way() const { return way_; }

    [[nodiscard]] float free_share(int other) const {
        if (length_ <= least_way_) return 1;
        const auto hit = cast_relative_way(stores_, other, from_, way_, least_way_);
        return hit ? std::max(hit->fraction - inner_radius(convex_) / length_, 0.0f) : 1;
    }

  private:
    const Stores& stores_;
    const Convex& convex_;
    int shape_;
    Position from_;
    Vec2 way_;
    float length_ = 0;
    float least_way_ = 0;  // shorter ones take the centre through nothing
};

// While a body stays in the boxes that it had when contacts were updated, all that it could pass through has
// a contact with it. One that was turned aside has to ask the trees.
float free_share_of_way(const Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    float share = 1;
    std::optional<Way> way;
    if ((stores.bodies.places[body].flags & place_flag::kBoxesMoved) == 0) {
        for_each_edge(stores.contacts.slots, record.first_contact, [&](int contact, int side) {
            const ContactRecord& c = stores.contacts.slots[contact];
            if (special::has(c, special::kRefused | special::kPassing)) return;
            const int own = side == 0 ? c.shape_a : c.shape_b;
            if (!way || way->shape() != own) way.emplace(stores, own);
            share = std::min(share, way->free_share(side == 0 ? c.shape_b : c.shape_a));
        });
        return share;
    }
    for (int s = record.first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
        way.emplace(stores, s);
        const auto visit = [&](int other) {
            if (may_collide(stores, s, other) && !lets_pass(stores, s, other))
                share = std::min(share, way->free_share(other));
            return 1.0f;
        };
        for (const Layer layer : kLayers) stores.broad.tree(layer).cast_ray(way->from(), way->way(), visit);
    }
    return share;
}

}  // namespace

void cover_fast_ways(Stores& stores, Vec2 gravity_m_s2, float dt_s, std::vector<int>& fast) {
    fast.clear();
    const BodyRows& awake = stores.bodies.rows(RowSet::Awake);
    for (int row = 0; row < awake.size(); ++row) {
        const int body = awake.body[row];
        std::uint32_t& flags = stores.bodies.places[body].flags;
        flags &= ~place_flag::kFast;
        if (!is_fast(stores.bodies, body, gravity_m_s2, dt_s)) continue;
        flags |= place_flag::kFast;
        fast.push_back(body);
        const Vec2 way = dt_s * expected_velocity(stores.bodies, body, gravity_m_s2, dt_s);
        const Transform xf = stores.bodies.transform(body);
        const float turn = dt_s * std::fabs(awake.spin[row]);
        for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body) {
            const ShapeRecord& shape = stores.shapes[s];
            const Aabb now = bounds(shape.convex, xf);
            // Turning moves a point by no more than its arm times the angle.
            const float swing =
                turn * farthest_distance(shape.convex, stores.bodies.slots[body].mass.center_m);
            const Aabb then = bounds(shape.convex, {xf.p + way, xf.q});
            const Aabb all = grown(merged(now, then), swing);
            if (contains(shape.fat_box, grown(all, tuning::kAabbReach_m))) continue;
            set_fat_box(stores, s, grown(all, shape.margin_m));
        }
    }
}

void hold_fast_bodies(Stores& stores, StepScratch& scratch, TaskPool& tasks) {
    const std::vector<int>& fast = scratch.fast;
    scratch.free_shares.assign(fast.size(), 1.0f);
    tasks.parallel_for(static_cast<int>(fast.size()), kBodiesPerChunk, [&](const Chunk& chunk) {
        for (int i = chunk.begin; i < chunk.end; ++i) {
            const int body = fast[i];
            if (!stores.bodies.is_awake(body) || stores.bodies.slots[body].type != BodyType::Dynamic)
                continue;
            scratch.free_shares[i] = free_share_of_way(stores, body);
        }
    });
    for (std::size_t i = 0; i < fast.size(); ++i) {
        const float share = scratch.free_shares[i];
        if (share == 1) continue;
        BodyRows& awake = stores.bodies.rows(RowSet::Awake);
        const int row = stores.bodies.slots[fast[i]].row;
        const Vec2 moved = awake.moved[row];
        Position& center = stores.bodies.places[fast[i]].center;
        center = center + (share - 1) * moved;
        awake.moved[row] = share * moved;
        update_boxes(stores, fast[i]);
    }
}

bool predict_contact(const Stores& stores, const ContactRecord& contact, const AxisGap& seen,
                     Vec2 gravity_m_s2, float dt_s, ContactInput& input) {
    const BodyStore& bodies = stores.bodies;
    const BodyRecord& body_a = bodies.slots[contact.body_a];
    const BodyRecord& body_b = bodies.slots[contact.body_b];
    const Vec2 velocity = expected_velocity(bodies, contact.body_b, gravity_m_s2, dt_s) -
                          expected_velocity(bodies, contact.body_a, gravity_m_s2, dt_s);
    const float turning = turning_speed(bodies, contact.body_a) + turning_speed(bodies, contact.body_b);
    // What moves along with the other cannot pass through it.
    const float thinnest = std::min(body_a.inner_radius_m, body_b.inner_radius_m);
    if (dt_s * (length(velocity) + turning) <= kFastShare * thinnest) return false;
    AxisGap apart = seen;
    if (apart.gap_m <= 0) {
        const Vec2 between = bodies.center_offset(contact.body_a, contact.body_b);
        apart = {normalized(between), length(between) - body_a.extent_m - body_b.extent_m};
    }
    const float closing = turning - dot(velocity, apart.axis);
    if (apart.gap_m > 0 && apart.gap_m - dt_s * closing > kImpactGap_m) return false;

    const Position origin = bodies.places[contact.body_a].center;
    const Sweep a = make_sweep(stores, contact.shape_a, origin, gravity_m_s2, dt_s);
    const Sweep b = make_sweep(stores, contact.shape_b, origin, gravity_m_s2, dt_s);
    const std::optional<float> time = time_of_impact(a, b, dt_s, kImpactGap_m);
    if (!time) return false;

    const Manifold m =
        collide(*a.shape, *b.shape, relative_pose_at(a, b, *time), tuning::kSpeculativeDistance_m);
    const SweptPose pose_a = pose_at(a, *time);
    input = {};
    input.normal = rotate(pose_a.rotation, m.normal);
    input.count = m.count;
    for (int i = 0; i < m.count; ++i) {
        const Vec2 at = pose_a.origin + rotate(pose_a.rotation, m.points[i].point);
        ContactInput::Point& p = input.points[i];
        // The arms are those of the impact, so that both bodies feel the impulse in one place. The gap is
        // chosen such that the one which the solver sees at the impact is the true one.
        p.r_a = at - (a.center + *time * a.velocity);
        p.r_b = at - (b.center + *time * b.velocity);
        p.feature = m.points[i].id;
        p.separation =
            m.points[i].separation - dot(moved(b, p.r_b, *time) - moved(a, p.r_a, *time), input.normal);
    }
    input.friction = contact.friction;
    input.restitution = contact.restitution;
    input.radius_a = a.shape->radius();
    input.radius_b = b.shape->radius();
    return m.count > 0;
}

}  // namespace cairn::physics
