// The log's sink.
#include <catch2/catch.hpp>
#include <string>

#include <cairn/engine/log.h>
#include <cairn/engine/printable.h>

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

TEST_CASE("what a terminal would obey or cannot show is escaped, whatever else a text holds") {
    CHECK(printable("a\x1b[31mb\xffz\x7f") == "a\\027[31mb\\255z\\127");
    CHECK(printable("two\nlines\tand \xc3\xa9") == "two\nlines\tand \xc3\xa9");
    CHECK(printable("\xc2\x85") == "\\194\\133");  // a control character of two bytes
}
