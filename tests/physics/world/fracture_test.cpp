#include <catch2/catch.hpp>
#include <limits>

#include "physics/support/pieces.h"
#include "physics/support/scenes.h"

namespace cairn::physics {
namespace {

using namespace test;

constexpr auto kInfinity = std::numeric_limits<float>::infinity();

World weightless(int threads = 1) {
    return World({.gravity_m_s2 = {}, .threads = threads});
}

float least_width(World& world, BodyId piece) {
    float widest = 0;
    for (const ShapeId id : world.body(piece)->shapes()) {
        const Outline& o = world.shape(id)->outline();
        float width = kInfinity;
        for (std::size_t i = 0; i < o.count; ++i) {
            const Vec2 edge = normalized(o.points_m[(i + 1) % o.count] - o.points_m[i]);
            float farthest = 0;
            for (std::size_t k = 0; k < o.count; ++k) {
                farthest = std::max(farthest, cross(edge, o.points_m[k] - o.points_m[i]));
            }
            width = std::min(width, farthest);
        }
        widest = std::max(widest, width);
    }
    return widest;
}

TEST_CASE("A box breaks into about as many pieces as asked for, which cover it side by side", "[fracture]") {
    for (const FracturePattern pattern : {FracturePattern::Uniform, FracturePattern::Radial}) {
        for (const int count : {2, 5, 12, 40, 150}) {
            World world = weightless();
            const BodyId box = add(world, {}, Box{2, 1});
            const FractureDef def{.pattern = pattern, .pieces = count, .seed = 3, .min_width_m = 0.01f};
            const std::vector<BodyId> pieces = world.break_body(box, {-2, 0.5}, def).value();
            CHECK(static_cast<double>(pieces.size()) == Approx(count).epsilon(0.3).margin(1));
            CHECK(area_of(world, pieces) == Approx(8).epsilon(1e-3));
            CHECK(area_of(world, pieces) <= 8 + 1e-4);
            CHECK_FALSE(world.contains(box));
            // With their areas those of the whole, no gaps means no overlap; what overlaps would show here.
            world.step(kStep_s).value();
            CHECK(world.max_penetration_m() < 1e-5f);
        }
    }
}

TEST_CASE("Breaking random bodies conserves mass, momentum and angular momentum", "[fracture]") {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        World world = weightless();
        const Vec2 velocity = random.vector(-10, 10);
        const BodyId body =
            add(world,
                {.position_m = {random.real(-20, 20), random.real(-20, 20)},
                 .angle_rad = random.real(-3, 3),
                 .linear_velocity_m_s = velocity,
                 .angular_velocity_rad_s = random.real_f(-10, 10)},
                Box{random.real_f(0.3, 2), random.real_f(0.3, 2)}, {.density_kg_m2 = random.real_f(0.5, 20)});
        const bool is_compound = random.chance(0.5);
        if (is_compound) add_random_shape(world, random, body);
        const Totals before = totals(world, std::array{body});
        const FractureDef def{
            .pattern = random.chance(0.5) ? FracturePattern::Uniform : FracturePattern::Radial,
            .pieces = 2 + random.below(30),
            .seed = random.bits(),
            .radius_m = random.chance(0.3) ? 0.5f : kInfinity,
            .grain = random.chance(0.3) ? Vec2{3, 1} : Vec2{}};
        const Position impact = world.body(body)->world_center() + random.vector(-1, 1);
        const std::vector<BodyId> pieces = world.break_body(body, impact, def).value();
        if (pieces.empty()) continue;
        const Totals after = totals(world, pieces);
        require_conserved(before, after, 20, 40);
        REQUIRE(after.kinetic_energy <= before.kinetic_energy * (is_compound ? 1.05 : 1 + 1e-3));
        for (const BodyId piece : pieces) REQUIRE(least_width(world, piece) >= 0.0099f);
    }
}

TEST_CASE("Pieces do not push each other apart", "[fracture]") {
    World world = weightless();
    const BodyId box =
        add(world, {.position_m = {100, 50}, .linear_velocity_m_s = {2, 1}}, Box{1, 1}, {.density_kg_m2 = 5});
    const std::vector<BodyId> pieces = world.break_body(box, {100, 50}, {.pieces = 50, .seed = 4}).value();
    REQUIRE(pieces.size() > 40);
    run_for(world, 1);
    for (const BodyId id : pieces) {
        CHECK(length(world.body(id)->linear_velocity() - Vec2{2, 1}) < 1e-3f);
        CHECK(std::fabs(world.body(id)->angular_velocity()) < 1e-3f);
    }
}

TEST_CASE("Pieces of a body that turns fly apart as the material moved", "[fracture]") {
    World world = weightless();
    const BodyId box = add(world, {.angular_velocity_rad_s = 2}, Box{1, 1});
    const std::vector<BodyId> pieces =
        world.break_body(box, {0, 0}, {.pattern = FracturePattern::Radial, .pieces = 30, .seed = 5}).value();
    const Totals before = totals(world, pieces);
    std::vector<Vec2> arms;
    for (const BodyId id : pieces) {
        const Vec2 arm = world.body(id)->world_center() - Position{};
        CHECK(length(world.body(id)->linear_velocity() - cross(2.0f, arm)) < 2e-3f);
        arms.push_back(arm);
    }
    run_for(world, 0.5);
    // Whatever they do to each other while they part, the sums stay.
    const Totals after = totals(world, pieces);
    CHECK(after.angular_momentum == Approx(before.angular_momentum).epsilon(1e-3));
    CHECK(after.kinetic_energy <= before.kinetic_energy * (1 + 1e-4));
}

TEST_CASE("The same seed gives the same pieces on any number of threads, another seed others", "[fracture]") {
    const auto hash_of = [](std::uint64_t seed, int threads) {
        World world({.threads = threads});
        add_ground(world);
        const BodyId box = add(world, {.position_m = {0, 3}, .angle_rad = 0.3}, Box{1, 1});
        const std::vector<BodyId> pieces =
            world.break_body(box, {0, 2}, {.pieces = 40, .seed = seed}).value();
        world.cut_body(pieces[3], {-5, 3}, {5, 3.2}).value();
        run_for(world, 2);
        return world.state_hash();
    };
    CHECK(hash_of(1, 1) == hash_of(1, 2));
    CHECK(hash_of(1, 1) != hash_of(2, 1));
}

TEST_CASE("Radial pieces are small about the impact and larger outward", "[fracture]") {
    World world = weightless();
    const BodyId pane = add(world, {}, Box{1, 1});
    const std::vector<BodyId> pieces =
        world.break_body(pane, {0.5, 0.5}, {.pattern = FracturePattern::Radial, .pieces = 40, .seed = 1})
            .value();
    double near = 0;
    double far = 0;
    int near_count = 0;
    for (const BodyId id : pieces) {
        const bool is_near = length(world.body(id)->world_center() - Position{0.5, 0.5}) < 0.4f;
        (is_near ? near : far) += static_cast<double>(world.body(id)->mass());
        near_count += is_near ? 1 : 0;
    }
    const int far_count = static_cast<int>(pieces.size()) - near_count;
    REQUIRE(near_count > 8);
    REQUIRE(far_count > 4);
    CHECK(far / far_count > 4 * near / near_count);
}

TEST_CASE("Pieces are long along the grain", "[fracture]") {
    World world = weightless();
    const BodyId plank = add(world, {.angle_rad = 1}, Box{2, 2});
    const std::vector<BodyId> pieces =
        world.break_body(plank, {0, 0}, {.pieces = 40, .seed = 2, .min_width_m = 0.01f, .grain = {6, 0}})
            .value();
    double along = 0;
    double across = 0;
    for (const BodyId id : pieces) {
        for (const ShapeId shape : world.body(id)->shapes()) {
            const Outline& o = world.shape(shape)->outline();
            Vec2 low{kInfinity, kInfinity};
            Vec2 high = -low;
            for (std::size_t i = 0; i < o.count; ++i) {
                low = {std::min(low.x, o.points_m[i].x), std::min(low.y, o.points_m[i].y)};
                high = {std::max(high.x, o.points_m[i].x), std::max(high.y, o.points_m[i].y)};
            }
            along += static_cast<double>(high.x - low.x);
            across += static_cast<double>(high.y - low.y);
        }
    }
    CHECK(along / across > 3);
    CHECK(area_of(world, pieces) == Approx(16).epsilon(2e-3));
}

TEST_CASE("Pieces narrower than asked for are not made", "[fracture]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        World world = weightless();
        const BodyId box = add(world, {}, Box{0.5f, 0.5f});
        const std::vector<BodyId> pieces =
            world.break_body(box, {0.5, 0}, {.pieces = 100, .seed = seed, .min_width_m = 0.15f}).value();
        REQUIRE(pieces.size() >= 4);
        for (const BodyId id : pieces) REQUIRE(least_width(world, id) >= 0.149f);
        REQUIRE(area_of(world, pieces) == Approx(1).epsilon(1e-3));
    }
    World world = weightless();
    const BodyId chip = add(world, {}, Box{0.05f, 0.05f});
    CHECK(world.break_body(chip, {}, {.min_width_m = 0.2f}).value().empty());
    CHECK(world.contains(chip));
}

