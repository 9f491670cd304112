// Billiards whose course is known, and what they must conserve.
#include "reference/billiards.h"

#include <catch2/catch.hpp>

namespace cairn::lab::reference {

TEST_CASE("a ball that hits another in the middle hands on its whole velocity") {
    std::vector<Ball> balls{{0, 0, 2, 0}, {3, 0, 0, 0}};
    const double time = play(balls, 0.5, 1);
    CHECK(time == Approx(2));  // one second to the hit, and one more as none follows
    CHECK(balls[0].x_m == Approx(2));
    CHECK(balls[0].vx_m_s == 0);
    CHECK(balls[1].x_m == Approx(5));
    CHECK(balls[1].vx_m_s == Approx(2));
}

TEST_CASE("after a hit off the middle, equal balls part at a right angle") {
    std::vector<Ball> balls{{0, 0.3, 2, 0}, {3, 0, 0, 0}};
    play(balls, 0.5, 1);
    CHECK(balls[0].vx_m_s * balls[1].vx_m_s + balls[0].vy_m_s * balls[1].vy_m_s == Approx(0).margin(1e-14));
    CHECK(balls[0].vx_m_s + balls[1].vx_m_s == Approx(2));
    CHECK(balls[0].vy_m_s + balls[1].vy_m_s == Approx(0).margin(1e-14));
}

TEST_CASE("a run of several hits ends half-way to the next") {
    std::vector<Ball> balls{{0, 0, 1, 0}, {2, 0, 0, 0}, {4, 0, 0, 0}, {8, 0, 0, 0}};
    CHECK(play(balls, 0.5, 2) == Approx(1 + 1 + 1.5));  // the third hit would be 3 s later
    CHECK(balls[2].x_m == Approx(5.5));
}

}  // namespace cairn::lab::reference
