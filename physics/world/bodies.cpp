// Bodies and shapes: creation, destruction, teleporting.
#include "world/bodies.h"

#include <algorithm>
#include <vector>

#include <cairn/physics/tuning.h>

#include "world/breakables.h"
#include "world/contacts.h"
#include "world/filtering.h"
#include "world/finalize.h"
#include "world/joints.h"
#include "world/one_way.h"
#include "world/sleep.h"
#include "world/unheld.h"

namespace cairn::physics {
namespace {

template <class Visit>
void for_each_shape(const Stores& stores, int body, Visit&& visit) {
    for (int shape = stores.bodies.slots[body].first_shape; shape != kNone;) {
        const int next = stores.shapes[shape].next_of_body;
        visit(shape);
        shape = next;
    }
}

RowSet initial_set(const BodyDef& def) {
    if (def.type == BodyType::Static) return RowSet::Static;
    return def.awake ? RowSet::Awake : RowSet::Asleep;
}

void destroy_contacts_of(WorldState& world, int shape) {
    Stores& stores = world.stores;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[stores.shapes[shape].body].first_contact,
                  [&](int contact, int) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if (c.shape_a == shape || c.shape_b == shape)
                          destroy_contact(stores, world.events, contact);
                  });
    forget_unheld(stores);
}

void unlink_shape(Stores& stores, int shape) {
    const ShapeRecord& record = stores.shapes[shape];
    BodyRecord& body = stores.bodies.slots[record.body];
    const int previous = record.previous_of_body;
    const int next = record.next_of_body;
    (previous == kNone ? body.first_shape : stores.shapes[previous].next_of_body) = next;
    (next == kNone ? body.last_shape : stores.shapes[next].previous_of_body) = previous;
}

}  // namespace

int create_body(Stores& stores, const BodyDef& def) {
    BodyRecord record;
    record.type = def.type;
    record.allow_sleep = def.allow_sleep;
    record.linear_damping_1_s = def.linear_damping_1_s;
    record.angular_damping_1_s = def.angular_damping_1_s;
    record.gravity_scale = def.gravity_scale;
    record.locks = def.locks;
    record.sleep_speed_m_s = def.sleep_speed_m_s;
    record.user_data = def.user_data;
    const int body = stores.bodies.slots.insert(record);
    stores.bodies.add_row(body, initial_set(def));
    start_mass(stores, body);

    BodyRows& rows = stores.bodies.rows_of(body);
    Place& place = stores.bodies.places[body];
    place.center = def.position_m;
    place.rotation = rows.rotation_before.back() = Rotation::from_angle(def.angle_rad);
    if (stores.bodies.is_awake(body)) {
        rows.velocity.back() = without_locked(def.linear_velocity_m_s, locked_axes(record));
        rows.spin.back() = turning_is_locked(record) ? 0 : def.angular_velocity_rad_s;
    } else if (def.type != BodyType::Static) {
        stores.bodies.slots[body].next_sleeper = body;
    }
    return body;
}

void destroy_body(WorldState& world, int body) {
    Stores& stores = world.stores;
    wake_body(stores, body);
    wake_neighbours(stores, body);
    const BodyRecord& record = stores.bodies.slots[body];
    // One by one: gears go with their joints.
    while (record.first_joint != kNone) destroy_joint(stores, edge_record(record.first_joint));
    for_each_edge(stores.contacts.slots, record.first_contact,
                  [&](int contact, int) { destroy_contact(stores, world.events, contact); });
    forget_unheld(stores);
    for_each_shape(stores, body, [&](int shape) {
        const int chain = stores.shapes[shape].chain;
        if (chain != kNone && stores.chains.alive(chain)) stores.chains.erase(chain);
        stores.broad.remove(shape);
        erase_shape(stores, shape);
    });
    while (stores.bodies.slots[body].first_sensor != kNone) {
        destroy_sensor(world, stores.bodies.slots[body].first_sensor);
    }
    stores.sensors.outdated = true;
    forget_breakable(stores, body);
    stores.bodies.remove_row(body);
    stores.bodies.slots.erase(body);
}

