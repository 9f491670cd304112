// The plots are documents in which every point can be found where it should be.
#include "plot/log_log_plot.h"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

namespace cairn::lab {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

Plot two_lines() {
    return {.title = "a < b & c",
            .x_label = "CPU seconds",
            .y_label = "error",
            .series = {{"one", "#123456", false, {{1e-5, 1e-3, true}, {1e-4, 1e-5}, {1e-3, 0}}},
                       {"two",
                        "#654321",
                        true,
                        {{2e-5, std::numeric_limits<double>::infinity()}, {3e-5, 1e3}, {0, 1e-2}}}}};
}

// Centres of the filled circles of a colour.
std::vector<std::pair<double, double>> dots(const std::string& svg, const std::string& color) {
    std::vector<std::pair<double, double>> found;
    const std::string circle = "<circle cx=\"";
    for (std::size_t i = svg.find(circle); i != std::string::npos; i = svg.find(circle, i + 1)) {
        const std::string tag = svg.substr(i, svg.find("/>", i) - i);
        if (tag.find("r=\"3\" fill=\"" + color + "\"") == std::string::npos) continue;
        const auto number = [&](const char* name) { return std::stod(tag.substr(tag.find(name) + 4)); };
        found.push_back({number("cx=\""), number("cy=\"")});
    }
    return found;
}

}  // namespace

TEST_CASE("every point is drawn, defaults with a ring and failures as crosses") {
    const std::string svg = to_svg(two_lines());
    CHECK(dots(svg, "#123456").size() == 3);
    CHECK(dots(svg, "#654321").size() == 1);
    CHECK(count(svg, "class=\"default\"") == 1);
    CHECK(count(svg, "class=\"failure\"") == 2 + 1);  // and the one of the legend
}

TEST_CASE("decades are equally far apart, and errors of nothing stand at the lower edge") {
    const auto one = dots(to_svg(two_lines()), "#123456");
    REQUIRE(one.size() == 3);
    CHECK(one[1].first - one[0].first == Approx(one[2].first - one[1].first).margin(0.2));
    // From 1e-9 to 10 are ten decades; from 1e-3 to 1e-5 two of them, and from there four to the edge.
    CHECK((one[1].second - one[0].second) * 2 == Approx(one[2].second - one[1].second).margin(0.4));
}

TEST_CASE("the axes are labelled, and text is safe") {
    const std::string svg = to_svg(two_lines());
    CHECK_THAT(svg, Catch::Contains("a &lt; b &amp; c") && Catch::Contains(">CPU seconds<") &&
                        Catch::Contains(">error<") && Catch::Contains(">-9<") && Catch::Contains(">one<"));
    CHECK(count(svg, "<text") == count(svg, "</text>"));
    CHECK_THAT(svg, Catch::EndsWith("</svg>\n"));
}

TEST_CASE("a plot of nothing is a plot") {
    CHECK_THAT(to_svg({}), Catch::StartsWith("<svg") && !Catch::Contains("nan") && !Catch::Contains("inf"));
}

}  // namespace cairn::lab
