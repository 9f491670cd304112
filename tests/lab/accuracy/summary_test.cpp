// Points to numbers: on points that are made up.
#include "accuracy/summary.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace cairn::lab {
namespace {

const EngineKind kOurs{"ours", nullptr, 4};
const EngineKind kTheirs{"theirs", nullptr, 8};
const Problem kProblem{
    .number = 1, .name = "made_up", .metrics = {{"height", "of the height"}, {"force", "N"}}};

Point point(const EngineKind& kind, int effort, float rate_hz, Sweep sweep, double error, double cpu_s) {
    Point made{.setting = {kind, effort, 1 / rate_hz}, .sweep = sweep, .errors = {error, kNotTold}};
    made.cpu_s_per_sim_s = cpu_s;
    return made;
}

// Ours is of second order; theirs is faster and coarser, and fails where it is cheapest.
std::vector<Point> points() {
    std::vector<Point> all{
        point(kOurs, 1, 60, Sweep::Effort, 0.2, 1e-5),
        point(kOurs, 4, 60, Sweep::Default, 4e-3, 4e-5),
        point(kOurs, 4, 30, Sweep::TimeStep, 1.6e-2, 2e-5),
        point(kOurs, 4, 120, Sweep::TimeStep, 1e-3, 8e-5),
        point(kTheirs, 1, 60, Sweep::Effort, 0.5, 1e-5),
        point(kTheirs, 8, 60, Sweep::Default, 0.1, 2e-5),
        point(kTheirs, 8, 120, Sweep::TimeStep, 0.04, 4e-5),
        point(kTheirs, 8, 240, Sweep::TimeStep, 0.009, 9e-5),
    };
    all[4].errors.clear();
    all[4].ended_by = "signal: Aborted";
    return all;
}

}  // namespace

TEST_CASE("the order is the slope of the error over the step") {
    CHECK(fitted_order({{0.1, 3e-2}, {0.2, 12e-2}, {0.4, 48e-2}}) == Approx(2));
    CHECK(std::isnan(fitted_order({{0.1, 3e-2}, {0.2, 12e-2}, {0.4, 1e-9}})));  // too few that tell
}

TEST_CASE("a summary tells the default, the order, and the time to a given error") {
    const std::vector<Summary> all = summarize(points(), 0);
    REQUIRE(all.size() == 2);
    CHECK(all[0].engine == "ours");
    CHECK(all[0].error == 4e-3);
    CHECK(all[0].order == Approx(2));
    CHECK(all[0].cpu_to_1_percent_s == 4e-5);
    CHECK(all[0].cpu_to_01_percent_s == 8e-5);
    CHECK(all[0].ratio == 1);
    CHECK(all[1].cpu_to_1_percent_s == 9e-5);
    CHECK(std::isinf(all[1].cpu_to_01_percent_s));
}

TEST_CASE("a peer is compared by its best error within the time of our default") {
    const std::vector<Summary> all = summarize(points(), 0);
    CHECK(all[1].error_in_same_time == 0.04);
    CHECK(all[1].ratio == Approx(10));
    std::vector<Point> exact = points();
    exact[1].errors[0] = 1e-12;
    exact[6].errors[0] = 1e-9;
    CHECK(summarize(exact, 0)[1].ratio == 1);  // both below what counts
    CHECK(first_is_best(all));
    std::vector<Point> worse = points();
    worse[1].errors[0] = 0.3;
    CHECK_FALSE(first_is_best(summarize(worse, 0)));
}

TEST_CASE("engines that cannot tell a metric are left out of it") {
    std::vector<Point> some = points();
    for (std::size_t i = 0; i < 4; ++i) some[i].errors[1] = 0.5;
    CHECK(summarize(some, 1).size() == 1);
    CHECK(accuracy_lines(kProblem, 1, some).size() == 4 + 1);  // and the one that failed before it could tell
}

TEST_CASE("each point is a line of JSON, failures too") {
    const std::vector<std::string> lines = accuracy_lines(kProblem, 0, points());
    REQUIRE(lines.size() == 8);
    const auto first = nlohmann::json::parse(lines[0]);
    CHECK(first["problem"] == "made_up/height");
    CHECK(first["engine"] == "ours");
    CHECK(first["solver"] == "default");
    CHECK(first["substeps"] == 1);
    CHECK(first["dt_s"] == Approx(1.0 / 60));
    CHECK(first["error"] == 0.2);
    CHECK(first["error_unit"] == "of the height");
    CHECK(first["cpu_s_per_sim_s"] == 1e-5);
    CHECK(first["failed"] == false);
    CHECK(nlohmann::json::parse(lines[2])["order"] == Approx(2));
    const auto failed = nlohmann::json::parse(lines[4]);
    CHECK(failed["failed"] == true);
    CHECK(failed["error"].is_null());
    CHECK(failed["ended_by"] == "signal: Aborted");
}

TEST_CASE("a plot has a line along the efforts and one along the steps, both through the default") {
    const Plot plot = accuracy_plot(kProblem, 0, points());
    REQUIRE(plot.series.size() == 4);
    CHECK(plot.series[0].points.size() == 2);
    CHECK(plot.series[1].points.size() == 3);
    CHECK(plot.series[1].dashed);
    for (const Series& series : plot.series) {
        CHECK(std::count_if(series.points.begin(), series.points.end(),
                            [](const PlotPoint& each) { return each.ringed; }) == 1);
    }
    CHECK(std::isinf(plot.series[2].points.front().y));
}

TEST_CASE("the table says what there is none of") {
    const std::vector<Summary> all = summarize(points(), 0);
    CHECK_THAT(accuracy_row(kProblem, 0, all[1]),
               Catch::Contains("made_up/height") && Catch::Contains("never"));
}

TEST_CASE("a summary is a line of JSON, with null where there is no number") {
    const std::vector<Summary> all = summarize(points(), 0);
    const auto line = nlohmann::json::parse(accuracy_summary_line(kProblem, 0, all[1]));
    CHECK(line["summary"] == "made_up/height");
    CHECK(line["engine"] == all[1].engine);
    CHECK(line["error_unit"] == "of the height");
    CHECK(line["compared"] == true);
    CHECK(line["cpu_s_to_01_percent"].is_null());
}

}  // namespace cairn::lab
