// The numbers of a row of pins (pin_chain.h), each sort in an array of its own, and what is done to all of
// them alike, with SIMD. Body k is joined to body k + 1 by joint k; there is one body more than joints.
// Invariant: every level of SIMD gives the same bits.
#pragma once

#include <cstddef>
#include <vector>

#include "resolve/direct/chain_factors.h"

namespace cairn::physics {

using Values = std::vector<double>;

struct PinRow {
    // Arms from the centres of mass to the anchor of each joint, m: on the body before it and on the one
    // after.
    struct Arms {
        Values before_x, before_y, after_x, after_y;
    };
    struct Speeds {
        Values x, y, w;  // m/s, m/s, rad/s
    };

    // Of bodies.
    Values mass, inverse_mass;
    Values own_inertia, inverse_own_inertia;
    Values inertia, inverse_inertia, inertia_before;  // I~, kg m^2
    Values levers;                                    // sum |r| |p|, kg m^2/s
    Values turned, cosine, sine;                      // rad, in this step
    Values moved_x, moved_y;                          // m, in this step
    Speeds kick;                                      // half of what forces do in a substep
    Values twist;                                     // the same of torques, N m s
    Speeds before, now;                               // a solution

    // Of joints.
    Arms start, arms, factored;    // at the start of the step, now, of the factors
    Values offset_x, offset_y;     // of the centres at the start of the step
    Values error_x, error_y;       // C, m
    Values impulse_x, impulse_y;   // p of the last solution
    Values sum_x, sum_y;           // of this substep
    Values total_x, total_y;       // of this step
    Values arm_before, arm_after;  // lengths; 0 where a body does not turn
    Values pulled, closed;         // |p| of the solutions that open and close

    void resize(std::size_t joints);
    [[nodiscard]] std::size_t bodies() const { return mass.size(); }
    [[nodiscard]] std::size_t joints() const { return offset_x.size(); }
};

// Of the bodies from first up to, and without, last:

/// Moves them on by velocities `before`, and turns them.
void advance(PinRow& row, double h_s, std::size_t first, std::size_t last);
/// cosine and sine.
void turn(PinRow& row, std::size_t first, std::size_t last);
/// I~ that geometric stiffness asks for; what turns faster than this gets no more than it has.
void choose_inertia(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last);
/// The same where more than twice of what there is is needed; whether it is anywhere.
bool enlarge_inertia(PinRow& row, double h_s, double fastest_rad_s, std::size_t first, std::size_t last);
/// 1/I~, and spins of `before` where it grew: angular momentum stays.
void settle_inertia(PinRow& row, std::size_t first, std::size_t last);

/// Half of what forces do in a substep, to `before`.
void kick(PinRow& row, std::size_t first, std::size_t last);
/// The greatest |w| of `before`, rad/s.
double fastest_spin(const PinRow& row, std::size_t first, std::size_t last);
/// sum (m a_linear b_linear + I~ a_angular b_angular): twice the kinetic energy where both are the same.
double energy_product(const PinRow& row, const PinRow::Speeds& a, const PinRow::Speeds& b, std::size_t first,
                      std::size_t last);

// Of all:

/// Whether no component of an impulse is greater; false when one is not a number.
bool are_within(const PinRow& row, double impulse);

/// Arms and errors where the bodies are now; the result is the greatest error.
double place(PinRow& row);
/// A = J M~^-1 J^T with J of row.factored, and so much more of its diagonal.
void assemble(const PinRow& row, double give, ChainFactors& factors);
/// Right-hand sides into the impulses: errors close at this rate, 1/s, up to a speed.
void aim(PinRow& row, double rate, double fastest_m_s);
/// to += M~^-1 J^T p.
void push(const PinRow& row, PinRow::Speeds& to);
/// |p|.
void measure_pulls(const PinRow& row, Values& pulls);
void sum_levers(PinRow& row);
void add_impulses(PinRow& row);

}  // namespace cairn::physics
