// Springs against the poles of the damped oscillator, as they come out of whole worlds.
#include "resolve/joints/exact_spring.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"

namespace cairn::physics {
namespace {

using namespace test;

struct Fitted {
    double frequency_hz;
    double damping_ratio;
};

// From samples of a free oscillation: x[n+1] = p x[n] - r x[n-1] for all n, by least squares; the poles of
// this recurrence are those of the oscillator.
Fitted fit(const std::vector<double>& x, double dt) {
    double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
    for (std::size_t n = 1; n + 1 < x.size(); ++n) {
        aa += x[n] * x[n];
        ab -= x[n] * x[n - 1];
        bb += x[n - 1] * x[n - 1];
        ac += x[n] * x[n + 1];
        bc -= x[n - 1] * x[n + 1];
    }
    const double determinant = aa * bb - ab * ab;
    const double p = (ac * bb - bc * ab) / determinant;
    const double r = (aa * bc - ab * ac) / determinant;
    const std::complex<double> pole = p / 2 + std::sqrt(std::complex<double>(p * p / 4 - r));
    const std::complex<double> rate = std::log(pole) / dt;
    const double w = std::abs(rate);
    return {w / (2 * kPiD), -rate.real() / w};
}

// A ball on a spring of 2 m that starts 0.1 m away from rest, without gravity.
std::vector<double> swing(float frequency_hz, float damping_ratio, float speed_m_s = 0) {
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    const BodyId hook = world.create_body({.type = BodyType::Static}).value();
    const BodyId ball =
        add(world, {.position_m = {0, -2.1}, .linear_velocity_m_s = {0, -speed_m_s}}, Circle{{}, 0.25f});
    world
        .create_joint(DistanceJointDef{.body_a = hook,
                                       .body_b = ball,
                                       .length_m = 2,
                                       .enable_spring = true,
                                       .frequency_hz = frequency_hz,
                                       .damping_ratio = damping_ratio})
        .value();
    std::vector<double> x;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        x.push_back(-2 - world.body(ball)->position().y);
    }
    return x;
}

}  // namespace

TEST_CASE("a spring has its frequency to 0.1 % and its damping ratio to 0.005, from 0.5 to 20 Hz") {
    for (const float frequency : {0.5f, 1.0f, 2.0f, 5.0f, 10.0f, 20.0f}) {
        for (const float ratio : {0.0f, 0.05f, 0.2f, 0.5f}) {
            // At 20 Hz and strong damping nothing is left after a few samples.
            std::vector<double> x = swing(frequency, ratio);
            std::size_t seen = 0;
            while (seen < x.size() && std::fabs(x[seen]) > 1e-3) ++seen;
            const double fade = std::exp(-2 * kPiD * d(frequency) * d(ratio) / 60);
            const auto enough = static_cast<std::size_t>(
                fade < 1 ? std::min(120.0, std::max(4.0, std::log(1e-2) / std::log(fade))) : 120.0);
            x.resize(enough);
            const Fitted fitted = fit(x, 1.0 / 60);
            INFO(frequency << " Hz, ratio " << ratio << ", " << enough << " samples");
            CHECK(fitted.frequency_hz == Approx(d(frequency)).epsilon(1e-3));
            CHECK(fitted.damping_ratio == Approx(d(ratio)).margin(5e-3));
        }
    }
}

