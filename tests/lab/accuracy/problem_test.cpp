// What the problems are made of, and one problem whose errors are known.
#include "accuracy/problem.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

namespace cairn::lab {

TEST_CASE("every problem of the specification is there, with metrics and a scene to time") {
    std::set<int> numbers;
    std::set<std::string> names;
    for (const Problem& problem : all_problems()) {
        CAPTURE(problem.name);
        numbers.insert(problem.number);
        CHECK(names.insert(problem.name).second);
        CHECK(!problem.metrics.empty());
        CHECK(problem.errors);
        CHECK(problem.timed_scene);
        CHECK(problem.timed_s > 0);
    }
    CHECK(numbers == std::set<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 18, 23, 24, 25});
}

TEST_CASE("bisection finds where a statement becomes true") {
    CHECK(bisect(0, 2, 1e-9, [](double x) { return x * x > 2; }) == Approx(std::sqrt(2.0)).epsilon(1e-8));
}

TEST_CASE("the top of a parabola is found between its samples") {
    const auto y = [](double t) { return 3 - 5 * (t - 0.3) * (t - 0.3); };
    CHECK(apex(y(-1), y(0), y(1)) == Approx(3));
    CHECK(apex(1, 1, 1) == 1);
}

TEST_CASE("angles are brought to one turn") {
    CHECK(wrapped(7 * std::numbers::pi) == Approx(std::numbers::pi));
    CHECK(wrapped(-0.5 * std::numbers::pi) == Approx(-0.5 * std::numbers::pi));
    CHECK(wrapped(100 * std::numbers::pi + 0.25) == Approx(0.25));
}

TEST_CASE("the peers' free fall has the error of the Euler method, Cairn's that of single precision") {
    const Problem& ballistic = all_problems().front();
    REQUIRE(ballistic.name == "ballistic");
    CHECK(ballistic.errors({measure::cairn(), 4})[0] < 1e-6);
    for (const EngineKind& kind : measure::peers()) {
        // Velocity first, then position: v dt too far down after one second, of a fall of g / 2.
        CHECK(ballistic.errors({kind, kind.default_effort})[0] == Approx(1.0 / 60).epsilon(0.01));
    }
}

}  // namespace cairn::lab
