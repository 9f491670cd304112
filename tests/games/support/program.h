// Runs the cairn program and keeps what it said.
#pragma once

#include <string>

namespace cairn::test {

struct ProgramRun {
    int exit_status = -1;
    std::string output;  // standard output and standard error, as they came

    // The rest of the line that begins with `label`, such as "won" for "result: "; empty without such a line.
    std::string field(const std::string& label) const;
};

// `arguments` are in the syntax of the shell. Sounds go nowhere.
ProgramRun run_cairn(const std::string& arguments);

}  // namespace cairn::test
