// Mixing of materials.
#include "world/material_mixing.h"

#include <algorithm>
#include <cmath>

#include "world/contact_lists.h"
#include "world/sleep.h"
#include "world/special_contacts.h"
#include "world/surface_speed.h"

namespace cairn::physics {
namespace {

std::size_t place_of(int kind_a, int kind_b) {
    const auto [low, high] = std::minmax(kind_a, kind_b);
    return static_cast<std::size_t>(high * (high + 1) / 2 + low);
}

Material material_of(const Stores& stores, int shape) {
    return stores.shapes[shape].def().material;
}

void remix(Stores& stores, int contact) {
    ContactRecord& c = stores.contacts.slots[contact];
    const ContactRecord before = c;
    mix_materials(stores, c);
    // A surface may run at another speed now, which stands in the materials alone.
    const bool changed = c.friction != before.friction || c.restitution != before.restitution ||
                         ((c.special | before.special) & special::kSurface) != 0;
    if (!changed) return;
    relist_contact(stores, contact);
    if (!c.has_points) return;
    const int body_a = c.body_a;
    const int body_b = c.body_b;
    wake_body(stores, body_a);
    wake_body(stores, body_b);
}

}  // namespace

void MixingTable::set(int kind_a, int kind_b, const MaterialRule& rule) {
    const int highest = std::max(kind_a, kind_b);
    const std::size_t needed = place_of(highest, highest) + 1;
    if (rules_.size() < needed) rules_.resize(needed);
    rules_[place_of(kind_a, kind_b)] = rule;
}

MaterialRule MixingTable::rule(int kind_a, int kind_b) const {
    const std::size_t place = place_of(kind_a, kind_b);
    return place < rules_.size() ? rules_[place] : MaterialRule{};
}

float mix(const MixRule& rule, float a, float b) {
    switch (rule.mixing) {
        case Mixing::GeometricMean:
            return std::sqrt(a * b);
        case Mixing::Average:
            return 0.5f * (a + b);
        case Mixing::Minimum:
            return std::min(a, b);
        case Mixing::Maximum:
            return std::max(a, b);
        case Mixing::Multiply:
            return a * b;
        case Mixing::Fixed:
            return rule.fixed;
    }
    return rule.fixed;
}

// Rolling: the stiffer resistance acts, and of the two roundings the wider one is what rolls.
SurfaceEffects surface_effects(const Stores& stores, const ContactRecord& contact) {
    const Material a = material_of(stores, contact.shape_a);
    const Material b = material_of(stores, contact.shape_b);
    const float radius = std::max(stores.shapes[contact.shape_a].convex().radius(),
                                  stores.shapes[contact.shape_b].convex().radius());
    return {std::max(a.rolling_resistance, b.rolling_resistance) * radius, mixed_surface_speed(a, b)};
}

void mix_materials(const Stores& stores, ContactRecord& contact) {
    const Material a = material_of(stores, contact.shape_a);
    const Material b = material_of(stores, contact.shape_b);
    const MaterialRule rule = stores.rules.mixing.rule(a.kind, b.kind);
    contact.friction = mix(rule.friction, a.friction, b.friction);
    contact.restitution = mix(rule.restitution, a.restitution, b.restitution);
    const bool surface = a.rolling_resistance > 0 || b.rolling_resistance > 0 || runs(a) || runs(b);
    special::set(contact, special::kSurface, surface);
}

void remix_contacts_of_shape(Stores& stores, int shape) {
    for_each_edge(stores.contacts.slots, stores.bodies.slots[stores.shapes[shape].body].first_contact,
                  [&](int contact, int) {
                      const ContactRecord& c = stores.contacts.slots[contact];
                      if (c.shape_a == shape || c.shape_b == shape) remix(stores, contact);
                  });
}

void remix_contacts_of_kinds(Stores& stores, int kind_a, int kind_b) {
    for (int contact = 0; contact < stores.contacts.slots.end_index(); ++contact) {
        if (!stores.contacts.slots.alive(contact)) continue;
        const ContactRecord& c = stores.contacts.slots[contact];
        const int a = material_of(stores, c.shape_a).kind;
        const int b = material_of(stores, c.shape_b).kind;
        if ((a == kind_a && b == kind_b) || (a == kind_b && b == kind_a)) remix(stores, contact);
    }
}

}  // namespace cairn::physics
