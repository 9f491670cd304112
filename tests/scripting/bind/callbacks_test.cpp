// Slips in the names of callbacks.
#include "bind/callbacks.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include <cairn/engine/log.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// What is logged while it lives.
class Log {
  public:
    Log() {
        before_ = engine::set_log_sink(
            [this](engine::LogLevel, std::string_view text) { lines_ += std::string(text) + '\n'; });
    }
    ~Log() { engine::set_log_sink(before_); }
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    [[nodiscard]] const std::string& lines() const { return lines_; }

  private:
    engine::LogSink before_;
    std::string lines_;
};

std::string hints_of(const std::string& main) {
    const Log log;
    LuaBench bench(GameFiles{{"main.lua", main}});
    const auto error = bench.game().load("main.lua", {});
    CHECK(!error);
    return log.lines();
}

}  // namespace

TEST_CASE("a slip in the name of a callback is told once, with the name that was meant") {
    CHECK(hints_of("function cairn.udpate() end") ==
          "cairn.udpate is never called: there is no such callback; did you mean \"update\"?\n");
    CHECK(
        hints_of(
            "function cairn.load() function cairn.keypressed() end function cairn.mousePressed() end end") ==
        "cairn.keypressed is never called: there is no such callback; did you mean \"key_pressed\"?\n"
        "cairn.mousePressed is never called: there is no such callback; did you mean \"mouse_pressed\"?\n");
    CHECK(hints_of("local s = { udate = function() end }\ncairn.scene.push(s) cairn.scene.pop() "
                   "cairn.scene.push(s)") ==
          "the scene's udate is never called: there is no such callback; did you mean \"update\"?\n");
    CHECK(hints_of("function cairn.quit() end") ==
          "cairn.quit is a function of Cairn, which the game has replaced\n");
}

TEST_CASE("functions of a game's own and good callbacks are no slips") {
    CHECK(
        hints_of(
            "function cairn.load() end function cairn.update() end function cairn.draw() end\n"
            "cairn.helper = function() end cairn.update_enemies = print cairn.levels = {}\n"
            "cairn.scene.push{ update = function() end, enter = function() end, leave = function() end }") ==
        "");
    for (const Callback& callback : callbacks()) CHECK(meant_callback(callback.name).empty());
}

}  // namespace cairn::scripting::test
