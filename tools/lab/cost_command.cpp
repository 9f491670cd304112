// By exec, so that signals, output and the status are the script's own.
#include "cost_command.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace cairn::lab {

std::vector<std::string> cost_arguments(const CommandLine& line, const std::string& script) {
    std::vector<std::string> arguments{script};
    if (line.quick) arguments.emplace_back("--quick");
    for (const std::string& feature : line.features)
        arguments.insert(arguments.end(), {"--feature", feature});
    if (!line.json.empty()) arguments.insert(arguments.end(), {"--json", line.json});
    return arguments;
}

std::string become_cost_script(const CommandLine& line) {
    std::vector<std::string> arguments = cost_arguments(line, CAIRN_LAB_COST_SCRIPT);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    execv(words.front(), words.data());
    return "cost makes builds from Cairn's sources, but " + arguments.front() +
           " cannot be run: " + std::strerror(errno);
}

}  // namespace cairn::lab
