// 400 pyramids of 55 boxes on 20 floors: many islands of a middling size, all awake.
#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Segment;

Scene many_pyramids() {
    return {.name = "many_pyramids",
            .summary = "400 pyramids of 55 boxes on 20 floors, kept awake",
            .world = {.enable_sleep = false},
            .steps = 200,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                constexpr int kFloors = 20;
                constexpr int kColumns = 20;
                constexpr int kBase = 10;
                const BodyRef ground = engine.add_body({.type = BodyType::Static});
                for (int floor = 0; floor < kFloors; ++floor) {
                    const float y = 11.0f * static_cast<float>(floor);
                    engine.add_shape(ground, Segment{{-110, y}, {110, y}}, {});
                }
                for (int floor = 0; floor < kFloors; ++floor) {
                    for (int column = 0; column < kColumns; ++column) {
                        for (int row = 0; row < kBase; ++row) {
                            for (int j = row; j < kBase; ++j) {
                                const double x = 0.5 * (row + 1) + (j - row) - 109.5 + 11 * column;
                                engine.add({.position_m = {x, row + 0.5 + 11 * floor}}, Box{0.5f, 0.5f});
                            }
                        }
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
