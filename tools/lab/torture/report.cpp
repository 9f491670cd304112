#include "torture/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "text.h"

namespace cairn::lab {
namespace {

using Json = nlohmann::ordered_json;
using measure::format;
using measure::rounded;

// Those of the case, and those of G.
std::vector<Figure> all_figures(const Outcome& outcome) {
    std::vector<Figure> figures = outcome.findings.figures;
    figures.push_back({"energy_excess", outcome.findings.energy_excess, kMostEnergyExcess, true});
    figures.push_back({"finite", outcome.findings.finite ? 1.0 : 0.0, 1, false});
    if (outcome.same_on_threads) {
        figures.push_back({"same_on_threads", *outcome.same_on_threads ? 1.0 : 0.0, 1, false});
    }
    return figures;
}

}  // namespace

std::string torture_line(const Case& test, std::string_view engine, const Outcome& outcome) {
    Json line;
    line["case"] = test.number;
    line["name"] = test.name;
    line["passed"] = outcome.passed();
    line["figures"] = Json::object();
    line["limits"] = Json::object();
    line["broken"] = Json::array();
    if (outcome.ended_by.empty()) {
        for (const Figure& figure : all_figures(outcome)) {
            line["figures"][figure.name] = rounded(figure.value);
            if (!std::isnan(figure.limit)) line["limits"][figure.name] = rounded(figure.limit);
            if (!figure.holds()) line["broken"].push_back(figure.name);
        }
    } else {
        line["ended_by"] = outcome.ended_by;
    }
    line["cpu_ms"] = rounded(1e3 * outcome.findings.cpu_s);
    line["engine"] = engine;
    return line.dump();
}

std::string torture_head() {
    return format("%4s %-10s %-6s %10s  %s", "case", "engine", "", "CPU", "");
}

std::string torture_row(const Case& test, std::string_view engine, const Outcome& outcome) {
    std::string row =
        format("%4s %-10s %-6s %7.0f ms  %s", test.number.c_str(), std::string(engine).c_str(),
               outcome.passed() ? "passed" : "FAILED", 1e3 * outcome.findings.cpu_s, test.name.c_str());
    if (!outcome.ended_by.empty()) return row + "\n       ! ended by " + outcome.ended_by;
    for (const Figure& figure : all_figures(outcome)) {
        row += format("\n       %s %s %.4g", figure.holds() ? " " : "!", figure.name.c_str(), figure.value);
        if (!std::isnan(figure.limit))
            row += format(" (%s %.4g)", figure.at_most ? "<=" : ">=", figure.limit);
    }
    return row;
}

}  // namespace cairn::lab
