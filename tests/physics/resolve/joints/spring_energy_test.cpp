// Undamped springs keep their energy whatever way their bodies turn: they are as stiff in all poses, and what
// they do to two bodies turns these as a whole by nothing. Each spring here has an energy that the test works
// out for itself, from the masses as the bodies stood when it was made.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/precise.h"
#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using namespace test;

enum class Kind { Rod, Weld, StiffWeld, Motor };

struct Pair {
    double x = 0;
    double y = 0;
};
Pair turned(Vec2 v, double angle_rad) {
    return {d(v.x) * std::cos(angle_rad) - d(v.y) * std::sin(angle_rad),
            d(v.x) * std::sin(angle_rad) + d(v.y) * std::cos(angle_rad)};
}

// Undamped, as all of them; anchors in the coordinates of each body.
WeldJointDef weld(Kind kind, float frequency_hz, BodyId a, BodyId b, Vec2 anchor_a, Vec2 anchor_b) {
    return {.body_a = a,
            .body_b = b,
            .local_anchor_a_m = anchor_a,
            .local_anchor_b_m = anchor_b,
            .linear_frequency_hz = frequency_hz,
            .linear_damping_ratio = 0,
            .angular_frequency_hz = kind == Kind::Weld ? frequency_hz : 0,
            .angular_damping_ratio = 0};
}
DistanceJointDef rod(float frequency_hz, BodyId a, BodyId b, Vec2 anchor_a, Vec2 anchor_b, double length_m) {
    return {.body_a = a,
            .body_b = b,
            .local_anchor_a_m = anchor_a,
            .local_anchor_b_m = anchor_b,
            .length_m = static_cast<float>(length_m),
            .enable_spring = true,
            .frequency_hz = frequency_hz};
}

// Two boxes, not alike, with a spring far from their centres.
struct TwoBoxes {
    Kind kind;
    float frequency_hz;
    World world;
    BodyId a, b;
    Vec2 anchor_a{0.7f, 0.4f};
    Vec2 anchor_b{-0.5f, 0.6f};
    double rest_m = 0;  // of the rod
    double k_rod = 0;
    std::array<std::array<double, 2>, 2> stiffness{};  // seen by a
    double k_angle = 0;

    TwoBoxes(Kind kind_, float frequency_hz_, JointSolver solver, AxisLocks locks = {})
        : kind(kind_),
          frequency_hz(frequency_hz_),
          world({.gravity_m_s2 = {}, .joint_solver = solver, .enable_sleep = false}) {
        const ShapeDef ghost{.density_kg_m2 = 2, .filter = {.mask = 0}};
        a = add(world, {.position_m = {-0.7, -0.4}, .linear_velocity_m_s = {-0.4f, 0.2f}, .locks = locks},
                Box{0.5f, 0.2f}, ghost);
        const Position p = kind == Kind::Rod ? Position{1, 0.2} : Position{d(-anchor_b.x), d(-anchor_b.y)};
        b = add(world, {.position_m = p, .linear_velocity_m_s = {0.8f, -0.9f}, .angular_velocity_rad_s = 1},
                Box{0.3f, 0.4f}, ghost);
        rest_m = length();
        make_joint();
        measure();
    }

    void make_joint() {
        if (kind == Kind::Rod) {
            world.create_joint(rod(frequency_hz, a, b, anchor_a, anchor_b, rest_m)).value();
        } else if (kind == Kind::Motor) {
            world
                .create_joint(MotorJointDef{.body_a = a,
                                            .body_b = b,
                                            .local_anchor_b_m = anchor_b,
                                            .target_offset_m = anchor_a,
                                            .linear_frequency_hz = frequency_hz,
                                            .linear_damping_ratio = 0,
                                            .angular_frequency_hz = frequency_hz,
                                            .angular_damping_ratio = 0,
                                            .max_force_n = kUnlimited,
                                            .max_torque_nm = kUnlimited})
                .value();
        } else {
            world.create_joint(weld(kind, frequency_hz, a, b, anchor_a, anchor_b)).value();
        }
    }

    // From anchor a to anchor b, as the world sees it.
    [[nodiscard]] Pair way() const {
        const Pair r_a = turned(anchor_a, world.body(a)->angle());
        const Pair r_b = turned(anchor_b, world.body(b)->angle());
        const Position p = world.body(a)->position();
        const Position q = world.body(b)->position();
        return {q.x + r_b.x - p.x - r_a.x, q.y + r_b.y - p.y - r_a.y};
    }
    [[nodiscard]] double length() const { return std::hypot(way().x, way().y); }
    [[nodiscard]] double mass(BodyId id) const { return d(world.body(id)->mass()); }
    [[nodiscard]] double inertia(BodyId id) const { return d(world.body(id)->mass_data().inertia_kg_m2); }