TEST_CASE("Beyond the radius of a break a body stays in one piece", "[fracture]") {
    World world;
    const BodyId wall = add(world, {.type = BodyType::Static, .position_m = {0, 2}}, Box{0.5f, 2});
    const FractureDef def{.pieces = 60, .seed = 1, .radius_m = 0.6f, .release = true};
    const std::vector<BodyId> pieces = world.break_body(wall, {-0.5, 2}, def).value();
    int standing = 0;
    double area = 0;
    for (const BodyId id : pieces) {
        const Body piece = *world.body(id);
        if (piece.type() == BodyType::Dynamic) {
            CHECK(length(piece.world_center() - Position{-0.5, 2}) < 1);
            continue;
        }
        ++standing;
        area += area_of(world, std::array{id});
    }
    CHECK(pieces.size() > 5);
    CHECK(standing >= 1);
    CHECK(standing <= 2);
    CHECK(world.counts().shapes < 50);  // where nothing breaks, nothing is cut up
    CHECK(area == Approx(4 - 0.5 * 3.14159 * 0.36).epsilon(0.15));
    run_for(world, 1);
    for (const BodyId id : pieces) {
        if (world.body(id)->type() == BodyType::Static) CHECK(world.body(id)->position() == Position{0, 2});
    }
}

TEST_CASE("A wall of many bricks on one body breaks where it is hit, and the bricks beyond keep their shape",
          "[fracture]") {
    World world = weightless();
    const BodyId wall = world.create_body({}).value();
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            world.create_shape(wall, Box{0.5f, 0.25f, {static_cast<float>(x), 0.5f * static_cast<float>(y)}})
                .value();
        }
    }
    const Totals before = totals(world, std::array{wall});
    const std::vector<BodyId> pieces =
        world.break_body(wall, {0, 2}, {.pieces = 60, .seed = 1, .radius_m = 1.5f}).value();
    REQUIRE(pieces.size() > 4);
    require_conserved(before, totals(world, pieces), 1, 10);
    std::size_t most = 0;
    for (const BodyId id : pieces) most = std::max(most, world.body(id)->shapes().size());
    CHECK(most > 80);
    CHECK(area_of(world, pieces) == Approx(50).epsilon(1e-2));
}

