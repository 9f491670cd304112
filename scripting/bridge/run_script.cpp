// A script is a game without frames: it runs once, to its end.
#include <cstdio>

#include <cairn/engine/printable.h>
#include <cairn/scripting/run_script.h>

#include "bridge/game.h"
#include "bridge/machine.h"

namespace cairn::scripting {

int run_script(const GameSource& source, const std::vector<std::string>& arguments) {
    auto machine = make_machine(source, MachineKind::Headless);
    std::string problem;
    if (!machine) {
        problem = machine.error().message;
    } else {
        Game game((*machine)->services(), {.plays_saves = true});
        if (const auto error = game.run_file((*machine)->main_path, arguments)) problem = error->to_text();
    }
    if (problem.empty()) return 0;
    std::fflush(stdout);
    std::fprintf(stderr, "cairn: error: %s\n", engine::printable(problem).c_str());
    return 1;
}

}  // namespace cairn::scripting
