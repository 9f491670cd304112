// Scenes with everything in them, for tests that ask the same of many: determinism, memory, consistency.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "physics/support/making.h"
#include "physics/support/random.h"

namespace cairn::physics::test {

struct Scene {
    std::string name;
    std::function<void(World&)> build;
    /// Called before each step with its number.
    std::function<void(World&, int)> act = [](World&, int) {};
};

inline void build_stack(World& world) {
    add_ground(world);
    for (int i = 0; i < 10; ++i) add(world, {.position_m = {0, 0.5 + i}}, Box{0.5f, 0.5f});
}

inline void build_pyramid(World& world, int base) {
    add_ground(world);
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            add(world, {.position_m = {1.1 * i + 0.55 * row - 0.55 * base, 0.5 + row}}, Box{0.5f, 0.5f});
        }
    }
}

/// A shape of any kind, at most 1 m across.
inline ShapeId add_random_shape(World& world, Random& random, BodyId body, const ShapeDef& def = {}) {
    switch (random.below(4)) {
        case 0:
            return world.create_shape(body, Circle{{}, random.real_f(0.1, 0.4)}, def).value();
        case 1: {
            const float half = random.real_f(0.1, 0.3);
            return world.create_shape(body, Capsule{{-half, 0}, {half, 0}, random.real_f(0.08, 0.2)}, def)
                .value();
        }
        case 2: {
            const float half_width = random.real_f(0.1, 0.4);
            return world.create_shape(body, Box{half_width, random.real_f(0.1, 0.4), {}, 0, 0.02f}, def)
                .value();
        }
        default: {
            std::array<Vec2, 6> points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Rotation q = Rotation::from_angle(static_cast<double>(i) + random.real(0, 0.5));
                points[i] = rotate(q, {random.real_f(0.25, 0.4), 0});
            }
            return world.create_shape(body, Polygon{.points_m = points}, def).value();
        }
    }
}

/// A walled pit into which bodies of all shapes fall.
inline void build_pile(World& world, int count, std::uint64_t seed) {
    Random random(seed);
    add_ground(world);
    add(world, {.type = BodyType::Static, .position_m = {-6, 10}}, Box{0.5f, 10});
    add(world, {.type = BodyType::Static, .position_m = {6, 10}}, Box{0.5f, 10});
    for (int i = 0; i < count; ++i) {
        const BodyId body = world
                                .create_body({.position_m = {random.real(-4.5, 4.5), 1 + 0.15 * i},
                                              .angle_rad = random.real(-3, 3)})
                                .value();
        add_random_shape(
            world, random, body,
            {.material = {.friction = random.real_f(0.1, 1), .restitution = random.real_f(0, 0.5)},
             .contact_events = true,
             .hit_events = true});
    }
}

/// Links of a chain from a fixed point, with a heavy ball at its end.
inline void build_chain(World& world, int links) {
    add_ground(world);
    BodyId previous = world.create_body({.type = BodyType::Static, .position_m = {0, 12}}).value();
    Vec2 anchor{0, 0};
    const auto pin = [&](BodyId next, Vec2 at) {
        world
            .create_joint(RevoluteJointDef{
                .body_a = previous, .body_b = next, .local_anchor_a_m = anchor, .local_anchor_b_m = at})
            .value();
    };
    for (int i = 0; i < links; ++i) {
        const BodyId link =
            add(world, {.position_m = {0.25 + 0.5 * i, 12}}, Capsule{{-0.2f, 0}, {0.2f, 0}, 0.05f});
        pin(link, {-0.25f, 0});
        previous = link;
        anchor = {0.25f, 0};
    }
    pin(add(world, {.position_m = {0.5 * links + 0.5, 12}}, Circle{{}, 0.5f}, {.density_kg_m2 = 2}),
        {-0.5f, 0});
}