TEST_CASE("a new spring is from its first step on where the oscillator is that starts as it does") {
    // q(t) = e^(-z w t) (q0 cos wd t + (v0 + z w q0)/wd sin wd t)
    const auto exact = [](double q0, double v0, double w, double z, double t) {
        const double wd = w * std::sqrt(1 - z * z);
        return std::exp(-z * w * t) * (q0 * std::cos(wd * t) + (v0 + z * w * q0) / wd * std::sin(wd * t));
    };
    for (const float frequency : {0.5f, 2.0f, 10.0f, 18.0f}) {
        for (const float ratio : {0.0f, 0.2f, 0.7f}) {
            const double w = 2 * kPiD * d(frequency);
            INFO(frequency << " Hz, damping ratio " << ratio);
            for (const float speed : {0.0f, 0.5f}) {
                const std::vector<double> x = swing(frequency, ratio, speed);
                const double amplitude = std::hypot(0.1, d(speed) / w);
                // What a frequency that is off by 3e-5 adds up to.
                for (int i = 0; i < 30; ++i) {
                    REQUIRE(
                        x[static_cast<std::size_t>(i)] ==
                        Approx(exact(0.1, d(speed), w, d(ratio), (i + 1) / 60.0)).margin(2e-3 * amplitude));
                }
            }
            // Of a pin: it has a lane from its second step on. Or its spring is switched on later.
            for (const JointSolver solver : {JointSolver::Sweeping, JointSolver::Direct}) {
                for (const bool late : {false, true}) {
                    World world({.gravity_m_s2 = {}, .joint_solver = solver, .enable_sleep = false});
                    const BodyId hook = world.create_body({.type = BodyType::Static}).value();
                    const BodyId disc = add(world, {.angle_rad = 0.2}, Circle{{}, 0.25f});
                    const JointId pin = world
                                            .create_joint(RevoluteJointDef{.body_a = hook,
                                                                           .body_b = disc,
                                                                           .enable_spring = !late,
                                                                           .frequency_hz = frequency,
                                                                           .damping_ratio = ratio})
                                            .value();
                    if (late) {
                        step_times(world, 5);
                        world.joint(pin)->set_spring(true, frequency, ratio).value();
                    }
                    INFO((solver == JointSolver::Direct ? "direct" : "swept") << (late ? ", late" : ""));
                    for (int i = 1; i <= 30; ++i) {
                        world.step(kStep_s).value();
                        REQUIRE(world.body(disc)->angle() ==
                                Approx(exact(0.2, 0, w, d(ratio), i / 60.0)).margin(2e-3 * 0.2));
                    }
                }
            }
        }
    }
}

TEST_CASE("a spring of any stiffness sags as far as it should, and stays bounded") {
    // 120 Hz is the Nyquist frequency of the substeps.
    for (const float frequency : {1.0f, 20.0f, 120.0f, 1200.0f, 120000.0f}) {
        for (const float ratio : {0.0f, 0.3f, 1.0f, 3.0f}) {
            World world({.enable_sleep = false});
            const BodyId hook = world.create_body({.type = BodyType::Static}).value();
            const double w = 2 * kPiD * d(frequency);
            const double sag = 10 / (w * w);
            const BodyId ball = add(world, {.position_m = {0, -2 - sag}}, Circle{{}, 0.25f});
            world
                .create_joint(DistanceJointDef{.body_a = hook,
                                               .body_b = ball,
                                               .length_m = 2,
                                               .enable_spring = true,
                                               .frequency_hz = frequency,
                                               .damping_ratio = ratio})
                .value();
            double mean = 0;
            for (int i = 0; i < 600; ++i) {
                world.step(kStep_s).value();
                const double x = -2 - world.body(ball)->position().y;
                REQUIRE(std::fabs(x) < 2 * sag + 1e-5);
                mean += x / 600;
            }
            INFO(frequency << " Hz, ratio " << ratio);
            CHECK(mean == Approx(sag).epsilon(0.02).margin(2e-6));
        }
    }
}

TEST_CASE("springs in series swing as the chain that they are") {
    // Fixed, n balls, free: w_k = 2 w sin((2k - 1) pi / (4n + 2)) of equal masses and springs of stiffness m
    // w^2.
    constexpr int kBalls = 5;
    World world({.gravity_m_s2 = {}, .enable_sleep = false});
    BodyId last = world.create_body({.type = BodyType::Static}).value();
    const double lowest = kPiD / (4 * kBalls + 2);
    const double w = 2 * kPiD * 5;
    std::vector<BodyId> balls;
    for (int i = 1; i <= kBalls; ++i) {
        // The lowest mode.
        const double away = 0.1 * std::sin(2 * lowest * i);
        const BodyId ball = add(world, {.position_m = {0, -i - away}}, Circle{{}, 0.25f});
        // The frequency is that of the pair; between two equal balls the effective mass is half of one.
        const float hz = i == 1 ? 5.0f : 5.0f * std::sqrt(2.0f);
        world
            .create_joint(DistanceJointDef{
                .body_a = last, .body_b = ball, .length_m = 1, .enable_spring = true, .frequency_hz = hz})
            .value();
        balls.push_back(ball);
        last = ball;
    }
    std::vector<double> x;
    for (int i = 0; i < 240; ++i) {
        world.step(kStep_s).value();
        x.push_back(-kBalls - world.body(balls.back())->position().y);
    }
    CHECK(fit(x, 1.0 / 60).frequency_hz == Approx(2 * w * std::sin(lowest) / (2 * kPiD)).epsilon(5e-3));
}

}  // namespace cairn::physics
