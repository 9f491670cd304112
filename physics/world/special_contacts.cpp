// Questions about special contacts.
#include "world/special_contacts.h"

namespace cairn::physics {

bool lets_pass(const Stores& stores, int shape_a, int shape_b) {
    if (!stores.rules.filter.may_collide) return false;
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
