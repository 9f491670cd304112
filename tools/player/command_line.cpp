// CLI11 does the parsing; its errors are turned into the program's own words, with the nearest known name.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <cairn/engine/printable.h>
#include <cairn/engine/result.h>
#include <cairn/scripting/reference.h>
#include <cairn/scripting/suggest.h>

namespace cairn::player {
namespace {

/// A whole number that fits, and nothing else: no sign, no blank, no fraction.
std::optional<std::uint64_t> whole_number(std::string_view text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return number;
}

engine::Result<std::uint64_t> number_of(const char* option, const std::string& text) {
    if (const auto number = whole_number(text)) return *number;
    return engine::Error{std::string(option) + " is \"" + text + "\": must be a whole number from 0 to " +
                         std::to_string(std::numeric_limits<std::uint64_t>::max())};
}

/// FILE.png or FILE.png@FRAME; a name may hold an @ of its own.
engine::Result<void> read_screenshot(const std::string& text, scripting::PlayOptions& options) {
    constexpr std::string_view kEnding = ".png";
    std::string_view file = text;
    if (!file.ends_with(kEnding)) {
        const std::size_t at = text.rfind('@');
        if (at != std::string::npos) {
            const auto frame = whole_number(std::string_view(text).substr(at + 1));
            if (!frame || *frame == 0)
                return engine::Error{"--screenshot is \"" + text +
                                     "\": after @ must stand the number of a frame, 1 or more"};
            options.screenshot_frame = *frame;
            file = file.substr(0, at);
        }
    }
    if (!file.ends_with(kEnding) || file.size() == kEnding.size())
        return engine::Error{"--screenshot is \"" + text + "\": the file's name must end in .png"};
    options.screenshot = file;
    return {};
}

/// The options of `cairn play` that are text to CLI11, whose own numbers wrap around silently.
struct PlayTexts {
    std::optional<std::string> frames;
    std::optional<std::string> seed;
    std::optional<std::string> screenshot;
};

engine::Result<void> read_play_options(const PlayTexts& texts, scripting::PlayOptions& options) {
    if (texts.frames) {
        const auto frames = number_of("--frames", *texts.frames);
        if (!frames) return frames.error();
        options.frames = *frames;
    }
    if (texts.seed) {
        if (!options.replay.empty())
            return engine::Error{"--seed is \"" + *texts.seed +
                                 "\": must be left out with --replay, which has its own"};
        const auto seed = number_of("--seed", *texts.seed);
        if (!seed) return seed.error();
        options.seed = *seed;
    }
    if (texts.screenshot) return read_screenshot(*texts.screenshot, options);
    return {};
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(known->get_name());
    }
    return names;
}

/// `cairn help TOPIC`: a command, or a name of the Lua API.
void print_topic(const CLI::App& app, const std::string& topic, ParsedLine& parsed) {
    parsed.is_done = true;
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (known->get_name() == topic) {
            std::fputs(known->help().c_str(), stdout);
            return;
        }
    }
    const auto reference = scripting::reference_of(topic);
    if (reference) {
        std::fputs(reference->c_str(), stdout);
        return;
    }
    std::fprintf(stderr, "cairn: error: %s; see cairn --help for the commands\n",
                 engine::printable(reference.error().message).c_str());
    parsed.status = 1;
}

/// What an unknown word on the command line was probably meant to be.
std::string unknown_word_message(const CLI::App& app, const std::string& word) {
    const CLI::App* command = &app;
    for (const CLI::App* chosen : app.get_subcommands()) command = chosen;
    const std::string where = command == &app ? "cairn" : "cairn " + command->get_name();
    if (!word.empty() && word[0] == '-') {
        return "unknown option \"" + word.substr(0, word.find('=')) + "\" of " + where +
               scripting::suggestion(word.substr(0, word.find('=')), option_names(*command));
    }
    if (command != &app)
        return "unexpected argument \"" + word + "\" of " + where + "; see " + where + " --help";
    return "unknown command \"" + word + "\"" + scripting::suggestion(word, command_names(app));
}

/// How many of the words are the program's own: those before the first -- of `cairn play`, and up to the
/// script of `cairn run`. The others are the game's: CLI11 would look for options in them, and put them in
/// another order.
int own_words(int argc, char** argv) {
    const std::string_view command = argc < 2 ? "" : argv[1];
    const auto is_separator = [](std::string_view word) { return word == "--"; };
    const auto is_script = [](std::string_view word) { return !word.starts_with('-'); };
    if (command == "play") return static_cast<int>(std::find_if(argv + 2, argv + argc, is_separator) - argv);
    if (command != "run") return argc;
    const auto script = std::find_if(argv + 2, argv + argc, is_script);
    return static_cast<int>(std::min(script + 1, argv + argc) - argv);
}

/// The game's words, without the first --, which says only where they begin.
std::vector<std::string> words_behind(int own, int argc, char** argv) {
    std::vector<std::string> words(argv + own, argv + argc);
    const auto separator = std::find(words.begin(), words.end(), "--");
    if (separator != words.end()) words.erase(separator);
    return words;
}

}  // namespace

