// Random operations on a world's data, with every invariant of its stores checked on the way.
#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/invariants.h"
#include "physics/support/random.h"
#include "physics/support/random_shapes.h"
#include "world/bodies.h"
#include "world/contacts.h"
#include "world/fast_bodies.h"
#include "world/fracture.h"
#include "world/joints.h"
#include "world/material_mixing.h"
#include "world/sleep.h"
#include "world/step.h"

namespace cairn::physics {
namespace {

using namespace test;

template <class Slots>
std::vector<int> alive_in(const Slots& slots) {
    std::vector<int> alive;
    for (int i = 0; i < slots.end_index(); ++i) {
        if (slots.alive(i)) alive.push_back(i);
    }
    return alive;
}

class Operations {
  public:
    explicit Operations(std::uint64_t seed) : random_(seed), world_(WorldDef{}, 1) {}

    WorldState& world() { return world_; }

    void one_of_many() {
        Stores& stores = world_.stores;
        const std::vector<int> bodies = alive_in(stores.bodies.slots);
        const std::vector<int> shapes = alive_in(stores.shapes);
        const std::vector<int> joints = alive_in(stores.joints.slots);
        const int choice = random_.below(100);
        if (bodies.size() < 5 || (choice < 14 && bodies.size() < 60)) return create();
        const int body = pick(bodies);
        if (choice < 22) return destroy_body(world_, body);
        if (choice < 30) return add_shape(body);
        if (choice < 36 && !shapes.empty()) return destroy_shape(world_, pick(shapes));
        if (choice < 44) return join(body, pick(bodies));
        if (choice < 48 && !joints.empty()) return destroy_joint(stores, pick(joints));
        if (choice < 54) {
            const double angle = random_.real(-3, 3);
            return teleport(stores, body, {random_.real(-5, 5), random_.real(0, 6)}, angle);
        }
        if (choice < 60) return wake_body(stores, body);
        if (choice < 66) return put_island_to_sleep(stores, world_.scratch, body);
        if (choice < 72 && !shapes.empty()) return refilter(pick(shapes));
        if (choice < 74 && !shapes.empty()) return make_of_other_material(pick(shapes));
        if (choice < 80) return push(body);
        if (choice < 81) return toggle_breakable(body);
        if (choice < 84 && bodies.size() < 100) return divide(body);
        step_world(world_, 1.0f / 60);
    }

  private:
    void toggle_breakable(int body) {
        if (is_breakable(world_.stores, body)) return forget_breakable(world_.stores, body);
        const float strength = random_.real_f(0.1, 3);
        const int generations = 1 + random_.below(2);
        make_breakable(world_.stores, body,
                       {.strength_ns = strength,
                        .fracture = {.pieces = 3, .min_width_m = 0.2f, .release = random_.chance(0.5)},
                        .generations = generations,
                        .automatic = true});
    }

    void divide(int body) {
        Stores& stores = world_.stores;
        if (validate_divisible(stores, body)) return;
        const RingPoint at{random_.real(-0.5, 0.5), random_.real(-0.5, 0.5)};
        const FractureDef def{.pieces = 2 + random_.below(4), .seed = random_.bits(), .min_width_m = 0.2f};
        const FracturePlan plan = random_.chance(0.5) ? plan_break(stores, body, at, def)
                                                      : plan_cut(stores, body, {{{-9, at.y}, {1, 0}}, 20});
        if (!plan.empty()) divide_body(world_, body, plan);
    }

    int pick(const std::vector<int>& from) { return from[random_.below(static_cast<int>(from.size()))]; }

