// A hollow square turns by a motor, with 2,025 small boxes inside.
#include <numbers>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::ShapeDef;

Scene tumbler() {
    return {.name = "tumbler",
            .summary = "2,025 boxes in a hollow square that a motor turns",
            .steps = 750,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                const BodyRef ground = engine.add_body({.type = BodyType::Static});
                const BodyRef drum = engine.add_body({.position_m = {0, 10}});
                const ShapeDef heavy{.density_kg_m2 = 50};
                engine.add_shape(drum, Box{0.5f, 10, {10, 0}}, heavy);
                engine.add_shape(drum, Box{0.5f, 10, {-10, 0}}, heavy);
                engine.add_shape(drum, Box{10, 0.5f, {0, 10}}, heavy);
                engine.add_shape(drum, Box{10, 0.5f, {0, -10}}, heavy);
                engine.add_revolute(ground, drum,
                                    {.local_anchor_a_m = {0, 10},
                                     .enable_motor = true,
                                     .motor_speed_rad_s = 25 * std::numbers::pi_v<float> / 180,
                                     .max_motor_torque_nm = 1e8f});
                for (int row = 0; row < 45; ++row) {
                    for (int column = 0; column < 45; ++column) {
                        engine.add({.position_m = {-9 + 0.4 * column, 1 + 0.4 * row}}, Box{0.125f, 0.125f});
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
