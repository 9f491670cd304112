// A row of bodies, each joined to the next by a plain pin, with nothing else on it: chains, ropes and empty
// bridges. It is solved as direct_component.h tells, to the same errors, in a tenth of the time.
//
// What makes it fast is what it need not do: no impulse has bounds, so there is nothing to choose; and
// without bodies among the unknowns,
//     A p = w - J v,    A = J M~^-1 J^T + E,    v += M~^-1 J^T p
// is block-tridiagonal with two unknowns a joint (chain_factors.h), and all else is done with SIMD
// (pin_row.h). Invariant: bodies and joints stand in the order of the row; what cannot be moved may stand at
// the ends only, with an inverse mass of 0.
#pragma once

#include <span>
#include <vector>

#include "resolve/direct/chain_factors.h"
#include "resolve/direct/direct_scene.h"
#include "resolve/direct/pin_row.h"

namespace cairn::physics {

class PinChain {
  public:
    /// Of joints given by their places in the scene; false when they are no such row. `body_of_row` is as of
    /// DirectComponent::assemble.
    bool assemble(std::span<const int> joints, const DirectScene& scene, std::vector<int>& body_of_row);

    // Of the bodies that move.
    [[nodiscard]] int bodies() const { return static_cast<int>(end_ - begin_); }
    [[nodiscard]] int row(int body) const { return rows_[begin_ + static_cast<std::size_t>(body)]; }
    /// I~ of the last substep, kg m^2.
    [[nodiscard]] double inertia(int body) const {
        return line_.inertia[begin_ + static_cast<std::size_t>(body)];
    }

    /// As those of DirectComponent.
    void start(const DirectScene& scene, std::span<const float> inertia_before);
    void solve(const DirectScene& scene);
    void move(const DirectScene& scene);
    /// After the last substep: impulses into the joints of the scene.
    void finish(std::span<JointConstraint> joints) const;

  private:
    // A joint as the scene has it.
    struct Pin {
        int place = 0;
        bool reversed = false;  // its body b comes before its body a
    };

    [[nodiscard]] bool is_same_row(std::span<const int> joints, const DirectScene& scene) const;
    bool line_up(std::span<const int> joints, const DirectScene& scene, std::vector<int>& body_of_row);
    void read_poses(const Motions& motions, std::size_t first, std::size_t last);
    void write_poses(Motions& motions) const;
    void read(const Motions& motions);
    void write(Motions& motions) const;
    void weigh_spins();
    void factor(double give);
    [[nodiscard]] double most_impulse() const;
    void satisfy(double rate);
    bool satisfy(double rate, double give);
    bool project(double h_s);
    [[nodiscard]] int parts_needed(double h_s) const;
    void advance_by(double h_s);
    void close(const DirectScene& scene, int parts);
    [[nodiscard]] double kinetic_energy(const PinRow::Speeds& v) const;
    [[nodiscard]] double indifferent_energy(const DirectScene& scene) const;
    [[nodiscard]] double work_of_kick() const;
    [[nodiscard]] double work_of_supports() const;
    [[nodiscard]] double surplus(const DirectScene& scene, double energy_before, int parts) const;
    void take_back(double surplus);

    std::vector<int> rows_;            // of the motions, by body; the immovable ones at the ends too
    std::size_t begin_ = 0, end_ = 0;  // bodies that move
    std::vector<Pin> pins_;
    PinRow line_;
    double greatest_error_ = 0;
    double whole_mass_ = 0;
    double fastest_rad_s_ = 0;  // beyond which bodies get no more inertia

    // Those of the factors, beside the arms.
    ChainFactors factors_;
    Values factored_inertia_, factored_mass_;  // inverse
    double give_ = 0;                          // 0: none

    std::vector<int> given_;      // joints of the last step
    std::vector<int> joints_of_;  // two by body, while lining up
    std::vector<int> found_;      // rows of bodies, while lining up
    double surplus_ = 0;          // as in DirectComponent
    double energy_ = 0;
    bool kicked_ = false;
};

}  // namespace cairn::physics
