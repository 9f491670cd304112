// Where log lines go. Invariant: without a sink a line is written by one call, so that lines of two threads
// do not mix.
#include <cstdio>
#include <string>
#include <utility>

#include <cairn/engine/log.h>
#include <cairn/engine/printable.h>

namespace cairn::engine {
namespace {

LogSink& current_sink() {
    static LogSink sink;
    return sink;
}

}  // namespace

std::string_view log_level_name(LogLevel level) {
    switch (level) {
        case LogLevel::Debug:
            return "debug";
        case LogLevel::Info:
            return "info";
        case LogLevel::Warning:
            return "warning";
        case LogLevel::Error:
            return "error";
    }
    return "";
}

void log(LogLevel level, std::string_view text) {
    if (const LogSink& sink = current_sink()) {
        sink(level, text);
        return;
    }
    if (level == LogLevel::Debug) return;
    std::string line = "cairn: ";
    line.append(log_level_name(level)).append(": ").append(printable(text)).append("\n");
    std::fwrite(line.data(), 1, line.size(), stderr);
}

LogSink set_log_sink(LogSink sink) {
    return std::exchange(current_sink(), std::move(sink));
}

}  // namespace cairn::engine
