// CLI11 does the parsing; names are checked here, so that errors say what would have been right.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace cairn::lab {
namespace {

using physics::Error;
using physics::Result;

struct Texts {
    std::vector<std::string> cases;
    std::vector<std::string> problems;
};

const std::string& key(const Case& test) {
    return test.number;
}
const std::string& key(const Problem& problem) {
    return problem.name;
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
    CLI::App app("Examines Cairn's physics: what it withstands, and how accurate it is.", "cairn-lab");
    app.footer("cairn-lab COMMAND --help says more about a command.");
    app.require_subcommand(0, 1);
    CLI::App* list = app.add_subcommand("list", "name the cases and problems");
    CLI::App* torture = app.add_subcommand("torture", "run the cases that are hard on an engine");
    torture->add_option("--case", texts.cases, "a case of the list; may be given again (all)")
        ->type_name("N");
    CLI::App* accuracy = app.add_subcommand("accuracy", "set errors against run times");
    accuracy->add_option("--problem", texts.problems, "a problem of the list; may be given again (all)")
        ->type_name("NAME");
    accuracy->add_option("--plot", line.plot, "draw plots into DIR, as SVG")->type_name("DIR");
    accuracy->add_flag("--quick", line.quick, "fewer settings, runs and starts");
    for (CLI::App* command : {torture, accuracy}) {
        command->add_flag("--peers", line.peers, "other engines too");
        command->add_option("--json", line.json, "one object a line to FILE, or to standard output")
            ->type_name("FILE|-");
    }

    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const std::vector<CLI::App*> chosen = app.get_subcommands();
        help = (chosen.empty() ? &app : chosen.front())->help();
        return CommandLine{};
    } catch (const CLI::ParseError& error) {
        return Error{std::string(error.what()) + "; see cairn-lab --help"};
    }
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
    help = app.help();
    return line;
}

}  // namespace cairn::lab
