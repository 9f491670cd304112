// Sums over shapes, as late as can be.
#include "world/body_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/physics/tuning.h>

#include "base/ample.h"
#include "world/contact_lists.h"
#include "world/edge_list.h"
#include "world/joint_lists.h"

namespace cairn::physics {
namespace {

// Of what is so little that float has no inverse of it, as of nothing: nothing pushes it.
float inverse(float mass) {
    const float result = mass > 0 ? 1 / mass : 0;
    return std::isfinite(result) ? result : 0;
}

template <class Visit>
void for_each_shape(const Stores& stores, int body, Visit&& visit) {
    for (int s = stores.bodies.slots[body].first_shape; s != kNone; s = stores.shapes[s].next_of_body)
        visit(stores.shapes[s]);
}

MassData to_mass_data(const MassSum& sum) {
    if (sum.mass <= 0) return {};
    const double x = sum.moment_x / sum.mass;
    const double y = sum.moment_y / sum.mass;
    const double central = sum.inertia - sum.mass * (x * x + y * y);
    return {static_cast<float>(sum.mass),
            static_cast<float>(central),
            {static_cast<float>(x), static_cast<float>(y)}};
}

// The origin stays where it is, and the velocity of the material at the new centre becomes the body's
// velocity.
void apply(Stores& stores, int body, const MassSum& sum) {
    BodyRecord& record = stores.bodies.slots[body];
    const Transform xf = stores.bodies.transform(body);
    const Vec2 old_center = record.mass.center_m;
    record.mass = to_mass_data(sum);
    record.inverse_mass = inverse(record.mass.mass_kg);
    const bool turns = record.inverse_mass > 0 && !turning_is_locked(record);
    record.inverse_inertia = turns ? inverse(record.mass.inertia_kg_m2) : 0;
    BodyRows& rows = stores.bodies.rows_of(body);
    stores.bodies.places[body].center = transform_point(xf, record.mass.center_m);
    rows.box_slack[record.row] = 0;
    rows.velocity[record.row] += without_locked(
        cross(rows.spin[record.row], rotate(xf.q, record.mass.center_m - old_center)), locked_axes(record));
    stores.masses.entries[body].is_outdated = true;
}

void measure_extent(Stores& stores, int body) {
    BodyRecord& record = stores.bodies.slots[body];
    record.extent_m = record.turn_arm_m = record.center_arm_m = 0;
    record.inner_radius_m = std::numeric_limits<float>::infinity();
    for_each_shape(stores, body, [&](const ShapeRecord& shape) {
        const float farthest = farthest_distance(shape.convex(), record.mass.center_m);
        record.extent_m = std::max(record.extent_m, farthest);
        record.turn_arm_m = std::max(record.turn_arm_m, farthest - shape.convex().radius());
        record.center_arm_m =
            std::max(record.center_arm_m, length(shape.convex().centroid - record.mass.center_m));
        // A line has no inside, but its contacts hold from the speculative distance on. Of a sliver far from
        // its body's origin, rounding may leave nothing.
        const float solid = shape.convex().is_line() ? tuning::kSpeculativeDistance_m
                                                     : std::max(0.0f, inner_radius(shape.convex()));
        record.inner_radius_m = std::min(record.inner_radius_m, solid);
    });
}

}  // namespace

void start_mass(Stores& stores, int body) {
    auto& entries = stores.masses.entries;
    cover_amply(entries, static_cast<std::size_t>(body) + 1);
    // One that was listed for the slot's last body stays listed, and does no harm.
    entries[body] = {.sum = {}, .is_listed = entries[body].is_listed};
}

void add_mass(Stores& stores, int body, const Convex& shape, float density_kg_m2) {
    note_reshaped(stores, body);
    if (stores.bodies.slots[body].type != BodyType::Dynamic) return;
    MassLedger::Entry& entry = stores.masses.entries[body];
    if (entry.lacks_shapes) return;  // the sum will be made anew, with this one
    entry.sum += mass_of(shape, static_cast<double>(density_kg_m2));
    apply(stores, body, entry.sum);
}

void lose_mass(Stores& stores, int body) {
    note_reshaped(stores, body);
    stores.masses.entries[body].lacks_shapes = stores.bodies.slots[body].type == BodyType::Dynamic;
}

void note_reshaped(Stores& stores, int body) {
    MassLedger::Entry& entry = stores.masses.entries[body];
    if (entry.is_listed) return;
    entry.is_listed = true;
    push_amply(stores.masses.reshaped, body);
}

void settle_mass(Stores& stores, int body) {
    MassLedger::Entry& entry = stores.masses.entries[body];
    if (!entry.lacks_shapes) return;
    entry.lacks_shapes = false;
    entry.sum = {};
    for_each_shape(stores, body, [&](const ShapeRecord& shape) {
        entry.sum += mass_of(shape.convex(), static_cast<double>(shape.def().density_kg_m2));
    });
    apply(stores, body, entry.sum);
}

void renew_mass(Stores& stores, int body) {
    note_reshaped(stores, body);
    settle_mass(stores, body);
    apply(stores, body, stores.masses.entries[body].sum);
}

void settle_masses(Stores& stores) {
    for (const int body : stores.masses.reshaped) {
        if (stores.bodies.slots.alive(body)) settle_mass(stores, body);
    }
}

void settle_reshaped(Stores& stores) {
    for (const int body : stores.masses.reshaped) {
        MassLedger::Entry& entry = stores.masses.entries[body];
        entry.is_listed = false;
        if (!stores.bodies.slots.alive(body)) continue;
        settle_mass(stores, body);
        measure_extent(stores, body);
        if (!entry.is_outdated) continue;
        entry.is_outdated = false;
        for_each_edge(stores.contacts.slots, stores.bodies.slots[body].first_contact,
                      [&](int contact, int) { relist_contact(stores, contact); });
        for_each_edge(stores.joints.slots, stores.bodies.slots[body].first_joint,
                      [&](int joint, int) { unseat_joint(stores, joint); });
    }
    stores.masses.reshaped.clear();
}

}  // namespace cairn::physics
