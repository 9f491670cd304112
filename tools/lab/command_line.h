// The commands and options of cairn-lab, and what to say about wrong ones.
#pragma once

#include <string>
#include <vector>

#include <cairn/physics/result.h>

#include "accuracy/problem.h"
#include "scene.h"
#include "torture/case.h"

namespace cairn::lab {

enum class Command { Help, List, Torture, Accuracy, Cost, Determinism };

struct CommandLine {
    Command command = Command::Help;
    std::vector<const Case*> cases;
    std::vector<const Problem*> problems;
    std::vector<const bench::Scene*> scenes;
    std::vector<std::string> features;  ///< of the physics, as tools/lab/cost knows them
    int steps = 0;                      ///< of scenes, at most; 0: as many as they have
    int nudged_step = -1;  ///< before which a body is nudged, to see whether it is noticed; -1: never
    bool peers = false;
    bool quick = false;
    std::string plot;  ///< a folder for plots, or nothing
    std::string json;  ///< a file, "-" for standard output, or nothing
};

/// Reads the arguments that follow the program's name. For the help, `help` is set to its text.
physics::Result<CommandLine> parse_command_line(const std::vector<std::string>& arguments, std::string& help);

}  // namespace cairn::lab