    // k = w^2/K where the bodies stand now, of both directions as K^-1 w^2.
    void measure() {
        const double square = std::pow(2 * kPiD * d(frequency_hz), 2);
        double xx = 1 / mass(a) + 1 / mass(b);
        double yy = xx;
        double xy = 0;
        const auto lever = [&](BodyId id, Vec2 arm) {
            xx += d(arm.y) * d(arm.y) / inertia(id);
            yy += d(arm.x) * d(arm.x) / inertia(id);
            xy -= d(arm.x) * d(arm.y) / inertia(id);
        };
        lever(a, anchor_a);
        lever(b, anchor_b);
        k_angle = square / (1 / inertia(a) + 1 / inertia(b));
        const double all = xx * yy - xy * xy;
        stiffness = {{{square * yy / all, -square * xy / all}, {-square * xy / all, square * xx / all}}};
        if (kind != Kind::Rod) return;
        const double ux = way().x / length();
        const double uy = way().y / length();
        k_rod = square / (xx * ux * ux + 2 * xy * ux * uy + yy * uy * uy);
    }

    [[nodiscard]] double energy_j() const {
        double sum = kinetic_energy(*world.body(a)) + kinetic_energy(*world.body(b));
        if (kind == Kind::Rod) return sum + k_rod * std::pow(length() - rest_m, 2) / 2;
        const double angle_a = world.body(a)->angle();
        const Pair w = way();
        const Pair q{w.x * std::cos(angle_a) + w.y * std::sin(angle_a),
                     w.y * std::cos(angle_a) - w.x * std::sin(angle_a)};
        sum +=
            (stiffness[0][0] * q.x * q.x + 2 * stiffness[0][1] * q.x * q.y + stiffness[1][1] * q.y * q.y) / 2;
        if (kind == Kind::StiffWeld) return sum;
        return sum + k_angle * std::pow(std::remainder(world.body(b)->angle() - angle_a, 2 * kPiD), 2) / 2;
    }

    // Over ten seconds.
    double mean_j() {
        constexpr int kSteps = 600;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
            world.step(kStep_s).value();
            sum += energy_j();
        }
        return sum / kSteps;
    }

    // About the origin of the world.
    [[nodiscard]] double angular_momentum() const {
        double sum = 0;
        for (const BodyId id : {a, b}) {
            const Body body = *world.body(id);
            const Position p = body.position();
            const Vec2 v = body.linear_velocity();
            sum += mass(id) * (p.x * d(v.y) - p.y * d(v.x)) + inertia(id) * d(body.angular_velocity());
        }
        return sum;
    }
};

// Boxes at random, each joined to one of the others half way between them, or by a rod at arms of a metre.
struct Tangle {
    World world;
    double start_j = 0;

    Tangle(Kind kind, float frequency_hz, JointSolver solver, std::uint64_t seed, bool on_ground = false)
        : world(
              {.gravity_m_s2 = {0, on_ground ? -10.0f : 0}, .joint_solver = solver, .enable_sleep = false}) {
        Random random(seed);
        if (on_ground) add_ground(world);
        std::vector<BodyId> boxes;
        for (int i = 0; i < 7; ++i) {
            const double x = random.real(-2.5, 2.5);
            const double y = random.real(on_ground ? 1 : -2.5, on_ground ? 5 : 2.5);
            const Vec2 v = random.vector(-1, 1);
            const float half_width_m = random.real_f(0.1, 0.4);
            const Box box{half_width_m, random.real_f(0.1, 0.4)};
            const auto density = static_cast<float>(std::exp(random.real(0, 3.5)));
            boxes.push_back(
                add(world, {.position_m = {x, y}, .linear_velocity_m_s = v}, box,
                    {.density_kg_m2 = density, .filter = {.mask = on_ground ? Filter{}.mask : 0}}));
        }
        for (int i = 0; i < 7; ++i) {
            const int other = random.below(7);
            if (other != i)
                join(kind, frequency_hz, boxes[static_cast<std::size_t>(i)],
                     boxes[static_cast<std::size_t>(other)], random);
        }
        start_j = energy_j();
    }

    void join(Kind kind, float frequency_hz, BodyId a, BodyId b, Random& random) {
        const Vec2 way = world.body(b)->position() - world.body(a)->position();
        if (kind == Kind::Rod) {
            const Pair arm_a = turned({1, 0}, random.real(-3, 3));
            const Pair arm_b = turned({1, 0}, random.real(-3, 3));
            const Vec2 r_a{static_cast<float>(arm_a.x), static_cast<float>(arm_a.y)};
            const Vec2 r_b{static_cast<float>(arm_b.x), static_cast<float>(arm_b.y)};
            const double length_m = d(std::max(length(way + r_b - r_a), 0.1f));
            world.create_joint(rod(frequency_hz, a, b, r_a, r_b, length_m)).value();
        } else {
            world.create_joint(weld(kind, frequency_hz, a, b, 0.5f * way, -0.5f * way)).value();
        }
    }

