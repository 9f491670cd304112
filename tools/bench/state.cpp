// Stacks, which are what snapshots are largest for: everything touches. Each is measured as it stands after
// some steps, and awake but where it says so.
#include "state.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>

#include <cairn/physics/recording.h>
#include <cairn/physics/world.h>

namespace cairn::bench {
namespace {

using namespace physics;

constexpr float kStep_s = 1.0f / 60;
constexpr int kRollbackFrames = 8;

struct StateScene {
    const char* name;
    int steps;
    bool sleeps;
    std::function<void(World&)> build;
};

void add_box(World& world, const BodyDef& def, const Box& box) {
    world.create_shape(world.create_body(def).value(), box).value();
}

void add_ground(World& world) {
    add_box(world, {.type = BodyType::Static, .position_m = {0, -1}}, {200, 1});
}

void build_towers(World& world) {
    add_ground(world);
    for (int i = 0; i < 1000; ++i)
        add_box(world, {.position_m = {2.0 * (i / 10) - 100, 0.5 + i % 10}}, {0.5f, 0.5f});
}

void build_pyramid(World& world) {
    constexpr int kBase = 44;
    add_ground(world);
    for (int row = 0; row < kBase; ++row) {
        for (int i = 0; i < kBase - row; ++i)
            add_box(world, {.position_m = {1.1 * i + 0.55 * row - 0.55 * kBase, 0.5 + row}}, {0.5f, 0.5f});
    }
}

// Boxes of which no two are alike, in a pit.
void build_heap(World& world, int count) {
    add_ground(world);
    for (const double x : {-8.5, 8.5})
        add_box(world, {.type = BodyType::Static, .position_m = {x, 50}}, {0.5f, 50});
    for (int i = 0; i < count; ++i) {
        const float size = 0.15f + 0.2f * static_cast<float>(i) / static_cast<float>(count);
        add_box(world,
                {.position_m = {-7.2 + 0.8 * (i % 19), 0.5 + 0.75 * (i / 19)}, .angle_rad = 0.1 * (i % 7)},
                {size, 0.5f - size});
    }
}

const std::array<StateScene, 5>& scenes() {
    static const std::array<StateScene, 5> all{{
        {"towers of 10", 120, false, build_towers},
        {"pyramid", 120, false, build_pyramid},
        {"pyramid asleep", 120, true, build_pyramid},
        {"heap, no two alike", 400, false, [](World& world) { build_heap(world, 1000); }},
        {"heap of 200", 200, false, [](World& world) { build_heap(world, 200); }},
    }};
    return all;
}

template <class Work>
double least_us(int repeat, Work&& work) {
    double least = 1e30;
    for (int i = 0; i < repeat; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
        least = std::min(least, taken.count());
    }
    return least;
}

void step(World& world) {
    world.step(kStep_s).value();
}

StateFigures measure(const StateScene& scene, int repeat) {
    World world({.enable_sleep = scene.sleeps});
    scene.build(world);
    for (int i = 0; i < scene.steps; ++i) step(world);
    Snapshot before;
    Snapshot snapshot;
    Snapshot delta;
    world.snapshot(before).value();
    step(world);
    world.snapshot(snapshot).value();
    make_delta(before.bytes(), snapshot.bytes(), delta).value();

    StateFigures figures;
    figures.scene = scene.name;
    figures.bodies = world.counts().bodies;
    figures.contacts = world.counts().contacts;
    figures.bytes = snapshot.size();
    figures.delta_bytes = delta.size();
    figures.save_us = least_us(repeat, [&] { world.snapshot(snapshot).value(); });
    figures.restore_us = least_us(repeat, [&] { world.restore(snapshot.bytes()).value(); });
    figures.delta_us = least_us(repeat, [&] { make_delta(before.bytes(), snapshot.bytes(), delta).value(); });
    figures.step_us = least_us(repeat, [&] {
        world.restore(snapshot.bytes()).value();
        step(world);
    });
    figures.step_us -= figures.restore_us;
    std::array<Snapshot, kRollbackFrames> frames;
    figures.rollback_ms = 1e-3 * least_us(repeat, [&] {
                              world.restore(snapshot.bytes()).value();
                              for (Snapshot& frame : frames) {
                                  step(world);
                                  world.snapshot(frame).value();
                              }
                          });
    return figures;
}

}  // namespace

std::vector<StateFigures> measure_state(int repeat) {
    std::vector<StateFigures> all;
    for (const StateScene& scene : scenes()) all.push_back(measure(scene, repeat));
    return all;
}

std::string state_table_head() {
    return "scene                bodies contacts  bytes/body delta/body  save us restore us delta us  step "
           "us "
           "rollback ms";
}

std::string state_table_row(const StateFigures& f) {
    char row[160];
    const auto bodies = static_cast<double>(f.bodies);
    std::snprintf(row, sizeof row, "%-20s %6d %8d %11.0f %10.0f %8.1f %10.1f %8.1f %8.1f %11.2f",
                  f.scene.c_str(), f.bodies, f.contacts, static_cast<double>(f.bytes) / bodies,
                  static_cast<double>(f.delta_bytes) / bodies, f.save_us, f.restore_us, f.delta_us, f.step_us,
                  f.rollback_ms);
    return row;
}

}  // namespace cairn::bench
