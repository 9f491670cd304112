#include "accuracy/sweep.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "child.h"

namespace cairn::lab {
namespace {

using Json = nlohmann::json;

// Numbers that are none are null in JSON.
std::vector<double> numbers(const Json& list) {
    std::vector<double> found;
    for (const Json& value : list) {
        found.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
    }
    return found;
}

void keep_errors(Point& point, const Answer& answer) {
    point.ended_by = answer.ended_by;
    if (!point.ended_by.empty()) return;
    const Json read = Json::parse(answer.text, nullptr, false);
    if (read.is_array()) {
        point.errors = numbers(read);
    } else {
        point.ended_by = "an answer that cannot be read";
    }
}

// One process for all settings of an engine, as some problems remember a reference; when it does not come to
// its end, one for each.
void find_errors(const Problem& problem, const std::vector<Point*>& points) {
    const Answer all = ask_child([&] {
        Json lists = Json::array();
        for (const Point* point : points) lists.push_back(problem.errors(point->setting));
        return lists.dump();
    });
    const Json lists = all.ended_by.empty() ? Json::parse(all.text, nullptr, false) : Json();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (lists.is_array() && lists.size() == points.size()) {
            points[i]->errors = numbers(lists[i]);
        } else {
            keep_errors(*points[i],
                        ask_child([&] { return Json(problem.errors(points[i]->setting)).dump(); }));
        }
    }
}

double timed_run(const Problem& problem, const Setting& setting) {
    Rig rig(setting.kind, setting.world(problem.timed_gravity_m_s2));
    rig.without_books();
    const BeforeStep before = problem.timed_scene(rig);
    const int steps = setting.steps(problem.timed_s);
    const double start = cpu_time_s();
    for (int i = 0; i < steps; ++i) {
        if (before) before(rig);
        rig.step(setting.dt_s);
    }
    return (cpu_time_s() - start) / (steps * static_cast<double>(setting.dt_s));
}

void find_times(const Problem& problem, const std::vector<Point*>& points, int samples) {
    const Answer answer = ask_child([&] {
        std::vector<std::vector<double>> times(points.size());
        for (int sample = 0; sample < samples; ++sample) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                times[i].push_back(timed_run(problem, points[i]->setting));
            }
        }
        return Json(times).dump();
    });
    const Json times = answer.ended_by.empty() ? Json::parse(answer.text, nullptr, false) : Json();
    if (!times.is_array()) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<double> sorted = numbers(times[i]);
        std::sort(sorted.begin(), sorted.end());
        points[i]->cpu_s_per_sim_s = sorted.front();
        points[i]->cpu_iqr_s = sorted[sorted.size() * 3 / 4] - sorted[sorted.size() / 4];
    }
}

}  // namespace

bool Point::tells(std::size_t metric) const {
    return errors.empty() || errors[metric] != kNotTold;
}

bool Point::failed(std::size_t metric) const {
    return errors.empty() || !std::isfinite(errors[metric]);
}

std::vector<Point> points_of(const EngineKind& kind, bool quick) {
    std::vector<Point> points;
    const auto add = [&](int effort, float dt_s, Sweep sweep) {
        points.push_back({.setting = {kind, effort, dt_s, quick}, .sweep = sweep});
    };
    for (const int effort : {1, 2, 4, 8, 16, 32}) {
        const bool left_out = quick && (effort == 2 || effort == 8 || effort == 32);
        if (effort != kind.default_effort && !left_out) add(effort, kStep_s, Sweep::Effort);
    }
    add(kind.default_effort, kStep_s, Sweep::Default);
    for (const float rate_hz : {30.0f, 120.0f, 240.0f, 480.0f}) {
        if (!quick || rate_hz == 30 || rate_hz == 240) add(kind.default_effort, 1 / rate_hz, Sweep::TimeStep);
    }
    return points;
}

std::vector<Point> solve(const Problem& problem, const std::vector<EngineKind>& kinds, bool quick,
                         int samples) {
    std::vector<Point> points;
    for (const EngineKind& kind : kinds) {
        const std::vector<Point> own = points_of(kind, quick);
        points.insert(points.end(), own.begin(), own.end());
    }
    std::vector<Point*> timed;
    for (const EngineKind& kind : kinds) {
        std::vector<Point*> own;
        for (Point& point : points) {
            if (point.setting.kind.name == kind.name) own.push_back(&point);
        }
        find_errors(problem, own);
        std::copy_if(own.begin(), own.end(), std::back_inserter(timed),
                     [](const Point* point) { return point->ended_by.empty(); });
    }
    find_times(problem, timed, samples);
    return points;
}

}  // namespace cairn::lab
