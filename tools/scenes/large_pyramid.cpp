// 5,050 boxes in one pyramid of 100 rows: one island, all of it awake, nothing moves.
#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;

Scene large_pyramid() {
    return {.name = "large_pyramid",
            .summary = "one pyramid of 5,050 boxes, kept awake",
            .world = {.enable_sleep = false},
            .steps = 500,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                engine.add({.type = BodyType::Static, .position_m = {0, -1}}, Box{100, 1});
                for (int row = 0; row < 100; ++row) {
                    for (int j = row; j < 100; ++j) {
                        const double x = 0.5 * (row + 1) + (j - row) - 50;
                        engine.add({.position_m = {x, row + 0.5}}, Box{0.5f, 0.5f});
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
