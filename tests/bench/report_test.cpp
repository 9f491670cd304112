// What is printed says what was measured.
#include "report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numeric>

namespace cairn::bench {
namespace {

Measurement some_measurement() {
    Measurement m;
    m.steps = 101;
    m.step_ms = {3, 1, 2};
    m.ms_total = 6;
    m.tally = {.bodies = 7, .shapes = 8, .joints = 1, .contacts = 9, .touching = 4};
    m.awake_body_steps = 600;
    m.allocations = 5;
    m.bytes_peak = 12345;
    m.max_penetration_m = 0.002f;
    m.stages[physics::Stage::Solve] = 0.75;
    m.state_hash = 0xabc;
    m.findings.costs = {{"cast_ray", 250}};
    return m;
}

}  // namespace

TEST_CASE("a spread is the least, the middle and the 99th of a hundred") {
    std::vector<double> values(200);
    std::iota(values.rbegin(), values.rend(), 1);  // 200, 199 ... 1
    const Spread spread = spread_of(values);
    CHECK(spread.min == 1);
    CHECK(spread.median == 100);
    CHECK(spread.p99 == 198);
    CHECK(spread_of({4}).p99 == 4);
    CHECK(spread_of({}).median == 0);
}

TEST_CASE("a line of results is one JSON object with all that was promised") {
    const std::string text = run_line(all_scenes().front(), {2, "avx2"}, some_measurement());
    CHECK(text.find('\n') == std::string::npos);
    const auto line = nlohmann::json::parse(text);
    CHECK(line.at("scene") == all_scenes().front().name);
    CHECK(line.at("threads") == 2);
    CHECK(line.at("simd") == "avx2");
    CHECK(line.at("steps") == 101);
    CHECK(line.at("bodies") == 7);
    CHECK(line.at("contacts") == 9);
    CHECK(line.at("touching") == 4);
    CHECK(line.at("joints") == 1);
    CHECK(line.at("ms_total") == 6);
    CHECK(line.at("ms_per_step") == nlohmann::json{{"min", 1}, {"median", 2}, {"p99", 3}});
    CHECK(line.at("stages_ms").size() == physics::kStages.size());
    CHECK(line.at("stages_ms").at("solve") == 0.75);
    CHECK(line.at("allocations") == 5);
    CHECK_FALSE(line.contains("allocations_warm"));
    CHECK(line.at("bytes_peak") == 12345);
    CHECK(line.at("awake_body_steps") == 600);
    CHECK(line.at("max_penetration_m") == 0.002);
    CHECK(line.at("state_hash") == "0000000000000abc");
    CHECK(line.at("ns_each").at("cast_ray") == 250);
}

TEST_CASE("what a warm world allocated is told where it was counted") {
    Measurement m = some_measurement();
    m.allocations_warm = 3;
    CHECK(nlohmann::json::parse(run_line(all_scenes().front(), {}, m)).at("allocations_warm") == 3);
    CHECK(run_table_row(all_scenes().front(), m).find("run again in its world: 3 allocations") !=
          std::string::npos);
    CHECK(run_table_row(all_scenes().front(), some_measurement()).find("again") == std::string::npos);
}

TEST_CASE("a line of a comparison names the engine and its ratio") {
    const auto line =
        nlohmann::json::parse(compare_line(all_scenes().front(), "box2d 2.4", some_measurement(), 5.5));
    CHECK(line.at("engine") == "box2d 2.4");
    CHECK(line.at("ratio") == 5.5);
    CHECK(line.at("ms_total") == 6);
}

}  // namespace cairn::bench