ParsedLine parse_command_line(int argc, char** argv, bool can_launch) {
    ParsedLine parsed;
    CommandLine& line = parsed.line;
    scripting::PlayOptions& play = line.play;
    PlayTexts texts;
    CLI::App app("Cairn, a 2D game framework with Lua scripting.", "cairn");
    app.footer(
        "cairn alone shows the bundled games; cairn COMMAND --help says more about a command, cairn help "
        "NAME "
        "about a name of the Lua API.");
    app.require_subcommand(0, 1);  // in `cairn help play`, "play" is an argument
    bool wants_version = false;
    app.add_flag("--version", wants_version, "print the version");

    CLI::App* play_command =
        app.add_subcommand("play", "play a game: a folder, a .lua file, or the name of a bundled game");
    play_command
        ->add_option("GAME", line.target, "folder with main.lua, .lua file, or name of a bundled game")
        ->required();
    play_command->add_option("ARGS", line.arguments, "arguments for cairn.load; after --");
    play_command->add_flag("--headless", play.headless, "without window and sound, as fast as possible");
    play_command
        ->add_option("--frames", texts.frames,
                     "end after N updates, or at the first error (headless default: 600)")
        ->type_name("N");
    play_command->add_option("--seed", texts.seed, "of the gameplay random stream (headless default: 1)")
        ->type_name("S");
    play_command
        ->add_option("--record", play.record,
                     "write the run to FILE; it begins without saves, and keeps none")
        ->type_name("FILE");
    play_command->add_option("--replay", play.replay, "take the input from FILE, and end with it")
        ->type_name("FILE");
    play_command
        ->add_option("--screenshot", texts.screenshot, "write a PNG picture of a frame (default: the last)")
        ->type_name("FILE.png[@FRAME]");
    play_command
        ->add_option("--video", play.video, "film the run with ffmpeg, without a window: .mp4, .webm, .gif")
        ->type_name("FILE");
    play_command->add_flag("--hash", play.print_hash, "print the hash of the last state");
    play_command->add_flag("--timings", play.print_timings, "print what frames took on average and at most");
    play_command->add_option("--show", play.shown_tools, "open tools: help, debug, profiler, inspector")
        ->type_name("TOOL,...")
        ->delimiter(',');

    CLI::App* run_command = app.add_subcommand("run", "run a Lua file headlessly");
    run_command->add_option("FILE", line.target, "the .lua file")->required();
    run_command->add_option("ARGS", line.arguments, "the script's own arguments");

    CLI::App* test_command = app.add_subcommand("test", "run the tests of a game: its tests/*.lua");
    test_command->add_option("GAME", line.target, "as for cairn play")->required();
    test_command->add_option("--junit", line.test.junit, "write the results to FILE as JUnit's XML")
        ->type_name("FILE");
    test_command->add_flag("--approve-pictures", line.test.approves_pictures,
                           "write the pictures that tests compare with");
    test_command
        ->add_option("--differences", line.test.differences,
                     "keep pictures that differ in DIR (default: the folder for temporary files)")
        ->type_name("DIR");

    CLI::App* check_command =
        app.add_subcommand("check", "examine a game's levels, scripts and assets; tells every fault");
    check_command->add_option("GAME", line.target, "as for cairn play")->required();

    CLI::App* new_command = app.add_subcommand("new", "start a new game in a folder");
    new_command->add_option("DIR", line.target, "a folder that is empty or does not exist yet")->required();

    CLI::App* help_command = app.add_subcommand("help", "print this help, or the Lua reference");
    bool wants_reference = false;
    bool wants_levels = false;
    bool wants_types = false;
    std::string help_topic;
    help_command->add_option("TOPIC", help_topic,
                             "a command, or a name of the Lua API: world:step, audio, Body, play, density");
    help_command->add_flag("--reference", wants_reference, "print the Lua reference in Markdown");
    help_command->add_flag("--levels", wants_levels, "print the format of levels in Markdown");
    help_command->add_flag("--types", wants_types, "print annotations for the Lua language server");

    const int own = own_words(argc, argv);
    try {
        app.parse(own, argv);
    } catch (const CLI::CallForHelp&) {
        const CLI::App* command = &app;
        for (const CLI::App* chosen : app.get_subcommands()) command = chosen;
        std::fputs(command->help().c_str(), stdout);
        parsed.is_done = true;
        return parsed;
    } catch (const CLI::ExtrasError&) {
        const std::vector<std::string> extras = app.remaining(true);
        std::fprintf(
            stderr, "cairn: error: %s\n",
            engine::printable(unknown_word_message(app, extras.empty() ? std::string() : extras.front()))
                .c_str());
        parsed.is_done = true;
        parsed.status = 1;
        return parsed;
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "cairn: error: %s; see cairn --help\n", engine::printable(error.what()).c_str());
        parsed.is_done = true;
        parsed.status = 1;
        return parsed;
    }
    if (const auto read = read_play_options(texts, play); !read) {
        std::fprintf(stderr, "cairn: error: %s\n", engine::printable(read.error().message).c_str());
        parsed.is_done = true;
        parsed.status = 1;
        return parsed;
    }
    if (argc == 1 && can_launch) line.command = Command::Launch;
    if (wants_version) line.command = Command::Version;
    if (play_command->parsed()) line.command = Command::Play;
    if (run_command->parsed()) line.command = Command::Run;
    for (std::string& word : words_behind(own, argc, argv)) line.arguments.push_back(std::move(word));
    play.arguments = line.arguments;
    if (test_command->parsed()) line.command = Command::Test;
    if (check_command->parsed()) line.command = Command::Check;
    if (new_command->parsed()) line.command = Command::New;
    if (wants_reference) line.command = Command::Reference;
    if (wants_levels) line.command = Command::Levels;
    if (wants_types) line.command = Command::Types;
    if (line.command == Command::Help && help_topic.empty()) std::fputs(app.help().c_str(), stdout);
    if (line.command == Command::Help && !help_topic.empty()) print_topic(app, help_topic, parsed);
    return parsed;
}

}  // namespace cairn::player
