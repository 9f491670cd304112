// Contacts of bodies that are smaller than the lengths with which contacts reckon: the slop, the reach. They
// are solved as if all were larger by a power of two, which changes no rounding: collision sees both shapes
// in that unit, the solver has its slop in it, and gravity asks for as many substeps as it does of that slop.
// Invariant: what is not tiny has the unit 1, to the bit; tiny contacts are always loose (is_loose), so that
// lanes know nothing of them.
#pragma once

#include <cairn/physics/tuning.h>

#include "collide/manifold.h"
#include "world/special_contacts.h"

namespace cairn::physics {

/// m. What fits into a disc of this radius is tiny. Larger: more is solved one by one; smaller: bodies as
/// small as the slop melt into each other.
inline constexpr float kTinyExtent_m = tuning::kLinearSlop_m;

/// The unit, in m, of lengths that are told in metres: 1 or, for what is tiny, such a power of two that the
/// extent is from 25 to 50 mm.
inline float length_unit(float extent_m) {
    float unit = 1;
    if (extent_m >= kTinyExtent_m) return unit;
    constexpr float kLeastUnit = 0x1p-20f;
    while (extent_m < 5 * tuning::kLinearSlop_m * unit && unit > kLeastUnit) unit *= 0.5f;
    return unit;
}

/// Radius of the disc about its centroid that a shape fits into, m.
inline float extent_of(const Convex& shape) {
    return farthest_distance(shape, shape.centroid);
}

/// Of the smaller of the two shapes.
inline float length_unit(const Stores& stores, const ContactRecord& c) {
    if (!special::has(c, special::kTiny)) return 1;
    return length_unit(
        std::min(extent_of(stores.shapes[c.shape_a].convex()), extent_of(stores.shapes[c.shape_b].convex())));
}

/// The manifold of two shapes, seen in such a unit.
Manifold collide_in_unit(const Convex& a, const Convex& b, const RelativePose& b_in_a, float unit);

/// The least unit of all contacts that are listed. Free where there are no tiny ones.
float least_unit(const Stores& stores);

}  // namespace cairn::physics
