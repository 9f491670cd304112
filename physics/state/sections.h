// A snapshot part by part, in the order in which they are written and read. Each part is written and read in
// the same file. Readers fill stores that are nobody's yet, and whose memory may be that of an earlier
// snapshot; whatever the bytes say, each reader leaves the stores in a state in which the next one may look
// at them, or fails.
#pragma once

#include "state/bytes.h"
#include "world/world_state.h"

namespace cairn::physics {

// state/body_state.cpp: bodies, their places, rows and masses.
void save_bodies(const Stores& stores, Writer& out);
void load_bodies(Reader& in, RestoreSpace& to);

// state/shape_state.cpp: shapes with their boxes, chains, sensors, breakable bodies, rules of materials.
void save_shapes(const Stores& stores, Writer& out);
void load_shapes(Reader& in, RestoreSpace& to);

// state/broad_state.cpp: the trees, and what moved since the last search.
void save_broad(const Stores& stores, Writer& out);
void load_broad(Reader& in, Stores& stores);

// state/link_state.cpp: which shapes, contacts and joints bodies have, in the order of their lists. The
// records of contacts and joints are there already.
void save_links(const Stores& stores, Writer& out);
void load_links(Reader& in, Stores& stores);

// state/contact_state.cpp: records of contacts.
void save_contacts(const ContactStore& contacts, Writer& out);
void load_contacts(Reader& in, ContactStore& contacts);
/// In `bucket` of a contact that was read, but not yet found in any list.
inline constexpr int kUnplaced = -2;

// state/contact_list_state.cpp: where contacts are.
void save_contact_lists(const Stores& stores, Writer& out);
void load_contact_lists(Reader& in, Stores& stores);

// state/joint_state.cpp: the same of joints.
void save_joints(const JointStore& joints, Writer& out);
void load_joints(Reader& in, JointStore& joints);
void save_joint_lists(const JointStore& joints, Writer& out);
void load_joint_lists(Reader& in, Stores& stores);

// state/event_state.cpp: what the last step told, and what the next one will.
void save_events(const Events& events, Writer& out);
void load_events(Reader& in, Events& events);

}  // namespace cairn::physics
