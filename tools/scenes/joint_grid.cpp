// A cloth of 10,000 discs that touch nothing, pinned to their neighbours and hung from seven.
#include <vector>

#include "scene.h"

namespace cairn::bench {

using physics::BodyType;
using physics::Circle;
using physics::ShapeDef;

namespace {

// Of the discs in the top row.
constexpr bool is_hung(int column) {
    return column >= 47 && column <= 53;
}

}  // namespace

Scene joint_grid() {
    return {
        .name = "joint_grid",
        .summary = "100 x 100 discs in one island of 19,794 pins",
        .world = {.enable_sleep = false},
        .steps = 500,
        .for_every_engine = true,
        .build = [](Engine& engine) -> BeforeStep {
            constexpr int kSide = 100;
            const ShapeDef def{.filter = {.categories = 2, .mask = ~std::uint64_t{2}}};
            std::vector<BodyRef> column_before;
            for (int k = 0; k < kSide; ++k) {
                std::vector<BodyRef> column;
                for (int i = 0; i < kSide; ++i) {
                    const bool hung = i == 0 && is_hung(k);
                    const BodyRef disc =
                        engine.add({.type = hung ? BodyType::Static : BodyType::Dynamic,
                                    .position_m = {static_cast<double>(k), -static_cast<double>(i)}},
                                   Circle{{}, 0.4f}, def);
                    if (i > 0) {
                        engine.add_revolute(column.back(), disc,
                                            {.local_anchor_a_m = {0, -0.5f}, .local_anchor_b_m = {0, 0.5f}});
                    }
                    if (k > 0 && !(hung && is_hung(k - 1))) {  // no pin between two that cannot move
                        engine.add_revolute(column_before[static_cast<std::size_t>(i)], disc,
                                            {.local_anchor_a_m = {0.5f, 0}, .local_anchor_b_m = {-0.5f, 0}});
                    }
                    column.push_back(disc);
                }
                column_before = std::move(column);
            }
            return {};
        }};
}

}  // namespace cairn::bench
