// Heaps of so many contacts that they are divided into domains.
#include "world/domains.h"

#include <catch2/catch.hpp>
#include <vector>

#include "physics/support/invariants.h"
#include "physics/support/making.h"
#include "physics/support/random.h"
#include "world/bodies.h"
#include "world/joint_lists.h"
#include "world/joints.h"
#include "world/sleep.h"
#include "world/step.h"

namespace cairn::physics {
namespace {

using namespace test;

int add_box(Stores& stores, const BodyDef& def, Vec2 half, const ShapeDef& shape = {}) {
    const int body = create_body(stores, def);
    create_shape(stores, body, make_convex(Box{half.x, half.y}).value(), shape);
    return body;
}

// Boxes in a pit, which touch from the first step on. With another stride slots do not tell who lies beside
// whom; it has no factor in common with their number.
std::vector<int> fill_pit(WorldState& world, Random& random, int columns, int layers, int stride = 1) {
    const auto width = static_cast<float>(columns);
    add_box(world.stores, {.type = BodyType::Static, .position_m = {0, -1}}, {width, 1});
    for (const float side : {-1.0f, 1.0f}) {
        add_box(world.stores, {.type = BodyType::Static, .position_m = {side * (0.26f * width + 0.6f), 40}},
                {0.5f, 40});
    }
    std::vector<int> boxes;
    for (int n = 0; n < columns * layers; ++n) {
        const int i = n * stride % (columns * layers);
        boxes.push_back(
            add_box(world.stores,
                    {.position_m = {0.52 * (i % columns) - 0.26 * (columns - 1), 0.22 + 0.41 * (i / columns)},
                     .angle_rad = random.real(-0.1, 0.1),
                     .linear_velocity_m_s = random.vector(-2, 2)},
                    {0.25f, 0.2f}));
    }
    return boxes;
}

struct Divided {
    int in_domains = 0;
    int between = 0;
};

Divided count_contacts(const ContactLanes& lanes) {
    Divided found;
    for (int bucket = kFirstColored; bucket < kBuckets; ++bucket) {
        for (int block = lanes.first_block(bucket); block != kNone; block = lanes.link(block).next)
            (domain_of(bucket) == kInterface ? found.between : found.in_domains) += lanes.link(block).used;
    }
    return found;
}

// Boxes come and go, and the heap falls asleep and wakes.
void check_heap(int stride, DividedBy expected) {
    Random random(21);
    WorldState world(WorldDef{.threads = 2}, 1);
    std::vector<int> boxes = fill_pit(world, random, 50, 30, stride);
    for (int step = 1; step <= 140; ++step) {
        step_world(world, kStep_s);
        if (step == 66 || step == 130) {
            const Divided found = count_contacts(world.stores.contacts.lanes);
            CHECK(world.stores.domains.count == 2);
            if (step == 66) CHECK(world.stores.domains.by == expected);
            CHECK(found.in_domains > 2000);
            CHECK(found.between < found.in_domains / 8);
        }
        // Slots are filled again anywhere: of four a step, a third of all when it is divided a second time,
        // more than one contact in eight would cross a cut by slots.
        for (int i = 0; i < 3; ++i) {
            const std::size_t at = static_cast<std::size_t>(random.below(static_cast<int>(boxes.size())));
            destroy_body(world, boxes[at]);
            boxes[at] = add_box(world.stores, {.position_m = {random.real(-12, 12), random.real(13, 16)}},
                                {0.25f, 0.2f});
        }
        if (step % 40 == 20) put_island_to_sleep(world.stores, world.scratch, boxes[0]);
        if (step % 40 == 23) wake_body(world.stores, boxes[0]);
        if (step % 16 == 1 || step == 64) check_world(world);
    }
    // When most has gone, nothing is divided any more.
    for (std::size_t i = 300; i < boxes.size(); ++i) destroy_body(world, boxes[i]);
    for (int step = 0; step < 65; ++step) step_world(world, kStep_s);
    CHECK(world.stores.domains.count == 0);
    CHECK(count_contacts(world.stores.contacts.lanes).in_domains == 0);
    check_world(world);
}

}  // namespace

TEST_CASE("domains share no body that moves, whatever comes and goes, falls asleep and wakes") {
    check_heap(1, DividedBy::Slots);
}

TEST_CASE("domains are strips of space where the order in which bodies were made does not tell who touches") {
    check_heap(751, DividedBy::X);
}

TEST_CASE("what is pushed together across domains has the momentum of the pushes, on any number of threads") {
    const auto run = [](int threads) {
        World world(WorldDef{.gravity_m_s2 = {}, .threads = threads});
        Random random(5);
        std::vector<BodyId> bodies;
        for (int i = 0; i < 1600; ++i) {
            const Vec2 at{0.5f * static_cast<float>(i % 50 - 25), 0.5f * static_cast<float>(i / 50 - 16)};
            bodies.push_back(add(world,
                                 {.position_m = Position{} + at, .linear_velocity_m_s = random.vector(-1, 1)},
                                 Circle{{}, 0.24f}));
        }
        const auto momentum_x = [&] {
            double x = 0;
            for (const BodyId id : bodies) {
                const Body body = world.body(id).value();
                x += static_cast<double>(body.mass_data().mass_kg) *
                     static_cast<double>(body.linear_velocity().x);
            }
            return x;
        };
        double expected = momentum_x();
        for (int step = 0; step < 100; ++step) {
            for (const BodyId id : bodies) {
                Body body = world.body(id).value();
                const Position p = body.transform().p;
                const Vec2 pull = -0.02f * Vec2{static_cast<float>(p.x), static_cast<float>(p.y)};
                body.apply_impulse_to_center(pull).value();
                expected += static_cast<double>(pull.x);
            }
            step_times(world, 1);
            if (step == 63) CHECK(world.counts().touching > 2500);
        }
        // Of pushes that come to thousands of N s, were they all one way.
        CHECK(momentum_x() == Approx(expected).margin(1e-3));
        return world.state_hash();
    };
    const std::uint64_t alone = run(1);
    for (const int threads : {2, 5}) {
        INFO(threads << " threads");
        CHECK(run(threads) == alone);
    }
}

// A net of bodies that are pinned to their neighbours; pins are torn out and others put in, and the net falls
// asleep and wakes.
TEST_CASE(
    "pins of a net are divided, and pull their bodies without adding momentum, on any number of threads") {
    constexpr int kColumns = 64;
    constexpr int kBodies = kColumns * 32;
    const auto run = [](int threads) {
        Random random(17);
        WorldState world(WorldDef{.gravity_m_s2 = {}, .threads = threads}, 1);
        Stores& stores = world.stores;
        for (int i = 0; i < kBodies; ++i) {
            const Vec2 at{static_cast<float>(i % kColumns), static_cast<float>(i / kColumns)};
            add_box(stores,
                    {.position_m = Position{} + at,
                     .linear_velocity_m_s = random.vector(-1, 1),
                     .linear_damping_1_s = 0},
                    {0.1f, 0.1f});
        }
        std::vector<int> pins;
        const auto pin = [&](int a, int b) {
            const Vec2 half{0.5f * static_cast<float>(b % kColumns - a % kColumns),
                            0.5f * static_cast<float>(b / kColumns - a / kColumns)};
            pins.push_back(create_joint(world, RevoluteJointDef{.body_a = stores.bodies.slots.id(a),
                                                                .body_b = stores.bodies.slots.id(b),
                                                                .local_anchor_a_m = half,
                                                                .local_anchor_b_m = -half,
                                                                .enable_motor = random.chance(0.2),
                                                                .max_motor_torque_nm = 1}));
        };
        for (int i = 0; i < kBodies; ++i) {
            if (i % kColumns + 1 < kColumns) pin(i, i + 1);
            if (i + kColumns < kBodies) pin(i, i + kColumns);
        }
        const auto momentum = [&] {
            double x = 0;
            double y = 0;
            for (int body = 0; body < kBodies; ++body) {
                const BodyRecord& record = stores.bodies.slots[body];
                const Vec2 v = stores.bodies.rows(record.set).velocity[static_cast<std::size_t>(record.row)];
                x += static_cast<double>(record.mass.mass_kg) * static_cast<double>(v.x);
                y += static_cast<double>(record.mass.mass_kg) * static_cast<double>(v.y);
            }
            return std::pair(x, y);
        };
        const auto [x, y] = momentum();
        for (int step = 1; step <= 140; ++step) {
            step_world(world, kStep_s);
            const auto at = static_cast<std::size_t>(random.below(static_cast<int>(pins.size())));
            const JointRecord& record = stores.joints.slots[pins[at]];
            const int a = record.body_a;
            const int b = record.body_b;
            destroy_joint(stores, pins[at]);
            pins[at] = pins.back();
            pins.pop_back();
            pin(a, b);
            if (step % 32 == 1) check_world(world);
        }
        int between = 0;
        for (const int joint : pins)
            between += joint_domain(stores.joints.slots[joint].seat.bucket) == kInterface ? 1 : 0;
        CHECK(stores.domains.count == 2);
        CHECK(between > 0);
        CHECK(between < static_cast<int>(pins.size()) / 8);
        // Of 2,048 bodies that pull each other with impulses of some .01 kg m/s in each substep.
        CHECK(momentum().first == Approx(x).margin(1e-4));
        CHECK(momentum().second == Approx(y).margin(1e-4));
        put_island_to_sleep(stores, world.scratch, 0);
        step_world(world, kStep_s);
        wake_body(stores, 0);
        step_world(world, kStep_s);
        check_world(world);
        return hash_state(world);
    };
    const std::uint64_t alone = run(1);
    for (const int threads : {2, 5}) {
        INFO(threads << " threads");
        CHECK(run(threads) == alone);
    }
}

TEST_CASE("rows of awake bodies go where they are sent, with all that is theirs") {
    Random random(8);
    BodyStore bodies(1);
    constexpr int kBodies = 40;
    for (int i = 0; i < kBodies; ++i) {
        const int body = bodies.slots.insert({});
        bodies.add_row(body, RowSet::Awake);
        bodies.rows(RowSet::Awake).velocity.back() = {static_cast<float>(body), 1};
        bodies.rows(RowSet::Awake).rest_time.back() = static_cast<float>(2 * body);
    }
    for (int round = 0; round < 20; ++round) {
        std::vector<int> from(kBodies);
        for (int i = 0; i < kBodies; ++i) from[static_cast<std::size_t>(i)] = i;
        for (int i = kBodies - 1; i > 0; --i)
            std::swap(from[static_cast<std::size_t>(i)], from[static_cast<std::size_t>(random.below(i + 1))]);
        const std::vector<int> before = bodies.rows(RowSet::Awake).body;
        std::vector<int> used = from;
        bodies.order_awake_rows(used);
        const BodyRows& rows = bodies.rows(RowSet::Awake);
        for (int row = 0; row < kBodies; ++row) {
            const auto i = static_cast<std::size_t>(row);
            REQUIRE(rows.body[i] == before[static_cast<std::size_t>(from[i])]);
            REQUIRE(rows.velocity[i].x == static_cast<float>(rows.body[i]));
            REQUIRE(rows.rest_time[i] == static_cast<float>(2 * rows.body[i]));
            REQUIRE(bodies.slots[rows.body[i]].row == row);
            REQUIRE(bodies.places[static_cast<std::size_t>(rows.body[i])].row == row + 1);
        }
    }
}

}  // namespace cairn::physics
