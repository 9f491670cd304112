// The cairn program.
#include <cstdio>
#include <cstdlib>

#include <cairn/engine/printable.h>
#include <cairn/scripting/check_game.h>
#include <cairn/scripting/play.h>
#include <cairn/scripting/reference.h>
#include <cairn/scripting/run_script.h>
#include <cairn/scripting/test_game.h>

#include "command_line.h"
#include "locate.h"
#include "new_game.h"

namespace {

using cairn::player::Command;
using cairn::player::CommandLine;

int fail(const std::string& message) {
    std::fprintf(stderr, "cairn: error: %s\n", cairn::engine::printable(message).c_str());
    return 1;
}

void print_bundled_games(const std::string& program_path) {
    std::printf("\nBundled games (cairn play NAME):\n");
    for (const auto& game : cairn::player::bundled_games(cairn::player::data_folder(program_path))) {
        std::printf("  %s\n", game.name.c_str());
    }
}

/// Where there is none, `cairn` alone prints its help.
bool has_display() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') return true;
    }
    return false;
}

/// Shows the shelf of games, plays what is chosen, and comes back to the shelf, until nothing is chosen.
int launch(const std::string& program_path) {
    while (true) {
        cairn::scripting::PlayResult chosen;
        const int status =
            cairn::scripting::play({.source = cairn::player::launcher(program_path), .result = &chosen});
        if (status != 0 || chosen.outcome != "play" || !chosen.level) return status;
        const auto source = cairn::player::locate_game(*chosen.level, program_path);
        if (!source) return fail(source.error().message);
        // A game that failed has shown its error; the shelf is still of use, unless all is to end.
        const int played = cairn::scripting::play({.source = *source});
        if (played > cairn::scripting::kSignalStatus) return played;
    }
}

int run(const CommandLine& line, const std::string& program_path) {
    switch (line.command) {
        case Command::Launch:
            return launch(program_path);
        case Command::Help:
            print_bundled_games(program_path);
            return 0;
        case Command::Version:
            std::printf("cairn %s\n", CAIRN_VERSION);
            return 0;
        case Command::Reference:
            std::fputs(cairn::scripting::reference_markdown().c_str(), stdout);
            return 0;
        case Command::Levels:
            std::fputs(cairn::scripting::level_reference_markdown().c_str(), stdout);
            return 0;
        case Command::Types:
            std::fputs(cairn::scripting::editor_annotations().c_str(), stdout);
            return 0;
        case Command::New: {
            if (const auto made = cairn::player::new_game(line.target); !made)
                return fail(made.error().message);
            std::printf("%s is ready: cairn play %s\n", line.target.c_str(),
                        cairn::player::shell_word(line.target).c_str());
            return 0;
        }
        case Command::Play:
        case Command::Run:
        case Command::Test:
        case Command::Check:
            break;
    }
    const auto source = line.command == Command::Run ? cairn::player::locate_script(line.target, program_path)
                                                     : cairn::player::locate_game(line.target, program_path);
    if (!source) return fail(source.error().message);
    if (line.command == Command::Test) return cairn::scripting::test_game(*source, line.test);
    if (line.command == Command::Check) return cairn::scripting::check_game(*source);
    if (line.command == Command::Run) return cairn::scripting::run_script(*source, line.arguments);
    cairn::scripting::PlayOptions options = line.play;
    options.source = *source;
    return cairn::scripting::play(options);
}

}  // namespace

int main(int argc, char** argv) {
    const cairn::player::ParsedLine parsed = cairn::player::parse_command_line(argc, argv, has_display());
    const int status = parsed.is_done ? parsed.status : run(parsed.line, argv[0]);
    // What was asked for may not have arrived: a full disk shows only now.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail("standard output cannot be written");
    return status;
}
