// Twenty thousand random calls of the public interface: nothing breaks, nothing becomes infinite, nothing
// stays.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

class Fuzz {
  public:
    explicit Fuzz(std::uint64_t seed) : random_(seed) {
        add_ground(world_);
        add(world_, {.type = BodyType::Static, .position_m = {-8, 10}}, Box{0.5f, 10});
        add(world_, {.type = BodyType::Static, .position_m = {8, 10}}, Box{0.5f, 10});
    }

    World& world() { return world_; }

    void call() {
        const std::vector<BodyId> bodies = world_.bodies();
        const int choice = random_.below(100);
        if (bodies.size() < 10 || (choice < 10 && bodies.size() < 60)) return create();
        Body body =
            *world_.body(bodies[static_cast<std::size_t>(random_.below(static_cast<int>(bodies.size())))]);
        const std::vector<ShapeId> shapes = body.shapes();
        const std::vector<JointId> joints = body.joints();
        if (choice < 15) {
            if (body.id() != bodies[0]) world_.destroy_body(body.id()).value();
        } else if (choice < 19) {
            add_random_shape(world_, random_, body.id());
        } else if (choice < 22) {
            if (!shapes.empty()) world_.destroy_shape(shapes.front()).value();
        } else if (choice < 26) {
            // Some pairs are refused: the same body twice, two immovable ones.
            const BodyId other =
                bodies[static_cast<std::size_t>(random_.below(static_cast<int>(bodies.size())))];
            static_cast<void>(world_.create_joint(RevoluteJointDef{.body_a = body.id(),
                                                                   .body_b = other,
                                                                   .local_anchor_b_m = {1, 0},
                                                                   .enable_limit = random_.chance(0.3),
                                                                   .lower_rad = -0.5f,
                                                                   .upper_rad = 0.5f,
                                                                   .enable_motor = random_.chance(0.3),
                                                                   .motor_speed_rad_s = 5,
                                                                   .max_motor_torque_nm = 20}));
        } else if (choice < 29) {
            const BodyId other =
                bodies[static_cast<std::size_t>(random_.below(static_cast<int>(bodies.size())))];
            static_cast<void>(world_.create_joint(DistanceJointDef{.body_a = body.id(),
                                                                   .body_b = other,
                                                                   .length_m = random_.real_f(0.1, 3),
                                                                   .enable_spring = random_.chance(0.5),
                                                                   .frequency_hz = random_.real_f(0.5, 20),
                                                                   .max_length_m = 4}));
        } else if (choice < 32) {
            if (!joints.empty()) world_.destroy_joint(joints.front()).value();
        } else if (choice < 36) {
            const double angle = random_.real(-10, 10);
            body.set_transform({random_.real(-7, 7), random_.real(0, 15)}, angle).value();
        } else if (choice < 42) {
            const Position at = body.world_center() + random_.vector(-1, 1);
            body.apply_impulse(random_.vector(-20, 20), at).value();
        } else if (choice < 46) {
            body.apply_force(random_.vector(-500, 500), body.world_center()).value();
        } else if (choice < 49) {
            body.set_linear_velocity(random_.vector(-50, 50)).value();
        } else if (choice < 52) {
            body.set_angular_velocity(random_.real_f(-50, 50)).value();
        } else if (choice < 55) {
            body.set_awake(random_.chance(0.5));
        } else if (choice < 57) {
            body.set_allow_sleep(random_.chance(0.7));
        } else if (choice < 60) {
            if (!shapes.empty())
                world_.shape(shapes.back())
                    ->set_filter({.mask = random_.bits() | 1, .group = random_.below(4) - 3});
        } else if (choice < 62) {
            if (!shapes.empty())
                world_.shape(shapes.back())
                    ->set_material({.friction = random_.real_f(0, 2), .restitution = random_.real_f(0, 1)})
                    .value();
        } else if (choice < 64) {
            world_.set_gravity(random_.vector(-10, 10)).value();
        } else if (choice < 65) {
            body.set_locks({random_.chance(0.2), random_.chance(0.2), random_.chance(0.2)});
        } else if (choice < 66) {
            const auto mixing = static_cast<Mixing>(random_.below(6));
            world_.set_material_rule(random_.below(4), random_.below(4), {.friction = {mixing, 0.5f}})
                .value();
        } else if (choice < 67) {
            if (!shapes.empty())
                world_.shape(shapes.back())
                    ->set_one_way_normal(random_.chance(0.5) ? Vec2{} : Vec2{0, 1})
                    .value();
        } else {
            world_.step(random_.chance(0.9) ? kStep_s : random_.real_f(0.001, 0.05)).value();
        }
    }

