// Going back, against hashes that were noted on the way.
#include "debug/rewind.h"

#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

/// A heap that falls, with bodies that come and go, and random numbers.
const char* const kHeap = R"(
    w = cairn.physics.new_world{ gravity_y = -10 }
    w:add_box{ type = 'static', y = -1, width = 40, height = 2 }
    boxes = {}
    for i = 1, 12 do
        boxes[i] = w:add_box{ x = 0.2 * i, y = 1.2 * i, width = 1, height = 1, data = { number = i } }
    end
    frames = 0
    function cairn.update(dt)
        frames = frames + 1
        boxes[1 + frames % 12]:apply_impulse_to_center(cairn.random.number(-2, 2), 0)
        if frames == 20 then w:add_circle{ x = -3, y = 5, radius = 0.5 } end
        if frames == 30 then boxes[13] = boxes[12] boxes[12]:destroy() boxes[12] = boxes[1] end
        w:step(dt)
    end)";

struct Past {
    LuaBench bench;
    Rewind rewind;
    std::vector<std::uint64_t> hashes;

    explicit Past(const std::string& more = "") { REQUIRE(bench.run(std::string(kHeap) + more) == ""); }
    void go_on(int updates) {
        for (int i = 0; i < updates; ++i) {
            REQUIRE_FALSE(bench.game().update({}));
            REQUIRE_FALSE(rewind.note(bench.game()));
            hashes.push_back(bench.game().state_hash());
        }
    }
    void go_back() {
        REQUIRE_FALSE(rewind.step_back(bench.game()));
        hashes.pop_back();
    }
};

TEST_CASE("each step back is the state that was, random numbers too, and from there all goes as before") {
    Past past;
    past.go_on(60);
    const std::vector<std::uint64_t> all = past.hashes;
    for (int i = 0; i < 50; ++i) {
        past.go_back();
        CHECK(past.bench.game().state_hash() == past.hashes.back());
    }
    CHECK(past.rewind.steps_back() == 9);
    // The script's own counter was not told to go back.
    CHECK(past.bench.value("frames") == "60");
    REQUIRE(past.bench.run("frames = 10 boxes[12] = boxes[13] or boxes[12]") == "");
    past.go_on(15);
    for (std::size_t i = 0; i < past.hashes.size(); ++i) CHECK(past.hashes[i] == all[i]);
}

TEST_CASE("a body that was destroyed comes back with its data") {
    Past past;
    past.go_on(40);
    REQUIRE(past.bench.run("assert(not boxes[13]:is_valid())") == "");
    for (int i = 0; i < 20; ++i) past.go_back();
    CHECK(past.bench.value("boxes[13]:is_valid()") == "true");
    CHECK(past.bench.value("boxes[13].data.number") == "12");
}

TEST_CASE("a body that the script holds no more comes back with its data, whatever was collected") {
    Past past(
        " function note() local found for _, body in ipairs(w:bodies()) do "
        "if body.data.number == 12 then found = body end end return found end");
    past.go_on(40);
    REQUIRE(past.bench.run("boxes[13] = nil collectgarbage() collectgarbage() assert(not note())") == "");
    for (int i = 0; i < 20; ++i) past.go_back();
    CHECK(past.bench.run("assert(note():is_valid())") == "");
}

TEST_CASE("what the game saves goes back with the worlds") {
    Past past(
        " function cairn.save_state() return { frames = frames } end "
        "function cairn.load_state(state) frames = state.frames end");
    past.go_on(25);
    for (int i = 0; i < 10; ++i) past.go_back();
    CHECK(past.bench.value("frames") == "15");
    const std::vector<std::uint64_t> before = past.hashes;
    past.go_on(1);
    for (int i = 0; i < 1; ++i) past.go_back();
    CHECK(past.hashes == before);
}

TEST_CASE("the past is bounded, and ends where worlds were made or destroyed") {
    Past past;
    past.go_on(60 * Rewind::kMost_s + 20);
    CHECK(past.rewind.steps_back() == 60 * Rewind::kMost_s - 1);
    CHECK(past.rewind.bytes() <= Rewind::kMostBytes);
    REQUIRE(past.bench.run("other = cairn.physics.new_world{}") == "");
    past.go_on(3);
    CHECK(past.rewind.steps_back() == 2);
    for (int i = 0; i < 2; ++i) past.go_back();
    const std::uint64_t first = past.bench.game().state_hash();
    REQUIRE_FALSE(past.rewind.step_back(past.bench.game()));  // there is nothing before
    CHECK(past.bench.game().state_hash() == first);
    REQUIRE(past.bench.run("other:destroy()") == "");
    REQUIRE_FALSE(past.rewind.step_back(past.bench.game()));
    CHECK(past.rewind.steps_back() <= 1);
}

TEST_CASE("a game's faults while it saves or loads are its errors") {
    Past past(
        " function cairn.save_state() if fails then return print end return {} end "
        "function cairn.load_state() error('cannot') end");
    past.go_on(5);
    const auto cannot = past.rewind.step_back(past.bench.game());
    REQUIRE(cannot);
    CHECK(cannot->message.find("cannot") != std::string::npos);
    REQUIRE(past.bench.run("fails = true") == "");
    const auto no_data = past.rewind.note(past.bench.game());
    REQUIRE(no_data);
    CHECK(no_data->message.find("cairn.save_state") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
