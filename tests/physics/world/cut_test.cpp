#include <catch2/catch.hpp>

#include "physics/support/pieces.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

World weightless() {
    return World({.gravity_m_s2 = {}});
}

// A body that moves and turns somewhere, with random shapes that hang together.
BodyId add_moving(World& world, Random& random, const Geometry& geometry) {
    const Vec2 velocity = random.vector(-10, 10);
    return add(world,
               {.position_m = {random.real(-20, 20), random.real(-20, 20)},
                .angle_rad = random.real(-3, 3),
                .linear_velocity_m_s = velocity,
                .angular_velocity_rad_s = random.real_f(-10, 10)},
               geometry, {.density_kg_m2 = random.real_f(0.5, 20)});
}

std::vector<BodyId> cut_across(World& world, BodyId id, Vec2 offset, Vec2 direction) {
    const Position middle = world.body(id)->world_center() + offset;
    return world.cut_body(id, middle + -10 * direction, middle + 10 * direction).value();
}

TEST_CASE("A cut divides a box into two bodies, the left one first", "[fracture]") {
    World world = weightless();
    const BodyId box = add(world, {.position_m = {5, 3}}, Box{2, 1});
    const std::vector<BodyId> pieces = world.cut_body(box, {5.5, 0}, {5.5, 9}).value();
    REQUIRE(pieces.size() == 2);
    CHECK_FALSE(world.contains(box));
    CHECK(world.bodies() == pieces);
    CHECK(world.body(pieces[0])->world_center().x == Approx(4.25));
    CHECK(world.body(pieces[1])->world_center().x == Approx(6.25));
    CHECK(world.body(pieces[0])->mass() == Approx(5));
    CHECK(world.body(pieces[1])->mass() == Approx(3));
    // A point of the material keeps its local coordinates.
    CHECK(world.body(pieces[0])->position().x == Approx(5));
    CHECK(world.body(pieces[1])->position().y == Approx(3));
}

TEST_CASE("Cuts of random bodies conserve mass, momentum and angular momentum", "[fracture]") {
    Random random(1);
    const Geometry shapes[] = {Circle{{0.2f, 0}, 0.7f}, Capsule{{-1, 0}, {1, 0.2f}, 0.3f},
                               Box{1, 0.5f, {}, 0.3f, 0.1f}, Box{2, 0.2f}};
    int cuts = 0;
    for (int i = 0; i < 400; ++i) {
        World world = weightless();
        const BodyId body = add_moving(world, random, shapes[i % 4]);
        const Totals before = totals(world, std::array{body});
        const double angle = random.real(0, 7);
        const std::vector<BodyId> pieces = cut_across(
            world, body, random.vector(-0.1, 0.1),
            Rotation::from_angle(angle).c == 0 ? Vec2{1, 0} : rotate(Rotation::from_angle(angle), {1, 0}));
        if (pieces.empty()) continue;
        ++cuts;
        REQUIRE(pieces.size() == 2);
        const Totals after = totals(world, pieces);
        require_conserved(before, after, 20, 40);
        // Sharp bodies lose nothing; what chords leave out of rounded ones makes them turn a little faster.
        REQUIRE(after.kinetic_energy <= before.kinetic_energy * (i % 4 == 3 ? 1 + 1e-4 : 1.06));
        for (const BodyId piece : pieces) {
            for (const ShapeId shape : world.body(piece)->shapes()) REQUIRE(area_of_shape(world, shape) > 0);
        }
    }
    CHECK(cuts > 380);
}

TEST_CASE("The two parts of a cut move on as the material moved, and do not push each other", "[fracture]") {
    World world = weightless();
    const BodyId box =
        add(world, {.linear_velocity_m_s = {3, -1}, .angular_velocity_rad_s = 0.5f}, Box{1, 1});
    const Body whole = *world.body(box);
    const Position left{-0.5, 0};
    const Vec2 expected = whole.velocity_at(left);
    const std::vector<BodyId> pieces = world.cut_body(box, {0, -2}, {0, 2}).value();
    REQUIRE(pieces.size() == 2);
    CHECK(length(world.body(pieces[0])->linear_velocity() - expected) < 1e-6f);
    run_for(world, 1);
    CHECK(length(world.body(pieces[0])->linear_velocity() - expected) < 1e-3f);
    CHECK(world.body(pieces[0])->angular_velocity() == Approx(0.5f).margin(1e-3));
}

