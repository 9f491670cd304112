// What is printed about a case can be read by machines and by people.
#include "torture/report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace cairn::lab {
namespace {

Outcome half_failed() {
    Outcome outcome;
    outcome.findings.figures = {{"drop_m", 0.25, 0.1, true}, {"turned_rad", 50, 45, false}, {"places", 51}};
    outcome.findings.cpu_s = 0.0125;
    outcome.same_on_threads = true;
    return outcome;
}

const Case kCase{"19b", "a case", true, {}};

}  // namespace

TEST_CASE("the line of a case holds its figures and their limits") {
    const auto line = nlohmann::json::parse(torture_line(kCase, "cairn", half_failed()));
    CHECK(line["case"] == "19b");
    CHECK(line["name"] == "a case");
    CHECK(line["engine"] == "cairn");
    CHECK(line["passed"] == false);
    CHECK(line["cpu_ms"] == 12.5);
    CHECK(line["figures"]["drop_m"] == 0.25);
    CHECK(line["limits"]["drop_m"] == 0.1);
    CHECK(line["figures"]["places"] == 51);
    CHECK_FALSE(line["limits"].contains("places"));
    CHECK(line["figures"]["same_on_threads"] == 1);
    CHECK(line["broken"] == nlohmann::json::array({"drop_m"}));
    CHECK(line["limits"]["energy_excess"] == kMostEnergyExcess);
    CHECK_FALSE(line.contains("ended_by"));
}

TEST_CASE("the line of a case that was ended says by what") {
    Outcome outcome;
    outcome.ended_by = "signal: Aborted";
    const auto line = nlohmann::json::parse(torture_line(kCase, "peer", outcome));
    CHECK(line["ended_by"] == "signal: Aborted");
    CHECK(line["passed"] == false);
    CHECK(line["figures"].empty());
}

TEST_CASE("in the table, what does not hold is marked") {
    const std::string row = torture_row(kCase, "cairn", half_failed());
    CHECK_THAT(row, Catch::Contains("FAILED") && Catch::Contains("! drop_m 0.25 (<= 0.1)") &&
                        Catch::Contains("  turned_rad 50 (>= 45)") && Catch::Contains("  places 51\n"));
    CHECK_THAT(row, !Catch::Contains("! turned_rad"));
}

}  // namespace cairn::lab
