// The cairn-lab program.
#include <cstdio>
#include <string>

#include "command_line.h"
#include "output.h"
#include "text.h"
#include "torture/report.h"

namespace {

using namespace cairn::lab;
using cairn::measure::format;
using cairn::measure::Output;

int fail(const std::string& message) {
    std::fprintf(stderr, "cairn-lab: error: %s\n", message.c_str());
    return 1;
}

std::vector<EngineKind> engines(bool with_peers, Output& output) {
    std::vector<EngineKind> kinds{{"cairn", cairn::measure::make_cairn}};
    if (!with_peers) return kinds;
    const auto peers = cairn::measure::peers();
    kinds.insert(kinds.end(), peers.begin(), peers.end());
    for (const std::string_view absent : cairn::measure::absent_peers()) {
        output.row("left out, as it was not installed when this program was built: " + std::string(absent));
    }
    return kinds;
}

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

void list() {
    for (const Case& test : all_cases()) std::printf("%4s  %s\n", test.number.c_str(), test.name.c_str());
}

int execute(const CommandLine& line) {
    Output output(line.json);
    if (output.failed()) return fail("cannot write to " + line.json);
    const int status = torture(line, output);
    if (!output.finish()) return fail("cannot write to " + line.json);
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    std::string help;
    const auto line = parse_command_line({argv + 1, argv + argc}, help);
    if (!line) return fail(line.error().message);
    switch (line->command) {
        case Command::Help:
            std::fputs(help.c_str(), stdout);
            break;
        case Command::List:
            list();
            break;
        case Command::Torture:
            if (const int status = execute(*line); status != 0) return status;
            break;
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail("standard output cannot be written");
    return 0;
}
