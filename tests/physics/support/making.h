// Short forms for what nearly every test of a world does.
#pragma once

#include <array>
#include <cmath>

#include <cairn/physics/world.h>

namespace cairn::physics::test {

inline constexpr float kStep_s = 1.0f / 60;

/// A body with one shape.
inline BodyId add(World& world, const BodyDef& body, const Geometry& geometry, const ShapeDef& shape = {}) {
    const BodyId id = world.create_body(body).value();
    world.create_shape(id, geometry, shape).value();
    return id;
}

/// Static, 200 m wide; its top is y = 0.
inline BodyId add_ground(World& world, const ShapeDef& shape = {}) {
    return add(world, {.type = BodyType::Static, .position_m = {0, -1}},
               Box{.half_width_m = 100, .half_height_m = 1}, shape);
}

inline void step_times(World& world, int count, float dt_s = kStep_s) {
    for (int i = 0; i < count; ++i) world.step(dt_s).value();
}

inline void run_for(World& world, double time_s, float dt_s = kStep_s) {
    step_times(world, static_cast<int>(std::lround(time_s / static_cast<double>(dt_s))), dt_s);
}

/// All counts, to be compared and printed as one.
inline std::array<int, 6> listed(const Counts& c) {
    return {c.bodies, c.awake_bodies, c.shapes, c.joints, c.contacts, c.touching};
}

inline double kinetic_energy(const Body& body) {
    const MassData mass = body.mass_data();
    const auto w = static_cast<double>(body.angular_velocity());
    return 0.5 * static_cast<double>(mass.mass_kg) *
               static_cast<double>(length_squared(body.linear_velocity())) +
           0.5 * static_cast<double>(mass.inertia_kg_m2) * w * w;
}

}  // namespace cairn::physics::test
