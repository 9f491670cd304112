#include "games/support/program.h"

#include <array>
#include <cstdio>
#include <sstream>
#include <sys/wait.h>

namespace cairn::test {

std::string ProgramRun::field(const std::string& label) const {
    std::istringstream lines(output);
    std::string line;
    while (std::getline(lines, line)) {
        if (line.rfind(label, 0) == 0) return line.substr(label.size());
    }
    return {};
}

ProgramRun run_cairn(const std::string& arguments) {
    const std::string command = "SDL_AUDIODRIVER=dummy '" CAIRN_PROGRAM "' " + arguments + " 2>&1";
    ProgramRun run;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return run;
    std::array<char, 4096> buffer;
    std::size_t count;
    while ((count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0)
        run.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) run.exit_status = WEXITSTATUS(status);
    return run;
}

}  // namespace cairn::test
