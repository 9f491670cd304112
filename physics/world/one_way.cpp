// Who passes a one-way shape. The two shapes are looked at as they were when they were last apart: now, or,
// when they overlap already, a step ago. So it does not matter how deep a fast body is when it is first seen.
#include "world/one_way.h"

#include <algorithm>

#include <cairn/physics/tuning.h>

#include "collide/distance.h"
#include "world/contact_lists.h"
#include "world/sleep.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

// Cosine between the one-way normal and the direction in which the other shape lies, from which on that is in
// front: 60 degrees, so that round things may meet an edge from above.
constexpr float kInFront = 0.5f;

enum class Side : std::uint8_t { Front, Elsewhere, Inside };

struct Poses {
    Transform a;
    Transform b;
};

Transform place_now(const Stores& stores, int body) {
    return stores.bodies.transform(body);
}

Transform place_before(const Stores& stores, int body) {
    const BodyRecord& record = stores.bodies.slots[body];
    const BodyRows& rows = stores.bodies.rows_of(body);
    const Rotation q = rows.rotation_before[record.row];
    const Position center = stores.bodies.places[body].center + -rows.moved[record.row];
    return {center + -rotate(q, record.mass.center_m), q};
}

// How far a shape reaches along a direction, from its body's origin.
float reach(const Convex& shape, Rotation q, Vec2 direction) {
    const Vec2 local = inverse_rotate(q, direction);
    float most = dot(shape.point(0), local);
    for (int i = 1; i < shape.count(); ++i) most = std::max(most, dot(shape.point(i), local));
    return most + shape.radius();
}

// Whether all of the other shape lies beyond the foremost point of this one: say, on top of its neighbour at
// the same height, from which it comes sliding.
bool is_beyond(const Convex& own, const Transform& own_xf, const Convex& other, const Transform& other_xf,
               Vec2 normal) {
    const float between = dot(other_xf.p - own_xf.p, normal);
    return between - reach(other, other_xf.q, -normal) - reach(own, own_xf.q, normal) >=
           -tuning::kLinearSlop_m;
}

// From a to b, of shapes that are apart or overlap by less than can be seen; nothing when they overlap more.
std::optional<Vec2> direction_between(const Convex& a, const Convex& b, const Poses& at) {
    const RelativePose b_in_a{inverse_rotate(at.a.q, at.b.p - at.a.p), inverse(at.a.q) * at.b.q};
    const Distance apart = distance_between(a, b, b_in_a);
    if (apart.distance > 0) return rotate(at.a.q, apart.normal);
    const Manifold m = collide(a, b, b_in_a, tuning::kLinearSlop_m);
    for (int i = 0; i < m.count; ++i) {
        if (m.points[i].separation < -tuning::kLinearSlop_m) return {};
    }
    if (m.count == 0) return {};
    return rotate(at.a.q, m.normal);
}

Side side_at(const Stores& stores, const ContactRecord& c, const Poses& at) {
    const ShapeRecord& a = stores.shapes[c.shape_a];
    const ShapeRecord& b = stores.shapes[c.shape_b];
    const Vec2 normal_a = rotate(at.a.q, a.def().one_way_normal);
    const Vec2 normal_b = rotate(at.b.q, b.def().one_way_normal);
    const bool beyond_a = !is_one_way(a) || is_beyond(a.convex(), at.a, b.convex(), at.b, normal_a);
    const bool beyond_b = !is_one_way(b) || is_beyond(b.convex(), at.b, a.convex(), at.a, normal_b);
    if (beyond_a && beyond_b) return Side::Front;
    const std::optional<Vec2> a_to_b = direction_between(a.convex(), b.convex(), at);
    if (!a_to_b) return Side::Inside;
    const bool front_a = beyond_a || dot(*a_to_b, normal_a) > kInFront;
    const bool front_b = beyond_b || dot(-*a_to_b, normal_b) > kInFront;
    return front_a && front_b ? Side::Front : Side::Elsewhere;
}

}  // namespace

Vec2 unit_or_zero(Vec2 direction) {
    const float largest = std::max(std::fabs(direction.x), std::fabs(direction.y));
    if (largest == 0) return {};
    return normalized(Vec2{direction.x / largest, direction.y / largest});
}

void forget_side(ContactRecord& contact) {
    special::set(contact, special::kPassing | special::kSolid, false);
}

bool is_held_out(const Stores& stores, ContactRecord& contact) {
    if (special::has(contact, special::kSolid)) return true;
    const int a = contact.body_a;
    const int b = contact.body_b;
    Side side = side_at(stores, contact, {place_now(stores, a), place_now(stores, b)});
    if (side == Side::Inside && !special::has(contact, special::kPassing)) {
        side = side_at(stores, contact, {place_before(stores, a), place_before(stores, b)});
    }
    const bool solid = side == Side::Front;
    special::set(contact, special::kSolid, solid);
    special::set(contact, special::kPassing, !solid);
    return solid;
}

void reconsider_one_way(Stores& stores, int shape) {
    const int body = stores.shapes[shape].body;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int) {
        ContactRecord& c = stores.contacts.slots[contact];
        if (c.shape_a != shape && c.shape_b != shape) return;
        special::set(c, special::kOneWay,
                     is_one_way(stores.shapes[c.shape_a]) || is_one_way(stores.shapes[c.shape_b]));
        forget_side(c);
        relist_contact(stores, contact);
        const int body_a = c.body_a;
        const int body_b = c.body_b;
        wake_body(stores, body_a);
        wake_body(stores, body_b);
    });
}

}  // namespace cairn::physics