    // Of motion, and of height above the ground.
    [[nodiscard]] double energy_j() const {
        double sum = 0;
        for (const BodyId id : world.bodies()) {
            const Body body = *world.body(id);
            if (body.type() != BodyType::Dynamic) continue;
            sum += kinetic_energy(body) - d(body.mass()) * d(world.gravity().y) * body.position().y;
        }
        return sum;
    }

    [[nodiscard]] double most_j(double time_s) {
        double most = 0;
        const long steps = std::lround(time_s / d(kStep_s));
        for (long i = 0; i < steps; ++i) {
            world.step(kStep_s).value();
            most = std::max(most, energy_j());
        }
        return most;
    }
};

}  // namespace

TEST_CASE("an undamped spring far from the centres of two boxes keeps their energy and momentum") {
    const Kind kind = GENERATE(Kind::Rod, Kind::Weld, Kind::StiffWeld, Kind::Motor);
    const JointSolver solver = GENERATE(JointSolver::Sweeping, JointSolver::Direct);
    const float frequency_hz = GENERATE(0.5f, 2.0f, 5.0f, 10.0f);
    TwoBoxes boxes(kind, frequency_hz, solver);
    const double angular_momentum = boxes.angular_momentum();
    const double first_j = boxes.mean_j();
    step_times(boxes.world, 2400);
    const double last_j = boxes.mean_j();
    CAPTURE(static_cast<int>(kind), static_cast<int>(solver), frequency_hz);
    CHECK(last_j <= 1.02 * first_j);
    // What holds the angle gives, when swept, and damps the spring by as much as a damping ratio of 2e-4
    // does.
    const bool gives = kind == Kind::StiffWeld && solver == JointSolver::Sweeping;
    const double kept = gives ? std::exp(-4 * kPiD * d(frequency_hz) * 2e-4 * 50) : 1;
    CHECK(last_j >= 0.98 * kept * first_j);
    CHECK(boxes.angular_momentum() == Approx(angular_momentum).epsilon(1e-3));
}

TEST_CASE("an undamped spring between boxes of which one is locked along an axis keeps their energy") {
    const Kind kind = GENERATE(Kind::Rod, Kind::Weld);
    const JointSolver solver = GENERATE(JointSolver::Sweeping, JointSolver::Direct);
    const AxisLocks locks = GENERATE(AxisLocks{.x = true}, AxisLocks{.y = true});
    TwoBoxes boxes(kind, 2, solver, locks);
    const double first_j = boxes.mean_j();
    step_times(boxes.world, 2400);
    CAPTURE(static_cast<int>(kind), static_cast<int>(solver), locks.x, locks.y);
    CHECK(boxes.mean_j() == Approx(first_j).epsilon(0.03));
}

