// What a sweep says of an engine in a few numbers, and how it is printed and drawn.
#pragma once

#include <string>
#include <vector>

#include "accuracy/sweep.h"
#include "plot/log_log_plot.h"

namespace cairn::lab {

/// Errors below this are those of single precision, and count as equal.
inline constexpr double kEqualError = 1e-6;

/// One metric, one engine.
struct Summary {
    std::string engine;
    double error = kNotTold;     ///< at the default setting
    double cpu_s_per_sim_s = 0;  ///< there
    double order = 0;  ///< p of error ~ dt^p over the steps; not a number when errors are too small to tell
    // The least CPU time that reaches 1 % and 0.1 %; infinite when no setting does.
    double cpu_to_1_percent_s = 0;
    double cpu_to_01_percent_s = 0;
    /// The least error within the CPU time of the first engine's default setting; infinite when no setting is
    /// that fast.
    double error_in_same_time = 0;
    /// That over the first engine's error at its default, errors below kEqualError taken as that: above 1,
    /// the first engine is better.
    double ratio = 1;
};

/// Of the engines in their order, the first being the one that the others are compared with. Engines that
/// cannot tell the metric are left out.
std::vector<Summary> summarize(const std::vector<Point>& points, std::size_t metric);

/// Whether the first engine's default is at least as accurate as all others in the same time.
bool first_is_best(const std::vector<Summary>& summaries);

/// Slope of log(error) over log(x) by least squares, from pairs of x and error; of fewer than three pairs
/// with errors above kEqualError, not a number.
double fitted_order(const std::vector<std::pair<double, double>>& x_and_error);

/// {"problem", "engine", "solver", "substeps", "dt_s", "error", "error_unit", "cpu_s_per_sim_s", "cpu_iqr_s",
/// "order", "failed"}, one line for each point; null is no finite number.
std::vector<std::string> accuracy_lines(const Problem& problem, std::size_t metric,
                                        const std::vector<Point>& points);
/// {"summary", "engine", "error_unit", "compared", "error", "cpu_s_per_sim_s", "order", "cpu_s_to_1_percent",
/// "cpu_s_to_01_percent", "error_in_same_time", "ratio"}; null is no finite number.
std::string accuracy_summary_line(const Problem& problem, std::size_t metric, const Summary& summary);
std::string accuracy_head();
std::string accuracy_row(const Problem& problem, std::size_t metric, const Summary& summary);

/// Error over CPU time: a line along the efforts and one along the time steps for each engine.
Plot accuracy_plot(const Problem& problem, std::size_t metric, const std::vector<Point>& points);

}  // namespace cairn::lab
