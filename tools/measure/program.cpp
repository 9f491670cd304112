#include "program.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace cairn::measure {

int Program::fail(const std::string& message) const {
    std::fprintf(stderr, "%s: error: %s\n", name_, message.c_str());
    return 1;
}

int Program::with_output(const std::string& json, const std::function<int(Output&)>& work) const {
    Output output(json);
    if (output.failed()) return fail("cannot write to " + json);
    const int status = work(output);
    if (!output.finish()) return fail("cannot write to " + json);
    return status;
}

int Program::end(int status) const {
    if (status != 0) return status;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail("standard output cannot be written");
    return 0;
}

physics::Result<bool> read_arguments(CLI::App& app, const std::vector<std::string>& arguments,
                                     std::string& help) {
    app.footer(app.get_name() + " COMMAND --help says more about a command.");
    app.require_subcommand(0, 1);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const std::vector<CLI::App*> chosen = app.get_subcommands();
        help = chosen.empty() ? app.help() : chosen.front()->help(app.get_name());
        return false;
    } catch (const CLI::ParseError& error) {
        return physics::Error{std::string(error.what()) + "; see " + app.get_name() + " --help"};
    }
    if (!app.get_subcommands().empty()) return true;
    help = app.help();
    return false;
}

std::vector<EngineKind> engines(bool with_peers, Output& output) {
    std::vector<EngineKind> kinds{cairn()};
    if (!with_peers) return kinds;
    kinds.insert(kinds.end(), peers().begin(), peers().end());
    for (const std::string_view absent : absent_peers()) {
        output.row("left out, as it was not installed when this program was built: " + std::string(absent));
    }
    return kinds;
}

}  // namespace cairn::measure
