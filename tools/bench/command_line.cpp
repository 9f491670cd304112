// CLI11 does the parsing; names and numbers are checked here, so that errors say what would have been right.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "program.h"
#include "text.h"

namespace cairn::bench {
namespace {

using measure::number_of;
using physics::Error;
using physics::Result;
using physics::SimdLevel;

constexpr int kMostThreads = 8;
constexpr int kMostRepeats = 1000;

/// The options as they were typed.
struct Texts {
    std::vector<std::string> scenes;
    std::string threads = "1";
    std::string simd;
    std::string repeat = "1";
    std::string steps = "0";
};

Result<SimdLevel> simd_of(const std::string& text) {
    const std::vector<SimdLevel> available = physics::available_simd_levels();
    if (text.empty()) return available.back();
    std::string names;
    for (const SimdLevel level : available) {
        if (name(level) == text) return level;
        names += (names.empty() ? "" : ", ") + std::string(name(level));
    }
    return Error{"--simd is \"" + text + "\", but must be one of " + names};
}

bool matches(const Scene& scene, const std::string& wanted) {
    return scene.name == wanted || wanted == "all";
}

/// In the order in which they were named; "all" stands for every one that the command can use.
Result<std::vector<const Scene*>> scenes_of(const std::vector<std::string>& names, Command command) {
    std::vector<const Scene*> found;
    for (const std::string& wanted : names) {
        bool known = false;
        for (const Scene& scene : all_scenes()) {
            if (!matches(scene, wanted)) continue;
            known = true;
            if (command == Command::Compare && !scene.for_every_engine) {
                if (wanted == "all") continue;
                return Error{"scene \"" + wanted + "\" uses what other engines lack, and cannot be compared"};
            }
            if (std::find(found.begin(), found.end(), &scene) == found.end()) found.push_back(&scene);
        }
        if (!known) return Error{"there is no scene \"" + wanted + "\"; cairn-bench list names them all"};
    }
    return found;
}

Result<CommandLine> read(Command command, const Texts& texts, std::string json) {
    CommandLine line;
    line.command = command;
    line.json = std::move(json);
    const auto threads = number_of("--threads", texts.threads, 1, kMostThreads);
    if (!threads) return threads.error();
    const auto repeat = number_of("--repeat", texts.repeat, 1, kMostRepeats);
    if (!repeat) return repeat.error();
    const auto steps = number_of("--steps", texts.steps, 0, 1000000);
    if (!steps) return steps.error();
    const auto simd = simd_of(texts.simd);
    if (!simd) return simd.error();
    const auto scenes = scenes_of(texts.scenes, command);
    if (!scenes) return scenes.error();
    line.threads = *threads;
    line.repeat = *repeat;
    line.most_steps = *steps;
    line.simd = *simd;
    line.scenes = *scenes;
    return line;
}

void add_options(CLI::App& command, Texts& texts, std::string& json) {
    command.add_option("--threads", texts.threads, "of Cairn, 1 to 8 (1)")->type_name("N");
    command.add_option("--simd", texts.simd, "level that Cairn may use (the best there is)")
        ->type_name("LEVEL");
    command.add_option("--repeat", texts.repeat, "runs of each scene, in turns; the fastest counts (1)")
        ->type_name("R");
    command.add_option("--steps", texts.steps, "cut scenes short after N steps (0: do not)")->type_name("N");
    command.add_option("--json", json, "one object a line to FILE, or to standard output")
        ->type_name("FILE|-");
}

}  // namespace

Result<CommandLine> parse_command_line(const std::vector<std::string>& arguments, std::string& help) {
    Texts texts;
    std::string json;
    CLI::App app("Measures Cairn's physics on fixed scenes.", "cairn-bench");
    CLI::App* list = app.add_subcommand("list", "name the scenes");
    CLI::App* run = app.add_subcommand("run", "measure scenes");
    run->add_option("SCENE", texts.scenes, "scenes of the list, or \"all\"")->required();
    add_options(*run, texts, json);
    bool warm = false;
    run->add_flag("--warm", warm, "also count allocations of a run in a world that ran the scene before");
    CLI::App* compare = app.add_subcommand("compare", "measure scenes on other engines too, in turns");
    compare->add_option("SCENE", texts.scenes, "scenes that every engine can run (all of those)");
    add_options(*compare, texts, json);

    CLI::App* state = app.add_subcommand("state", "measure snapshots: size, saving, restoring, rollback");
    state->add_option("--repeat", texts.repeat, "rounds; the least counts (100)")->type_name("R");
    CLI::App* lua = app.add_subcommand("lua", "measure what calls from Lua cost");
    lua->add_option("--json", json, "one object a line to FILE, or to standard output")->type_name("FILE|-");

    const auto has_command = measure::read_arguments(app, arguments, help);
    if (!has_command) return has_command.error();
    if (!*has_command) return CommandLine{};
    if (list->parsed()) return CommandLine{.command = Command::List};
    if (lua->parsed()) return CommandLine{.command = Command::Lua, .json = json};
    if (run->parsed()) {
        Result<CommandLine> line = read(Command::Run, texts, json);
        if (line) line->warm = warm;
        return line;
    }
    if (state->parsed()) {
        // The first rounds make room, which later ones have.
        if (state->count("--repeat") == 0) texts.repeat = "100";
        return read(Command::State, texts, json);
    }
    if (texts.scenes.empty()) texts.scenes = {"all"};
    return read(Command::Compare, texts, json);
}

}  // namespace cairn::bench
