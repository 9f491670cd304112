// What programs that measure have in common: how they read their arguments, where they write, how they fail.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cairn/physics/result.h>

#include "engine.h"
#include "output.h"

namespace CLI {
class App;
}

namespace cairn::measure {

class Program {
  public:
    constexpr explicit Program(const char* name) : name_(name) {}

    /// Says why, on standard error. The result is the exit status, 1.
    [[nodiscard]] int fail(const std::string& message) const;
    /// The status of the work, or that of a failure to write.
    [[nodiscard]] int with_output(const std::string& json, const std::function<int(Output&)>& work) const;
    /// The last thing a program does.
    [[nodiscard]] int end(int status) const;

  private:
    const char* name_;
};

/// True when a command was given; else `help` is the text to show. The footer and the rule that there is at
/// most one command are added here.
physics::Result<bool> read_arguments(CLI::App& app, const std::vector<std::string>& arguments,
                                     std::string& help);

/// Cairn, and the peers that were asked for. Tells which of them are missing.
std::vector<EngineKind> engines(bool with_peers, Output& output);

}  // namespace cairn::measure
