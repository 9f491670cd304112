// The log's sink.
#include <catch2/catch.hpp>
#include <string>

#include <cairn/engine/log.h>

using namespace cairn::engine;

TEST_CASE("a log sink receives the lines until it is replaced") {
    std::string seen;
    const LogSink before = set_log_sink([&](LogLevel level, std::string_view text) {
        seen.append(log_level_name(level)).append(":").append(text).append(";");
    });
    log(LogLevel::Debug, "a");
    log(LogLevel::Error, "b");
    set_log_sink([](LogLevel, std::string_view) {});
    log(LogLevel::Error, "c");
    set_log_sink(before);
    CHECK(seen == "debug:a;error:b;");
}
