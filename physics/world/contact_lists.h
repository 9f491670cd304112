// In which list a contact is: near, in a colour, loose, or in none while its bodies sleep.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

/// Puts a contact that is in no list among the near ones, if one of its bodies is awake.
void list_contact(Stores& stores, int contact);

/// Takes the contact out of its list. It remembers its impulses.
void unlist_contact(Stores& stores, int contact);

/// The contact has no points any more: it forgets their impulses, and goes back to the near ones.
void forget_points(Stores& stores, int contact);

/// Takes a contact that is in no list and has points into a colour, or among the loose ones where no lane can
/// hold it: a body has no colour left, or nothing there can be moved.
void color_contact(Stores& stores, int contact);

/// After something changed that lanes keep a copy of, such as the mass of a body or the friction: the contact
/// starts again from the near ones.
void relist_contact(Stores& stores, int contact);

ContactMemory memory_of(const ContactStore& contacts, int contact);

/// Calls visit(contact) for each contact that has points or may have some: those in colours and loose ones.
template <class Visit>
void for_each_acting(const ContactStore& contacts, Visit&& visit) {
    for (int bucket = kFirstColored; bucket < kBuckets; ++bucket) {
        for (int block = contacts.lanes.first_block(bucket); block != kNone;
             block = contacts.lanes.link(block).next) {
            const PairBlock& pairs = contacts.lanes.pairs(block);
            for (int lane = 0; lane < contacts.lanes.link(block).used; ++lane) visit(pairs.contact[lane]);
        }
    }
    for (const int contact : contacts.loose) visit(contact);
}

}  // namespace cairn::physics
