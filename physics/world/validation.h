// The rules for what comes from outside: definitions, numbers, handles.
#pragma once

#include "base/check.h"
#include "world/world_state.h"

namespace cairn::physics {

check::Fault validate(const WorldDef& def);
check::Fault validate(const BodyDef& def);
check::Fault validate(const ShapeDef& def);
check::Fault validate(const Material& material);
check::Fault validate(const MaterialRule& rule);
check::Fault validate_material_kinds(int kind_a, int kind_b);
check::Fault validate_step(float dt_s);

/// While a step runs, only what the host was asked could call: it must not change the world.
check::Fault refuse_within_step(const WorldState& world);

/// Says why a handle names nothing: null, of another world, or destroyed.
Error bad_handle(const char* kind, std::uint64_t index1, std::uint64_t world, std::uint64_t own_world);

/// The slot of a handle, or the error.
template <class Slots, class Id>
Result<int> find_slot(const Slots& slots, Id id, const char* kind, std::uint64_t own_world) {
    const int index = slots.find(id);
    if (index != kNone) return index;
    return bad_handle(kind, id.index1, id.world, own_world);
}

}  // namespace cairn::physics
