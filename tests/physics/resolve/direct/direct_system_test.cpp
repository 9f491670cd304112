// Equations with bounds against what defines their solution: M dv = J^T p, and each impulse either within its
// bounds with its equation fulfilled, or at a bound with the speed on the side to which that gives way.
#include "resolve/direct/direct_system.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using State = DirectEquation::State;
using Bound = DirectEquation::Bound;
using test::Random;

constexpr int kMany = 1000;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

void fill_j(DirectSystem& system, Random& random) {
    for (int m = 0; m < static_cast<int>(system.members.size()); ++m) {
        const DirectSystem::Member& member = system.members[at(m)];
        for (int l = member.first_link; l < member.last_link; ++l) {
            for (int e = member.first_equation; e < member.last_equation; ++e) {
                for (int i = 0; i < 3; ++i) system.j(m, l, e)[i] = random.real(-1, 1);
            }
        }
    }
    system.weigh();
}

// A row of bodies; between neighbours an equation without bounds, one that only pushes, one within a range.
DirectSystem make_row(int bodies, Random& random, double mass_ratio) {
    DirectSystem system;
    for (int i = 0; i < bodies; ++i) system.add_body();
    for (int i = 0; i < bodies; ++i) {
        system.begin_member();
        system.add_link(i);
        if (i > 0) system.add_link(i - 1);
        (void)system.add_equation();
        DirectEquation& pushes = system.equations[at(system.add_equation())];
        pushes.bound = Bound::Range;
        pushes.high = kInfinite;
        pushes.state = random.chance(0.5) ? State::Acts : State::AtLow;
        DirectEquation& ranges = system.equations[at(system.add_equation())];
        ranges.bound = Bound::Range;
        ranges.high = random.real(0, 1);
        ranges.low = -ranges.high;
    }
    system.arrange();
    for (DirectBody& body : system.bodies) {
        body.mass = std::pow(mass_ratio, random.real(0, 1));
        body.own_inertia = body.inertia = body.mass * random.real(0.1, 1);
    }
    fill_j(system, random);
    for (DirectEquation& e : system.equations) {
        e.wanted = random.real(-1, 1);
        e.give = 1e-8 * e.inverse_mass;
    }
    return system;
}

std::vector<double> random_velocity(int bodies, Random& random) {
    std::vector<double> velocity;
    for (int i = 0; i < 3 * bodies; ++i) velocity.push_back(random.real(-5, 5));
    return velocity;
}

// What the impulses do to the bodies, added to where they came from, less where they are; as part of the
// largest change of velocity.
double imbalance(const DirectSystem& system, std::vector<double> velocity) {
    double largest = 1;
    for (int m = 0; m < static_cast<int>(system.members.size()); ++m) {
        const DirectSystem::Member& member = system.members[at(m)];
        for (int l = member.first_link; l < member.last_link; ++l) {
            const int b = system.links[at(l)].body;
            const DirectBody& body = system.bodies[at(b)];
            for (int e = member.first_equation; e < member.last_equation; ++e) {
                for (int i = 0; i < 3; ++i) {
                    const double change = system.j(m, l, e)[i] * system.equations[at(e)].impulse /
                                          (i < 2 ? body.mass : body.inertia);
                    velocity[at(3 * b + i)] += change;
                    largest = std::max(largest, std::fabs(change));
                }
            }
        }
    }
    double greatest = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
        greatest = std::max(greatest, std::fabs(velocity[i] - system.velocity[i]));
    return greatest / largest;
}

// How far the equation and its bound are from being kept, in speed or, relative, in impulse.
double violation(const DirectSystem& system, int member, int equation) {
    const DirectEquation& e = system.equations[at(equation)];
    const double over = system.speed(member, equation) + e.give * e.impulse - e.wanted;
    if (e.bound == Bound::None) return std::fabs(over);
    const double whole = e.before + e.impulse;
    const double outside = std::max({0.0, e.low - whole, whole - e.high}) / (1 + std::fabs(whole));
    if (e.state == State::AtLow) return std::max(outside, -over);
    if (e.state == State::AtHigh) return std::max(outside, over);
    return std::max(outside, std::fabs(over));
}