/// A net of balls on springs and ropes, with a motor below that stirs it.
inline void build_springs(World& world) {
    add_ground(world);
    const BodyId frame = world.create_body({.type = BodyType::Static, .position_m = {0, 10}}).value();
    std::vector<BodyId> balls;
    for (int i = 0; i < 12; ++i) {
        const int row = i / 4;
        const int column = i % 4;
        const BodyId ball = add(world, {.position_m = {column - 1.5, 9.0 - row}}, Circle{{}, 0.2f});
        const auto tie = [&](BodyId other, Vec2 anchor, float max_length) {
            world
                .create_joint(DistanceJointDef{.body_a = other,
                                               .body_b = ball,
                                               .local_anchor_a_m = anchor,
                                               .length_m = 1,
                                               .enable_spring = true,
                                               .frequency_hz = 3,
                                               .damping_ratio = 0.2f,
                                               .min_length_m = 0.5f,
                                               .max_length_m = max_length})
                .value();
        };
        row == 0 ? tie(frame, {static_cast<float>(column) - 1.5f, 0}, 2) : tie(balls[i - 4], {}, 1.5f);
        if (column > 0) tie(balls[i - 1], {}, 1.5f);
        balls.push_back(ball);
    }
    const BodyId stirrer = add(world, {.position_m = {0, 4.5}}, Box{2.5f, 0.1f}, {.density_kg_m2 = 3});
    world
        .create_joint(RevoluteJointDef{.body_a = frame,
                                       .body_b = stirrer,
                                       .local_anchor_a_m = {0, -5.5f},
                                       .enable_motor = true,
                                       .motor_speed_rad_s = 3,
                                       .max_motor_torque_nm = 500})
        .value();
}

/// Bodies come, are pushed, change and go while the world runs.
inline Scene coming_and_going(std::uint64_t seed) {
    struct State {
        Random random;
        std::vector<BodyId> bodies{};
    };
    const auto state = std::make_shared<State>(State{Random(seed)});
    return {
        "coming-and-going",
        [](World& world) {
            add_ground(world);
            add(world, {.type = BodyType::Static, .position_m = {-5, 5}}, Box{0.5f, 5});
            add(world, {.type = BodyType::Static, .position_m = {5, 5}}, Box{0.5f, 5});
            add(world, {.type = BodyType::Kinematic, .position_m = {0, 0.5}, .angular_velocity_rad_s = 1},
                Box{1.5f, 0.1f});
        },
        [state](World& world, int step) {
            auto& [random, bodies] = *state;
            if (step % 3 == 0 && bodies.size() < 80) {
                const BodyId body = world
                                        .create_body({.position_m = {random.real(-4, 4), random.real(6, 9)},
                                                      .linear_velocity_m_s = random.vector(-5, 5)})
                                        .value();
                add_random_shape(world, random, body);
                if (!bodies.empty() && random.chance(0.2)) {
                    world
                        .create_joint(DistanceJointDef{
                            .body_a = bodies.back(), .body_b = body, .length_m = 1.5f, .enable_spring = true})
                        .value();
                }
                bodies.push_back(body);
            }
            if (step % 7 == 0 && bodies.size() > 10) {
                const int chosen = random.below(static_cast<int>(bodies.size()));
                world.destroy_body(bodies[chosen]).value();
                bodies.erase(bodies.begin() + chosen);
            }
            if (step % 11 == 0) {
                const BodyId chosen = bodies[random.below(static_cast<int>(bodies.size()))];
                world.body(chosen)->apply_impulse_to_center(random.vector(-2, 2)).value();
            }
            if (step % 50 == 49) {
                const BodyId chosen = bodies[random.below(static_cast<int>(bodies.size()))];
                const double angle = random.real(-3, 3);
                world.body(chosen)->set_transform({random.real(-4, 4), 9}, angle).value();
            }
        }};
}

/// Fresh scenes: those with a state of their own start over.
inline std::vector<Scene> all_scenes() {
    return {{"stack", build_stack},
            {"pyramid", [](World& world) { build_pyramid(world, 20); }},
            {"pile", [](World& world) { build_pile(world, 120, 1); }},
            {"chain", [](World& world) { build_chain(world, 20); }},
            {"springs", build_springs},
            coming_and_going(2)};
}

}  // namespace cairn::physics::test
