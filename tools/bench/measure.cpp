// Takes the time of a scene. Between the timed steps nothing is read that takes longer than a look at the
// clock.
#include "measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "memory_meter.h"

namespace cairn::bench {
namespace {

using Clock = std::chrono::steady_clock;
using measure::allocations;
using measure::live_bytes;
using measure::peak_bytes;
using measure::restart_peak;
using physics::Profile;
using physics::Snapshot;
using physics::Vec2;
using physics::World;

double ms_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

// The world as it runs: the number of the next step belongs to it.
class Run {
  public:
    Run(Engine& engine, BeforeStep before, Findings& findings)
        : engine_(engine), before_(std::move(before)), findings_(findings) {}

    void step() {
        if (before_) before_(engine_, next_, findings_);
        engine_.step(kStep_s);
        ++next_;
    }

  private:
    Engine& engine_;
    BeforeStep before_;
    Findings& findings_;
    int next_ = 0;
};

void add(Profile& sum, const Profile& step) {
    for (std::size_t i = 0; i < sum.stage_ms.size(); ++i) sum.stage_ms[i] += step.stage_ms[i];
}

// The clock of the stages would be a part of the time where a step is too short for a clock of its own.
bool profiles_while_timed(const Scene& scene) {
    return scene.steps_per_sample == 1;
}

void run_timed_steps(const Scene& scene, Engine& engine, Run& run, int samples, Measurement& m) {
    World* const world = engine.cairn_world();
    const bool profiles = world != nullptr && profiles_while_timed(scene);
    if (world != nullptr) world->set_profiling(profiles);
    m.step_ms.reserve(samples);
    std::int64_t allocations_at_half = allocations();
    for (int sample = 0; sample < samples; ++sample) {
        if (sample == samples / 2) allocations_at_half = allocations();
        const Clock::time_point start = Clock::now();
        for (int i = 0; i < scene.steps_per_sample; ++i) run.step();
        const double ms = ms_between(start, Clock::now());
        m.ms_total += ms;
        m.step_ms.push_back(ms / scene.steps_per_sample);
        m.awake_body_steps += std::int64_t{scene.steps_per_sample} * engine.awake_bodies();
        if (profiles) add(m.stages, world->profile());
    }
    m.allocations = allocations() - allocations_at_half;
    if (profiles) {
        for (double& ms : m.stages.stage_ms) ms /= std::max(samples, 1);
    }
}

int steps_of(const Scene& scene, int most_steps) {
    return most_steps > 0 ? std::min(most_steps, scene.steps) : scene.steps;
}

float root_mean_square_change(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
    double sum = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        sum += static_cast<double>(length_squared(after[i] - before[i]));
    }
    return before.empty() ? 0 : static_cast<float>(std::sqrt(sum / static_cast<double>(before.size())));
}

}  // namespace

Measurement measure(const Scene& scene, MakeEngine make_engine, int threads, int most_steps) {
    Measurement m;
    m.steps = steps_of(scene, most_steps);
    const int untimed = std::min(scene.untimed_steps, m.steps);
    const int samples = (m.steps - untimed) / scene.steps_per_sample;

    const std::int64_t bytes_before = live_bytes();
    restart_peak();
    WorldSetting setting = scene.world;
    setting.threads = threads;
    const std::unique_ptr<Engine> engine = make_engine(setting);
    Run run(*engine, scene.build(*engine), m.findings);
    for (int i = 0; i < untimed; ++i) run.step();
    run_timed_steps(scene, *engine, run, samples, m);

    m.bytes_peak = peak_bytes() - bytes_before;
    m.tally = engine->tally();
    m.max_penetration_m = engine->max_penetration_m();
    World* const world = engine->cairn_world();
    if (world != nullptr) {
        m.state_hash = world->state_hash() ^ m.findings.digest;
        world->set_profiling(true);
    }
    const std::vector<Vec2> before = engine->velocities_m_s();
    run.step();
    m.jitter_m_s = root_mean_square_change(before, engine->velocities_m_s());
    if (world != nullptr && !profiles_while_timed(scene)) m.stages = world->profile();
    return m;
}

WarmRun run_warm(const Scene& scene, int threads, int most_steps) {
    // A world holds the state it is in and room for the one it may be restored to, which change places: runs
    // warm up the one and the other by turns. Each gives back once what only the begin of a scene took, and
    // takes it again in its second run.
    constexpr int kWarmingRuns = 4;
    WorldSetting setting = scene.world;
    setting.threads = threads;
    const std::unique_ptr<Engine> engine = measure::make_cairn(setting);
    World& world = *engine->cairn_world();
    const BeforeStep before = scene.build(*engine);
    const Snapshot start = world.snapshot().value();
    WarmRun warm;
    for (int i = 0; i <= kWarmingRuns; ++i) {
        if (i > 0) world.restore(start.bytes()).value();
        Findings findings;
        Run run(*engine, before, findings);
        const std::int64_t allocations_before = allocations();
        for (int step = 0; step < steps_of(scene, most_steps); ++step) run.step();
        warm.allocations = allocations() - allocations_before;
        warm.state_hash = world.state_hash() ^ findings.digest;
    }
    return warm;
}

}  // namespace cairn::bench
