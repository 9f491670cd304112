// Recordings of worlds from Lua. The oracle is the hash that each state had when it was recorded.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

const char* const kRecorded = R"(
    w = cairn.physics.new_world{}
    w:add_box{ type = "static", y = -0.5, width = 40, height = 1 }
    ball = w:add_circle{ y = 3, radius = 0.5, restitution = 0.5, data = { name = "ball" } }
    r = cairn.physics.new_recording{ states_between_whole_ones = 7 }
    r:record(w)
    hashes = { w:state_hash() }
    for i = 1, 40 do
        w:step(1 / 60)
        r:record(w)
        hashes[i + 1] = w:state_hash()
    end
)";

TEST_CASE("a recording goes back to any state, bit for bit, and bodies stay who they are") {
    LuaBench bench;
    REQUIRE(bench.run(kRecorded) == "");
    CHECK(bench.value("r:size()") == "41");
    CHECK(bench.run("for _, i in ipairs{ 41, 1, 20, 7, 8, 40 } do r:seek(w, i) assert(w:state_hash() == "
                    "hashes[i]) end") == "");
    CHECK(bench.run("r:seek(w, 12) w:step(1 / 60) assert(w:state_hash() == hashes[13])") == "");
    CHECK(bench.value("ball:is_valid() and w:bodies()[2] == ball and ball.data.name") == "ball");
    REQUIRE(bench.run("ball:destroy() r:seek(w, 5)") == "");
    CHECK(bench.value("w:body_count()") == "2");
    CHECK(bench.value("next(w:bodies()[2].data)") == "nil");
}

TEST_CASE("a recording is saved and loaded as a string, and can take another future") {
    LuaBench bench;
    REQUIRE(bench.run(kRecorded) == "");
    REQUIRE(
        bench.run("text = r:save() copy = cairn.physics.new_recording() copy:load(text) copy:seek(w, 30)") ==
        "");
    CHECK(bench.value("w:state_hash() == hashes[30]") == "true");
    CHECK(bench.value("copy:byte_count() == r:byte_count() and #text >= r:byte_count()") == "true");
    REQUIRE(bench.run("copy:cut(31)") == "");
    CHECK(bench.value("copy:size()") == "30");
    CHECK(bench.run("copy:seek(w, 31)") ==
          "test.lua:1: Recording:seek: index is 31; expected 1 to 30, the number of states");
    CHECK(bench.run("copy:load(text:sub(1, -2))").find("Recording:load: ") != std::string::npos);
    CHECK(bench.value("copy:size()") == "30");
    CHECK(bench.run("cairn.physics.new_recording{ states_between_whole_ones = 0 }")
              .find("states_between_whole_ones = 0: must be from 1 to 10000") != std::string::npos);
}

TEST_CASE("the difference of two snapshots makes one of the other, and of none else") {
    LuaBench bench;
    REQUIRE(bench.run(kRecorded) == "");
    REQUIRE(bench.run("a = w:snapshot().bytes w:step(1 / 60) b = w:snapshot().bytes\n"
                      "d = cairn.physics.make_delta(a, b)") == "");
    CHECK(bench.value("cairn.physics.apply_delta(a, d) == b") == "true");
    CHECK(bench.value("#d < #b") == "true");
    CHECK(bench.run("cairn.physics.apply_delta(b, d)").find("cairn.physics.apply_delta: ") !=
          std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
