// The hash of a world's state, in slot order.
#include "base/state_hash.h"

#include "world/contact_lists.h"
#include "world/joint_lists.h"

namespace cairn::physics {
namespace {

void add_body(StateHash& hash, const BodyStore& bodies, int body) {
    const BodyRecord& record = bodies.slots[body];
    const BodyRows& rows = bodies.rows(record.set);
    hash.add(bodies.slots.id(body).bits() & 0xffffffffffffu);  // without the world's tag: twins hash alike
    hash.add(static_cast<std::uint64_t>(record.type) << 8 | static_cast<std::uint64_t>(record.set));
    hash.add(bodies.places[body].center);
    hash.add(bodies.places[body].rotation);
    hash.add(rows.velocity[record.row]);
    hash.add(rows.spin[record.row], rows.rest_time[record.row]);
    hash.add(rows.force[record.row]);
    hash.add(rows.torque[record.row], record.mass.mass_kg);
    if (record.joint_inertia > 0) hash.add(record.joint_inertia, 0);
}

void add_contact(StateHash& hash, const ContactStore& contacts, int contact) {
    const ContactRecord& c = contacts.slots[contact];
    hash.add(static_cast<std::uint64_t>(c.shape_a) << 32 | static_cast<std::uint32_t>(c.shape_b));
    if (c.special != 0) hash.add(std::uint64_t{c.special});
    const ContactMemory memory = memory_of(contacts, contact);
    for (int i = 0; i < 2; ++i) {
        if (memory.features[i] == kNoFeature) continue;
        hash.add(static_cast<std::uint64_t>(memory.features[i]));
        hash.add(memory.impulse[i], memory.friction_impulse);
    }
}

void add_joint(StateHash& hash, const JointStore& joints, int joint) {
    const JointRecord& j = joints.slots[joint];
    const JointMemory memory = memory_of(joints, joint);
    hash.add(static_cast<std::uint64_t>(j.body_a) << 32 | static_cast<std::uint32_t>(j.body_b));
    hash.add(memory.angle_rad);
    for (std::size_t i = 0; i < memory.impulse.size(); i += 2)
        hash.add(memory.impulse[i], memory.impulse[i + 1]);
}

}  // namespace

std::uint64_t hash_state(const WorldState& world) {
    const Stores& stores = world.stores;
    StateHash hash;
    hash.add(world.step_count);
    for (int i = 0; i < stores.bodies.slots.end_index(); ++i) {
        if (stores.bodies.slots.alive(i)) add_body(hash, stores.bodies, i);
    }
    for (int i = 0; i < stores.contacts.slots.end_index(); ++i) {
        if (stores.contacts.slots.alive(i)) add_contact(hash, stores.contacts, i);
    }
    for (int i = 0; i < stores.joints.slots.end_index(); ++i) {
        if (stores.joints.slots.alive(i)) add_joint(hash, stores.joints, i);
    }
    return hash.value();
}

}  // namespace cairn::physics
