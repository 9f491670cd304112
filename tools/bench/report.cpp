// What the measurements are called and how they are laid out.
#include "report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "text.h"

namespace cairn::bench {
namespace {

using Json = nlohmann::ordered_json;
using measure::format;
using measure::rounded;

std::string hex(std::uint64_t hash) {
    return format("%016llx", static_cast<unsigned long long>(hash));
}

Json times_of(const Measurement& m) {
    const Spread spread = spread_of(m.step_ms);
    return {{"min", rounded(spread.min)}, {"median", rounded(spread.median)}, {"p99", rounded(spread.p99)}};
}

Json stages_of(const Measurement& m) {
    Json stages = Json::object();
    for (const physics::Stage stage : physics::kStages) {
        stages[std::string(name(stage))] = rounded(m.stages[stage]);
    }
    return stages;
}

void add_common(Json& line, const Measurement& m) {
    line["steps"] = m.steps;
    line["bodies"] = m.tally.bodies;
    line["contacts"] = m.tally.contacts;
    line["touching"] = m.tally.touching;
    line["joints"] = m.tally.joints;
    line["ms_total"] = rounded(m.ms_total);
    line["ms_per_step"] = times_of(m);
}

void add_quality(Json& line, const Measurement& m) {
    line["awake_body_steps"] = m.awake_body_steps;
    line["max_penetration_m"] = rounded(static_cast<double>(m.max_penetration_m));
    line["jitter_m_s"] = rounded(static_cast<double>(m.jitter_m_s));
}

// "1.23 ms", or with the unit that suits the size.
std::string time_text(double ms) {
    if (ms >= 0.1) return format("%.3f ms", ms);
    if (ms >= 0.001) return format("%.2f us", 1e3 * ms);
    return format("%.0f ns", 1e6 * ms);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto rank = [&](double share) {
        const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
        return values[std::max<std::size_t>(at, 1) - 1];
    };
    return {values.front(), rank(0.5), rank(0.99)};
}

std::string run_line(const Scene& scene, const RunSetting& setting, const Measurement& m) {
    Json line;
    line["scene"] = scene.name;
    line["threads"] = setting.threads;
    line["simd"] = setting.simd;
    add_common(line, m);
    line["stages_ms"] = stages_of(m);
    line["allocations"] = m.allocations;
    if (m.allocations_warm) line["allocations_warm"] = *m.allocations_warm;
    line["bytes_peak"] = m.bytes_peak;
    add_quality(line, m);
    line["state_hash"] = hex(m.state_hash);
    for (const Findings::Cost& cost : m.findings.costs) line["ns_each"][cost.what] = rounded(cost.ns_each);
    return line.dump();
}

std::string compare_line(const Scene& scene, std::string_view engine, const Measurement& m, double ratio) {
    Json line;
    line["scene"] = scene.name;
    line["engine"] = engine;
    add_common(line, m);
    line["ratio"] = rounded(ratio);
    add_quality(line, m);
    return line.dump();
}

std::string run_table_head() {
    return format("%-14s %8s %8s %6s %11s %11s %11s %11s %6s %9s %8s %9s %16s", "scene", "bodies", "touching",
                  "steps", "total", "median", "min", "p99", "alloc", "peak", "deepest", "jitter",
                  "state hash");
}

std::string run_table_row(const Scene& scene, const Measurement& m) {
    const Spread spread = spread_of(m.step_ms);
    std::string row = format(
        "%-14s %8d %8d %6d %8.1f ms %11s %11s %11s %6lld %6.1f MB %5.2f mm %9.1e %16s", scene.name.c_str(),
        m.tally.bodies, m.tally.touching, m.steps, m.ms_total, time_text(spread.median).c_str(),
        time_text(spread.min).c_str(), time_text(spread.p99).c_str(), static_cast<long long>(m.allocations),
        static_cast<double>(m.bytes_peak) / 1e6, 1e3 * static_cast<double>(m.max_penetration_m),
        static_cast<double>(m.jitter_m_s), hex(m.state_hash).c_str());
    row += "\n    ";
    for (const physics::Stage stage : physics::kStages) {
        row += format(" %s %s ", std::string(name(stage)).c_str(), time_text(m.stages[stage]).c_str());
    }
    if (m.allocations_warm)
        row += format("\n     run again in its world: %lld allocations",
                      static_cast<long long>(*m.allocations_warm));
    for (const Findings::Cost& cost : m.findings.costs) {
        row += format("\n     %s: %.0f ns each", cost.what.c_str(), cost.ns_each);
    }
    return row;
}

std::string compare_table_head() {
    return format("%-14s %-16s %11s %11s %8s %8s %13s %9s %9s", "scene", "engine", "total", "median", "ratio",
                  "touching", "awake steps", "deepest", "jitter");
}

std::string compare_table_row(const Scene& scene, std::string_view engine, const Measurement& m,
                              double ratio) {
    return format("%-14s %-16s %8.1f ms %11s %8.2f %8d %13lld %6.2f mm %9.1e", scene.name.c_str(),
                  std::string(engine).c_str(), m.ms_total, time_text(spread_of(m.step_ms).median).c_str(),
                  ratio, m.tally.touching, static_cast<long long>(m.awake_body_steps),
                  1e3 * static_cast<double>(m.max_penetration_m), static_cast<double>(m.jitter_m_s));
}

}  // namespace cairn::bench
