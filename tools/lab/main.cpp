// The cairn-lab program.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "accuracy/summary.h"
#include "command_line.h"
#include "cost_command.h"
#include "determinism/proof.h"
#include "program.h"
#include "text.h"
#include "torture/report.h"

namespace {

using namespace cairn::lab;
using cairn::measure::engines;
using cairn::measure::format;
using cairn::measure::Output;

constexpr cairn::measure::Program kProgram("cairn-lab");

constexpr int kQuickSteps = 10;

/// 1 when Cairn failed a case.
int torture(const CommandLine& line, Output& output) {
    int failed = 0;
    const std::vector<EngineKind> kinds = engines(line.peers, output);
    output.row(torture_head());
    for (const Case* test : line.cases) {
        for (const EngineKind& kind : kinds) {
            const bool is_cairn = &kind == &kinds.front();
            if (!is_cairn && !test->for_every_engine) continue;
            const Outcome outcome = run_case(*test, kind);
            if (is_cairn && !outcome.passed()) ++failed;
            output.line(torture_line(*test, kind.name, outcome));
            output.row(torture_row(*test, kind.name, outcome));
        }
    }
    output.row(format("%zu of %zu cases passed", line.cases.size() - static_cast<std::size_t>(failed),
                      line.cases.size()));
    return failed == 0 ? 0 : 1;
}

bool write_plot(const std::string& folder, const Problem& problem, std::size_t metric,
                const std::vector<Point>& points) {
    std::ofstream file(std::filesystem::path(folder) /
                       (problem.name + "_" + problem.metrics[metric].name + ".svg"));
    file << to_svg(accuracy_plot(problem, metric, points));
    return static_cast<bool>(file.flush());
}

int accuracy(const CommandLine& line, Output& output) {
    if (!line.plot.empty()) {
        std::error_code error;
        std::filesystem::create_directories(line.plot, error);
        if (error) return kProgram.fail("cannot make the folder " + line.plot + ": " + error.message());
    }
    const std::vector<EngineKind> kinds = engines(line.peers, output);
    const int samples = line.quick ? 5 : 20;
    output.row(accuracy_head());
    int compared = 0, best = 0;
    for (const Problem* problem : line.problems) {
        const std::vector<Point> points = solve(*problem, kinds, line.quick, samples);
        for (std::size_t metric = 0; metric < problem->metrics.size(); ++metric) {
            for (const std::string& text : accuracy_lines(*problem, metric, points)) output.line(text);
            const std::vector<Summary> summaries = summarize(points, metric);
            for (const Summary& summary : summaries) {
                output.line(accuracy_summary_line(*problem, metric, summary));
                output.row(accuracy_row(*problem, metric, summary));
            }
            if (problem->metrics[metric].compared) {
                ++compared;
                best += first_is_best(summaries) ? 1 : 0;
            }
            if (!line.plot.empty() && !write_plot(line.plot, *problem, metric, points)) {
                return kProgram.fail("cannot write plots to " + line.plot);
            }
        }
    }
    if (line.peers) {
        output.row(format(
            "at the default, cairn is as accurate as the best peer in the same time in %d of %d metrics",
            best, compared));
    }
    return 0;
}

int determinism(const CommandLine& line, Output& output) {
    const std::vector<RunSetting> settings = determinism_settings(line.quick);
    const int most_steps = line.steps > 0 ? line.steps : line.quick ? kQuickSteps : 0;
    std::size_t held = 0;
    output.row(determinism_head());
    for (const cairn::bench::Scene* scene : line.scenes) {
        const Proof proof = prove(*scene, settings, most_steps, line.nudged_step);
        if (proof.holds()) ++held;
        for (const std::string& text : determinism_lines(proof)) output.line(text);
        for (const std::string& row : determinism_rows(proof)) output.row(row);
    }
    output.row(format("%zu of %zu scenes are the same to the last bit in %zu settings", held,
                      line.scenes.size(), settings.size()));
    return held == line.scenes.size() ? 0 : 1;
}

void list() {
    for (const Case& test : all_cases())
        std::printf("torture  %4s  %s\n", test.number.c_str(), test.name.c_str());
    for (const Problem& problem : all_problems()) {
        std::string metrics;
        for (const Metric& metric : problem.metrics) metrics += (metrics.empty() ? "" : ", ") + metric.name;
        std::printf("accuracy %4d  %s: %s\n", problem.number, problem.name.c_str(), metrics.c_str());
    }
    for (const cairn::bench::Scene& scene : determinism_scenes())
        std::printf("determinism  %s: %s\n", scene.name.c_str(), scene.summary.c_str());
}

int execute(const CommandLine& line, Output& output) {
    switch (line.command) {
        case Command::Help:
            return 0;
        case Command::List:
            list();
            return 0;
        case Command::Torture:
            return torture(line, output);
        case Command::Accuracy:
            return accuracy(line, output);
        case Command::Cost:  // writes by itself
            break;
        case Command::Determinism:
            return determinism(line, output);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::string help;
    const auto line = parse_command_line({argv + 1, argv + argc}, help);
    if (!line) return kProgram.fail(line.error().message);
    std::fputs(help.c_str(), stdout);
    if (line->command == Command::Cost) return kProgram.fail(become_cost_script(*line));
    return kProgram.end(
        kProgram.with_output(line->json, [&](Output& output) { return execute(*line, output); }));
}
