// Mass, centre of mass and extent of bodies, from their shapes.
// Invariant: adding a shape costs the same however many the body has; taking shapes away only marks the body,
// and all its shapes are summed once, when somebody asks or the next step begins.
#pragma once

#include <cstdint>
#include <vector>

#include "collide/convex.h"
#include "collide/mass.h"

namespace cairn::physics {

struct Stores;

/// What is known of each body's shapes together, by slot of the body.
struct MassLedger {
    struct Entry {
        MassSum sum;
        bool is_listed = false;     // in `reshaped`
        bool is_outdated = false;   // lanes of contacts still have the old mass and centre
        bool lacks_shapes = false;  // the sum still holds shapes that are gone
    };
    std::vector<Entry> entries;
    std::vector<int> reshaped;  // bodies whose shapes changed since the last step
};

/// For a new body in the slot.
void start_mass(Stores& stores, int body);
/// The body got this shape.
void add_mass(Stores& stores, int body, const Convex& shape, float density_kg_m2);
/// The body lost a shape.
void lose_mass(Stores& stores, int body);
/// The extent of the body changed, but its mass did not.
void note_reshaped(Stores& stores, int body);

/// Makes mass and centre true; the extent may still wait.
void settle_mass(Stores& stores, int body);
/// The same, when something else changed that the mass depends on.
void renew_mass(Stores& stores, int body);
/// The same for all bodies.
void settle_masses(Stores& stores);
/// Stage, before anything asks for extents: what all changed bodies weigh and how far they reach. Contacts of
/// those whose mass changed start again from the near ones.
void settle_reshaped(Stores& stores);

}  // namespace cairn::physics
