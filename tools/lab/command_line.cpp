// CLI11 does the parsing; names are checked here, so that errors say what would have been right.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "determinism/proof.h"
#include "program.h"
#include "text.h"

namespace cairn::lab {
namespace {

using physics::Error;
using physics::Result;

struct Texts {
    std::vector<std::string> cases;
    std::vector<std::string> problems;
    std::vector<std::string> scenes;
    std::string steps = "0";
    std::string nudge = "-1";
};

const std::string& key(const Case& test) {
    return test.number;
}
const std::string& key(const Problem& problem) {
    return problem.name;
}
const std::string& key(const bench::Scene& scene) {
    return scene.name;
}

/// Those that were named, in that order and each once; all when none was.
template <class Thing>
Result<std::vector<const Thing*>> chosen_of(std::span<const Thing> all, const std::vector<std::string>& names,
                                            const char* what) {
    std::vector<const Thing*> found;
    if (names.empty()) {
        for (const Thing& thing : all) found.push_back(&thing);
    }
    for (const std::string& wanted : names) {
        const auto match =
            std::find_if(all.begin(), all.end(), [&](const Thing& thing) { return key(thing) == wanted; });
        if (match == all.end()) {
            return Error{std::string("there is no ") + what + " \"" + wanted +
                         "\"; cairn-lab list names them all"};
        }
        if (std::find(found.begin(), found.end(), &*match) == found.end()) found.push_back(&*match);
    }
    return found;
}

}  // namespace

Result<CommandLine> parse_command_line(const std::vector<std::string>& arguments, std::string& help) {
    Texts texts;
    CommandLine line;
    CLI::App app(
        "Examines Cairn's physics: what it withstands, how accurate it is, whether runs are the same, and "
        "whether what is not used costs nothing.",
        "cairn-lab");
    CLI::App* list = app.add_subcommand("list", "name the cases, problems and scenes");
    CLI::App* torture = app.add_subcommand("torture", "run the cases that are hard on an engine");
    torture->add_option("--case", texts.cases, "a case of the list; may be given again (all)")
        ->type_name("N");
    CLI::App* accuracy = app.add_subcommand("accuracy", "set errors against run times");
    accuracy->add_option("--problem", texts.problems, "a problem of the list; may be given again (all)")
        ->type_name("NAME");
    accuracy->add_option("--plot", line.plot, "draw plots into DIR, as SVG")->type_name("DIR");
    accuracy->add_flag("--quick", line.quick, "fewer settings, runs and starts");
    for (CLI::App* command : {torture, accuracy})
        command->add_flag("--peers", line.peers, "other engines too");
    CLI::App* cost = app.add_subcommand("cost", "prove that a scene pays nothing for what it does not use");
    cost->add_option("--feature", line.features, "one of those that a build can leave out (all)")
        ->type_name("NAME");
    cost->add_flag("--quick", line.quick, "at most 1,000 bodies");
    CLI::App* determinism = app.add_subcommand(
        "determinism", "run scenes with all threads and SIMD levels, and compare every step");
    determinism->add_option("--scene", texts.scenes, "a scene of the list; may be given again (all)")
        ->type_name("NAME");
    determinism->add_option("--steps", texts.steps, "cut scenes short after N steps (0: do not)")
        ->type_name("N");
    determinism->add_flag("--quick", line.quick,
                          "fewer settings, and 10 steps unless --steps says otherwise");
    determinism
        ->add_option("--nudge", texts.nudge,
                     "push a body a little before step N of the last setting, which must be found (-1: no)")
        ->type_name("N");
    for (CLI::App* command : {torture, accuracy, cost, determinism}) {
        command->add_option("--json", line.json, "one object a line to FILE, or to standard output")
            ->type_name("FILE|-");
    }

    const auto has_command = measure::read_arguments(app, arguments, help);
    if (!has_command) return has_command.error();
    if (!*has_command) return CommandLine{};
    if (list->parsed()) {
        line.command = Command::List;
        return line;
    }
    if (torture->parsed()) {
        line.command = Command::Torture;
        auto cases = chosen_of(all_cases(), texts.cases, "case");
        if (!cases) return cases.error();
        line.cases = *std::move(cases);
        return line;
    }
    if (accuracy->parsed()) {
        line.command = Command::Accuracy;
        auto problems = chosen_of(all_problems(), texts.problems, "problem");
        if (!problems) return problems.error();
        line.problems = *std::move(problems);
        return line;
    }
    if (cost->parsed()) {
        line.command = Command::Cost;
        return line;
    }
    line.command = Command::Determinism;
    auto scenes = chosen_of(std::span(determinism_scenes()), texts.scenes, "scene");
    if (!scenes) return scenes.error();
    line.scenes = *std::move(scenes);
    const auto steps = measure::number_of("--steps", texts.steps, 0, 1000000);
    if (!steps) return steps.error();
    line.steps = *steps;
    const auto nudge = measure::number_of("--nudge", texts.nudge, -1, 1000000);
    if (!nudge) return nudge.error();
    line.nudged_step = *nudge;
    return line;
}

}  // namespace cairn::lab