int add_shape(Stores& stores, int body, const Convex& convex, const ShapeDef& def) {
    stores.sensors.outdated = true;
    BodyRecord& owner = stores.bodies.slots[body];
    const Aabb box = bounds(convex, stores.bodies.transform(body));
    ShapeRecord record;
    record.body = body;
    record.previous_of_body = owner.last_shape;
    record.margin_m = tuning::kAabbReach_m;
    // Small shapes take small margins, or a heap of grains would be one heap of pairs.
    if (owner.type != BodyType::Static)
        record.margin_m +=
            std::min(tuning::kAabbMargin_m - tuning::kAabbReach_m, 0.025f * half_perimeter(box));

    ShapeDef made_of = def;
    made_of.one_way_normal = unit_or_zero(def.one_way_normal);
    record.take_prototype(stores.prototypes, convex, made_of);
    const int shape = insert_shape(stores, record, grown(box, record.margin_m));
    stores.broad.add(shape, layer_of(owner.set), stores.fat_boxes[shape]);
    (owner.last_shape == kNone ? owner.first_shape : stores.shapes[owner.last_shape].next_of_body) = shape;
    owner.last_shape = shape;
    tell_kin(stores, shape);
    if (record.previous_of_body != kNone) tell_kin(stores, record.previous_of_body);
    stores.bodies.rows_of(body).box_slack[owner.row] = 0;
    return shape;
}

void tell_kin(Stores& stores, int shape) {
    const ShapeRecord& record = stores.shapes[shape];
    const BodyRecord& owner = stores.bodies.slots[record.body];
    // Nobody looks for pairs of static shapes.
    const bool is_alone = owner.first_shape == owner.last_shape || owner.type == BodyType::Static;
    stores.broad.set_kin(shape, record.group < 0 ? record.group : is_alone ? 0 : record.body + 1);
}

void remove_shape(Stores& stores, int shape) {
    stores.sensors.outdated = true;
    unlink_shape(stores, shape);
    stores.broad.remove(shape);
    erase_shape(stores, shape);
}

int create_shape(Stores& stores, int body, const Convex& convex, const ShapeDef& def) {
    if (def.sensor) return create_sensor(stores, body, convex, def);
    const int shape = add_shape(stores, body, convex, def);
    add_mass(stores, body, convex, def.density_kg_m2);
    return shape;
}

void destroy_shape(WorldState& world, int shape) {
    Stores& stores = world.stores;
    if (stores.shapes[shape].def().sensor) return destroy_sensor(world, shape);
    const int body = stores.shapes[shape].body;
    wake_body(stores, body);
    destroy_contacts_of(world, shape);
    remove_shape(stores, shape);
    lose_mass(stores, body);
}

void refilter_shape(WorldState& world, int shape) {
    Stores& stores = world.stores;
    stores.sensors.outdated = true;
    if (stores.shapes[shape].def().sensor) return;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[stores.shapes[shape].body].first_contact,
                  [&](int contact, int) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if (c.shape_a != shape && c.shape_b != shape) return;
                      // The host is asked again only about pairs that are new.
                      if (stores.rules.filter.may_collide || !may_collide(stores, c.shape_a, c.shape_b))
                          destroy_contact(stores, world.events, contact);
                  });
    forget_unheld(stores);
    tell_kin(stores, shape);
    stores.broad.touch(shape);
    wake_body(stores, stores.shapes[shape].body);
}

void set_locks(Stores& stores, int body, AxisLocks locks) {
    wake_body(stores, body);
    BodyRecord& record = stores.bodies.slots[body];
    record.locks = locks;
    BodyRows& rows = stores.bodies.rows_of(body);
    rows.velocity[record.row] = without_locked(rows.velocity[record.row], locked_axes(record));
    if (turning_is_locked(record)) rows.spin[record.row] = 0;
    renew_mass(stores, body);
}

void teleport(Stores& stores, int body, Position origin_m, double angle_rad) {
    wake_body(stores, body);
    wake_neighbours(stores, body);
    const BodyRecord& record = stores.bodies.slots[body];
    BodyRows& rows = stores.bodies.rows_of(body);
    const Transform xf{origin_m, Rotation::from_angle(angle_rad)};
    Place& place = stores.bodies.places[body];
    place.rotation = rows.rotation_before[record.row] = xf.q;
    place.center = transform_point(xf, record.mass.center_m);
    rows.moved[record.row] = {};
    update_boxes(stores, body);
    note_moved_boxes(stores, body);  // within the boxes that it had, too: its contacts are looked at
    stores.sensors.outdated = true;
    if (record.type != BodyType::Static) return;
    // A static body never wakes anything by touching it, so what sleeps at its new place is woken here:
    // afterwards, since waking changes the trees.
    std::vector<int> met;
    for_each_shape(stores, body, [&](int shape) {
        for (const Layer layer : {Layer::Asleep, Layer::Awake}) {
            stores.broad.tree(layer).query(stores.fat_boxes[shape],
                                           [&](int other) { met.push_back(stores.shapes[other].body); });
        }
    });
    for (const int other : met) wake_body(stores, other);
}

}  // namespace cairn::physics
