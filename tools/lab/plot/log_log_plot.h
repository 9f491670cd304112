// A plot with both axes logarithmic, as SVG: lines with their points, defaults ringed, failures as crosses at
// the upper edge. Invariant: every point of a series is drawn; one beyond the frame stands at its edge.
#pragma once

#include <string>
#include <vector>

namespace cairn::lab {

struct PlotPoint {
    double x = 0;
    double y = 0;  ///< not finite, or beyond all: a failure
    bool ringed = false;
};

struct Series {
    std::string name;
    std::string color;  ///< as SVG takes it
    bool dashed = false;
    std::vector<PlotPoint> points;  ///< joined in this order; failures are not joined
};

struct Plot {
    std::string title;
    std::string x_label;  ///< with its unit
    std::string y_label;
    double least_y = 1e-9;  ///< what is less stands at the lower edge
    double most_y = 10;     ///< what is more has failed
    std::vector<Series> series;
};

/// A whole document, 760 x 480.
std::string to_svg(const Plot& plot);

}  // namespace cairn::lab