TEST_CASE("A cut that begins or ends within a shape does not divide it", "[fracture]") {
    World world = weightless();
    const BodyId box = add(world, {}, Box{1, 1});
    CHECK(world.cut_body(box, {0, -2}, {0, 0.5}).value().empty());
    CHECK(world.cut_body(box, {0, -0.5}, {0, 0.5}).value().empty());
    CHECK(world.cut_body(box, {0, 0}, {0, 5}).value().empty());
    CHECK(world.cut_body(box, {3, -2}, {3, 2}).value().empty());
    CHECK(world.cut_body(box, {0.995, -2}, {0.995, 2}).value().empty());  // would shave off 5 mm
    REQUIRE(world.contains(box));
    CHECK(world.cut_body(box, {0, -1}, {0, 1}).value().size() == 2);  // from side to side
}

TEST_CASE("A disc becomes two bodies with flat faces, as heavy together as it was", "[fracture]") {
    World world = weightless();
    const BodyId disc = add(world, {}, Circle{{}, 1}, {.density_kg_m2 = 3});
    const std::vector<BodyId> pieces = world.cut_body(disc, {-2, 0.1}, {2, 0.1}).value();
    REQUIRE(pieces.size() == 2);
    CHECK(world.body(pieces[0])->mass() + world.body(pieces[1])->mass() == Approx(3 * kPi));
    for (const BodyId piece : pieces) {
        for (const ShapeId shape : world.body(piece)->shapes()) {
            const Outline& outline = world.shape(shape)->outline();
            CHECK(outline.kind == ShapeKind::Polygon);
            CHECK(outline.radius_m == 0);
            for (int i = 0; i < outline.count; ++i)
                CHECK(length(outline.points_m[static_cast<std::size_t>(i)]) <= 1.00001f);
        }
    }
}

TEST_CASE("Parts of a compound that touch stay one body", "[fracture]") {
    World world = weightless();
    // A letter U: a base, and two arms.
    const BodyId body = add(world, {}, Box{2, 0.5f});
    world.create_shape(body, Box{0.5f, 1, {-1.5f, 1.5f}}).value();
    world.create_shape(body, Box{0.5f, 1, {1.5f, 1.5f}}).value();
    SECTION("both arms cut off") {
        const std::vector<BodyId> pieces = world.cut_body(body, {-5, 1.5}, {5, 1.5}).value();
        REQUIRE(pieces.size() == 3);
        std::vector<float> masses;
        for (const BodyId piece : pieces) masses.push_back(world.body(piece)->mass());
        CHECK(masses == std::vector<float>{6, 1, 1});
    }
    SECTION("one arm cut off") {
        const std::vector<BodyId> pieces = world.cut_body(body, {-5, 1.5}, {0, 1.5}).value();
        REQUIRE(pieces.size() == 2);
        CHECK(world.body(pieces[0])->shapes().size() == 3);
    }
    SECTION("along the joint of base and arm") {
        const std::vector<BodyId> pieces = world.cut_body(body, {-5, 0.5}, {0, 0.5}).value();
        REQUIRE(pieces.size() == 2);
        CHECK(world.body(pieces[0])->mass() + world.body(pieces[1])->mass() == Approx(8));
    }
    SECTION("down through the base between the arms") {
        CHECK(world.cut_body(body, {0.2, 5}, {0.2, -5}).value().size() == 2);
    }
    SECTION("into one arm only") {
        CHECK(world.cut_body(body, {-5, 1.5}, {-1.5, 1.5}).value().empty());
    }
}

TEST_CASE("A ring that is cut through one of its walls stays one body, and as it was", "[fracture]") {
    World world = weightless();
    const BodyId ring = add(world, {}, Box{2, 0.25f, {0, -2}});
    world.create_shape(ring, Box{2, 0.25f, {0, 2}}).value();
    world.create_shape(ring, Box{0.25f, 2, {-2, 0}}).value();
    world.create_shape(ring, Box{0.25f, 2, {2, 0}}).value();
    const std::vector<ShapeId> shapes = world.body(ring)->shapes();
    CHECK(world.cut_body(ring, {-5, 0}, {0, 0}).value().empty());
    CHECK(world.body(ring)->shapes() == shapes);
    CHECK(world.cut_body(ring, {-5, 0}, {5, 0}).value().size() == 2);
}

