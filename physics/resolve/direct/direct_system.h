// Equations on the velocities of some bodies, solved together, with bounds on their impulses.
//     [M  J^T; J  -E] [v; -p] = [M v0; w]
// M the masses, v0 the velocities before, J the Jacobian, E the give of each equation, w the speed wanted, p
// the impulses.
//
// Bounds make it a linear complementarity problem with a positive definite matrix: each impulse is either
// within its bounds, and its equation holds, or at one of them, and the speed is on the side to which that
// bound gives way. The right choice is found by principal pivoting: all that are on the wrong side change
// over at once. Where that goes round in circles, it is found by descent (direct_descent.cpp). Bounds of
// friction follow the impulses that press, in a few rounds. Source: Judice and Pires, "A block principal
// pivoting algorithm for large-scale strictly monotone linear complementarity problems" (1994).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "resolve/direct/block_ldl.h"

namespace cairn::physics {

struct DirectBody {
    double mass = 1;  // kg
    double own_inertia = 1;
    double inertia = 1;  // as the system sees it
    bool moves_x = true;
    bool moves_y = true;
    bool turns = true;
};

struct DirectEquation {
    enum class State : std::uint8_t {
        Acts,    // an equation of the system
        Idle,    // no part of it
        AtLow,   // the impulse is at its bound
        AtHigh,  //
        Given,   // the impulse stays as it is
    };
    enum class Bound : std::uint8_t {
        None,
        Range,     // low <= impulse <= high
        Round,     // with the next equation: their length is at most high
        Friction,  // a range of +- coefficient times the impulses of the equations from first_push to
                   // last_push
    };
    State state = State::Acts;
    Bound bound = Bound::None;
    double give = 0;
    double wanted = 0;
    double low = 0;
    double high = 0;
    double coefficient = 0;
    int first_push = 0, last_push = 0;
    double drift = 0;         // the part of J v that no body of the system has
    double inverse_mass = 0;  // J 1/M J^T
    double impulse = 0;       // p
    double before = 0;        // what was given before; bounds are of the sum of both
};

class DirectSystem {
  public:
    using State = DirectEquation::State;
    using Bound = DirectEquation::Bound;

    /// Equations that share their bodies.
    struct Member {
        int first_link = 0, last_link = 0;
        int first_equation = 0, last_equation = 0;
        int first_j = 0;
        [[nodiscard]] int equations() const { return last_equation - first_equation; }
    };
    struct Link {
        int body = 0;
        int edge = 0;  // of the factorization
    };

    // Building: bodies first.

    void clear();
    void add_body() { bodies.push_back({}); }
    void begin_member();
    void add_link(int body);
    int add_equation();
    /// Finds the order of elimination.
    void arrange();

    /// The three numbers of J of an equation for a link of its member, each for the velocity in the plane and
    /// the spin.
    double* j(int member, int link, int equation) {
        const Member& m = members[static_cast<std::size_t>(member)];
        return j_.data() + m.first_j +
               3 * ((link - m.first_link) * m.equations() + equation - m.first_equation);
    }
    [[nodiscard]] const double* j(int member, int link, int equation) const {
        return const_cast<DirectSystem*>(this)->j(member, link, equation);
    }
    /// After J or masses changed: sets inverse_mass of all equations, by own_inertia.
    void weigh();
    /// J v, with these velocities of the bodies.
    [[nodiscard]] double speed(int member, int equation, std::span<const double> of_bodies) const;
    [[nodiscard]] double speed(int member, int equation) const { return speed(member, equation, velocity); }

    /// Finds impulses, and velocities from those given, starting from the states that are set. Bounds are
    /// kept; equations too, but in systems that are too hard for so many factorizations: there equations
    /// without bounds hold, and the others are no farther off than without their impulses. Returns how many
    /// it took, at most a few more.
    int satisfy(std::span<const double> velocity_before, int most_factorizations);
    /// dv for other right-hand sides of the equations that act, in x, with the factors of the last solution.
    void solve(std::vector<double>& x) const { factors_.solve(x); }
    [[nodiscard]] int unknowns() const { return factors_.size(); }
    [[nodiscard]] int place_of_body(int body) const { return factors_.offset(body); }
    [[nodiscard]] int place_of_member(int member) const {
        return factors_.offset(static_cast<int>(bodies.size()) + member);
    }

    std::vector<DirectBody> bodies;
    std::vector<Member> members;
    std::vector<Link> links;
    std::vector<DirectEquation> equations;
    std::vector<double> velocity;  // three per body: m/s, m/s, rad/s

  private:
    struct Place {
        int member = 0;
        int equation = 0;
    };
    struct Bounded {
        int member = 0;
        int equation = 0;
        double impulse = 0;  // with what was given before
        double excess = 0;   // J v + E p - w
        double aim = 0;      // impulse
        bool stays = false;  // at its bound, though its equation would let it go
    };

    void start(std::span<const double> velocity_before);
    void push(const Member& m, int equation, double impulse);
    void factor(BlockLdl& factors) const;
    void set_member(BlockLdl& factors, int member) const;
    void renew_factors();
    void renew_factors_of_wrong();
    void balance(const BlockLdl& factors);
    void find_wrong();
    bool pivot();
    void descend();
    [[nodiscard]] double excess(const Bounded& b) const;
    void hold(const Bounded& b, double impulse);
    void release();
    [[nodiscard]] double way_to_first_bound() const;
    bool go(double part);
    bool advance();
    void settle();
    bool shorten_wrong();
    [[nodiscard]] bool is_wrong(const DirectEquation& e, int member, int equation) const;
    void change_over(int equation);
    bool renew_friction();

    std::vector<double> momentum_before_;  // of bodies, in the order of x_; and 0 elsewhere
    std::vector<Place> limited_;           // equations that have bounds, and are not idle
    std::vector<Place> wrong_;
    // While descending.
    std::vector<Bounded> bounded_;
    BlockLdl unbounded_factors_;
    std::vector<double> j_;
    std::vector<double> x_;  // right-hand side and solution
    BlockLdl factors_;
    int factorizations_left_ = 0;
    bool is_stale_ = true;               // factors_ are not those of the states as they are
    std::vector<BlockLdl::Node> nodes_;  // while arranging
    std::vector<BlockLdl::Edge> edges_;
};

}  // namespace cairn::physics
