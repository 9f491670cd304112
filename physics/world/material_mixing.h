// What becomes of two materials where they meet.
// Invariant: a contact's friction and restitution are those of the materials and rules as they are now.
#pragma once

#include <vector>

#include <cairn/physics/rules.h>
#include <cairn/physics/shape.h>

namespace cairn::physics {

struct ContactRecord;
struct Stores;

/// The rules that the host gave, for unordered pairs of kinds: a triangle, as large as the highest kind
/// named.
class MixingTable {
  public:
    void set(int kind_a, int kind_b, const MaterialRule& rule);
    /// The rule given, or the one that holds where none was.
    [[nodiscard]] MaterialRule rule(int kind_a, int kind_b) const;

  private:
    friend struct StateAccess;

    std::vector<MaterialRule> rules_;
};

float mix(const MixRule& rule, float a, float b);

/// What the few contacts have that roll with resistance or whose surfaces run.
struct SurfaceEffects {
    float rolling_m = 0;  // torque that resists rolling, per normal force
    float speed_m_s = 0;  // of b's surface past a's, along the tangent, that friction brings about
};

/// Asked for contacts with special::kSurface.
SurfaceEffects surface_effects(const Stores& stores, const ContactRecord& contact);

/// Gives the contact the mixed values, and special::kSurface if it needs it.
void mix_materials(const Stores& stores, ContactRecord& contact);

/// Mixes anew: contacts of a shape whose material has changed, or of two kinds whose rule has. Where that
/// makes a difference to bodies that touch, they wake.
void remix_contacts_of_shape(Stores& stores, int shape);
void remix_contacts_of_kinds(Stores& stores, int kind_a, int kind_b);

}  // namespace cairn::physics
