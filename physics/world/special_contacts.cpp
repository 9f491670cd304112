// Questions about special contacts.
#include "world/special_contacts.h"

#include "world/breakables.h"
#include "world/filtering.h"
#include "world/one_way.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {

void mark_special(const Stores& stores, ContactRecord& contact) {
    special::set(contact, special::kRefused, !host_allows(stores, contact.shape_a, contact.shape_b));
    special::set(contact, special::kWatched,
                 is_breakable(stores, contact.body_a) || is_breakable(stores, contact.body_b));
    special::set(contact, special::kOneWay,
                 is_one_way(stores.shapes[contact.shape_a]) || is_one_way(stores.shapes[contact.shape_b]));
    const auto is_tiny = [&](int shape) { return extent_of(stores.shapes[shape].convex()) < kTinyExtent_m; };
    special::set(contact, special::kTiny, is_tiny(contact.shape_a) || is_tiny(contact.shape_b));
}

bool lets_pass(const Stores& stores, int shape_a, int shape_b) {
    const bool may_be = stores.rules.filter.may_collide || is_one_way(stores.shapes[shape_a]) ||
                        is_one_way(stores.shapes[shape_b]);
    if (!may_be) return false;
    bool passes = false;
    for_each_edge(stores.contacts.slots, stores.bodies.slots[stores.shapes[shape_a].body].first_contact,
                  [&](int contact, int) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if (c.shape_a != shape_b && c.shape_b != shape_b) return;
                      if (c.shape_a != shape_a && c.shape_b != shape_a) return;
                      passes |= special::has(c, special::kRefused | special::kPassing);
                  });
    return passes;
}

}  // namespace cairn::physics
