#include "torture/runner.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "child.h"

namespace cairn::lab {
namespace {

using Json = nlohmann::ordered_json;

Outcome examine(const Case& test, const EngineKind& kind) {
    const auto run = [&](int threads) {
        Trial trial(kind, threads);
        test.run(trial);
        return trial.finish();
    };
    Outcome outcome;
    outcome.findings = run(1);
    if (kind.name == "cairn") {
        const std::uint64_t digest = outcome.findings.digest;
        outcome.same_on_threads = run(2).digest == digest && run(8).digest == digest;
    }
    return outcome;
}

// Numbers that are none are null in JSON.
double number(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

Outcome ended(std::string by) {
    Outcome outcome;
    outcome.ended_by = std::move(by);
    return outcome;
}

}  // namespace

bool Outcome::passed() const {
    return ended_by.empty() && findings.finite && findings.energy_excess <= kMostEnergyExcess &&
           same_on_threads.value_or(true) &&
           std::all_of(findings.figures.begin(), findings.figures.end(),
                       [](const Figure& figure) { return figure.holds(); });
}

std::string to_text(const Outcome& outcome) {
    Json text;
    text["figures"] = Json::array();
    for (const Figure& figure : outcome.findings.figures) {
        text["figures"].push_back({figure.name, figure.value, figure.limit, figure.at_most});
    }
    text["energy_excess"] = outcome.findings.energy_excess;
    text["finite"] = outcome.findings.finite;
    text["cpu_s"] = outcome.findings.cpu_s;
    if (outcome.same_on_threads) text["same_on_threads"] = *outcome.same_on_threads;
    return text.dump();
}

Outcome outcome_from(const std::string& text) {
    const Json read = Json::parse(text, nullptr, false);
    if (!read.is_object() || !read.contains("figures")) return ended("an answer that cannot be read");
    Outcome outcome;
    for (const Json& figure : read["figures"]) {
        outcome.findings.figures.push_back({figure.at(0).get<std::string>(), number(figure.at(1)),
                                            number(figure.at(2)), figure.at(3).get<bool>()});
    }
    outcome.findings.energy_excess = number(read["energy_excess"]);
    outcome.findings.finite = read["finite"].get<bool>();
    outcome.findings.cpu_s = number(read["cpu_s"]);
    if (read.contains("same_on_threads")) outcome.same_on_threads = read["same_on_threads"].get<bool>();
    return outcome;
}

Outcome run_case(const Case& test, const EngineKind& kind) {
    const Answer answer = ask_child([&] { return to_text(examine(test, kind)); });
    return answer.ended_by.empty() ? outcome_from(answer.text) : ended(answer.ended_by);
}

}  // namespace cairn::lab
