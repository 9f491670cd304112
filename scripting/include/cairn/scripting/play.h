// Plays a game: in a window, or headlessly and as fast as the machine can.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cairn::scripting {

/// Where a game is and what it may see. Paths are those of the operating system.
struct GameSource {
    std::string program_path;         ///< argv[0]
    std::string path;                 ///< a folder with main.lua, or a .lua file
    std::string name;                 ///< what recordings call the game
    std::vector<std::string> assets;  ///< folders and archives that every game sees
    std::string save_root;            ///< holds the save folders; empty: the user's data folder
};

/// What the game reported last with cairn.result.
struct PlayResult {
    std::string outcome;  ///< empty: nothing was reported
    std::optional<std::string> level;
};

struct PlayOptions {
    GameSource source;
    bool headless = false;
    std::optional<std::uint64_t>
        frames;  ///< end after so many updates; headless default: kDefaultHeadlessFrames
    std::optional<std::uint64_t> seed;  ///< of the gameplay stream; default: 1 headless, else by the clock
    std::string record;                 ///< file to write the run to; empty: none
    std::string replay;                 ///< file to take the input from; empty: none
    std::string screenshot;             ///< PNG file to write; empty: none
    std::optional<std::uint64_t> screenshot_frame;  ///< default: the last one
    /// File to film the run to, with ffmpeg, a frame for each update; empty: none. Then there is no window.
    std::string video;
    bool print_hash = false;
    bool print_timings = false;            ///< what frames took, the slowest too
    std::vector<std::string> shown_tools;  ///< "help", "debug": open from the start
    std::vector<std::string> arguments;    ///< for cairn.load
    PlayResult* result = nullptr;          ///< takes what the game reports, instead of standard output
};

/// Ten seconds of game time.
inline constexpr std::uint64_t kDefaultHeadlessFrames = 600;

/// What is added to the number of a signal in the exit status of a program that it ended, as shells do.
inline constexpr int kSignalStatus = 128;

/// Returns the exit status: 0 when the game ran to its end without an error, kSignalStatus + SIGTERM or
/// SIGINT when such a signal ended its window. Results go to standard output, errors to standard error.
int play(const PlayOptions& options);

}  // namespace cairn::scripting
