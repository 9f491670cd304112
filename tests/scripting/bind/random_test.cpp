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

TEST_CASE("normal numbers have their mean, their deviation and their share within one deviation") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "local n, sum, squares, near = 20000, 0, 0, 0 for i = 1, n do local x = cairn.random.normal(3, "
            "2) "
            "sum = sum + x squares = squares + (x - 3)^2 if math.abs(x - 3) < 2 then near = near + 1 end end "
            "mean, variance, share = sum / n, squares / n, near / n") == "");
    // Within five deviations of each estimate: 2 / sqrt(n) = 0.014, 4 sqrt(2 / n) = 0.04, 0.0033.
    CHECK(std::stod(bench.value("mean")) == Approx(3).margin(0.07));
    CHECK(std::stod(bench.value("variance")) == Approx(4).margin(0.2));
    CHECK(std::stod(bench.value("share")) == Approx(0.6827).margin(0.017));
}

TEST_CASE("shuffling keeps the members and finds every order equally often") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "counts = {} for i = 1, 6000 do local list = { 'a', 'b', 'c' } cairn.random.shuffle(list) local "
            "order = table.concat(list) counts[order] = (counts[order] or 0) + 1 end") == "");
    for (const char* order : {"abc", "acb", "bac", "bca", "cab", "cba"}) {
        INFO(order);
        // 1000 expected, with a deviation of 29.
        CHECK(std::stod(bench.value(std::string("counts.") + order)) == Approx(1000).margin(150));
    }
}

TEST_CASE("choices and chances follow their probabilities") {
    LuaBench bench;
    REQUIRE(bench.run("r = cairn.random.new(5) a, hits = 0, 0 for i = 1, 4000 do if r:choose{ 'a', 'b', 'c', "
                      "'d' } == 'a' "
                      "then a = a + 1 end if cairn.random.chance(0.1) then hits = hits + 1 end end") == "");
    CHECK(std::stod(bench.value("a")) == Approx(1000).margin(140));
    CHECK(std::stod(bench.value("hits")) == Approx(400).margin(95));
    CHECK(bench.value("cairn.random.chance(0)") == "false");
    CHECK(bench.value("cairn.random.chance(1)") == "true");
    CHECK(bench.run("cairn.random.choose{}") == "test.lua:1: cairn.random.choose: the list is empty");
}

TEST_CASE("wrong intervals are errors") {
    LuaBench bench;
    CHECK(bench.run("cairn.random.integer(3, 2)") ==
          "test.lua:1: cairn.random.integer: low is 3 and high is 2; expected low <= high");
    CHECK(bench.run("cairn.random.number(3, 2)").find("and no more than 1.8e308 between them") !=
          std::string::npos);
    CHECK(bench.run("cairn.random.number(0, 1/0)") != "");
    CHECK(bench.run("cairn.random.number(0/0, 1)") != "");
    CHECK(bench.run("math.random(3, 2)") != "");
    CHECK(bench.run("math.randomseed()").find("expected a seed") != std::string::npos);
}

}  // namespace
}  // namespace cairn::scripting::test
