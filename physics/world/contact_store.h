// Contacts: pairs of shapes whose fat boxes overlap, with what they remember from step to step.
// Invariant: a pair has at most one contact; shape_a < shape_b; a contact is in `active` exactly when one of
// its bodies is awake; it is in the lists of both bodies.
#pragma once

#include <array>
#include <cstdint>

#include <cairn/physics/ids.h>

#include "base/slot_map.h"
#include "world/active_list.h"
#include "world/edge_list.h"

namespace cairn::physics {

struct ContactPoint {
    Vec2 r_a;  // from the bodies' centres of mass, in world axes, m
    Vec2 r_b;
    float separation = 0;
    std::uint16_t id = 0;
    bool is_new = false;       // this step
    float normal_impulse = 0;  // of one substep, N s
    float static_impulse = 0;  // what it would be at rest, by estimate
};

struct ContactRecord {
    int shape_a = kNone;
    int shape_b = kNone;
    int body_a = kNone;
    int body_b = kNone;
    Edges edges;
    int active_index = kNone;
    Vec2 normal;  // world axes, from a to b
    int count = 0;
    std::array<ContactPoint, 2> points{};
    float radius_a = 0;  // by which the shapes are rounded
    float radius_b = 0;
    float friction_impulse = 0;  // of the whole manifold
    float friction = 0;
    float restitution = 0;
    bool touching = false;
    bool reports_touch = false;
    bool reports_hit = false;
    std::uint8_t special = 0;  // bits of world/special_contacts.h
};

struct ContactStore {
    explicit ContactStore(std::uint16_t world_tag) : slots(world_tag) {}

    SlotMap<ContactRecord, Handle<struct ContactTag>> slots;
    ActiveList active;
};

}  // namespace cairn::physics
