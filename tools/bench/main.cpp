// The cairn-bench program.
#include <cstdio>
#include <string>

#include "command_line.h"
#include "lua.h"
#include "measure.h"
#include "program.h"
#include "report.h"
#include "state.h"

namespace {

using namespace cairn::bench;
using cairn::measure::Output;

constexpr cairn::measure::Program kProgram("cairn-bench");

/// Keeps the faster one.
void keep_best(Measurement& best, Measurement next, bool first) {
    if (first || next.ms_total < best.ms_total) best = std::move(next);
}

int run(const CommandLine& line, Output& output) {
    std::vector<Measurement> best(line.scenes.size());
    for (int round = 0; round < line.repeat; ++round) {
        for (std::size_t i = 0; i < line.scenes.size(); ++i) {
            Measurement next =
                measure(*line.scenes[i], cairn::measure::make_cairn, line.threads, line.most_steps);
            if (round > 0 && next.state_hash != best[i].state_hash) {
                return kProgram.fail("scene " + line.scenes[i]->name +
                                     " ended in another state than in the run before");
            }
            keep_best(best[i], std::move(next), round == 0);
        }
    }
    for (std::size_t i = 0; line.warm && i < line.scenes.size(); ++i) {
        const WarmRun warm = run_warm(*line.scenes[i], line.threads, line.most_steps);
        if (warm.state_hash != best[i].state_hash) {
            return kProgram.fail("scene " + line.scenes[i]->name +
                                 " ended in another state when it was gone back to its begin");
        }
        best[i].allocations_warm = warm.allocations;
    }
    output.row(run_table_head());
    for (std::size_t i = 0; i < line.scenes.size(); ++i) {
        output.line(run_line(*line.scenes[i], {line.threads, std::string(name(line.simd))}, best[i]));
        output.row(run_table_row(*line.scenes[i], best[i]));
    }
    return 0;
}

int compare(const CommandLine& line, Output& output) {
    const std::vector<cairn::measure::EngineKind> engines = cairn::measure::engines(true, output);
    output.row(compare_table_head());
    for (const Scene* scene : line.scenes) {
        std::vector<Measurement> best(engines.size());
        for (int round = 0; round < line.repeat; ++round) {
            for (std::size_t i = 0; i < engines.size(); ++i) {
                keep_best(best[i], measure(*scene, engines[i].make, line.threads, line.most_steps),
                          round == 0);
            }
        }
        for (std::size_t i = 0; i < engines.size(); ++i) {
            const double ratio = best[i].ms_total / best[0].ms_total;
            output.line(compare_line(*scene, engines[i].name, best[i], ratio));
            output.row(compare_table_row(*scene, engines[i].name, best[i], ratio));
        }
    }
    return 0;
}

void list() {
    for (const Scene& scene : all_scenes()) {
        std::printf("%-14s %6d steps  %s\n", scene.name.c_str(), scene.steps, scene.summary.c_str());
    }
}

int execute(const CommandLine& line) {
    if (const auto forced = cairn::physics::force_simd_level(line.simd); !forced) {
        return kProgram.fail(forced.error().message);
    }
    return kProgram.with_output(line.json, [&](Output& output) {
        return line.command == Command::Run ? run(line, output) : compare(line, output);
    });
}

}  // namespace

int main(int argc, char** argv) {
    std::string help;
    const auto line = parse_command_line({argv + 1, argv + argc}, help);
    if (!line) return kProgram.fail(line.error().message);
    int status = 0;
    switch (line->command) {
        case Command::Help:
            std::fputs(help.c_str(), stdout);
            break;
        case Command::List:
            list();
            break;
        case Command::Lua:
            status = kProgram.with_output(line->json, [](Output& output) {
                const std::string problem = measure_lua(output);
                return problem.empty() ? 0 : kProgram.fail(problem);
            });
            break;
        case Command::State:
            std::puts(state_table_head().c_str());
            for (const StateFigures& figures : measure_state(line->repeat))
                std::puts(state_table_row(figures).c_str());
            break;
        case Command::Run:
        case Command::Compare:
            status = execute(*line);
            break;
    }
    return kProgram.end(status);
}
