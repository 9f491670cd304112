#include "torture/case.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace cairn::lab {

bool Figure::holds() const {
    if (std::isnan(limit)) return true;
    return at_most ? value <= limit : value >= limit;
}

Rig& Trial::rig(const WorldSetting& setting) {
    close();
    WorldSetting own = setting;
    own.threads = threads_;
    rig_ = std::make_unique<Rig>(kind_, own);
    return *rig_;
}

void Trial::at_most(std::string name, double value, double limit) {
    findings_.figures.push_back({std::move(name), value, limit, true});
}

void Trial::at_least(std::string name, double value, double limit) {
    findings_.figures.push_back({std::move(name), value, limit, false});
}

void Trial::require(std::string name, bool holds) {
    at_least(std::move(name), holds ? 1 : 0, 1);
}

void Trial::note(std::string name, double value) {
    findings_.figures.push_back({std::move(name), value});
}

bool Trial::is_cairn() const {
    return kind_.name == "cairn";
}

Findings Trial::finish() {
    close();
    return findings_;
}

void Trial::close() {
    if (rig_ == nullptr) return;
    findings_.energy_excess = std::max(findings_.energy_excess, rig_->energy_excess());
    findings_.finite = findings_.finite && rig_->finite();
    findings_.digest = findings_.digest * 0x9e3779b97f4a7c15u ^ rig_->digest();
    findings_.cpu_s += rig_->cpu_s();
    rig_.reset();
}

std::span<const Case> all_cases() {
    static const std::vector<Case> cases = [] {
        std::vector<Case> all;
        add_heavy_on_light(all);
        add_stacks(all);
        add_chains(all);
        add_rigid_joints(all);
        add_springs(all);
        add_joint_limits(all);
        add_time_steps(all);
        add_sizes_and_places(all);
        add_fast_motion(all);
        add_overlaps(all);
        add_bad_input(all);
        add_extreme_materials(all);
        add_sleepers(all);
        // "19b" follows 19.
        std::stable_sort(all.begin(), all.end(), [](const Case& a, const Case& b) {
            return std::atoi(a.number.c_str()) < std::atoi(b.number.c_str());
        });
        return all;
    }();
    return cases;
}

double slop_m(double size_m) {
    return std::min(0.005, 0.01 * size_m);
}

}  // namespace cairn::lab
