// Joints: creation and removal.
#include "world/joints.h"

#include "world/contacts.h"
#include "world/sleep.h"

namespace cairn::physics {
namespace {

void destroy_contacts_between(WorldState& world, int body_a, int body_b) {
    Stores& stores = world.stores;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[body_a].first_contact,
                  [&](int contact, int side) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if ((side == 0 ? c.body_b : c.body_a) == body_b)
                          destroy_contact(stores, world.events, contact);
                  });
}

// Asks for the pairs of a body's shapes again: those that the joint kept apart may meet now.
void look_for_pairs(Stores& stores, int body) {
    for (int shape = stores.bodies.slots[body].first_shape; shape != kNone;
         shape = stores.shapes[shape].next_of_body) {
        stores.broad.touch(shape);
    }
}

}  // namespace

int create_joint(WorldState& world, std::variant<RevoluteJointDef, DistanceJointDef> def) {
    Stores& stores = world.stores;
    JointRecord record;
    std::visit(
        [&](const auto& d) {
            record.body_a = stores.bodies.slots.find(d.body_a);
            record.body_b = stores.bodies.slots.find(d.body_b);
            record.collide_connected = d.collide_connected;
            record.user_data = d.user_data;
        },
        def);
    record.def = def;
    const int joint = stores.joints.slots.insert(record);
    link_edge(stores.joints.slots, stores.bodies.slots[record.body_a].first_joint, joint, 0);
    link_edge(stores.joints.slots, stores.bodies.slots[record.body_b].first_joint, joint, 1);
    wake_joint_bodies(stores, joint);
    if (stores.bodies.is_awake(record.body_a) || stores.bodies.is_awake(record.body_b)) {
        stores.joints.active.add(stores.joints.slots, joint);
    }
    if (!record.collide_connected) destroy_contacts_between(world, record.body_a, record.body_b);
    return joint;
}

void destroy_joint(Stores& stores, int joint) {
    wake_joint_bodies(stores, joint);
    const JointRecord& record = stores.joints.slots[joint];
    const int body_a = record.body_a;
    if (!record.collide_connected) look_for_pairs(stores, body_a);
    stores.joints.active.remove(stores.joints.slots, joint);
    unlink_edge(stores.joints.slots, stores.bodies.slots[record.body_a].first_joint, joint, 0);
    unlink_edge(stores.joints.slots, stores.bodies.slots[record.body_b].first_joint, joint, 1);
    stores.joints.slots.erase(joint);
}

void wake_joint_bodies(Stores& stores, int joint) {
    wake_body(stores, stores.joints.slots[joint].body_a);
    wake_body(stores, stores.joints.slots[joint].body_b);
}

}  // namespace cairn::physics