TEST_CASE("Pieces inherit what their body and shapes are", "[fracture]") {
    World world = weightless();
    const BodyDef def{.linear_damping_1_s = 0.1f,
                      .angular_damping_1_s = 0.2f,
                      .gravity_scale = 0.5f,
                      .locks = {.rotation = true},
                      .allow_sleep = false,
                      .sleep_speed_m_s = 0.3f,
                      .user_data = 77};
    const ShapeDef shape{.density_kg_m2 = 4,
                         .material = {.friction = 0.1f, .restitution = 0.5f, .kind = 3},
                         .filter = {.categories = 2, .mask = 5, .group = -3},
                         .seen_by_sensors = false,
                         .one_way_normal = {0, 1},
                         .user_data = 88};
    const BodyId box = add(world, def, Box{1, 1}, shape);
    for (const BodyId id : world.cut_body(box, {0, -2}, {0, 2}).value()) {
        const Body piece = *world.body(id);
        CHECK(piece.linear_damping() == 0.1f);
        CHECK(piece.angular_damping() == 0.2f);
        CHECK(piece.gravity_scale() == 0.5f);
        CHECK(piece.locks() == AxisLocks{.rotation = true});
        CHECK_FALSE(piece.allows_sleep());
        CHECK(piece.sleep_speed() == 0.3f);
        CHECK(piece.user_data() == 77);
        const Shape part = *world.shape(piece.shapes().at(0));
        CHECK(part.density() == Approx(4));
        CHECK(part.material().friction == 0.1f);
        CHECK(part.material().restitution == 0.5f);
        CHECK(part.material().kind == 3);
        CHECK(part.filter().mask == 5);
        CHECK(part.filter().group == -3);
        CHECK_FALSE(part.is_seen_by_sensors());
        CHECK(part.one_way_normal() == Vec2{0, 1});
        CHECK(part.user_data() == 88);
    }
}

TEST_CASE("Joints and sensors go with the piece that holds them", "[fracture]") {
    World world = weightless();
    const BodyId frame = world.create_body({.type = BodyType::Static}).value();
    const BodyId plank = add(world, {}, Box{2, 0.2f});
    const ShapeId eye =
        world.create_shape(plank, Circle{{1.5f, 0}, 0.1f}, {.sensor = true, .user_data = 9}).value();
    const JointId left = world
                             .create_joint(RevoluteJointDef{.body_a = frame,
                                                            .body_b = plank,
                                                            .local_anchor_a_m = {-1.8f, 0},
                                                            .local_anchor_b_m = {-1.8f, 0}})
                             .value();
    const JointId right = world
                              .create_joint(DistanceJointDef{.body_a = plank,
                                                             .body_b = frame,
                                                             .local_anchor_a_m = {1.8f, 0},
                                                             .local_anchor_b_m = {1.8f, 3},
                                                             .length_m = 3})
                              .value();
    const std::vector<BodyId> pieces = world.cut_body(plank, {0, -1}, {0, 1}).value();
    REQUIRE(pieces.size() == 2);
    REQUIRE(world.contains(left));
    REQUIRE(world.contains(right));
    CHECK(world.joint(left)->body_a() == frame);
    CHECK(world.joint(left)->body_b() == pieces[0]);
    CHECK(world.joint(right)->body_a() == pieces[1]);
    CHECK(world.joint(right)->body_b() == frame);
    CHECK(world.joint(left)->anchor_b().x == Approx(-1.8));
    CHECK(world.body(pieces[0])->joints() == std::vector{left});
    CHECK(world.body(pieces[1])->joints() == std::vector{right});
    CHECK_FALSE(world.contains(eye));
    CHECK(world.body(pieces[0])->shapes().size() == 1);
    REQUIRE(world.body(pieces[1])->shapes().size() == 2);
    const Shape sensor = *world.shape(world.body(pieces[1])->shapes()[1]);
    CHECK(sensor.is_sensor());
    CHECK(sensor.user_data() == 9);
    // They hang from the frame still.
    world.set_gravity({0, -10}).value();
    run_for(world, 2);
    CHECK(length(world.joint(left)->anchor_b() - world.joint(left)->anchor_a()) < 0.01f);
    CHECK(world.joint(right)->current_length() == Approx(3).margin(0.02));
    world.destroy_body(pieces[0]).value();
    CHECK_FALSE(world.contains(left));
}

TEST_CASE("What rests on a body that is cut away wakes; a block that is cut stays standing", "[fracture]") {
    World world;
    add_ground(world);
    const BodyId block = add(world, {.position_m = {0, 1}}, Box{1, 1});
    const BodyId rider = add(world, {.position_m = {0.5, 2.5}}, Box{0.3f, 0.5f});
    run_for(world, 2);
    REQUIRE_FALSE(world.body(block)->is_awake());
    const Position at = world.body(rider)->position();
    const std::vector<BodyId> halves = world.cut_body(block, {-2, 1}, {2, 1}).value();
    REQUIRE(halves.size() == 2);
    CHECK(world.body(rider)->is_awake());
    const double upper = world.body(halves[0])->world_center().y;
    run_for(world, 2);
    CHECK(world.body(halves[0])->world_center().y == Approx(upper).margin(0.005));
    CHECK(length(world.body(rider)->position() - at) < 0.005f);
    CHECK_FALSE(world.body(halves[0])->is_awake());
}

