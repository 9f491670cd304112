// A heavy block ploughs, without gravity, into a wall of 9,600 sleeping boxes that touch.
#include "scene.h"

namespace cairn::bench {

using physics::Box;

Scene smash() {
    return {.name = "smash",
            .summary = "a block at 40 m/s meets 9,600 sleeping boxes, without gravity",
            .world = {.gravity_m_s2 = {}},
            .steps = 300,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                engine.add({.position_m = {-20, 0}, .linear_velocity_m_s = {40, 0}}, Box{4, 4},
                           {.density_kg_m2 = 8});
                for (int column = 0; column < 120; ++column) {
                    for (int row = 0; row < 80; ++row) {
                        engine.add({.position_m = {30 + 0.4 * column, 0.4 * (row - 40)}, .awake = false},
                                   Box{0.2f, 0.2f});
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
