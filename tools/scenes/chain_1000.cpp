// A chain of 1,000 links hangs from one end, and bears 10,000 times the mass of a link at the other.
#include <numbers>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Box;
using physics::Circle;
using physics::ShapeDef;

Scene chain_1000() {
    return {.name = "chain_1000",
            .summary = "1,000 links bear a ball of 10,000 times the mass of one",
            .world = {.enable_sleep = false},
            .steps = 600,
            .for_every_engine = true,
            .build = [](Engine& engine) -> BeforeStep {
                constexpr int kLinks = 1000;
                constexpr float kHalfWidth_m = 0.05f;
                constexpr float kHalfLength_m = 0.25f;
                constexpr float kRadius_m = 2;
                const ShapeDef link{.filter = {.categories = 2, .mask = ~std::uint64_t{2}}};
                ShapeDef ball = link;
                ball.density_kg_m2 = 1e4f * (4 * kHalfWidth_m * kHalfLength_m) /
                                     (std::numbers::pi_v<float> * kRadius_m * kRadius_m);
                BodyRef last = engine.add_body({.type = BodyType::Static});
                float anchor_y_m = 0;
                for (int i = 0; i < kLinks; ++i) {
                    const BodyRef body =
                        engine.add({.position_m = {0, -static_cast<double>(kHalfLength_m) * (2 * i + 1)}},
                                   Box{kHalfWidth_m, kHalfLength_m}, link);
                    engine.add_revolute(
                        last, body,
                        {.local_anchor_a_m = {0, anchor_y_m}, .local_anchor_b_m = {0, kHalfLength_m}});
                    last = body;
                    anchor_y_m = -kHalfLength_m;
                }
                const double end_m = -2.0 * kLinks * static_cast<double>(kHalfLength_m);
                const BodyRef weight = engine.add({.position_m = {0, end_m - static_cast<double>(kRadius_m)}},
                                                  Circle{{}, kRadius_m}, ball);
                engine.add_revolute(
                    last, weight, {.local_anchor_a_m = {0, anchor_y_m}, .local_anchor_b_m = {0, kRadius_m}});
                return {};
            }};
}

}  // namespace cairn::bench
