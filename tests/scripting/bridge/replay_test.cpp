#include "bridge/replay.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "support/source_path.h"

namespace cairn::scripting {
namespace {

using engine::InputKind;

Replay sample() {
    return {.game = "two words",
            .seed = 0xffffffffffffffffu,
            .size = {640, 360},
            .frames = 100,
            .hash = 0x0123456789abcdefu,
            .events = {{1, {.kind = InputKind::KeyPressed, .key = engine::Key::Space, .is_repeat = true}},
                       {1,
                        {.kind = InputKind::MousePressed,
                         .button = engine::MouseButton::Right,
                         .position = {0.1f, 200}}},
                       {50, {.kind = InputKind::TextEntered, .text = "a b\n%"}},
                       {100, {.kind = InputKind::FocusLost}}}};
}

TEST_CASE("a replay written and read is the same") {
    const auto read = parse_replay(to_text(sample()), "r");
    if (!read) FAIL(read.error().message);
    CHECK(*read == sample());
    Replay bare = sample();
    bare.hash.reset();
    bare.events.clear();
    const auto read_bare = parse_replay(to_text(bare), "r");
    REQUIRE(read_bare);
    CHECK(*read_bare == bare);
}

TEST_CASE("replays may hold comments, blank lines and the line ends of Windows") {
    const auto read = parse_replay(
        "cairn-replay 1\r\n# by hand\r\ngame g\r\n\r\nframes 9\r\nsize 1 2\r\nseed 3\r\nevents\r\n"
        "2 key_pressed space\r\n# end\r\n",
        "r");
    if (!read) FAIL(read.error().message);
    CHECK(read->events.size() == 1);
    CHECK(read->seed == 3);
}

TEST_CASE("every fault is named with its line") {
    const std::string head = "cairn-replay 1\ngame g\nseed 1\nsize 10 10\nframes 5\n";
    const auto error_of = [](const std::string& text) {
        const auto read = parse_replay(text, "r.replay");
        return read ? std::string() : read.error().message;
    };
    CHECK(error_of("").find("r.replay:1: this is no recording") == 0);
    CHECK(error_of("cairn-replay 2\n").find("expected \"cairn-replay 1\"") != std::string::npos);
    CHECK(error_of(head) == "r.replay:5: the file ends before the line \"events\"");
    CHECK(error_of("cairn-replay 1\nseed 1\nsize 1 1\nframes 1\nevents\n").find("\"game ...\" is missing") !=
          std::string::npos);
    CHECK(error_of("cairn-replay 1\nseed x\n") ==
          "r.replay:2: \"seed\" needs a whole number, at least 0, found \"x\"");
    CHECK(error_of(head + "hash 12\nevents\n") ==
          "r.replay:6: \"hash\" needs 16 hexadecimal digits, found \"12\"");
    CHECK(error_of(head + "speed 3\n").find("r.replay:6: unknown line \"speed\"") == 0);
    CHECK(error_of("cairn-replay 1\nsize 0 5\n").find("r.replay:2: \"size\" needs") == 0);
    CHECK(error_of(head + "events\nx key_pressed a\n").find("r.replay:7: an event begins with the number") ==
          0);
    CHECK(error_of(head + "events\n6 key_pressed a\n") ==
          "r.replay:7: frame 6 is not in 1 to 5, the frames of this recording");
    CHECK(error_of(head + "events\n3 key_pressed a\n2 key_pressed a\n") ==
          "r.replay:8: frame 2 comes after frame 3; events must be in order");
    CHECK(error_of(head + "events\n3 key_presed a\n").find("r.replay:7: ") == 0);
    CHECK(error_of(head + "events\n3\n").find("r.replay:7: ") == 0);
}

TEST_CASE("the reference names every kind of event") {
    std::ostringstream reference;
    reference << std::ifstream(cairn::test::source_path("docs/reference/replays.md")).rdbuf();
    REQUIRE(reference.str() != "");
    for (int kind = 0; kind < engine::kInputKindCount; ++kind) {
        const std::string name(engine::input_kind_name(static_cast<engine::InputKind>(kind)));
        INFO(name);
        CHECK(reference.str().find('`' + name) != std::string::npos);
    }
}

}  // namespace
}  // namespace cairn::scripting
