// Runs the tests of a game: each tests/*.lua with cairn.test.
#pragma once

#include <string>

#include <cairn/scripting/play.h>

namespace cairn::scripting {

struct TestOptions {
    std::string junit;  ///< file to write the results to, in JUnit's XML; empty: none
    /// Pictures that tests compare with are written anew instead.
    bool approves_pictures = false;
    /// Folder for pictures that are not as they should be, and for what differs; empty: cairn-differences in
    /// the system's folder for temporary files.
    std::string differences;
};

/// Prints one line per test. Returns the exit status: 0 when there are tests and all pass.
int test_game(const GameSource& source, const TestOptions& options = {});

}  // namespace cairn::scripting
