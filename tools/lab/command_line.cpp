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
};

/// In the order in which they were named, each once; all when none was.
Result<std::vector<const Case*>> cases_of(const std::vector<std::string>& numbers) {
    std::vector<const Case*> found;
    for (const Case& test : all_cases()) {
        if (numbers.empty()) found.push_back(&test);
    }
    for (const std::string& wanted : numbers) {
        const auto match = std::find_if(all_cases().begin(), all_cases().end(),
                                        [&](const Case& test) { return test.number == wanted; });
        if (match == all_cases().end()) {
            return Error{"there is no case \"" + wanted + "\"; cairn-lab list names them all"};
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
    CLI::App* list = app.add_subcommand("list", "name the cases");
    CLI::App* torture = app.add_subcommand("torture", "run the cases that are hard on an engine");
    torture->add_option("--case", texts.cases, "a case of the list; may be given again (all)")
        ->type_name("N");
    torture->add_flag("--peers", line.peers, "other engines too");
    torture->add_option("--json", line.json, "one object a line to FILE, or to standard output")
        ->type_name("FILE|-");

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
        auto cases = cases_of(texts.cases);
        if (!cases) return cases.error();
        line.cases = *std::move(cases);
        return line;
    }
    help = app.help();
    return line;
}

}  // namespace cairn::lab
