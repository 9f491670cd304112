// Springs on the rails of wheel and prismatic joints, at levers: what is held across the spring and the
// spring do not feed each other, and the two swing as mechanics says.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "physics/support/making.h"
#include "resolve/joints/exact_spring.h"

namespace cairn::physics {
namespace {

using namespace test;

using Spring = SpringTone;

// Two boxes of a metre that float and pass through each other, on one rail with a spring at rest.
struct Pair {
    World world{{.gravity_m_s2 = {}, .enable_sleep = false}};
    BodyId a;
    BodyId b;
    JointId joint;

    Pair(bool is_wheel, const Spring& spring, Vec2 at_a, Vec2 at_b, float angle_rad, float density_a)
        : a(box({}, density_a)),
          b(box({static_cast<double>(at_a.x - at_b.x), static_cast<double>(at_a.y - at_b.y)}, 1)) {
        if (is_wheel) {
            joint = world
                        .create_joint(WheelJointDef{.body_a = a,
                                                    .body_b = b,
                                                    .local_anchor_a_m = at_a,
                                                    .local_anchor_b_m = at_b,
                                                    .local_angle_a_rad = angle_rad,
                                                    .frequency_hz = spring.frequency_hz,
                                                    .damping_ratio = spring.damping_ratio})
                        .value();
        } else {
            joint = world
                        .create_joint(PrismaticJointDef{.body_a = a,
                                                        .body_b = b,
                                                        .local_anchor_a_m = at_a,
                                                        .local_anchor_b_m = at_b,
                                                        .local_angle_a_rad = angle_rad,
                                                        .local_angle_b_rad = angle_rad,
                                                        .enable_spring = true,
                                                        .frequency_hz = spring.frequency_hz,
                                                        .damping_ratio = spring.damping_ratio})
                        .value();
        }
    }

    BodyId box(Position position_m, float density) {
        return add(world, {.position_m = position_m}, Box{0.5f, 0.5f},
                   {.density_kg_m2 = density, .filter = {.mask = 0}});
    }

    [[nodiscard]] double kinetic_energy_j() const {
        double sum = 0;
        for (const BodyId id : {a, b}) {
            const auto body = world.body(id);
            const Vec2 v = body->linear_velocity();
            const double w = body->angular_velocity();
            sum += (body->mass() * dot(v, v) + body->mass_data().inertia_kg_m2 * w * w) / 2;
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("a spring on a rail makes no energy at any lever and stiffness") {
    std::mt19937 random(7);
    const auto uniform = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
    };
    for (const bool is_wheel : {false, true}) {
        for (const float frequency_hz : {50.0f, 76.0f, 90.0f, 150.0f, 600.0f, 3'000.0f, 120'000.0f}) {
            for (const float damping_ratio : {0.0f, 0.05f, 0.3f, 1.0f}) {
                // Undamped ones that are resolved may swing for ever, and are left to their poles.
                if (damping_ratio == 0 && frequency_hz < 80) continue;
                for (int draw = 0; draw < 4; ++draw) {
                    const Vec2 at_a{uniform(-1.5f, 1.5f), uniform(-1.5f, 1.5f)};
                    const Vec2 at_b{uniform(-1, 1), uniform(-1, 1)};
                    const float angle_rad = uniform(-3, 3);
                    const float density = std::pow(20.0f, uniform(0, 1));
                    Pair pair(is_wheel, {frequency_hz, damping_ratio}, at_a, at_b, angle_rad, density);
                    for (const BodyId id : {pair.a, pair.b}) {
                        const Vec2 velocity{uniform(-1, 1), uniform(-1, 1)};
                        pair.world.body(id)->set_linear_velocity(velocity).value();
                        pair.world.body(id)->set_angular_velocity(uniform(-1, 1)).value();
                    }
                    const double before = pair.kinetic_energy_j();
                    double most = 0;
                    for (int step = 0; step < 600; ++step) {
                        pair.world.step(1 / 60.0f).value();
                        most = std::max(most, pair.kinetic_energy_j());
                    }
                    CAPTURE(is_wheel, frequency_hz, damping_ratio, draw, before);
                    REQUIRE(most <= 1.001 * before);
                }
            }
        }
    }
}

// A spring of frequency f is k = (2 pi f)^2 / K, with K = J 1/M J^T along it. What is held leaves K' of K to
// answer, so the two swing at f sqrt(K'/K).
TEST_CASE("a spring on a rail swings at a lever as the masses that it moves say") {
    const bool is_wheel = GENERATE(false, true);
    const float f = GENERATE(2.0f, 8.0f);
    constexpr float kDamping = 0.02f;
    const Vec2 at_a{1.2f, 1.1f};
    const Vec2 at_b{0.2f, -0.1f};
    const float angle_rad = 0.1f;
    Pair pair(is_wheel, {f, kDamping}, at_a, at_b, angle_rad, 1);

    const MassData a = pair.world.body(pair.a)->mass_data();
    const MassData b = pair.world.body(pair.b)->mass_data();
    const Vec2 u{std::cos(angle_rad), std::sin(angle_rad)};
    const Vec2 n{-u.y, u.x};
    const double m = 1 / static_cast<double>(a.mass_kg) + 1 / static_cast<double>(b.mass_kg);
    const auto share = [&](Vec2 one, Vec2 other) {
        return static_cast<double>(cross(at_a, one) * cross(at_a, other) / a.inertia_kg_m2 +
                                   cross(at_b, one) * cross(at_b, other) / b.inertia_kg_m2);
    };
    const double k = m + share(u, u);
    const double held = m + share(n, n);
    double answering = k - share(u, n) * share(u, n) / held;
    if (!is_wheel) {  // the angle is held as well: what is left of it and of u when n is taken out
        const auto with_angle = [&](Vec2 one) {
            return static_cast<double>(cross(at_a, one) / a.inertia_kg_m2 +
                                       cross(at_b, one) / b.inertia_kg_m2);
        };
        const double angle = 1 / static_cast<double>(a.inertia_kg_m2) +
                             1 / static_cast<double>(b.inertia_kg_m2) - with_angle(n) * with_angle(n) / held;
        const double both = with_angle(u) - with_angle(n) * share(u, n) / held;
        answering -= both * both / angle;
    }
    const double expected_hz = static_cast<double>(f) * std::sqrt(answering / k);
    REQUIRE(answering < 0.9 * k);

    pair.world.body(pair.b)->set_linear_velocity(0.02f * u).value();
    double first_s = 0;
    double last_s = 0;
    int turns = 0;
    double speed_before = 0;
    for (int step = 0; step < 300; ++step) {
        pair.world.step(1 / 60.0f).value();
        const auto speed_at = [&](BodyId id, Vec2 arm) {
            const auto body = pair.world.body(id);
            return static_cast<double>(dot(body->linear_velocity(), u) +
                                       body->angular_velocity() * cross(arm, u));
        };
        const double speed = speed_at(pair.b, at_b) - speed_at(pair.a, at_a);
        if (step > 0 && (speed > 0) != (speed_before > 0)) {
            const double at_s = (step + speed_before / (speed_before - speed)) / 60;
            if (turns++ == 0) first_s = at_s;
            last_s = at_s;
        }
        speed_before = speed;
    }
    REQUIRE(turns > 10);
    const double measured_hz = (turns - 1) / (2 * (last_s - first_s));
    CAPTURE(is_wheel, f, expected_hz, measured_hz);
    CHECK(measured_hz == Approx(expected_hz).epsilon(0.004));
}

}  // namespace cairn::physics
