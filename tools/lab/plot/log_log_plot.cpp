#include "plot/log_log_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text.h"

namespace cairn::lab {
namespace {

using measure::format;

constexpr double kWidth = 760, kHeight = 480;
constexpr double kLeft = 80, kRight = 560, kTop = 50, kBottom = 420;  // of the frame
constexpr double kInk = 1.6;

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else {
            out += c;
        }
    }
    return out;
}

std::string text(double x, double y, const char* anchor, int size, const std::string& what) {
    return format(
               "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\" fill=\"black\" "
               "stroke=\"none\">",
               x, y, anchor, size) +
           escaped(what) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
    return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" fill=\"none\" %s/>\n", x1, y1, x2,
                  y2, style);
}

// From 10^low to 10^high, both whole; shown from `from` to `to`.
struct Axis {
    int low = 0, high = 1;
    double from = 0, to = 1;

    [[nodiscard]] double at(double value) const {
        const double share = (std::log10(value) - low) / (high - low);
        return from + std::clamp(share, 0.0, 1.0) * (to - from);
    }
};

Axis axis_of(double least, double most, double from, double to) {
    Axis axis{static_cast<int>(std::floor(std::log10(least))), static_cast<int>(std::ceil(std::log10(most))),
              from, to};
    if (axis.high == axis.low) ++axis.high;
    return axis;
}

Axis x_axis(const Plot& plot) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Series& series : plot.series) {
        for (const PlotPoint& point : series.points) {
            if (!(point.x > 0) || !std::isfinite(point.x)) continue;
            least = std::min(least, point.x);
            most = std::max(most, point.x);
        }
    }
    return most > 0 ? axis_of(least, most, kLeft, kRight) : axis_of(1e-6, 1e-3, kLeft, kRight);
}

// "10" with the exponent raised, and the end of the 10 at x: as two texts, since not every program that shows
// SVG knows how to shift a part of one.
std::string power_of_ten(double x, double y, int exponent) {
    return text(x, y, "end", 12, "10") + text(x + 1, y - 5, "start", 9, std::to_string(exponent));
}

std::string frame(const Plot& plot, const Axis& x, const Axis& y) {
    std::string out;
    const char* const grid = "stroke=\"#ddd\" stroke-width=\"1\"";
    const char* const tick = "stroke=\"#333\" stroke-width=\"1\"";
    const int every = std::max(1, (y.high - y.low + 11) / 12);
    for (int decade = x.low; decade <= x.high; ++decade) {
        const double at = x.at(std::pow(10.0, decade));
        out += line(at, kTop, at, kBottom, grid) + power_of_ten(at + 3, kBottom + 20, decade);
        for (int i = 2; i < 10 && decade < x.high; ++i) {
            const double minor = x.at(i * std::pow(10.0, decade));
            out += line(minor, kBottom, minor, kBottom - 4, tick);
        }
    }
    for (int decade = y.low; decade <= y.high; decade += every) {
        const double at = y.at(std::pow(10.0, decade));
        out += line(kLeft, at, kRight, at, grid) + power_of_ten(kLeft - 20, at + 4, decade);
    }
    out +=
        format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" stroke=\"#333\"/>\n",
               kLeft, kTop, kRight - kLeft, kBottom - kTop);
    out += text((kLeft + kRight) / 2, 28, "middle", 16, plot.title);
    out += text((kLeft + kRight) / 2, kBottom + 46, "middle", 13, plot.x_label);
    const double middle = (kTop + kBottom) / 2;
    out += format(
               "<text transform=\"translate(26 %.1f) rotate(-90)\" x=\"0\" y=\"0\" text-anchor=\"middle\" "
               "font-size=\"13\" fill=\"black\" stroke=\"none\">",
               middle) +
           escaped(plot.y_label) + "</text>\n";
    return out;
}

bool has_failed(const Plot& plot, const PlotPoint& point) {
    return !std::isfinite(point.y) || point.y > plot.most_y;
}

std::string cross(double x, double y, const std::string& color) {
    return format(
        "<path class=\"failure\" d=\"M%.1f %.1fl10 10m0 -10l-10 10\" fill=\"none\" stroke=\"%s\" "
        "stroke-width=\"2\"/>\n",
        x - 5, y - 5, color.c_str());
}

std::string dashes(const Series& series) {
    return series.dashed ? " stroke-dasharray=\"5 4\"" : "";
}

std::string drawn(const Plot& plot, const Series& series, const Axis& x, const Axis& y) {
    std::string marks, path;
    const char* const color = series.color.c_str();
    for (const PlotPoint& point : series.points) {
        // A failure before anything could be timed stands at the right.
        const double px = point.x > 0 && std::isfinite(point.x) ? x.at(point.x) : kRight;
        if (has_failed(plot, point)) {
            marks += cross(px, kTop, series.color);
            continue;
        }
        const double py = y.at(std::max(point.y, plot.least_y));
        path += format("%s%.1f %.1f", path.empty() ? "M" : "L", px, py);
        marks +=
            format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"none\"/>\n", px, py, color);
        if (point.ringed) {
            marks += format(
                "<circle class=\"default\" cx=\"%.1f\" cy=\"%.1f\" r=\"7\" fill=\"none\" stroke=\"%s\" "
                "stroke-width=\"2\"/>\n",
                px, py, color);
        }
    }
    if (path.empty()) return marks;
    return format("<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>\n", path.c_str(),
                  color, kInk, dashes(series).c_str()) +
           marks;
}

std::string legend(const Plot& plot) {
    std::string out;
    double y = kTop + 14;
    for (const Series& series : plot.series) {
        out += line(kRight + 14, y - 4, kRight + 44, y - 4,
                    format("stroke=\"%s\" stroke-width=\"%.1f\"%s", series.color.c_str(), kInk,
                           dashes(series).c_str())
                        .c_str());
        out += text(kRight + 50, y, "start", 12, series.name);
        y += 20;
    }
    y += 6;
    out +=
        format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"7\" fill=\"none\" stroke=\"#333\" stroke-width=\"2\"/>\n",
               kRight + 29, y - 4) +
        text(kRight + 50, y, "start", 12, "default setting");
    y += 20;
    return out + cross(kRight + 29, y - 4, "#333") + text(kRight + 50, y, "start", 12, "failed");
}

}  // namespace

std::string to_svg(const Plot& plot) {
    const Axis x = x_axis(plot);
    const Axis y = axis_of(plot.least_y, plot.most_y, kBottom, kTop);
    std::string out = format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
        "height=\"%.0f\" font-family=\"sans-serif\">\n",
        kWidth, kHeight, kWidth, kHeight);
    out += format("<rect width=\"%.0f\" height=\"%.0f\" fill=\"white\"/>\n", kWidth, kHeight);
    out += frame(plot, x, y);
    for (const Series& series : plot.series) out += drawn(plot, series, x, y);
    return out + legend(plot) + "</svg>\n";
}

}  // namespace cairn::lab
