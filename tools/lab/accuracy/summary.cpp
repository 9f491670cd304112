#include "accuracy/summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "text.h"

namespace cairn::lab {
namespace {

using Json = nlohmann::ordered_json;
using measure::format;
using measure::rounded;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<std::string> engines_in(const std::vector<Point>& points) {
    std::vector<std::string> names;
    for (const Point& point : points) {
        const std::string name(point.setting.kind.name);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::vector<const Point*> points_of_engine(const std::vector<Point>& points, const std::string& engine) {
    std::vector<const Point*> own;
    for (const Point& point : points) {
        if (point.setting.kind.name == engine) own.push_back(&point);
    }
    return own;
}

double error_of(const Point& point, std::size_t metric) {
    return point.failed(metric) ? kInfinite : point.errors[metric];
}

// Of time steps, or of substeps as steps of a fraction of the length.
double order_along(const std::vector<const Point*>& points, std::size_t metric, Sweep sweep) {
    std::vector<std::pair<double, double>> pairs;
    for (const Point* point : points) {
        if (point->failed(metric) || (point->sweep != sweep && point->sweep != Sweep::Default)) continue;
        const double x =
            sweep == Sweep::TimeStep ? static_cast<double>(point->setting.dt_s) : 1.0 / point->setting.effort;
        pairs.push_back({x, point->errors[metric]});
    }
    return fitted_order(pairs);
}

double least_time(const std::vector<const Point*>& points, std::size_t metric, double error) {
    double least = kInfinite;
    for (const Point* point : points) {
        if (error_of(*point, metric) <= error) least = std::min(least, point->cpu_s_per_sim_s);
    }
    return least;
}

Json number(double value) {
    return std::isfinite(value) ? Json(rounded(value)) : Json(nullptr);
}

std::string number_text(double value, const char* pattern) {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "never";
    return format("%.*s", 20, format(pattern, value).c_str());
}

}  // namespace

double fitted_order(const std::vector<std::pair<double, double>>& x_and_error) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [x, error] : x_and_error) {
        if (!(error > kEqualError)) continue;
        const double lx = std::log(x), ly = std::log(error);
        n += 1;
        sx += lx;
        sy += ly;
        sxx += lx * lx;
        sxy += lx * ly;
    }
    return n < 3 ? std::numeric_limits<double>::quiet_NaN() : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::vector<Summary> summarize(const std::vector<Point>& points, std::size_t metric) {
    std::vector<Summary> all;
    for (const std::string& engine : engines_in(points)) {
        const std::vector<const Point*> own = points_of_engine(points, engine);
        const auto standard = std::find_if(own.begin(), own.end(),
                                           [](const Point* point) { return point->sweep == Sweep::Default; });
        if (!(*standard)->tells(metric)) continue;
        Summary summary{.engine = engine,
                        .error = error_of(**standard, metric),
                        .cpu_s_per_sim_s = (*standard)->cpu_s_per_sim_s,
                        .order = order_along(own, metric, Sweep::TimeStep),
                        .cpu_to_1_percent_s = least_time(own, metric, 1e-2),
                        .cpu_to_01_percent_s = least_time(own, metric, 1e-3)};
        const Summary& first = all.empty() ? summary : all.front();
        summary.error_in_same_time = all.empty() ? summary.error : kInfinite;
        for (const Point* point : own) {
            if (!all.empty() && point->cpu_s_per_sim_s <= first.cpu_s_per_sim_s) {
                summary.error_in_same_time = std::min(summary.error_in_same_time, error_of(*point, metric));
            }
        }
        summary.ratio =
            std::max(summary.error_in_same_time, kEqualError) / std::max(first.error, kEqualError);
        all.push_back(summary);
    }
    return all;
}

bool first_is_best(const std::vector<Summary>& summaries) {
    return !summaries.empty() && std::isfinite(summaries.front().error) &&
           std::all_of(summaries.begin(), summaries.end(),
                       [](const Summary& summary) { return summary.ratio >= 1; });
}

std::vector<std::string> accuracy_lines(const Problem& problem, std::size_t metric,
                                        const std::vector<Point>& points) {
    std::vector<std::string> lines;
    for (const std::string& engine : engines_in(points)) {
        const std::vector<const Point*> own = points_of_engine(points, engine);
        for (const Point* point : own) {
            if (!point->tells(metric)) continue;
            Json line;
            line["problem"] = problem.name + "/" + problem.metrics[metric].name;
            line["engine"] = engine;
            line["solver"] = "default";
            line["substeps"] = point->setting.effort;
            line["dt_s"] = rounded(static_cast<double>(point->setting.dt_s));
            line["error"] = number(error_of(*point, metric));
            line["error_unit"] = problem.metrics[metric].unit;
            line["cpu_s_per_sim_s"] = number(point->cpu_s_per_sim_s);
            line["cpu_iqr_s"] = number(point->cpu_iqr_s);
            line["order"] = number(
                order_along(own, metric, point->sweep == Sweep::Effort ? Sweep::Effort : Sweep::TimeStep));
            line["failed"] = point->failed(metric);
            if (!point->ended_by.empty()) line["ended_by"] = point->ended_by;
            lines.push_back(line.dump());
        }
    }
    return lines;
}

std::string accuracy_summary_line(const Problem& problem, std::size_t metric, const Summary& summary) {
    Json line;
    line["summary"] = problem.name + "/" + problem.metrics[metric].name;
    line["engine"] = summary.engine;
    line["error_unit"] = problem.metrics[metric].unit;
    line["compared"] = problem.metrics[metric].compared;
    line["error"] = number(summary.error);
    line["cpu_s_per_sim_s"] = number(summary.cpu_s_per_sim_s);
    line["order"] = number(summary.order);
    line["cpu_s_to_1_percent"] = number(summary.cpu_to_1_percent_s);
    line["cpu_s_to_01_percent"] = number(summary.cpu_to_01_percent_s);
    line["error_in_same_time"] = number(summary.error_in_same_time);
    line["ratio"] = number(summary.ratio);
    return line.dump();
}

std::string accuracy_head() {
    return format("%-29s %-10s %10s %9s %6s %10s %10s %12s %9s", "problem/metric", "engine", "error",
                  "CPU us/s", "order", "us to 1 %", "to 0.1 %", "in same time", "ratio");
}

std::string accuracy_row(const Problem& problem, std::size_t metric, const Summary& summary) {
    return format(
        "%-29s %-10s %10s %9s %6s %10s %10s %12s %9s",
        (problem.name + "/" + problem.metrics[metric].name).c_str(), summary.engine.c_str(),
        std::isinf(summary.error) ? "failed" : format("%.2e", summary.error).c_str(),
        number_text(1e6 * summary.cpu_s_per_sim_s, "%.1f").c_str(),
        number_text(summary.order, "%.2f").c_str(),
        number_text(1e6 * summary.cpu_to_1_percent_s, "%.1f").c_str(),
        number_text(1e6 * summary.cpu_to_01_percent_s, "%.1f").c_str(),
        std::isinf(summary.error_in_same_time) ? "none" : format("%.2e", summary.error_in_same_time).c_str(),
        std::isinf(summary.error_in_same_time) ? "-" : number_text(summary.ratio, "%.3g").c_str());
}

Plot accuracy_plot(const Problem& problem, std::size_t metric, const std::vector<Point>& points) {
    static constexpr std::array kColors{"#1f5fbf", "#d9690f", "#3a9a3a", "#8a4fbf"};
    Plot plot{.title = problem.name + ": " + problem.metrics[metric].name,
              .x_label = "CPU seconds per simulated second",
              .y_label = "error, " + problem.metrics[metric].unit};
    std::size_t color = 0;
    for (const std::string& engine : engines_in(points)) {
        const std::vector<const Point*> own = points_of_engine(points, engine);
        const auto series_of = [&](Sweep sweep, const std::string& what, bool dashed) {
            Series series{
                .name = engine + ", " + what, .color = kColors[color % kColors.size()], .dashed = dashed};
            std::vector<const Point*> line;
            std::copy_if(own.begin(), own.end(), std::back_inserter(line), [&](const Point* point) {
                return point->tells(metric) && (point->sweep == sweep || point->sweep == Sweep::Default);
            });
            std::sort(line.begin(), line.end(), [&](const Point* a, const Point* b) {
                return sweep == Sweep::Effort ? a->setting.effort < b->setting.effort
                                              : a->setting.dt_s > b->setting.dt_s;
            });
            for (const Point* point : line) {
                series.points.push_back(
                    {point->cpu_s_per_sim_s, error_of(*point, metric), point->sweep == Sweep::Default});
            }
            if (!series.points.empty()) plot.series.push_back(std::move(series));
        };
        series_of(Sweep::Effort, engine == "cairn" ? "substeps" : "iterations", false);
        series_of(Sweep::TimeStep, "time step", true);
        ++color;
    }
    return plot;
}

}  // namespace cairn::lab
