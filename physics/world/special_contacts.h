// What sets a few contacts apart from all others: one byte in the record, 0 for nearly all, so that ordinary
// contacts pay nothing for it.
#pragma once

#include <cstdint>

#include "world/world_state.h"

namespace cairn::physics {

namespace special {

inline constexpr std::uint8_t kRefused = 1;   // the host's filter said no: never gets points
inline constexpr std::uint8_t kSurface = 2;   // rolling resistance or a running surface
inline constexpr std::uint8_t kOneWay = 4;    // one of the shapes is solid from one side only
inline constexpr std::uint8_t kPassing = 8;   // of those: the pair goes through each other, until it parts
inline constexpr std::uint8_t kSolid = 16;    // of those: it is a contact like others, until it parts
inline constexpr std::uint8_t kWatched = 32;  // one of the bodies is breakable: its impulse is wanted
inline constexpr std::uint8_t kTiny = 64;     // world/tiny_contacts.h

inline void set(ContactRecord& contact, std::uint8_t bit, bool on) {
    contact.special = static_cast<std::uint8_t>(on ? contact.special | bit : contact.special & ~bit);
}
inline bool has(const ContactRecord& contact, std::uint8_t bit) {
    return (contact.special & bit) != 0;
}

}  // namespace special

/// Whether no lane takes the contact, whatever its bodies: it needs what lanes have not, or it is not known
/// yet whether it acts at all.
inline bool is_loose(const ContactRecord& contact) {
    const std::uint8_t undecided = special::kOneWay | special::kSolid;
    return special::has(contact, special::kRefused | special::kSurface | special::kTiny) ||
           (contact.special & undecided) == special::kOneWay;
}

/// For a new contact of these shapes: what the host says of it, and what sets the shapes and bodies apart.
std::uint8_t special_bits(const Stores& stores, int shape_a, int shape_b);

/// Whether two shapes that may collide are let through each other all the same. Costs a look at the shapes
/// unless something of the kind is in use.
bool lets_pass(const Stores& stores, int shape_a, int shape_b);

}  // namespace cairn::physics
