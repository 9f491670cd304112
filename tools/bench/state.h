// What snapshots cost: bytes a body, microseconds to save and to restore, and a rollback.
#pragma once

#include <string>
#include <vector>

namespace cairn::bench {

struct StateFigures {
    std::string scene;
    int bodies = 0;
    int contacts = 0;
    std::size_t bytes = 0;
    std::size_t delta_bytes = 0;  ///< from one step to the next
    // The least of `repeat` rounds.
    double save_us = 0;
    double restore_us = 0;
    double delta_us = 0;
    double step_us = 0;
    double rollback_ms = 0;  ///< back by 8 frames, then 8 steps, each with a snapshot
};

std::vector<StateFigures> measure_state(int repeat);

std::string state_table_head();
std::string state_table_row(const StateFigures& figures);

}  // namespace cairn::bench
