#include "reference/statics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cairn::lab::reference {
namespace {

// tan of link i when w / H is `slope`: half a step off the middle.
double tangent(int i, int links, double slope) {
    return slope * (i - 0.5 * (links - 1));
}

double span_of(int links, double link_m, double slope) {
    double span = 0;
    for (int i = 0; i < links; ++i) span += link_m * std::cos(std::atan(tangent(i, links, slope)));
    return span;
}

}  // namespace

HangingChain hanging_chain(int links, double link_m, double weight_n, double span_m) {
    double low = 0, high = 1;
    while (span_of(links, link_m, high) > span_m) high *= 2;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (span_of(links, link_m, middle) > span_m ? low : high) = middle;
    }
    HangingChain found;
    double y = 0;
    for (int i = 0; i < links; ++i) {
        found.angle_rad.push_back(std::atan(tangent(i, links, low)));
        y += link_m * std::sin(found.angle_rad.back());
        found.sag_m = std::max(found.sag_m, -y);
    }
    const double horizontal = weight_n / low;
    found.end_tension_n = std::hypot(horizontal, 0.5 * links * weight_n);
    return found;
}

double cantilever_tip_m(int links, double link_m, double weight_per_m, double k_nm_rad) {
    const auto n = static_cast<std::size_t>(links);
    std::vector<double> angle(n);
    const double weight = weight_per_m * link_m;
    // Moments from where the links are, angles from the moments, over again: each turn is small.
    for (int round = 0; round < 200; ++round) {
        std::vector<double> hinge_x(n + 1);
        for (std::size_t i = 0; i < n; ++i) hinge_x[i + 1] = hinge_x[i] + link_m * std::cos(angle[i]);
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double moment = 0;
            for (std::size_t j = i; j < n; ++j) {
                moment += weight * (0.5 * (hinge_x[j] + hinge_x[j + 1]) - hinge_x[i]);
            }
            sum -= moment / k_nm_rad;
            angle[i] = sum;
        }
    }
    double tip = 0;
    for (const double a : angle) tip += link_m * std::sin(a);
    return tip;
}

}  // namespace cairn::lab::reference