TEST_CASE("A thousand bodies are cut in rows, each into two that lie side by side", "[fracture]") {
    World world = weightless();
    std::vector<BodyId> bodies;
    for (int i = 0; i < 1000; ++i) {
        bodies.push_back(add(world, {.position_m = {3.0 * (i % 40), 3.0 * (i / 40)}}, Box{1, 1}));
    }
    for (int row = 0; row < 25; ++row) {
        for (const CutHit& hit : world.cuts_along({-5, 3.0 * row + 0.1}, {200, 3.0 * row + 0.2}).value()) {
            REQUIRE(hit.pieces == 2);
            REQUIRE(world.cut_body(hit.body, {-5, 3.0 * row + 0.1}, {200, 3.0 * row + 0.2}).value().size() ==
                    2);
        }
    }
    const std::vector<BodyId> halves = world.bodies();
    REQUIRE(halves.size() == 2000);
    CHECK(area_of(world, halves) == Approx(4000).epsilon(1e-4));
    world.step(kStep_s).value();
    CHECK(world.max_penetration_m() < 1e-5f);
}

TEST_CASE("Bad fractures give errors and change nothing", "[fracture]") {
    World world;
    const BodyId box = add(world, {}, Box{1, 1});
    const auto message = [&](const FractureDef& def) {
        return world.break_body(box, {}, def).error().message;
    };
    CHECK(message({.pieces = 1}) == "fracture.pieces is 1, but must be from 2 to 256");
    CHECK(message({.pieces = 257}) == "fracture.pieces is 257, but must be from 2 to 256");
    CHECK(message({.min_width_m = 0.001f}) ==
          "fracture.min_width_m is 0.001, but must be finite and at least 0.01 m");
    CHECK(message({.min_width_m = kInfinity}) ==
          "fracture.min_width_m is inf, but must be finite and at least 0.01 m");
    CHECK(message({.radius_m = 0}) == "fracture.radius_m is 0, but must be greater than 0");
    CHECK(message({.grain = {0.5f, 0}}) ==
          "the length of fracture.grain is 0.5, but must be 0 or from 1 to 16");
    CHECK(message({.grain = {NAN, 0}}) == "fracture.grain is (nan, 0), but must be finite");
    CHECK(message({.pattern = static_cast<FracturePattern>(7)}) ==
          "fracture.pattern is 7, but must be from 0 to 1");
    CHECK(world.break_body(box, {0, INFINITY}).error().message == "impact_m is (0, inf), but must be finite");
    CHECK(world.break_body({}, {}).error().message == "the body handle is null");
    CHECK(world.counts().bodies == 1);
    CHECK(world.break_body(box, {1e6, 1e6}, {.pattern = FracturePattern::Radial})->size() >
          1);  // far beside it
}

}  // namespace
}  // namespace cairn::physics
