// Sweeps visit the settings they should, and keep what failed.
#include "accuracy/sweep.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <set>

namespace cairn::lab {
namespace {

// Its error is the step itself; the smallest step ends the process.
Problem made_up() {
    return {.number = 1,
            .name = "made_up",
            .metrics = {{"x", "1"}},
            .errors = [](const Setting& setting) -> std::vector<double> {
                if (setting.dt_s < 1.0f / 400) std::raise(SIGKILL);
                if (setting.effort == 2) return {std::numeric_limits<double>::quiet_NaN()};
                return {static_cast<double>(setting.dt_s)};
            },
            .timed_s = 0.1,
            .timed_scene = [](Rig& rig) -> BeforeStep { return rig.add({}, physics::Circle{}), nullptr; }};
}

}  // namespace

TEST_CASE("a sweep goes along the efforts and along the steps, and meets the default once") {
    const std::vector<Point> points = points_of({"x", nullptr, 10}, false);
    std::set<std::pair<int, float>> settings;
    int defaults = 0;
    for (const Point& point : points) {
        CHECK(settings.insert({point.setting.effort, point.setting.dt_s}).second);
        defaults += point.sweep == Sweep::Default ? 1 : 0;
    }
    CHECK(defaults == 1);
    CHECK(settings.size() == 6 + 1 + 4);
    CHECK(points_of({"x", nullptr, 4}, false).size() == 6 + 4);
    CHECK(points_of({"x", nullptr, 4}, true).size() < 6);
}

TEST_CASE("a setting at which an engine ends the process fails alone") {
    const std::vector<Point> points = solve(made_up(), {measure::cairn()}, false, 3);
    int ended = 0, failed = 0;
    for (const Point& point : points) {
        if (!point.ended_by.empty()) {
            ++ended;
            CHECK(point.setting.dt_s < 1.0f / 400);
            CHECK(std::isnan(point.cpu_s_per_sim_s));
        } else {
            CHECK(point.cpu_s_per_sim_s > 0);
        }
        if (point.failed(0)) {
            ++failed;
        } else {
            CHECK(point.errors[0] == Approx(point.setting.dt_s));
        }
    }
    CHECK(ended == 1);
    CHECK(failed == 2);
}

}  // namespace cairn::lab
