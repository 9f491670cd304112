// The commands and options of the program, and what to say about wrong ones.
#pragma once

#include <string>
#include <vector>

#include <cairn/scripting/play.h>
#include <cairn/scripting/test_game.h>

namespace cairn::player {

enum class Command { Launch, Help, Play, Run, Test, Check, New, Reference, Levels, Types, Version };

struct CommandLine {
    Command command = Command::Help;
    std::string target;  ///< the game, file or folder
    std::vector<std::string> arguments;
    scripting::PlayOptions play;  ///< without its source
    scripting::TestOptions test;
};

/// Either a command line, or what was printed and the exit status.
struct ParsedLine {
    bool is_done = false;
    int status = 0;
    CommandLine line;
};

/// Without arguments it is Launch, where that can be, or Help.
ParsedLine parse_command_line(int argc, char** argv, bool can_launch);

}  // namespace cairn::player
