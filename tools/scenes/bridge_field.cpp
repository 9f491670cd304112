// 50 bridges of 40 planks, each with twenty boxes that fall on it.
#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;

namespace {

constexpr int kBridgesAcross = 5;
constexpr int kBridgesUp = 10;
constexpr int kPlanks = 40;
constexpr int kLoads = 20;

void add_bridge(Engine& engine, double x_m, double y_m) {
    const BodyRef banks = engine.add_body({.type = BodyType::Static, .position_m = {x_m, y_m}});
    engine.add_shape(banks, Box{1, 0.25f, {-1, 0}}, {});
    engine.add_shape(banks, Box{1, 0.25f, {kPlanks + 1, 0}}, {});
    BodyRef last = banks;
    float anchor_m = 0;
    for (int i = 0; i < kPlanks; ++i) {
        const BodyRef plank = engine.add({.position_m = {x_m + i + 0.5, y_m}}, Box{0.5f, 0.125f},
                                         {.density_kg_m2 = 4, .material = {.friction = 0.8f}});
        engine.add_revolute(last, plank, {.local_anchor_a_m = {anchor_m, 0}, .local_anchor_b_m = {-0.5f, 0}});
        last = plank;
        anchor_m = 0.5f;
    }
    engine.add_revolute(
        last, banks, {.local_anchor_a_m = {0.5f, 0}, .local_anchor_b_m = {static_cast<float>(kPlanks), 0}});
    for (int i = 0; i < kLoads; ++i) {
        engine.add({.position_m = {x_m + 5 + 3.0 * (i % 10), y_m + 2 + 1.5 * (i / 10)}}, Box{0.4f, 0.4f},
                   {.density_kg_m2 = 2});
    }
}

}  // namespace

Scene bridge_field() {
    return {.name = "bridge_field",
            .summary = "50 bridges of 40 planks, twenty boxes fall on each",
            .steps = 600,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                for (int up = 0; up < kBridgesUp; ++up) {
                    for (int across = 0; across < kBridgesAcross; ++across) {
                        add_bridge(engine, 50.0 * across, 30.0 * up);
                    }
                }
                return {};
            }};
}

}  // namespace cairn::bench
