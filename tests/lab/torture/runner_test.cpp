// Cases run in processes of their own: what ends one ends nothing else.
#include "torture/runner.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <limits>
#include <unistd.h>

namespace cairn::lab {
namespace {

const EngineKind kCairn = measure::cairn();

Case case_of(std::function<void(Trial&)> run) {
    return {"1", "made up", true, std::move(run)};
}

void fall(Trial& trial) {
    Rig& rig = trial.rig();
    rig.add_ground();
    rig.add({.position_m = {0, 2}}, physics::Box{0.5f, 0.5f});
    rig.run(1);
}

}  // namespace

TEST_CASE("a case whose figures hold has passed, with the same states on any number of threads") {
    const Outcome outcome = run_case(case_of([](Trial& trial) {
                                         fall(trial);
                                         trial.at_most("x", 1, 2);
                                     }),
                                     kCairn);
    CHECK(outcome.passed());
    CHECK(outcome.same_on_threads == true);
    CHECK(outcome.findings.cpu_s > 0);
}

TEST_CASE("a case fails by a figure, by energy from nowhere, and by what is not finite") {
    CHECK_FALSE(run_case(case_of([](Trial& trial) { trial.at_most("x", 3, 2); }), kCairn).passed());
    CHECK_FALSE(run_case(case_of([](Trial& trial) {
                             Rig& rig = trial.rig();
                             const BodyRef ball = rig.add({}, physics::Circle{});
                             rig.step();
                             rig.engine().set_linear_velocity(ball, {9, 0});
                             rig.step();
                         }),
                         kCairn)
                    .passed());
    Outcome outcome;
    CHECK(outcome.passed());
    outcome.findings.finite = false;
    CHECK_FALSE(outcome.passed());
}

TEST_CASE("a case whose states depend on the threads fails") {
    const Outcome outcome = run_case(case_of([runs = 0](Trial& trial) mutable {
                                         Rig& rig = trial.rig();
                                         rig.add({.position_m = {1.0 * runs++, 2}}, physics::Circle{});
                                         rig.run(1);
                                     }),
                                     kCairn);
    CHECK(outcome.same_on_threads == false);
    CHECK_FALSE(outcome.passed());
}

TEST_CASE("a case that crashes or leaves fails, and the next one runs") {
    const Outcome killed = run_case(case_of([](Trial&) { std::raise(SIGKILL); }), kCairn);
    CHECK_FALSE(killed.passed());
    CHECK_THAT(killed.ended_by, Catch::StartsWith("signal: "));
    const Outcome left = run_case(case_of([](Trial&) { _exit(3); }), kCairn);
    CHECK(left.ended_by == "exit status 3");
    CHECK(run_case(case_of(fall), kCairn).passed());
}

TEST_CASE("an outcome comes through the pipe as it went in, with numbers that are none") {
    Outcome outcome;
    outcome.findings.figures = {{"a_m", 0.1 + 0.2, 1e-300, false},
                                {"b", std::numeric_limits<double>::quiet_NaN()}};
    outcome.findings.energy_excess = std::numeric_limits<double>::infinity();
    outcome.findings.finite = false;
    outcome.findings.cpu_s = 1.5;
    outcome.same_on_threads = true;
    const Outcome back = outcome_from(to_text(outcome));
    REQUIRE(back.findings.figures.size() == 2);
    CHECK(back.findings.figures[0].name == "a_m");
    CHECK(back.findings.figures[0].value == 0.1 + 0.2);
    CHECK(back.findings.figures[0].limit == 1e-300);
    CHECK_FALSE(back.findings.figures[0].at_most);
    CHECK(std::isnan(back.findings.figures[1].value));
    CHECK(std::isnan(back.findings.figures[1].limit));
    CHECK_FALSE(back.findings.energy_excess <= 1);
    CHECK_FALSE(back.findings.finite);
    CHECK(back.findings.cpu_s == 1.5);
    CHECK(back.same_on_threads == true);
    CHECK(outcome_from("").ended_by == "an answer that cannot be read");
}

}  // namespace cairn::lab
