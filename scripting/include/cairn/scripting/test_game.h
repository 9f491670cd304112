// Runs the tests of a game: each tests/*.lua with cairn.test.
#pragma once

#include <cairn/scripting/play.h>

namespace cairn::scripting {

/// Prints one line per test. Returns the exit status: 0 when there are tests and all pass.
int test_game(const GameSource& source);

}  // namespace cairn::scripting
