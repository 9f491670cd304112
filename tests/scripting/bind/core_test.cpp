#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("sorted_pairs visits numbers, strings, false and true in order") {
    LuaBench bench;
    REQUIRE(bench.run(
                "order = '' for k, v in cairn.sorted_pairs{ b = 2, a = 1, [10] = 10, [2] = 2, [1.5] = 1.5, "
                "[true] = 't', "
                "[false] = 'f', B = 0 } do order = order .. tostring(k) .. '=' .. tostring(v) .. ' ' end") ==
            "");
    CHECK(bench.value("order") == "1.5=1.5 2=2 10=10 B=0 a=1 b=2 false=f true=t ");
}

TEST_CASE("sorted_pairs passes over what the loop removes and refuses keys without an order") {
    LuaBench bench;
    REQUIRE(bench.run("t = { a = 1, b = 2, c = 3 } seen = '' for k in cairn.sorted_pairs(t) do seen = seen "
                      ".. k t.b = nil end") == "");
    CHECK(bench.value("seen") == "ac");
    CHECK(bench.run("for k in cairn.sorted_pairs{ [{}] = 1 } do end").find("a key is a table") !=
          std::string::npos);
    CHECK(bench.run("for k in cairn.sorted_pairs{} do error('none') end") == "");
}

TEST_CASE("a result is reported with what is known") {
    LuaBench bench;
    CHECK_FALSE(bench.game().result());
    REQUIRE(bench.run("cairn.result{ outcome = 'lost' }") == "");
    REQUIRE(bench.game().result());
    CHECK(bench.game().result()->outcome == "lost");
    CHECK_FALSE(bench.game().result()->stars);
    REQUIRE(bench.run("cairn.result{ outcome = 'won', level = 'one', score = 10.5, stars = 3 }") == "");
    CHECK(*bench.game().result()->stars == 3);
    CHECK(*bench.game().result()->score == 10.5);
    CHECK(bench.run("cairn.result{ score = 1 }").find("outcome is missing") != std::string::npos);
}

TEST_CASE("cairn.test is only there in tests") {
    LuaBench bench;
    CHECK(bench.value("cairn.test") == "nil");
}

}  // namespace
}  // namespace cairn::scripting::test
