// 200 ragdolls fall into a trough and lie on each other.
#include "ragdoll.h"
#include "scene.h"
#include "trough.h"

namespace cairn::bench {

Scene ragdoll_pile_200() {
    return {.name = "ragdoll_pile_200",
            .summary = "200 ragdolls fall into a trough of 10 m, on each other",
            .steps = 600,
            .build = [](Engine& engine) -> BeforeStep {
                add_trough(engine, 6, 20);
                for (int i = 0; i < 200; ++i) {
                    // Rows lean to and fro, so that nobody stands on a head.
                    const int row = i / 8;
                    add_ragdoll(engine, {-4.2 + 1.2 * (i % 8) + 0.3 * (row % 3 - 1), 1.0 + 2.2 * row}, i + 1);
                }
                return {};
            }};
}

}  // namespace cairn::bench
