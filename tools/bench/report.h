// Measurements as JSON lines and as a table.
#pragma once

#include <string>
#include <string_view>

#include "measure.h"

namespace cairn::bench {

struct Spread {
    double min = 0;
    double median = 0;
    double p99 = 0;
};
/// By nearest rank; all 0 for no values.
Spread spread_of(std::vector<double> values);

/// How a scene was run on Cairn.
struct RunSetting {
    int threads = 1;
    std::string simd;
};

/// One line without its end.
std::string run_line(const Scene& scene, const RunSetting& setting, const Measurement& m);
/// `ratio` is the time of the engine to that of Cairn.
std::string compare_line(const Scene& scene, std::string_view engine, const Measurement& m, double ratio);

std::string run_table_head();
std::string run_table_row(const Scene& scene, const Measurement& m);
std::string compare_table_head();
std::string compare_table_row(const Scene& scene, std::string_view engine, const Measurement& m,
                              double ratio);

}  // namespace cairn::bench
