// Questions about special contacts.
#include "world/special_contacts.h"

#include <algorithm>

#include "world/breakables.h"
#include "world/filtering.h"
#include "world/one_way.h"
#include "world/tiny_contacts.h"

namespace cairn::physics {

std::uint8_t special_bits(const Stores& stores, int shape_a, int shape_b) {
    const ShapeRecord& a = stores.shapes[shape_a];
    const ShapeRecord& b = stores.shapes[shape_b];
    unsigned bits = host_allows(stores, shape_a, shape_b) ? 0 : special::kRefused;
    if (is_breakable(stores, a.body) || is_breakable(stores, b.body)) bits |= special::kWatched;
    if (is_one_way(a) || is_one_way(b)) bits |= special::kOneWay;
    if (std::min(a.prototype->reach_m, b.prototype->reach_m) < kTinyExtent_m) bits |= special::kTiny;
    return static_cast<std::uint8_t>(bits);
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
