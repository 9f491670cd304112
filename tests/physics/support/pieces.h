// What bodies amount to together, and whether they overlap: the oracles for cutting and breaking.
#pragma once

#include <catch2/catch.hpp>
#include <span>
#include <vector>

#include "collide/mass.h"
#include "physics/support/making.h"
#include "world/world_state.h"

namespace cairn::physics::test {

/// Sums over bodies, about the origin of the world.
struct Totals {
    double mass = 0;
    double momentum_x = 0;
    double momentum_y = 0;
    double angular_momentum = 0;
    double kinetic_energy = 0;
    double center_x = 0;  // times mass
    double center_y = 0;
};

inline Totals totals(World& world, std::span<const BodyId> bodies) {
    Totals t;
    for (const BodyId id : bodies) {
        const Body body = *world.body(id);
        const auto m = static_cast<double>(body.mass());
        const auto x = static_cast<double>(body.linear_velocity().x);
        const auto y = static_cast<double>(body.linear_velocity().y);
        const Position c = body.world_center();
        t.mass += m;
        t.momentum_x += m * x;
        t.momentum_y += m * y;
        t.angular_momentum += m * (c.x * y - c.y * x) + static_cast<double>(body.mass_data().inertia_kg_m2) *
                                                            static_cast<double>(body.angular_velocity());
        t.kinetic_energy += kinetic_energy(body);
        t.center_x += m * c.x;
        t.center_y += m * c.y;
    }
    return t;
}

/// Equal to what float can tell, of bodies not faster than about `speed_m_s` and within `reach_m` of the
/// origin.
inline void require_conserved(const Totals& before, const Totals& after, double speed_m_s, double reach_m) {
    const double margin = 2e-6 * before.mass;
    REQUIRE(after.mass == Approx(before.mass).epsilon(1e-6));
    REQUIRE(after.momentum_x == Approx(before.momentum_x).margin(margin * speed_m_s));
    REQUIRE(after.momentum_y == Approx(before.momentum_y).margin(margin * speed_m_s));
    REQUIRE(after.angular_momentum == Approx(before.angular_momentum).margin(margin * speed_m_s * reach_m));
    REQUIRE(after.center_x == Approx(before.center_x).margin(margin * reach_m));
    REQUIRE(after.center_y == Approx(before.center_y).margin(margin * reach_m));
}

inline double area_of_shape(World& world, ShapeId id) {
    const Outline& outline = world.shape(id)->outline();
    double twice = 0;
    for (int i = 2; i < outline.count; ++i) {
        twice +=
            static_cast<double>(cross(outline.points_m[static_cast<std::size_t>(i) - 1] - outline.points_m[0],
                                      outline.points_m[static_cast<std::size_t>(i)] - outline.points_m[0]));
    }
    return twice / 2;
}

/// Of sharp polygons.
inline double area_of(World& world, std::span<const BodyId> bodies) {
    double sum = 0;
    for (const BodyId id : bodies) {
        for (const ShapeId shape : world.body(id)->shapes()) sum += area_of_shape(world, shape);
    }
    return sum;
}

}  // namespace cairn::physics::test