    void create() {
        const int kind = random_.below(10);
        BodyDef def{.position_m = {random_.real(-5, 5), random_.real(0, 6)},
                    .angle_rad = random_.real(-3, 3),
                    .linear_velocity_m_s = random_.vector(-3, 3)};
        def.type = kind < 2 ? BodyType::Static : kind == 2 ? BodyType::Kinematic : BodyType::Dynamic;
        def.awake = random_.chance(0.8);
        if (kind == 2 && random_.chance(0.5)) def.linear_velocity_m_s = {};
        const int body = create_body(world_.stores, def);
        add_shape(body);
        if (random_.chance(0.2)) toggle_breakable(body);
    }
    void add_shape(int body) {
        const Form form = kForms[static_cast<std::size_t>(random_.below(kForms.size()))];
        const Convex convex = random_convex(random_, form);
        create_shape(world_.stores, body, convex,
                     {.filter = random_filter(),
                      .contact_events = random_.chance(0.5),
                      .sensor = random_.chance(0.1)});
    }
    Filter random_filter() {
        if (random_.chance(0.7)) return {};
        return {.categories = random_.bits() & 3, .mask = random_.bits() & 3, .group = random_.below(3) - 1};
    }
    void join(int a, int b) {
        const auto& slots = world_.stores.bodies.slots;
        const bool movable = slots[a].type == BodyType::Dynamic || slots[b].type == BodyType::Dynamic;
        if (a == b || !movable) return;
        if (random_.chance(0.3)) {
            create_joint(world_, WheelJointDef{.body_a = slots.id(a),
                                               .body_b = slots.id(b),
                                               .local_anchor_a_m = random_.vector(-1, 1),
                                               .local_angle_a_rad = random_.real_f(-3, 3),
                                               .enable_limit = random_.chance(0.5),
                                               .enable_motor = random_.chance(0.5),
                                               .motor_speed_rad_s = 5,
                                               .max_motor_torque_nm = 1,
                                               .collide_connected = random_.chance(0.5)});
        } else if (random_.chance(0.5)) {
            create_joint(world_, RevoluteJointDef{.body_a = slots.id(a),
                                                  .body_b = slots.id(b),
                                                  .local_anchor_a_m = random_.vector(-1, 1),
                                                  .local_anchor_b_m = random_.vector(-1, 1),
                                                  .collide_connected = random_.chance(0.5)});
        } else {
            create_joint(world_, DistanceJointDef{.body_a = slots.id(a),
                                                  .body_b = slots.id(b),
                                                  .length_m = random_.real_f(0.5, 3),
                                                  .enable_spring = random_.chance(0.5)});
        }
    }
    void refilter(int shape) {
        redefine_shape(world_.stores, shape, [&](ShapeDef& def) { def.filter = random_filter(); });
        refilter_shape(world_, shape);
    }
    void make_of_other_material(int shape) {
        const float friction = random_.real_f(0, 1);
        redefine_shape(world_.stores, shape, [&](ShapeDef& def) { def.material.friction = friction; });
        remix_contacts_of_shape(world_.stores, shape);
    }
    void push(int body) {
        if (!world_.stores.bodies.is_awake(body)) return;
        BodyRows& rows = world_.stores.bodies.rows(RowSet::Awake);
        rows.velocity[world_.stores.bodies.slots[body].row] += random_.vector(-3, 3);
    }

    Random random_;
    WorldState world_;
};

// What a step does after each search: contacts in use whose boxes have parted go.
void end_parted_contacts(WorldState& world) {
    for (const int contact : alive_in(world.stores.contacts.slots)) {
        const ContactRecord& c = world.stores.contacts.slots[contact];
        if (c.bucket != kNone && !are_near(world.stores, c.shape_a, c.shape_b))
            destroy_contact(world.stores, world.events, contact);
    }
}

}  // namespace

TEST_CASE("whatever is done to a world, its stores stay consistent") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Operations operations(seed);
        for (int i = 0; i < 4'000; ++i) {
            operations.one_of_many();
            if (i % 10 != 0) continue;
            INFO("seed " << seed << ", operation " << i);
            check_world(operations.world());
        }
        WorldState& world = operations.world();
        step_world(world, 1.0f / 60);
        step_world(world, 1.0f / 60);
        check_world(world);
        for (const int body : alive_in(world.stores.bodies.slots)) destroy_body(world, body);
        check_world(world);
        CHECK(world.stores.bodies.slots.size() == 0);
        CHECK(world.stores.shapes.size() == 0);
        CHECK(world.stores.contacts.slots.size() == 0);
        CHECK(world.stores.joints.slots.size() == 0);
        CHECK(count_listed(world.stores.contacts) == 0);
        CHECK(world.stores.joints.active.size() == 0);
        for (const Layer layer : kLayers) CHECK(world.stores.broad.tree(layer).size() == 0);
    }
}

TEST_CASE(
    "whenever pairs are looked for, every pair that overlaps has its contact afterwards, and one only") {
    for (const std::uint64_t seed : {4u, 5u}) {
        Operations operations(seed);
        for (int i = 0; i < 3'000; ++i) {
            operations.one_of_many();
            if (i % 7 != 0) continue;
            WorldState& world = operations.world();
            // As a step begins.
            cover_fast_ways(world.stores, world.def.gravity_m_s2, 1.0f / 60, world.scratch, world.tasks);
            find_new_pairs(world.stores, world.scratch, world.tasks);
            INFO("seed " << seed << ", operation " << i);
            check_nothing_missed(world.stores);
            check_contacts(world.stores);
            end_parted_contacts(world);
        }
    }
}

}  // namespace cairn::physics
