// The fixed step against exact counts: a step of 1/64 s is a power of two, so sums of time are exact.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include <cairn/engine/fixed_step.h>

using cairn::engine::FixedStep;

namespace {
constexpr double kStep_s = 1.0 / 64;
}

TEST_CASE("FixedStep runs one update per step of time that has passed") {
    FixedStep loop(kStep_s);
    CHECK(loop.advance(kStep_s).updates == 1);
    CHECK(loop.advance(3 * kStep_s).updates == 3);
    CHECK(loop.advance(0).updates == 0);
}

TEST_CASE("FixedStep keeps the time that is left over") {
    FixedStep loop(kStep_s);
    CHECK(loop.advance(0.75 * kStep_s).updates == 0);
    const FixedStep::Frame frame = loop.advance(0.75 * kStep_s);
    CHECK(frame.updates == 1);
    CHECK(frame.alpha == 0.5);
}

TEST_CASE("FixedStep makes sixty updates of a second, however it is divided into frames") {
    for (const int frames : {24, 37, 50, 60, 75, 144, 240, 1000}) {
        FixedStep loop;
        int updates = 0;
        double least_alpha = 1;
        double largest_alpha = 0;
        // Half a step more than 10 s, so that rounding cannot move the last update out of the time.
        const double total_s = 10 + 0.5 / 60;
        for (int i = 0; i < 10 * frames; ++i) {
            const FixedStep::Frame frame = loop.advance(total_s / (10 * frames));
            updates += frame.updates;
            least_alpha = std::min(least_alpha, frame.alpha);
            largest_alpha = std::max(largest_alpha, frame.alpha);
        }
        INFO(frames << " frames per second");
        CHECK(updates == 600);
        CHECK(least_alpha >= 0);
        CHECK(largest_alpha < 1);
    }
}

TEST_CASE("FixedStep gives up time beyond the cap instead of chasing it") {
    FixedStep loop(kStep_s, 4);
    const FixedStep::Frame late = loop.advance(100 * kStep_s);
    CHECK(late.updates == 4);
    CHECK(late.alpha == 0);
    CHECK(loop.advance(kStep_s).updates == 1);
}

TEST_CASE("FixedStep takes a time that makes no sense as no time") {
    FixedStep loop(kStep_s);
    CHECK(loop.advance(-1).updates == 0);
    CHECK(loop.advance(std::numeric_limits<double>::quiet_NaN()).updates == 0);
    CHECK(loop.advance(std::numeric_limits<double>::infinity()).updates == 0);
    CHECK(loop.advance(kStep_s).updates == 1);
}

TEST_CASE("FixedStep forgets the rest on reset, and a headless frame is one whole update") {
    FixedStep loop(kStep_s);
    (void)loop.advance(0.75 * kStep_s);
    loop.reset();
    CHECK(loop.advance(0.75 * kStep_s).updates == 0);
    CHECK(FixedStep::exactly_one().updates == 1);
    CHECK(FixedStep::exactly_one().alpha == 1);
}
