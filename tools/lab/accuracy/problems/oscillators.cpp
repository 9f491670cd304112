// Problem 9: springs from soft to far stiffer than a step. Samples of a damped oscillator obey
//   x_{n+1} = 2 e^(-z w h) cos(w_d h) x_n - e^(-2 z w h) x_{n-1};
// the coefficients, fitted to what the engine did (Prony 1795), give its frequency and damping ratio.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "accuracy/problem.h"

namespace cairn::lab {
namespace {

using physics::BodyType;
using physics::Circle;

constexpr double kRest_m = 2;
constexpr double kAmplitude_m = 0.5;
constexpr Vec2 kNoGravity{0, 0};

// w from w h at the default step, whatever the step is.
BodyRef add_oscillator(Rig& rig, double wh, double damping_ratio) {
    const BodyRef wall = rig.add_body({.type = BodyType::Static});
    const BodyRef body = rig.add({.position_m = {kRest_m + kAmplitude_m, 0}}, Circle{{}, 0.5f});
    const double frequency_hz = wh / static_cast<double>(kStep_s) / (2 * std::numbers::pi);
    rig.spring(wall, body, {0, 0}, {kRest_m + kAmplitude_m, 0}, kRest_m, static_cast<float>(frequency_hz),
               static_cast<float>(damping_ratio));
    return body;
}

struct Found {
    double omega_rad_s = 0;
    double damping_ratio = 0;
};

Found fitted(const std::vector<double>& x, double interval_s) {
    double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        aa += x[i] * x[i];
        ab += x[i] * x[i - 1];
        bb += x[i - 1] * x[i - 1];
        ay += x[i] * x[i + 1];
        by += x[i - 1] * x[i + 1];
    }
    const double det = aa * bb - ab * ab;
    const double p = (ay * bb - by * ab) / det, q = (by * aa - ay * ab) / det;
    const std::complex<double> root = 0.5 * (p + std::sqrt(std::complex<double>(p * p + 4 * q)));
    const std::complex<double> pole = std::log(root) / interval_s;
    return {std::abs(pole), -pole.real() / std::abs(pole)};
}

std::vector<double> spring_errors(const Setting& setting) {
    double frequency_error = 0, damping_error = 0, growth = 0;
    const auto worse = [](double& worst, double value) {
        if (!(value <= worst)) worst = value;
    };
    const double dt = setting.dt_s;
    for (const double wh : {1e-3, 1e-2, 0.1, 0.5, 1.0, 1.9}) {
        for (const double ratio : {0.0, 0.1, 0.5}) {
            const double omega = wh / static_cast<double>(kStep_s);
            if (omega * dt >= 2) continue;  // its samples would look like those of a slower one
            const auto rig = rig_of(setting, kNoGravity);
            const BodyRef body = add_oscillator(*rig, wh, ratio);
            // About nine samples a turn, as far as steps allow.
            const int stride = std::max(1, static_cast<int>(0.7 / (omega * dt)));
            std::vector<double> x{kAmplitude_m};
            for (int i = 0; i < 40; ++i) {
                for (int k = 0; k < stride; ++k) rig->step(setting.dt_s);
                x.push_back(rig->motion(body).position_m.x - kRest_m);
                // What has died away tells of rounding only.
                if (std::fabs(x.back()) < 1e-3 * kAmplitude_m && ratio > 0 && x.size() > 6) break;
            }
            const Found found = fitted(x, stride * dt);
            worse(frequency_error, std::fabs(found.omega_rad_s / omega - 1));
            worse(damping_error, std::fabs(found.damping_ratio - ratio));
        }
    }
    for (const double wh : {1.0, 10.0, 100.0, 1000.0}) {
        for (const double ratio : {0.0, 0.5, 1.0}) {
            const auto rig = rig_of(setting, kNoGravity);
            const BodyRef body = add_oscillator(*rig, wh, ratio);
            for (int i = 0; i < 600; ++i) {
                rig->step(setting.dt_s);
                worse(growth, std::fabs(rig->motion(body).position_m.x - kRest_m) / kAmplitude_m - 1);
            }
        }
    }
    return {frequency_error, damping_error, std::max(growth, 0.0)};
}

}  // namespace

void add_oscillators(std::vector<Problem>& problems) {
    problems.push_back(
        {.number = 9,
         .name = "spring",
         .metrics = {{"frequency", "of the frequency"}, {"damping", "ratio"}, {"growth", "of the amplitude"}},
         .errors = spring_errors,
         .timed_s = 10,
         .timed_gravity_m_s2 = kNoGravity,
         .timed_scene = [](Rig& rig) -> BeforeStep { return add_oscillator(rig, 0.5, 0.1), nullptr; }});
}

}  // namespace cairn::lab
