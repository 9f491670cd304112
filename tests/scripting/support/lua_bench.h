// A game made of text, for tests: its files in a folder of its own, headless, with one Lua state.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "bridge/game.h"
#include "bridge/machine.h"

namespace cairn::scripting::test {

/// Paths and contents.
using GameFiles = std::map<std::string, std::string>;

/// A folder that is removed with its contents.
class GameFolder {
  public:
    explicit GameFolder(const GameFiles& files);
    ~GameFolder();
    GameFolder(const GameFolder&) = delete;
    GameFolder& operator=(const GameFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    /// The folder as a game called "bench".
    [[nodiscard]] GameSource source() const;

  private:
    std::string path_;
};

class LuaBench {
  public:
    explicit LuaBench(const GameFiles& files = {}, MachineKind kind = MachineKind::Headless,
                      GameOptions options = {});

    /// Runs a chunk called "test.lua". Gives the error's message, or an empty text.
    std::string run(const std::string& code);
    /// The value of an expression as tostring shows it, or "error: MESSAGE".
    std::string value(const std::string& expression);

    Game& game() { return *game_; }
    Machine& machine() { return *machine_; }

  private:
    GameFolder folder_;
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<Game> game_;
};

}  // namespace cairn::scripting::test
