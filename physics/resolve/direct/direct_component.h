// A structure of joints and contacts that is solved as one system, exactly, where sweeping would take
// hundreds of rounds: long chains, heavy bodies on light ones.
//
// In each substep, with M the masses, J the Jacobian, E a trace of give that makes redundant joints solvable:
//   open      v += h/2 of gravity and forces
//   solve     [M J^T; J -E] [dv; -p] = [0; -(C/h + J v)], v += dv
//   (other contacts, each by itself)
//   move      x += h v, then two projections of x on C = 0 of the joints with the same factors
//   close     v += h/2 of gravity and forces; the system anew where the bodies are now, with J v = 0; energy
//             that nothing brought in is taken back
// The half kicks before and after make a pendulum keep its energy to 1e-8 a minute. Where bodies turn fast,
// as in whips, move and close are done in up to 32 parts, with the half kick in the last.
//
// Geometric stiffness: a taut joint turns a body back with k = sum |r| |F|, and explicit steps explode where
// h^2 k > 4 I. So the system sees the inertia I~ = I + max(0, h^2 k - 2 I), with F of the last solution, and
// again with F of this one when that was too little. Where I~ grew, the spin is scaled so that angular
// momentum stays. Sources: Baraff 1996; Tournier, Nesme, Gilles and Faure, "Stable Constrained Dynamics"
// (2015); Andrews, Teichmann and Kovecses, "Geometric Stiffness for Real-time Constrained Multibody Dynamics"
// (2017).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "resolve/direct/direct_scene.h"
#include "resolve/direct/direct_system.h"

namespace cairn::physics {

class DirectComponent {
  public:
    /// Of joints and contacts given by their places in the scene. `body_of_row` is a working list as long as
    /// the motions, of -1, and is so again afterwards.
    void assemble(std::span<const int> joints, std::span<const int> contacts, const DirectScene& scene,
                  std::vector<int>& body_of_row);

    [[nodiscard]] int bodies() const { return static_cast<int>(system_.bodies.size()); }
    /// Of the motions.
    [[nodiscard]] int row(int body) const { return rows_[static_cast<std::size_t>(body)]; }
    /// I~ of the last substep, kg m^2.
    [[nodiscard]] double inertia(int body) const {
        return system_.bodies[static_cast<std::size_t>(body)].inertia;
    }

    /// Once per step, before anything acts. I~ of the last step is given by row of the motions; 0: as it is.
    void start(const DirectScene& scene, std::span<const float> inertia_before);
    void solve(const DirectScene& scene);
    /// To the end of the substep, with velocities along joints and contacts there.
    void move(const DirectScene& scene);

  private:
    using Member = DirectSystem::Member;
    // One law of a joint along one direction.
    struct JointRow {
        int law = 0;   // of the constraint
        int part = 0;  // of a law with several directions
        double sign = 1;
        double error = 0;         // C
        double speed_before = 0;  // of springs
        // What one unit of impulse is to the other body, for the reaction: at its anchor.
        Vec2 force;
        float torque = 0;
    };
    struct JointMember {
        int place = 0;                                           // in the scene
        std::array<int, kMaxJointBodies> links{-1, -1, -1, -1};  // -1: cannot be moved
    };
    struct ContactMember {
        int place = 0;
        std::array<int, 2> links{-1, -1};
    };
    // For geometric stiffness.
    struct Lever {
        double arm = 0;  // |r|, m
        // Linear impulses: of the last biased solution, and of the last closing one.
        double pulled = 0, closed = 0;
    };
    enum class Phase : std::uint8_t { Solve, Close };
    // Give of joints, as a part of J 1/M J^T; contacts may be left to a sweep.
    struct Attempt {
        double joints = 0;
        bool sweeps_contacts = false;
    };
    static const std::array<Attempt, 3> kAttempts;

    int find_body(int row, std::vector<int>& body_of_row);
    int link_to(int row, const Motions& motions, std::vector<int>& body_of_row);
    [[nodiscard]] int joint_rows() const { return static_cast<int>(joint_rows_.size()); }
    [[nodiscard]] const Member& member_of_contact(std::size_t contact) const {
        return system_.members[joints_.size() + contact];
    }

    void place_joints(const DirectScene& scene);
    void place_contacts(const DirectScene& scene);
    void read(const Motions& motions);
    void write(Motions& motions) const;
    void note_spins(const Motions& motions);
    void weigh_spins(Motions& motions) const;
    void describe(const DirectScene& scene, Phase phase);
    void describe(const JointLaw& law, JointRow& row, DirectEquation& e, double h, Phase phase) const;
    [[nodiscard]] std::vector<DirectEquation::State>& states_of(Phase phase) {
        return states_[static_cast<std::size_t>(phase)];
    }
    void recall(int equation, Phase phase);
    void remember_states(Phase phase);
    void forget_states();
    void describe_contact(const DirectScene& scene, std::size_t contact, Phase phase);
    void satisfy(const DirectScene& scene, Phase phase);
    void sweep_contacts(const DirectScene& scene, Phase phase);
    [[nodiscard]] bool is_contradictory() const;
    [[nodiscard]] double inertia_for(std::size_t body, double h) const;
    bool enlarge_inertia(double h);
    template <class Set>
    void measure_pulls(const Set& set);
    void sum_levers();
    void note_spring_speeds();
    [[nodiscard]] double greatest_error(const DirectScene& scene) const;
    bool project(const DirectScene& scene);
    [[nodiscard]] bool has_pressed() const;
    [[nodiscard]] int parts_needed(const DirectScene& scene) const;
    void advance(const DirectScene& scene);
    void close(const DirectScene& scene, int parts);
    void give_impulses(const DirectScene& scene);
    [[nodiscard]] double kinetic_energy(std::span<const double> velocity) const;
    [[nodiscard]] double indifferent_energy(const DirectScene& scene) const;
    void note_energy(const Motions& motions);
    [[nodiscard]] bool is_driven(const DirectScene& scene, std::size_t member, int equation) const;
    [[nodiscard]] double work_done(const DirectScene& scene) const;
    [[nodiscard]] double surplus(const DirectScene& scene, double energy_before, int parts) const;
    [[nodiscard]] double work_of_kick(const DirectScene& scene, int parts) const;
    [[nodiscard]] bool is_free() const;
    void take_back(double surplus);
    void kick(const DirectScene& scene);

    DirectSystem system_;    // members: joints, then contacts
    std::vector<int> rows_;  // of bodies
    std::vector<double> inertia_before_;
    std::vector<double> levers_;  // of bodies, sum |r| |p|, kg m^2/s
    std::vector<JointMember> joints_;
    std::vector<ContactMember> contacts_;
    std::vector<JointRow> joint_rows_;  // the first equations of the system
    std::vector<Lever> links_;          // the first links
    std::vector<double> velocity_before_;
    std::vector<float> known_spins_;        // rad/s, as the system left them
    std::vector<double> impulse_at_start_;  // of the phase
    std::vector<double> x_;
    std::array<std::vector<DirectEquation::State>, 2> states_;  // of equations in this step, by phase
    bool is_weighed_ = false;                                   // since J changed
    Attempt attempt_;
    int factorizations_left_ = 0;  // of the solution, or of all closing ones
    double surplus_ = 0;           // J that errors added in the solution
    double energy_ = 0;            // J without them, before positions are projected
    bool kicked_ = false;
    bool is_loop_ = false;
};

}  // namespace cairn::physics
