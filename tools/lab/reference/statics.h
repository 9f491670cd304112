// Chains and beams at rest, in double.
#pragma once

#include <vector>

#include <cairn/physics/math.h>

namespace cairn::lab::reference {

/// A chain of equal bars between two hinges at one height, `span_m` apart; span_m < links * link_m.
struct HangingChain {
    std::vector<double> angle_rad;  ///< of each link, from left to right
    double sag_m = 0;               ///< of its lowest hinge below its ends
    double end_tension_n = 0;
};
/// The discrete catenary: the horizontal tension H is the same everywhere, and from link to link the vertical
/// one changes by the weight w of a link, so that tan(t_{i+1}) - tan(t_i) = w / H.
HangingChain hanging_chain(int links, double link_m, double weight_n, double span_m);

/// Height of the tip of a level beam of equal rigid links, held at its wall and between links by springs
/// against turning, k_nm_rad each. Large turns, too; for small ones it is
/// - w l^3 N^2 (N+1)^2 / (8 k), w the weight per length.
double cantilever_tip_m(int links, double link_m, double weight_per_m, double k_nm_rad);

}  // namespace cairn::lab::reference
