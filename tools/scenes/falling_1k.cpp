// 1,000 circles, capsules and boxes fall into a pit and pile up; none may sleep.
#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Capsule;
using physics::Circle;
using physics::Geometry;

Scene falling_1k() {
    return {.name = "falling_1k",
            .summary = "1,000 circles, capsules and boxes fall into a pit, kept awake",
            .world = {.enable_sleep = false},
            .steps = 600,
            .build = [](Engine& engine) -> BeforeStep {
                engine.add({.type = BodyType::Static, .position_m = {0, -1}}, Box{30, 1});
                engine.add({.type = BodyType::Static, .position_m = {-21, 20}}, Box{1, 20});
                engine.add({.type = BodyType::Static, .position_m = {21, 20}}, Box{1, 20});
                const Geometry kinds[] = {Circle{{}, 0.3f}, Capsule{{-0.2f, 0}, {0.2f, 0}, 0.2f},
                                          Box{0.3f, 0.25f}};
                for (int i = 0; i < 1000; ++i) {
                    // Rows that lean a little, so that nothing lands exactly on top of what is below.
                    const int row = i / 40;
                    const double x = (i % 40) - 19.5 + 0.07 * (row % 5 - 2);
                    engine.add({.position_m = {x, 1.0 + row}, .angle_rad = 0.1 * (i % 7)}, kinds[i % 3],
                               {.material = {.restitution = 0.1f}});
                }
                return {};
            }};
}

}  // namespace cairn::bench
