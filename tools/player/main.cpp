// The cairn program.
#include <cstdio>

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
    std::fprintf(stderr, "cairn: error: %s\n", message.c_str());
    return 1;
}

void print_bundled_games(const std::string& program_path) {
    std::printf("\nBundled games (cairn play NAME):\n");
    for (const std::string& name : cairn::player::bundled_games(cairn::player::data_folder(program_path))) {
        std::printf("  %s\n", name.c_str());
    }
}

int run(const CommandLine& line, const std::string& program_path) {
    switch (line.command) {
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
            std::printf("%s is ready: cairn play %s\n", line.target.c_str(), line.target.c_str());
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
    if (line.command == Command::Test) return cairn::scripting::test_game(*source);
    if (line.command == Command::Check) return cairn::scripting::check_game(*source);
    if (line.command == Command::Run) return cairn::scripting::run_script(*source, line.arguments);
    cairn::scripting::PlayOptions options = line.play;
    options.source = *source;
    return cairn::scripting::play(options);
}

}  // namespace

int main(int argc, char** argv) {
    const cairn::player::ParsedLine parsed = cairn::player::parse_command_line(argc, argv);
    const int status = parsed.is_done ? parsed.status : run(parsed.line, argv[0]);
    // What was asked for may not have arrived: a full disk shows only now.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail("standard output cannot be written");
    return status;
}