// What the impulses that solve the system make least: f = |dv|^2 / 2 by masses + E p^2 / 2 - p (w - J v).
double objective(const DirectSystem& system, const std::vector<double>& before) {
    double sum = 0;
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
        const DirectBody& body = system.bodies[b];
        for (std::size_t i = 0; i < 3; ++i) {
            const double change = system.velocity[3 * b + i] - before[3 * b + i];
            sum += (i < 2 ? body.mass : body.inertia) * change * change / 2;
        }
    }
    DirectSystem still = system;
    still.velocity = before;
    for (int m = 0; m < static_cast<int>(system.members.size()); ++m) {
        const DirectSystem::Member& member = system.members[at(m)];
        for (int i = member.first_equation; i < member.last_equation; ++i) {
            const DirectEquation& e = system.equations[at(i)];
            sum += e.give * e.impulse * e.impulse / 2 - e.impulse * (e.wanted - still.speed(m, i));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("equations and bounds are kept, and what the impulses do is what happens to the bodies") {
    Random random(1);
    const double mass_ratio = GENERATE(1.0, 1e3, 1e6);
    int at_bounds = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const int bodies = 1 + random.below(30);
        DirectSystem system = make_row(bodies, random, mass_ratio);
        const std::vector<double> before = random_velocity(bodies, random);
        system.satisfy(before, kMany);
        CAPTURE(mass_ratio, trial, bodies);
        CHECK(imbalance(system, before) < 1e-9);
        for (int m = 0; m < bodies; ++m) {
            const DirectSystem::Member& member = system.members[at(m)];
            for (int e = member.first_equation; e < member.last_equation; ++e) {
                CHECK(violation(system, m, e) < 1e-6);
                at_bounds += system.equations[at(e)].state != State::Acts ? 1 : 0;
            }
        }
    }
    CHECK(at_bounds > 100);
}

TEST_CASE("what is given up early keeps its bounds, and is no worse than what has no bounds alone") {
    Random random(2);
    const int most = GENERATE(1, 2, 3, 5, 8);
    const double mass_ratio = GENERATE(1.0, 1e4);
    int given_up = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const int bodies = 10 + random.below(30);
        DirectSystem system = make_row(bodies, random, mass_ratio);
        const std::vector<double> before = random_velocity(bodies, random);
        DirectSystem alone = system;
        for (DirectEquation& e : alone.equations) {
            if (e.bound != Bound::None) e.state = State::Idle;
        }
        alone.satisfy(before, kMany);
        CAPTURE(most, mass_ratio, trial, bodies);
        const int taken = system.satisfy(before, most);
        CHECK(taken <= most + 3);
        CHECK(imbalance(system, before) < 1e-9);
        const double worst = objective(alone, before);
        CHECK(objective(system, before) <= worst + 1e-9 * std::fabs(worst));
        bool solved = true;
        for (int m = 0; m < bodies; ++m) {
            const DirectSystem::Member& member = system.members[at(m)];
            for (int i = member.first_equation; i < member.last_equation; ++i) {
                const DirectEquation& e = system.equations[at(i)];
                const double rounding = 1e-9 * std::fabs(e.impulse);
                if (e.bound == Bound::None) {
                    CHECK(violation(system, m, i) < 1e-6);
                } else {
                    CHECK((e.impulse >= e.low - rounding && e.impulse <= e.high + rounding));
                }
                solved = solved && violation(system, m, i) < 1e-6;
            }
        }
        given_up += solved ? 0 : 1;
    }
    if (most < 3) CHECK(given_up > 10);
}

TEST_CASE("impulses of an earlier phase count towards the bounds") {
    DirectSystem system;
    system.add_body();
    system.begin_member();
    system.add_link(0);
    DirectEquation& e = system.equations[at(system.add_equation())];
    e.bound = Bound::Range;
    e.high = kInfinite;
    e.before = 3;
    system.arrange();
    system.bodies[0].mass = 2;
    system.j(0, 0, 0)[0] = 1;
    system.weigh();
    // To stop the body 2 N s must go back, of the 3 that were given; then 5, of which 3 can.
    system.satisfy(std::vector<double>{1, 0, 0}, kMany);
    CHECK(system.equations[0].impulse == Approx(-2));
    CHECK(system.velocity[0] == Approx(0).margin(1e-12));
    system.satisfy(std::vector<double>{2.5, 0, 0}, kMany);
    CHECK(system.equations[0].impulse == Approx(-3));
    CHECK(system.velocity[0] == Approx(1));
}

TEST_CASE("friction holds up to its share of what presses, and slides beyond") {
    const double along = GENERATE(0.1, 0.49, 0.6, 3.0, -3.0);
    DirectSystem system;
    system.add_body();
    system.begin_member();
    system.add_link(0);
    DirectEquation& push = system.equations[at(system.add_equation())];
    push.bound = Bound::Range;
    push.high = kInfinite;
    DirectEquation& friction = system.equations[at(system.add_equation())];
    friction.bound = Bound::Friction;
    friction.coefficient = 0.5;
    friction.last_push = 1;
    system.arrange();
    system.bodies[0].mass = 4;
    system.j(0, 0, 0)[1] = 1;
    system.j(0, 0, 1)[0] = 1;
    system.weigh();
    for (DirectEquation& e : system.equations) e.give = 1e-10 * e.inverse_mass;
    system.satisfy(std::vector<double>{along, -1, 0}, kMany);
    CHECK(system.velocity[1] == Approx(0).margin(1e-8));
    const double slid = std::max(std::fabs(along) - 0.5, 0.0);
    CHECK(system.velocity[0] == Approx(std::copysign(slid, along)).margin(2e-3));
}

}  // namespace cairn::physics
