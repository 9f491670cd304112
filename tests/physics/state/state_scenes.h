// Scenes for tests of snapshots: together they use everything that a world can hold. What is done to a world
// before a step follows from the world and the number of the step alone, so that a restored world gets the
// same as the one it was taken from.
#pragma once

#include <cairn/physics/prefabs/all.h>

#include "physics/support/scenes.h"

namespace cairn::physics::test {

inline Material restless(float friction) {
    return {.friction = friction, .restitution = 0.3f};
}

inline void build_joint_zoo(World& world) {
    add_ground(world);
    create_ragdoll(world, {.position_m = {-8, 1}, .spring_hz = 2}).value();
    create_vehicle(world, {.position_m = {-4, 1.5}}).value();
    create_gear_train(world, {.position_m = {0, 5}, .max_motor_torque_nm = 40}).value();
    create_pulley_lift(world, {.position_m = {6, 6}}).value();
    const Elevator elevator = create_elevator(world, {.position_m = {11, 0.3}}).value();
    send_elevator(world, elevator, 2).value();
    const BodyId post = world.create_body({.type = BodyType::Static, .position_m = {0, 9}}).value();
    const auto hang = [&](double x) { return add(world, {.position_m = {x, 8}}, Box{0.4f, 0.2f}); };
    world
        .create_joint(MotorJointDef{.body_a = post,
                                    .body_b = hang(-3),
                                    .target_offset_m = {-2, -1},
                                    .linear_frequency_hz = 2,
                                    .angular_frequency_hz = 3,
                                    .max_force_n = 50,
                                    .max_torque_nm = 5})
        .value();
    world.create_joint(MouseJointDef{.body_a = post, .body_b = hang(-1), .max_force_n = 60}).value();
    world
        .create_joint(
            FrictionJointDef{.body_a = post, .body_b = hang(1), .max_force_n = 1, .max_torque_nm = 1})
        .value();
    world
        .create_joint(WeldJointDef{.body_a = post,
                                   .body_b = hang(3),
                                   .local_anchor_a_m = {3, -1},
                                   .angular_frequency_hz = 3,
                                   .strength = {.break_force_n = 30}})
        .value();
    const BodyId a = hang(4.2);
    world.create_joint(FilterJointDef{.body_a = a, .body_b = hang(4.5)}).value();
}

inline void build_terrain(World& world) {
    const BodyId ground = world.create_body({.type = BodyType::Static}).value();
    std::vector<Vec2> points;
    for (int i = 0; i < 60; ++i) points.push_back({30.0f - static_cast<float>(i), i % 3 == 0 ? 0.4f : 0.0f});
    const std::array materials{restless(0.7f)};
    world.create_chain(ground, {.points_m = points, .materials = materials, .contact_events = true}).value();
    add(world, {.type = BodyType::Static, .position_m = {0, 2}}, Box{2, 0.1f}, {.one_way_normal = {0, 1}});
    add(world, {.type = BodyType::Static, .position_m = {-8, 1}}, Box{2, 2}, {.sensor = true});
    for (int i = 0; i < 25; ++i) {
        add(world,
            {.position_m = {-12.0 + i, 3 + 0.1 * (i % 4)}, .linear_velocity_m_s = {1, i % 2 == 0 ? 2.0f : 0}},
            Circle{{}, 0.3f},
            {.material = {.rolling_resistance = 0.02f, .kind = i % 3}, .contact_events = true});
    }
    world.set_material_rule(0, 2, {.friction = {Mixing::Fixed, 0.1f}}).value();
}

inline void build_breakables(World& world) {
    add_ground(world);
    for (int i = 0; i < 4; ++i) {
        const BodyId pane = add(
            world, {.type = i < 2 ? BodyType::Dynamic : BodyType::Static, .position_m = {4.0 * i - 6, 1.5}},
            Box{0.15f, 1.5f});
        world
            .set_breakable(pane,
                           {.strength_ns = 1, .fracture = {.pieces = 9}, .generations = 2, .automatic = true})
            .value();
    }
    for (int i = 0; i < 4; ++i) {
        add(world, {.position_m = {-20.0 - 9 * i, 1.5}, .linear_velocity_m_s = {25, 2}}, Circle{{}, 0.4f},
            {.density_kg_m2 = 4, .hit_events = true});
    }
}

inline void build_platforms(World& world) {
    add_ground(world);
    add(world, {.type = BodyType::Kinematic, .position_m = {0, 1}, .linear_velocity_m_s = {0.5f, 0}},
        Box{3, 0.2f}, {.material = {.surface_speed_m_s = 1}});
    for (int i = 0; i < 12; ++i) {
        add(world,
            {.position_m = {-2.5 + 0.4 * i, 2.0 + 0.8 * (i % 3)},
             .linear_damping_1_s = 0.1f,
             .locks = {.x = i % 4 == 0, .rotation = i % 3 == 0},
             .allow_sleep = i % 5 != 0},
            Box{0.25f, 0.3f}, {.density_kg_m2 = i % 4 == 1 ? 100.0f : 1.0f});
    }
}

inline void build_fast(World& world) {
    add_ground(world);
    add(world, {.type = BodyType::Static, .position_m = {10, 5}}, Box{0.05f, 5});
    for (int i = 0; i < 10; ++i) {
        add(world,
            {.position_m = {-30, 1 + 0.7 * i}, .linear_velocity_m_s = {300, 0}, .angular_velocity_rad_s = 40},
            Box{0.1f, 0.2f}, {.material = restless(0.3f)});
    }
}

/// Bodies come, are joined, pushed, changed, put to sleep and destroyed, as the number of the step has it.
inline void come_and_go(World& world, int step) {
    Random random(static_cast<std::uint64_t>(step) + 1);
    const std::vector<BodyId> bodies = world.bodies();
    const auto any = [&] {
        return bodies[static_cast<std::size_t>(random.below(static_cast<int>(bodies.size())))];
    };
    if (step % 3 == 0 && bodies.size() < 70) {
        const double x = random.real(-4, 4);
        const BodyId made = world.create_body({.position_m = {x, random.real(5, 8)}}).value();
        add_random_shape(world, random, made, {.contact_events = random.chance(0.3)});
        if (random.chance(0.3)) add_random_shape(world, random, made);
        const BodyId other = any();
        if (random.chance(0.3) && world.body(other)->type() == BodyType::Dynamic) {
            world
                .create_joint(RevoluteJointDef{.body_a = other,
                                               .body_b = made,
                                               .enable_motor = random.chance(0.5),
                                               .motor_speed_rad_s = 2,
                                               .max_motor_torque_nm = 3})
                .value();
        }
    }
    const BodyId chosen = any();
    Body body = *world.body(chosen);
    if (body.type() != BodyType::Dynamic) return;
    switch (step % 7) {
        case 1:
            body.apply_force_to_center(random.vector(-30, 30)).value();
            break;
        case 2:
            body.set_awake(false);
            break;
        case 3: {
            const std::vector<ShapeId> shapes = body.shapes();
            if (shapes.size() > 1) world.destroy_shape(shapes.front()).value();
            break;
        }
        case 4: {
            const double x = random.real(-4, 4);
            body.set_transform({x, 7}, 1).value();
            break;
        }
        case 5:
            if (bodies.size() > 30) world.destroy_body(chosen).value();
            break;
        default:
            break;
    }
}

inline void build_pit(World& world) {
    add_ground(world);
    for (const double x : {-5.0, 5.0}) {
        add(world, {.type = BodyType::Static, .position_m = {x, 5}}, Box{0.5f, 5});
    }
}

/// Ten scenes, and what is done to them before each step.
inline std::vector<Scene> state_scenes() {
    const auto poke = [](World& world, int step) {
        if (step % 20 == 10) come_and_go(world, step / 20);
    };
    return {{"pyramid", [](World& world) { build_pyramid(world, 12); }},
            {"pile", [](World& world) { build_pile(world, 60, 7); }, poke},
            {"chain", [](World& world) { build_chain(world, 15); }, poke},
            {"springs", build_springs, poke},
            {"come and go", build_pit, come_and_go},
            {"joint zoo", build_joint_zoo, poke},
            {"terrain", build_terrain, poke},
            {"breakables", build_breakables},
            {"platforms", build_platforms, poke},
            {"fast", build_fast}};
}

}  // namespace cairn::physics::test
