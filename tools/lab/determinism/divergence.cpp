// Histories hold hashes only; the states at the place of the first difference are made by running again.
#include "determinism/divergence.h"

#include <algorithm>
#include <array>
#include <bit>

#include "text.h"

namespace cairn::lab {
namespace {

using measure::format;
using physics::World;

constexpr std::array kQuantities{"x", "y", "cos", "sin", "vx", "vy", "w", "awake"};

// More than what rounding would swallow again, at any speed of these scenes.
constexpr float kNudge_m_s = 1e-5f;

using BodyState = std::array<double, kQuantities.size()>;

BodyState state_of(const physics::Body& body) {
    const physics::Transform pose = body.transform();
    const physics::Vec2 v = body.linear_velocity();
    return {pose.p.x,
            pose.p.y,
            static_cast<double>(pose.q.c),
            static_cast<double>(pose.q.s),
            static_cast<double>(v.x),
            static_cast<double>(v.y),
            static_cast<double>(body.angular_velocity()),
            body.is_awake() ? 1.0 : 0.0};
}

void nudge(World& world) {
    const std::vector<physics::BodyId> bodies = world.bodies();
    // Near the middle: the first ones are often what stands around.
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        auto body = world.body(bodies[(i + bodies.size() / 2) % bodies.size()]);
        if (body->type() != physics::BodyType::Dynamic || !body->is_awake()) continue;
        physics::Vec2 v = body->linear_velocity();
        v.x += kNudge_m_s;
        body->set_linear_velocity(v).value();
        return;
    }
}

/// Calls after(world, step) after each step.
template <class After>
void run(const bench::Scene& scene, const RunSetting& setting, int steps, After&& after) {
    physics::force_simd_level(setting.simd).value();
    bench::WorldSetting world_setting = scene.world;
    world_setting.threads = setting.threads;
    const auto engine = measure::make_cairn(world_setting);
    const bench::BeforeStep before = scene.build(*engine);
    bench::Findings findings;
    World& world = *engine->cairn_world();
    for (int step = 0; step < steps; ++step) {
        if (before) before(*engine, step, findings);
        if (step == setting.nudged_step) nudge(world);
        engine->step(bench::kStep_s);
        after(world, step);
    }
}

std::vector<BodyState> states_after(const bench::Scene& scene, const RunSetting& setting, int step) {
    std::vector<BodyState> states;
    run(scene, setting, step + 1, [&](World& world, int now) {
        if (now != step) return;
        for (const physics::BodyId body : world.bodies()) states.push_back(state_of(*world.body(body)));
    });
    return states;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

History record(const bench::Scene& scene, const RunSetting& setting, int steps) {
    History history;
    run(scene, setting, steps, [&](World& world, int step) {
        history.hashes.push_back(world.state_hash());
        if (step + 1 == steps) history.bodies = world.counts().bodies;
    });
    return history;
}

std::optional<Divergence> divergence(const bench::Scene& scene, const RunSetting& reference,
                                     const RunSetting& setting, const History& reference_history,
                                     const History& history) {
    const auto [at, other] = std::mismatch(reference_history.hashes.begin(), reference_history.hashes.end(),
                                           history.hashes.begin(), history.hashes.end());
    if (at == reference_history.hashes.end()) return std::nullopt;

    Divergence found;
    found.step = static_cast<int>(at - reference_history.hashes.begin());
    const std::vector<BodyState> expected = states_after(scene, reference, found.step);
    const std::vector<BodyState> got = states_after(scene, setting, found.step);
    found.bodies = static_cast<int>(expected.size());
    if (expected.size() != got.size()) {
        found.what = format("%zu bodies and %zu", expected.size(), got.size());
        return found;
    }
    for (std::size_t body = 0; body < expected.size(); ++body) {
        for (std::size_t i = 0; i < kQuantities.size(); ++i) {
            if (same_bits(expected[body][i], got[body][i])) continue;
            found.body = static_cast<int>(body);
            found.what = format("%s: %.17g and %.17g", kQuantities[i], expected[body][i], got[body][i]);
            return found;
        }
    }
    found.what = "what contacts and joints remember";
    return found;
}

}  // namespace cairn::lab
