// The public explosions and wind: checks what comes from outside, then applies what they come to.
#include <cairn/physics/world.h>

#include "world/surface_forces.h"
#include "world/validation.h"

namespace cairn::physics {
Result<void> World::explode(const ExplosionDef& def) {
    if (auto fault = check::first_of({refuse_within_step(*state_), validate(def)})) return *fault;
    settle_reshaped(state_->stores);
    for (const SurfaceForce& impulse : explosion_impulses(state_->stores, def)) {
        Body met = body(impulse.body).value();
        if (auto done = met.apply_impulse_to_center(impulse.linear); !done) return done;
        if (auto done = met.apply_angular_impulse(impulse.angular); !done) return done;
    }
    return {};
}

Result<void> World::apply_wind(const WindDef& def, float dt_s) {
    if (auto fault = check::first_of({refuse_within_step(*state_), validate(def), validate_step(dt_s)}))
        return *fault;
    settle_reshaped(state_->stores);
    // Into the rows, and not by Body::apply_force, which would keep awake what a breeze cannot move.
    BodyRows& awake = state_->stores.bodies.rows(RowSet::Awake);
    for (int row = 0; row < awake.size(); ++row) {
        if (state_->stores.bodies.slots[awake.body[row]].type != BodyType::Dynamic) continue;
        const SurfaceForce force = wind_force(state_->stores, awake.body[row], def, dt_s);
        awake.force[row] += force.linear;
        awake.torque[row] += force.angular;
    }
    return {};
}

Result<void> World::apply_wind(BodyId id, const WindDef& def, float dt_s) {
    if (auto fault = check::first_of({refuse_within_step(*state_), validate(def), validate_step(dt_s)}))
        return *fault;
    const Result<Body> found = body(id);
    if (!found) return found.error();
    if (found->type() != BodyType::Dynamic) return {};
    Body met = *found;
    const SurfaceForce force = wind_force(state_->stores, state_->stores.bodies.slots.find(id), def, dt_s);
    if (auto done = met.apply_force_to_center(force.linear); !done) return done;
    return met.apply_torque(force.angular);
}

}  // namespace cairn::physics