TEST_CASE("Static and kinematic bodies are cut into bodies of their type", "[fracture]") {
    World world;
    const BodyId wall = add(world, {.type = BodyType::Static}, Box{1, 1});
    for (const BodyId id : world.cut_body(wall, {0, -2}, {0, 2}).value()) {
        CHECK(world.body(id)->type() == BodyType::Static);
    }
    const BodyId lift =
        add(world, {.type = BodyType::Kinematic, .linear_velocity_m_s = {1, 0}, .angular_velocity_rad_s = 2},
            Box{1, 1});
    const std::vector<BodyId> pieces = world.cut_body(lift, {0, -2}, {0, 2}).value();
    REQUIRE(pieces.size() == 2);
    CHECK(world.body(pieces[0])->type() == BodyType::Kinematic);
    CHECK(world.body(pieces[0])->linear_velocity() == Vec2{1, 0});
}

TEST_CASE("Forces for the next step go on acting on the pieces", "[fracture]") {
    World world = weightless();
    const BodyId box = add(world, {}, Box{1, 1});
    world.body(box)->apply_force({8, 0}, {0, 0.5}).value();
    World whole = weightless();
    const BodyId same = add(whole, {}, Box{1, 1});
    whole.body(same)->apply_force({8, 0}, {0, 0.5}).value();
    const std::vector<BodyId> pieces = world.cut_body(box, {-2, 0.3}, {2, 0.3}).value();
    world.step(kStep_s).value();
    whole.step(kStep_s).value();
    const Totals of_whole = totals(whole, std::array{same});
    const Totals of_pieces = totals(world, pieces);
    CHECK(of_pieces.momentum_x == Approx(of_whole.momentum_x));
    CHECK(of_pieces.angular_momentum == Approx(of_whole.angular_momentum).epsilon(1e-4));
}

TEST_CASE("The bodies along a cut come in order, with what would become of them", "[fracture]") {
    World world;
    const BodyId far = add(world, {.position_m = {5, 0}}, Box{1, 1});
    const BodyId near = add(world, {.position_m = {1, 0}}, Circle{{}, 0.5f});
    const BodyId last = add(world, {.type = BodyType::Static, .position_m = {10, 0}}, Box{2, 2});
    add(world, {.position_m = {5, 5}}, Box{1, 1});
    const std::uint64_t hash = world.state_hash();
    const std::vector<CutHit> hits = world.cuts_along({-1, 0}, {10, 0}).value();
    REQUIRE(hits.size() == 3);
    CHECK(hits[0].body == near);
    CHECK(hits[0].pieces == 2);
    CHECK(hits[0].enter_m.x == Approx(0.5));
    CHECK(hits[0].exit_m.x == Approx(1.5));
    CHECK(hits[1].body == far);
    CHECK(hits[1].enter_m.x == Approx(4));
    CHECK(hits[1].pieces == 2);
    CHECK(hits[2].body == last);  // in which the way ends
    CHECK(hits[2].pieces == 1);
    CHECK(hits[2].exit_m.x == Approx(10));
    CHECK(world.cuts_along({-1, 0}, {10, 0}, {.ignored_body = near})->size() == 2);
    CHECK(world.state_hash() == hash);
    // It foretells what the cut does.
    for (const CutHit& hit : hits) {
        const std::size_t pieces = world.cut_body(hit.body, {-1, 0}, {10, 0})->size();
        CHECK(std::max<std::size_t>(pieces, 1) == static_cast<std::size_t>(hit.pieces));
    }
}

TEST_CASE("Bad cuts give errors and change nothing", "[fracture]") {
    World world;
    const BodyId box = add(world, {}, Box{1, 1});
    CHECK(world.cut_body({}, {0, 0}, {1, 0}).error().message == "the body handle is null");
    CHECK(world.cut_body(box, {NAN, 0}, {1, 0}).error().message ==
          "cut.from_m is (nan, 0), but must be finite");
    CHECK(world.cut_body(box, {0, 0}, {2e12, 0}).error().message ==
          "cut.to_m is 2e+12, but must be within 1e12 m of the world's origin");
    CHECK(world.cut_body(box, {1, 1}, {1, 1}).error().message ==
          "the length of the cut is 0, but must be greater than 0.005 m and at most 1e9 m");
    CHECK_FALSE(world.cuts_along({0, 0}, {0, 0}));
    world.create_shape(box, Segment{{1, 0}, {2, 0}}).value();
    CHECK(world.cut_body(box, {0, -2}, {0, 2}).error().message ==
          "the body has a segment or a chain, but only shapes with an area can be divided");
    CHECK(world.cuts_along({0, -2}, {0, 2})->at(0).pieces == 1);
    const BodyId empty = world.create_body({}).value();
    CHECK(world.cut_body(empty, {0, -2}, {0, 2}).error().message ==
          "the body has no shape but sensors, but must have one that can be divided");
    CHECK(world.counts().bodies == 2);
}

}  // namespace
}  // namespace cairn::physics