    void require_sane() {
        int shapes = 0;
        int awake = 0;
        for (const BodyId id : world_.bodies()) {
            const Body body = *world_.body(id);
            REQUIRE(is_finite(body.position()));
            REQUIRE(is_finite(body.linear_velocity()));
            REQUIRE(std::isfinite(body.angular_velocity()));
            shapes += static_cast<int>(body.shapes().size());
            awake += body.is_awake() ? 1 : 0;
            for (const ShapeId shape : body.shapes()) REQUIRE(world_.shape(shape)->body() == id);
            for (const JointId joint : body.joints()) {
                const Joint j = *world_.joint(joint);
                REQUIRE((j.body_a() == id || j.body_b() == id));
                REQUIRE(is_finite(j.reaction_force()));
            }
        }
        const Counts counts = world_.counts();
        REQUIRE(counts.bodies == static_cast<int>(world_.bodies().size()));
        REQUIRE(counts.shapes == shapes);
        REQUIRE(counts.awake_bodies == awake);
        REQUIRE(counts.touching <= counts.contacts);
    }

  private:
    void create() {
        const int kind = random_.below(8);
        const BodyType type = kind == 0   ? BodyType::Static
                              : kind == 1 ? BodyType::Kinematic
                                          : BodyType::Dynamic;
        const BodyId body = world_
                                .create_body({.type = type,
                                              .position_m = {random_.real(-7, 7), random_.real(0, 15)},
                                              .angle_rad = random_.real(-3, 3),
                                              .linear_velocity_m_s = random_.vector(-5, 5),
                                              .linear_damping_1_s = random_.real_f(0, 1),
                                              .gravity_scale = random_.real_f(-1, 2),
                                              .locks = {.x = random_.chance(0.05),
                                                        .y = random_.chance(0.05),
                                                        .rotation = random_.chance(0.1)}})
                                .value();
        add_random_shape(
            world_, random_, body,
            {.density_kg_m2 = random_.chance(0.1) ? 0 : random_.real_f(0.1, 10),
             .material = {.rolling_resistance = random_.chance(0.1) ? 0.2f : 0.0f,
                          .surface_speed_m_s = random_.chance(0.1) ? random_.real_f(-3, 3) : 0.0f,
                          .kind = random_.below(4)},
             .contact_events = true,
             .hit_events = true,
             .sensor = random_.chance(0.1),
             .one_way_normal = random_.chance(0.1) ? random_.vector(-1, 1) : Vec2{}});
    }

    Random random_;
    World world_;
};

}  // namespace

TEST_CASE("twenty thousand random calls leave every value finite and every count right") {
    Fuzz fuzz(1);
    for (int i = 0; i < 20'000; ++i) {
        fuzz.call();
        if (i % 50 != 0) continue;
        INFO("call " << i);
        fuzz.require_sane();
    }
    World& world = fuzz.world();
    while (!world.bodies().empty()) world.destroy_body(world.bodies().back()).value();
    CHECK(listed(world.counts()) == std::array{0, 0, 0, 0, 0, 0});
    world.step(kStep_s).value();
    world.step(kStep_s).value();
    CHECK(world.contact_ends().empty());
}

TEST_CASE("the same random calls give the same bits") {
    Fuzz a(2);
    Fuzz b(2);
    for (int i = 0; i < 3'000; ++i) {
        a.call();
        b.call();
        if (i % 100 == 0) REQUIRE(a.world().state_hash() == b.world().state_hash());
    }
    CHECK(a.world().state_hash() == b.world().state_hash());
}

}  // namespace cairn::physics
