// Figures hold or do not, and a trial gathers them from all of its worlds.
#include "torture/case.h"

#include <catch2/catch.hpp>
#include <limits>

namespace cairn::lab {

TEST_CASE("a figure holds on its side of the limit, and one that is no number never does") {
    CHECK(Figure{"x", 1, 1, true}.holds());
    CHECK_FALSE(Figure{"x", 1.1, 1, true}.holds());
    CHECK(Figure{"x", 1, 1, false}.holds());
    CHECK_FALSE(Figure{"x", 0.9, 1, false}.holds());
    CHECK(Figure{"x", 100}.holds());  // a note
    CHECK_FALSE(Figure{"x", std::numeric_limits<double>::quiet_NaN(), 1, true}.holds());
    CHECK_FALSE(Figure{"x", std::numeric_limits<double>::quiet_NaN(), 1, false}.holds());
}

TEST_CASE("the slop of the criteria is 5 mm, and less for what is small") {
    CHECK(slop_m(10) == 0.005);
    CHECK(slop_m(0.001) == Approx(1e-5));
}

TEST_CASE("a trial keeps the worst of all its worlds") {
    Trial trial(measure::cairn(), 1);
    const auto push = [&](float speed_m_s) {
        Rig& rig = trial.rig({.gravity_m_s2 = {0, 0}});
        const BodyRef ball = rig.add({.linear_velocity_m_s = {1, 0}}, physics::Circle{{}, 0.5f});
        rig.step();
        rig.engine().set_linear_velocity(ball, {speed_m_s, 0});
        rig.step();
    };
    push(2);
    push(1);
    trial.note("steps", 4);
    const Findings findings = trial.finish();
    CHECK(findings.energy_excess == Approx(0.75));
    CHECK(findings.finite);
    CHECK(findings.digest != 0);
    REQUIRE(findings.figures.size() == 1);
    CHECK(findings.figures.front().name == "steps");
}

}  // namespace cairn::lab
