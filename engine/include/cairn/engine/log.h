// One line of text from the engine to whoever watches: standard error, unless a sink takes it.
// Invariant: the sink is called on the thread that logs, with one line and no trailing newline.
#pragma once

#include <functional>
#include <string_view>

namespace cairn::engine {

enum class LogLevel { Debug, Info, Warning, Error };

using LogSink = std::function<void(LogLevel level, std::string_view text)>;

/// "debug", "info", "warning" or "error".
std::string_view log_level_name(LogLevel level);

/// Without a sink, Debug lines are dropped and the others go to standard error as "cairn: warning: text".
void log(LogLevel level, std::string_view text);

/// Replaces where lines go and returns the sink that was there before; an empty sink restores standard error.
LogSink set_log_sink(LogSink sink);

}  // namespace cairn::engine
