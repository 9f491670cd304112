// Runs a scene with every setting and puts what comes of it into words.
#include "determinism/proof.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "determinism/joint_scenes.h"
#include "text.h"

namespace cairn::lab {
namespace {

using Json = nlohmann::ordered_json;
using measure::format;

constexpr int kMostThreads = 8;

std::string hex(std::uint64_t hash) {
    return format("%016llx", static_cast<unsigned long long>(hash));
}

std::string last_hash(const History& history) {
    return history.hashes.empty() ? "" : hex(history.hashes.back());
}

}  // namespace

const std::vector<bench::Scene>& determinism_scenes() {
    static const std::vector<bench::Scene> scenes = [] {
        std::vector<bench::Scene> list(bench::all_scenes().begin(), bench::all_scenes().end());
        for (bench::Scene& scene : joint_scenes()) list.push_back(std::move(scene));
        return list;
    }();
    return scenes;
}

std::vector<RunSetting> determinism_settings(bool quick) {
    std::vector<physics::SimdLevel> levels = physics::available_simd_levels();
    std::reverse(levels.begin(), levels.end());
    std::vector<RunSetting> settings;
    for (const physics::SimdLevel level : levels) {
        for (int threads = 1; threads <= kMostThreads; ++threads) {
            const bool few =
                threads == 1 || (level == levels.front() && (threads == 2 || threads == kMostThreads));
            if (!quick || few) settings.push_back({threads, level});
        }
    }
    return settings;
}

bool Proof::holds() const {
    return std::none_of(comparisons.begin(), comparisons.end(),
                        [](const Comparison& c) { return c.divergence.has_value(); });
}

Proof prove(const bench::Scene& scene, const std::vector<RunSetting>& settings, int most_steps,
            int nudged_step) {
    Proof proof;
    proof.scene = &scene;
    proof.steps = most_steps > 0 ? std::min(most_steps, scene.steps) : scene.steps;
    const RunSetting& reference = settings.front();
    proof.reference = record(scene, reference, proof.steps);
    for (std::size_t i = 1; i < settings.size(); ++i) {
        Comparison comparison;
        comparison.setting = settings[i];
        if (i + 1 == settings.size()) comparison.setting.nudged_step = nudged_step;
        comparison.history = record(scene, comparison.setting, proof.steps);
        comparison.divergence =
            divergence(scene, reference, comparison.setting, proof.reference, comparison.history);
        proof.comparisons.push_back(std::move(comparison));
    }
    return proof;
}

std::string determinism_head() {
    return format("%-18s %8s %6s %5s %16s", "scene", "bodies", "steps", "runs", "state hash");
}

std::vector<std::string> determinism_rows(const Proof& proof) {
    std::vector<std::string> rows{format("%-18s %8d %6d %5zu %16s  %s", proof.scene->name.c_str(),
                                         proof.reference.bodies, proof.steps, proof.comparisons.size() + 1,
                                         last_hash(proof.reference).c_str(),
                                         proof.holds() ? "same" : "! differs")};
    for (const Comparison& c : proof.comparisons) {
        if (!c.divergence) continue;
        const Divergence& d = *c.divergence;
        const std::string who = d.body < 0 ? "" : format("body %d of %d, ", d.body, d.bodies);
        rows.push_back(format("    ! %d threads, %s: first after step %d, %s%s", c.setting.threads,
                              std::string(name(c.setting.simd)).c_str(), d.step, who.c_str(),
                              d.what.c_str()));
    }
    return rows;
}

std::vector<std::string> determinism_lines(const Proof& proof) {
    std::vector<std::string> lines;
    for (const Comparison& c : proof.comparisons) {
        Json line;
        line["scene"] = proof.scene->name;
        line["threads"] = c.setting.threads;
        line["simd"] = name(c.setting.simd);
        line["steps"] = proof.steps;
        line["bodies"] = c.history.bodies;
        line["hash"] = last_hash(c.history);
        line["same"] = !c.divergence.has_value();
        if (c.divergence) {
            line["first_step"] = c.divergence->step;
            line["first_body"] = c.divergence->body;
            line["what"] = c.divergence->what;
        }
        lines.push_back(line.dump());
    }
    return lines;
}

}  // namespace cairn::lab
