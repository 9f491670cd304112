#include <catch2/catch.hpp>

#include <cairn/engine/random.h>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("the gameplay stream is that of the seed, and math.random draws from it") {
    LuaBench bench({}, MachineKind::Headless, {.seed = 42});
    engine::Random expected(42);
    CHECK(std::stoll(bench.value("cairn.random.integer(1, 1000000)")) == expected.range(1, 1000000));
    CHECK(std::stoll(bench.value("math.random(1000000)")) == expected.range(1, 1000000));
    CHECK(std::stoll(bench.value("math.random(-5, 5)")) == expected.range(-5, 5));
    CHECK(bench.value("math.random() < 1") == "true");
}

TEST_CASE("seeds repeat, and generators of one's own are apart") {
    LuaBench bench;
    REQUIRE(bench.run("cairn.random.seed(7) a = cairn.random.uniform() math.randomseed(7) "
                      "cairn.random.visual:uniform() r = cairn.random.new(7) c = r:uniform() b = "
                      "cairn.random.uniform()") == "");
    CHECK(bench.value("a == b and a == c") == "true");
    const std::uint64_t hash = bench.game().state_hash();
    REQUIRE(bench.run("cairn.random.visual:number(1, 2) r:integer(1, 6)") == "");
    CHECK(bench.game().state_hash() == hash);
    REQUIRE(bench.run("cairn.random.uniform()") == "");
    CHECK(bench.game().state_hash() != hash);
}

TEST_CASE("wrong intervals are errors") {
    LuaBench bench;
    CHECK(bench.run("cairn.random.integer(3, 2)").find("low is 3 and high is 2; expected low <= high") !=
          std::string::npos);
    CHECK(bench.run("cairn.random.number(0, 1/0)") != "");
    CHECK(bench.run("cairn.random.number(0/0, 1)") != "");
    CHECK(bench.run("math.random(3, 2)") != "");
    CHECK(bench.run("math.randomseed()").find("expected a seed") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
