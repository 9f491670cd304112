// In which list a contact is: near, in a colour, loose, or in none while its bodies sleep.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Which routine finds the manifold of its shapes.
PairGeometry geometry_of(const Stores& stores, const ContactRecord& contact);

/// What its lane in a colour is to hold.
PairLane make_lane(const Stores& stores, int contact);

/// Writes what it is to be among the pairs without points into an empty one.
void fill_near_pair(const Stores& stores, const ContactRecord& record, int contact, PairGeometry geometry,
                    NearPair& pair);

/// Puts a contact that is in no list among the near ones, if one of its bodies is awake.
void list_contact(Stores& stores, int contact);

/// The same for one that was made of this draft just now.
void list_contact(Stores& stores, int contact, const NewContact& draft);

/// Takes the contact out of its list. It remembers its impulses.
void unlist_contact(Stores& stores, int contact);

/// The contact has no points any more: it forgets their impulses, and goes back to the near ones.
void forget_points(Stores& stores, int contact);

/// What its points gave goes for nothing, since no number may be left of it.
void forget_impulses(ContactStore& contacts, int contact);

/// Takes a contact that is in no list and has points into a colour, or among the loose ones where no lane can
/// hold it: a body has no colour left, or nothing there can be moved.
void color_contact(Stores& stores, int contact);

/// After something changed that lanes keep a copy of, such as the mass of a body or the friction: the contact
/// starts again from the near ones.
void relist_contact(Stores& stores, int contact);

/// Asks for what taking the contact out of its list will read and write.
void ask_for_place(const ContactStore& contacts, int contact);

/// Asks for what a list that takes the contact in reads of its bodies.
void ask_for_bodies(const Stores& stores, int contact);

ContactMemory memory_of(const ContactStore& contacts, int contact);

}  // namespace cairn::physics