// What the anchor feels follows from how the box moves, which does not turn.
TEST_CASE("a weld with springs that holds its angle tells the torque that it bears") {
    const float frequency_hz = GENERATE(2.0f, 5.0f, 20.0f);
    const float damping_ratio = GENERATE(0.0f, 0.05f);
    World world({.gravity_m_s2 = {}, .joint_solver = JointSolver::Sweeping, .enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    const BodyId box =
        add(world, {.position_m = {1, 0.5}, .linear_velocity_m_s = {0.5f, -1}}, Box{0.5f, 0.3f});
    const JointId weld = world
                             .create_joint(WeldJointDef{.body_a = wall,
                                                        .body_b = box,
                                                        .local_anchor_b_m = {-1, -0.5f},
                                                        .linear_frequency_hz = frequency_hz,
                                                        .linear_damping_ratio = damping_ratio})
                             .value();
    const double mass = d(world.body(box)->mass());
    double wrong = 0;
    double all = 0;
    for (int i = 0; i < 600; ++i) {
        const Vec2 before = world.body(box)->linear_velocity();
        world.step(kStep_s).value();
        const Vec2 change = world.body(box)->linear_velocity() - before;
        const double torque_nm = mass * (1 * d(change.y) - 0.5 * d(change.x)) / d(kStep_s);
        wrong += std::pow(d(world.joint(weld)->reaction_torque()) - torque_nm, 2);
        all += torque_nm * torque_nm;
    }
    CAPTURE(frequency_hz, damping_ratio);
    CHECK(std::sqrt(wrong) < 1e-3 * std::sqrt(all));
}

// Along a way on which the principal axes turn over.
TEST_CASE("a motor joint that is led around bears its load evenly") {
    World world({.enable_sleep = false});
    const BodyId wall = world.create_body({.type = BodyType::Static}).value();
    const ShapeDef ghost{.filter = {.mask = 0}};
    const BodyId a = add(world, {}, Box{0.5f, 0.2f}, ghost);
    world.create_joint(WeldJointDef{.body_a = wall, .body_b = a}).value();
    const BodyId b =
        add(world, {.position_m = {0.5, 0}}, Box{0.3f, 0.2f}, {.density_kg_m2 = 5, .filter = {.mask = 0}});
    MotorJointDef def{.body_a = a,
                      .body_b = b,
                      .local_anchor_a_m = {0.3f, 0.1f},
                      .local_anchor_b_m = {-0.5f, 0.05f},
                      .linear_frequency_hz = 20,
                      .linear_damping_ratio = 1,
                      .angular_frequency_hz = 10,
                      .angular_damping_ratio = 1,
                      .max_force_n = kUnlimited,
                      .max_torque_nm = kUnlimited};
    const JointId joint = world.create_joint(def).value();
    Vec2 last;
    for (int i = 0; i < 1800; ++i) {
        def.target_angle_rad = static_cast<float>(3 * std::sin(0.004 * i));
        world.joint(joint)->redefine(def).value();
        world.step(kStep_s).value();
        const Vec2 force = world.joint(joint)->reaction_force();
        CAPTURE(i, def.target_angle_rad);
        if (i > 300) CHECK(length(force - last) < 0.01f * length(force));
        last = force;
    }
}

TEST_CASE("structures on undamped springs at arms of metres give back no more than was put in") {
    const Kind kind = GENERATE(Kind::Rod, Kind::Weld, Kind::StiffWeld);
    const float frequency_hz = GENERATE(2.0f, 10.0f, 25.0f);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Tangle tangle(kind, frequency_hz, JointSolver::Direct, seed);
        CAPTURE(static_cast<int>(kind), frequency_hz, seed);
        CHECK(tangle.most_j(20) <= 1.02 * tangle.start_j);
    }
}

TEST_CASE("structures on undamped springs at arms of metres fall to the ground with what they had") {
    const Kind kind = GENERATE(Kind::Rod, Kind::Weld, Kind::StiffWeld);
    const float frequency_hz = GENERATE(5.0f, 20.0f, 30.0f);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Tangle tangle(kind, frequency_hz, JointSolver::Automatic, seed, true);
        CAPTURE(static_cast<int>(kind), frequency_hz, seed);
        CHECK(tangle.most_j(20) <= 1.02 * tangle.start_j);
    }
}

// k = w^2/K with K = 1/m + r^2/I where the plank was level, and then it hangs.
TEST_CASE("a plank that swings down on its spring sags as far as the spring was stiff when it was set") {
    constexpr float kFrequency_hz = 2;
    World world;
    const BodyId ground = world.create_body({.type = BodyType::Static}).value();
    const BodyId plank =
        add(world, {.position_m = {1, 0}, .linear_damping_1_s = 1, .angular_damping_1_s = 1}, Box{1, 0.1f});
    const JointId joint = world
                              .create_joint(DistanceJointDef{.body_a = ground,
                                                             .body_b = plank,
                                                             .local_anchor_a_m = {0, 3},
                                                             .local_anchor_b_m = {-1, 0},
                                                             .length_m = 3,
                                                             .enable_spring = true,
                                                             .frequency_hz = kFrequency_hz,
                                                             .damping_ratio = 1})
                              .value();
    const double mass = d(world.body(plank)->mass());
    const double inertia = d(world.body(plank)->mass_data().inertia_kg_m2);
    const double square = std::pow(2 * kPiD * d(kFrequency_hz), 2);
    const auto sag_m = [&](double mobility) { return mass * 10 / (square / mobility); };
    const auto length_m = [&] {
        run_for(world, 60);
        const Body body = *world.body(plank);
        return 3 - (body.position().y + std::cos(body.angle() + kPiD / 2));
    };
    const double level = 1 / mass + 1 / inertia;
    CHECK(length_m() - 3 == Approx(sag_m(level)).epsilon(0.01));
    SECTION("another length or damping leaves it as it was") {
        world.joint(joint)->set_length(2).value();
        world.joint(joint)->set_spring(true, kFrequency_hz, 0.9f).value();
        CHECK(length_m() - 2 == Approx(sag_m(level)).epsilon(0.01));
    }
    SECTION("set anew it is as stiff as its frequency says for the plank that hangs") {
        world.joint(joint)->set_spring(false, kFrequency_hz, 1).value();
        world.joint(joint)->set_spring(true, kFrequency_hz, 1).value();
        CHECK(length_m() - 3 == Approx(sag_m(1 / mass)).epsilon(0.01));
    }
}

}  // namespace cairn::physics
