// Chains as runs of shapes. A segment's form depends on the two points of it and on one more on either side,
// so a change of one point reaches four segments. Contacts of segments that change form are made anew: what
// they remember is about another form.
#include "world/chains.h"

#include <algorithm>

#include "world/bodies.h"
#include "world/contacts.h"
#include "world/finalize.h"
#include "world/sleep.h"
#include "world/unheld.h"

namespace cairn::physics {
namespace {

int segment_count(const ChainRecord& chain) {
    return static_cast<int>(chain.points_m.size()) - (chain.closed ? 0 : 1);
}

Convex form_of(const ChainRecord& chain, int segment) {
    const auto& points = chain.points_m;
    const int count = static_cast<int>(points.size());
    const auto at = [&](int i) { return points[(i + count) % count]; };
    std::optional<Vec2> before = chain.before_m;
    std::optional<Vec2> after = chain.after_m;
    if (chain.closed || segment > 0) before = at(segment - 1);
    if (chain.closed || segment + 2 < count) after = at(segment + 2);
    return make_chain_segment(before, at(segment), at(segment + 1), after);
}

int add_segment(Stores& stores, int chain, int segment, const ShapeDef& def) {
    const ChainRecord& record = stores.chains[chain];
    const int shape = add_shape(stores, record.body, form_of(record, segment), def);
    stores.shapes[shape].chain = chain;
    return shape;
}

// Ends the contacts of these shapes, all of one body, in one walk over the body's contacts.
void end_contacts(WorldState& world, int body, std::vector<int> shapes) {
    Stores& stores = world.stores;
    std::sort(shapes.begin(), shapes.end());
    const auto is_one = [&](int shape) { return std::binary_search(shapes.begin(), shapes.end(), shape); };
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact, [&](int contact, int side) {
        const ContactRecord& c = stores.contacts.slots[contact];
        if (is_one(side == 0 ? c.shape_a : c.shape_b)) destroy_contact(stores, world.events, contact);
    });
    forget_unheld(stores);
}

// What sleeps where segments have come to be would sleep on inside of them.
void wake_near(Stores& stores, const std::vector<int>& shapes) {
    std::vector<int> met;  // waking changes the trees
    for (const int shape : shapes) {
        for (const Layer layer : {Layer::Asleep, Layer::Awake}) {
            stores.broad.tree(layer).query(stores.fat_boxes[shape],
                                           [&](int other) { met.push_back(stores.shapes[other].body); });
        }
    }
    for (const int body : met) wake_body(stores, body);
}

// Gives the segments from `first` to `last` their new form; of a closed chain they are counted around it.
void reform(WorldState& world, int chain, int first, int last) {
    Stores& stores = world.stores;
    const ChainRecord& record = stores.chains[chain];
    const int count = segment_count(record);
    if (!record.closed) {
        first = std::max(first, 0);
        last = std::min(last, count - 1);
    } else if (last - first >= count) {
        first = 0;
        last = count - 1;
    }
    const Transform xf = stores.bodies.transform(record.body);
    std::vector<int> shapes;
    for (int i = first; i <= last; ++i) {
        const int segment = (i + count) % count;
        const int shape = record.segments[segment];
        shapes.push_back(shape);
        const ShapeRecord& s = stores.shapes[shape];
        remake_shape(stores, shape, form_of(record, segment), s.def());
        set_fat_box(stores, shape, grown(bounds(s.convex(), xf), s.margin_m));
        stores.broad.touch(shape);  // what it met before loses its contact, and gets a new one
    }
    wake_body(stores, record.body);
    end_contacts(world, record.body, shapes);
    wake_near(stores, shapes);
    note_reshaped(stores, record.body);
    stores.sensors.outdated = true;
}

}  // namespace

int create_chain(WorldState& world, int body, const ChainDef& def) {
    Stores& stores = world.stores;
    ChainRecord record;
    record.body = body;
    record.closed = def.closed;
    record.before_m = def.before_m;
    record.after_m = def.after_m;
    record.points_m.assign(def.points_m.begin(), def.points_m.end());
    record.user_data = def.user_data;
    const int chain = stores.chains.insert(std::move(record));

    ShapeDef shape;
    shape.density_kg_m2 = 0;
    shape.filter = def.filter;
    shape.contact_events = def.contact_events;
    shape.hit_events = def.hit_events;
    shape.user_data = def.user_data;
    const int count = segment_count(stores.chains[chain]);
    stores.chains[chain].segments.reserve(count);
    for (int i = 0; i < count; ++i) {
        if (!def.materials.empty()) shape.material = def.materials[def.materials.size() == 1 ? 0 : i];
        stores.chains[chain].segments.push_back(add_segment(stores, chain, i, shape));
    }
    note_reshaped(stores, body);
    return chain;
}

void destroy_chain(WorldState& world, int chain) {
    Stores& stores = world.stores;
    const ChainRecord& record = stores.chains[chain];
    wake_body(stores, record.body);
    end_contacts(world, record.body, record.segments);
    for (const int shape : record.segments) remove_shape(stores, shape);
    note_reshaped(stores, record.body);
    stores.chains.erase(chain);
}

void set_chain_point(WorldState& world, int chain, int index, Vec2 point_m) {
    world.stores.chains[chain].points_m[index] = point_m;
    reform(world, chain, index - 2, index + 1);
}

void insert_chain_points(WorldState& world, int chain, int index, std::span<const Vec2> points_m) {
    if (points_m.empty()) return;
    Stores& stores = world.stores;
    ChainRecord& record = stores.chains[chain];
    const int added = static_cast<int>(points_m.size());
    const int at = std::min(index, static_cast<int>(record.segments.size()));
    const ShapeDef def = stores.shapes[record.segments[std::max(at - 1, 0)]].def();
    record.points_m.insert(record.points_m.begin() + index, points_m.begin(), points_m.end());
    record.segments.insert(record.segments.begin() + at, added, kNone);
    for (int i = at; i < at + added; ++i) record.segments[i] = add_segment(stores, chain, i, def);
    reform(world, chain, at - 2, at + added + 1);
}

void remove_chain_points(WorldState& world, int chain, int first, int count) {
    if (count == 0) return;
    Stores& stores = world.stores;
    ChainRecord& record = stores.chains[chain];
    // At the end of an open chain the segments that led to the points go, elsewhere those that led from them.
    const bool ends_chain = first + count == static_cast<int>(record.points_m.size());
    const int at = !record.closed && ends_chain ? first - 1 : first;
    const std::vector<int> gone(record.segments.begin() + at, record.segments.begin() + at + count);
    end_contacts(world, record.body, gone);
    for (const int shape : gone) remove_shape(stores, shape);
    record.points_m.erase(record.points_m.begin() + first, record.points_m.begin() + first + count);
    record.segments.erase(record.segments.begin() + at, record.segments.begin() + at + count);
    reform(world, chain, at - 2, at + 1);
}

void set_chain_ends(WorldState& world, int chain, std::optional<Vec2> before_m, std::optional<Vec2> after_m) {
    ChainRecord& record = world.stores.chains[chain];
    record.before_m = before_m;
    record.after_m = after_m;
    const int last = segment_count(record) - 1;
    reform(world, chain, 0, 0);
    reform(world, chain, last, last);
}

}  // namespace cairn::physics
