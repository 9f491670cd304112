// Moves of contacts between lists.
#include "world/contact_lists.h"

#include <bit>

#include "base/ample.h"
#include "world/direct_groups.h"
#include "world/domains.h"
#include "world/special_contacts.h"

namespace cairn::physics {
namespace {

bool can_be_moved(const BodyRecord& body) {
    return body.inverse_mass > 0;
}

void note_if_uneven(Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    const float a = stores.bodies.slots[c.body_a].inverse_mass;
    const float b = stores.bodies.slots[c.body_b].inverse_mass;
    if (a > 0 && b > 0 && (a > kUnevenMasses * b || b > kUnevenMasses * a))
        stores.contacts.uneven.add(stores.contacts.slots, contact);
}

// How far the shape reaches from its body's centre of mass, which mostly is its own.
float reach_of(const ShapePrototype& shape, Vec2 center_m) {
    if (shape.convex.centroid == center_m) return shape.reach_m;
    return farthest_distance(shape.convex, center_m);
}

// As in BoxLanes.
Vec2 offset_of(const Convex& shape, Vec2 center_m, PairGeometry geometry) {
    return geometry == PairGeometry::Boxes ? shape.centroid - center_m : -center_m;
}

// Moves the bits of the two bodies; immovable ones have no part in colours.
void mark_color(Stores& stores, const ContactRecord& c, int bucket, bool on) {
    const std::uint32_t bit = 1u << color_of(bucket);
    const auto mark = [&](int body) {
        std::uint32_t& colors = stores.contacts.colors[body];
        colors = on ? colors | bit : colors & ~bit;
    };
    mark(c.body_b);
    if (kind_of(bucket) == BlockKind::TwoBodies) mark(c.body_a);
}

int choose_bucket(Stores& stores, const ContactRecord& c) {
    const BodyRecord& a = stores.bodies.slots[c.body_a];
    const BodyRecord& b = stores.bodies.slots[c.body_b];
    if (!can_be_moved(b) || is_loose(c)) return kLooseBucket;
    BlockKind kind = BlockKind::TwoBodies;
    if (a.type == BodyType::Static) kind = BlockKind::OneBody;
    if (a.type == BodyType::Kinematic) kind = BlockKind::Carried;
    if (kind == BlockKind::TwoBodies && !can_be_moved(a)) return kLooseBucket;
    if (locked_axes(a) != 0 || locked_axes(b) != 0) return kLooseBucket;
    std::uint32_t used = stores.contacts.colors[c.body_b];
    if (kind == BlockKind::TwoBodies) used |= stores.contacts.colors[c.body_a];
    const int color = std::countr_one(used);
    if (color >= kColors) return kLooseBucket;
    const bool both = kind == BlockKind::TwoBodies;
    settle_in_domain(stores, c.body_b);
    if (both) settle_in_domain(stores, c.body_a);
    return colored_bucket(color, kind, geometry_of(stores, c),
                          domain_of(stores.domains, c.body_a, c.body_b, both));
}

void add_loose(ContactStore& contacts, int contact) {
    contacts.slots[contact].bucket = kLooseBucket;
    contacts.slots[contact].lane = static_cast<int>(contacts.loose.size());
    push_amply(contacts.loose, contact);
    contacts.tiny += special::has(contacts.slots[contact], special::kTiny) ? 1 : 0;
}

// geometry() tells the list of near ones that it may go to, and fill(geometry, pair) what it is to be there.
template <class GeometryOf, class Fill>
void list(Stores& stores, int contact, const GeometryOf& geometry_of, const Fill& fill) {
    ContactRecord& c = stores.contacts.slots[contact];
    if (c.bucket != kNone) return;
    if (!stores.bodies.is_awake(c.body_a) && !stores.bodies.is_awake(c.body_b)) return;
    note_if_uneven(stores, contact);
    if (is_loose(c)) return add_loose(stores.contacts, contact);
    const PairGeometry geometry = geometry_of();
    c.bucket = near_bucket(geometry);
    ContactLanes& lanes = stores.contacts.lanes;
    c.lane = lanes.open_near(geometry);
    fill(geometry, lanes.near_pairs(geometry)[c.lane]);
}

void take_out(Stores& stores, int contact) {
    ContactStore& contacts = stores.contacts;
    ContactRecord& c = contacts.slots[contact];
    if (c.bucket == kLooseBucket) {
        const int last = contacts.loose.back();
        contacts.loose[c.lane] = last;
        contacts.slots[last].lane = c.lane;
        contacts.loose.pop_back();
        contacts.tiny -= special::has(c, special::kTiny) ? 1 : 0;
    } else {
        if (is_colored(c.bucket)) mark_color(stores, c, c.bucket, false);
        const int moved = contacts.lanes.remove(c.bucket, c.lane);
        if (moved != kNone) contacts.slots[moved].lane = c.lane;
    }
    c.bucket = kNone;
}

}  // namespace

PairGeometry geometry_of(const Stores& stores, const ContactRecord& c) {
    const Convex& a = stores.shapes[c.shape_a].convex();
    const Convex& b = stores.shapes[c.shape_b].convex();
    if (a.is_box && b.is_box) return PairGeometry::Boxes;
    const bool in_lanes = !a.is_chained() && !b.is_chained() && !(a.is_line() && b.is_line());
    return in_lanes ? PairGeometry::Hulls : PairGeometry::Chains;
}

PairLane make_lane(const Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    const Convex& a = stores.shapes[c.shape_a].convex();
    const Convex& b = stores.shapes[c.shape_b].convex();
    PairLane lane;
    lane.contact = contact;
    lane.body_a = c.body_a;
    lane.body_b = c.body_b;
    lane.shape_a = c.shape_a;
    lane.shape_b = c.shape_b;
    const PairGeometry geometry = geometry_of(stores, c);
    lane.offset_a = offset_of(a, stores.bodies.slots[c.body_a].mass.center_m, geometry);
    lane.offset_b = offset_of(b, stores.bodies.slots[c.body_b].mass.center_m, geometry);
    if (geometry == PairGeometry::Boxes) {
        lane.half_a = a.half_size;
        lane.half_b = b.half_size;
    }
    lane.reports = c.reports_touch || special::has(c, special::kWatched);
    lane.faint = faint_restitution(c) > 0;
    lane.impacts = (c.restitution > 0 && !lane.faint) || c.reports_hit;
    return lane;
}

void fill_near_pair(const Stores& stores, const ContactRecord& c, int contact, PairGeometry geometry,
                    NearPair& pair) {
    const ShapePrototype& a = *stores.shapes[c.shape_a].prototype;
    const ShapePrototype& b = *stores.shapes[c.shape_b].prototype;
    const Vec2 center_a = stores.bodies.slots[c.body_a].mass.center_m;
    const Vec2 center_b = stores.bodies.slots[c.body_b].mass.center_m;
    pair.body_a = c.body_a;
    pair.body_b = c.body_b;
    pair.reach_m = reach_of(a, center_a) + reach_of(b, center_b);
    pair.flags = c.has_points ? near_flag::kRemembers : 0;
    pair.contact = contact;
    pair.shape_a = c.shape_a;
    pair.shape_b = c.shape_b;
    pair.offset_a = offset_of(a.convex, center_a, geometry);
    pair.offset_b = offset_of(b.convex, center_b, geometry);
}

void ask_for_place(const ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    if (c.bucket != kNone && c.bucket != kLooseBucket) contacts.lanes.ask_for(c.bucket, c.lane);
}

void ask_for_bodies(const Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    for (const int shape : {c.shape_a, c.shape_b}) stores.shapes.ask_for(shape);
    const std::vector<std::uint32_t>& colors = stores.contacts.colors;
    for (const int body : {c.body_a, c.body_b}) {
        stores.bodies.slots.ask_for(body);
        const auto at = static_cast<std::size_t>(body);
        if (at < colors.size()) prefetch(&colors[at], sizeof colors[at]);
    }
}

ContactMemory memory_of(const ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    if (!is_colored(c.bucket)) return c.memory;
    return contacts.lanes.memory(c.lane);
}

void list_contact(Stores& stores, int contact) {
    const ContactRecord& c = stores.contacts.slots[contact];
    list(
        stores, contact, [&] { return geometry_of(stores, c); },
        [&](PairGeometry geometry, NearPair& pair) { fill_near_pair(stores, c, contact, geometry, pair); });
}

void list_contact(Stores& stores, int contact, const NewContact& draft) {
    list(
        stores, contact, [&] { return draft.geometry; },
        [&](PairGeometry, NearPair& pair) {
            pair = draft.pair;
            pair.contact = contact;
        });
}

void unlist_contact(Stores& stores, int contact) {
    ContactRecord& c = stores.contacts.slots[contact];
    if (c.bucket == kNone) return;
    c.memory = memory_of(stores.contacts, contact);
    take_out(stores, contact);
    stores.contacts.uneven.remove(stores.contacts.slots, contact);
}

void forget_points(Stores& stores, int contact) {
    ContactRecord& c = stores.contacts.slots[contact];
    if (c.bucket != kNone) take_out(stores, contact);
    c.memory = {};
    list_contact(stores, contact);
}

void forget_impulses(ContactStore& contacts, int contact) {
    ContactRecord& c = contacts.slots[contact];
    const bool colored = is_colored(c.bucket);
    ContactMemory memory = colored ? contacts.lanes.memory(c.lane) : c.memory;
    memory.impulse = {};
    memory.friction_impulse = 0;
    if (colored) {
        contacts.lanes.set_memory(c.lane, memory);
    } else {
        c.memory = memory;
    }
}

void color_contact(Stores& stores, int contact) {
    ContactStore& contacts = stores.contacts;
    ContactRecord& c = contacts.slots[contact];
    c.has_points = true;
    note_if_uneven(stores, contact);
    cover_amply(contacts.colors, static_cast<std::size_t>(stores.bodies.slots.end_index()));
    c.bucket = choose_bucket(stores, c);
    if (c.bucket == kLooseBucket) return add_loose(contacts, contact);
    mark_color(stores, c, c.bucket, true);
    c.lane = contacts.lanes.add(c.bucket, make_lane(stores, contact));
    contacts.lanes.set_memory(c.lane, c.memory);
    contacts.lanes.set_material(c.lane, c.friction, faint_restitution(c));
}

void relist_contact(Stores& stores, int contact) {
    if (stores.contacts.slots[contact].bucket == kNone) return;
    unlist_contact(stores, contact);
    list_contact(stores, contact);
}

}  // namespace cairn::physics
