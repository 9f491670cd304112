// Rows of pins by their own solver, against the solver of all structures.
#include "resolve/direct/pin_chain.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/making.h"

namespace cairn::physics {
namespace {

using namespace test;

enum class Ends { Held, Hanging, Free };

struct Setting {
    Ends ends = Ends::Hanging;
    bool is_row = true;     // else one pin has a motor without force, and all structures' solver takes it
    bool reversed = false;  // every other pin looks back
    double ratio = 1;       // of the mass of the last body
    float support_m_s = 0;  // of what holds the first body
};

// 20 planks up and down in turns, some of which are pushed.
struct Row {
    World world{{.joint_solver = JointSolver::Direct, .enable_sleep = false}};
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;

    explicit Row(const Setting& setting) {
        constexpr int kPlanks = 20;
        constexpr double kTilt_rad = 0.3;
        const double along_m = 0.5 * std::cos(kTilt_rad);
        const double up_m = 0.5 * std::sin(kTilt_rad);
        const bool held = setting.ends != Ends::Free;
        BodyId last{};
        Vec2 anchor{};
        if (held) {
            last = world
                       .create_body(
                           {.type = BodyType::Kinematic, .linear_velocity_m_s = {0, setting.support_m_s}})
                       .value();
        }
        for (int i = 0; i < kPlanks; ++i) {
            const bool heavy = i + 1 == kPlanks;
            const BodyId body = add(world,
                                    {.position_m = {along_m * (i + 0.5), up_m / 2},
                                     .angle_rad = i % 2 == 0 ? kTilt_rad : -kTilt_rad},
                                    Box{0.25f, 0.05f},
                                    {.density_kg_m2 = heavy ? static_cast<float>(10 * setting.ratio) : 10.0f,
                                     .filter = {.group = -1}});
            if (i > 0 || held) join(last, body, anchor, {-0.25f, 0}, setting, i == 3, i % 2 == 1);
            bodies.push_back(body);
            last = body;
            anchor = {0.25f, 0};
        }
        if (setting.ends == Ends::Held) {
            const BodyId bank =
                world.create_body({.type = BodyType::Static, .position_m = {kPlanks * along_m, 0}}).value();
            join(last, bank, anchor, {}, setting, false, false);
        }
        for (std::size_t i = 5; i < 10; ++i) world.body(bodies[i])->set_linear_velocity({0, 3}).value();
    }

    void join(BodyId a, BodyId b, Vec2 on_a, Vec2 on_b, const Setting& setting, bool may_drive,
              bool may_look_back) {
        RevoluteJointDef def{.body_a = a, .body_b = b, .local_anchor_a_m = on_a, .local_anchor_b_m = on_b};
        if (setting.reversed && may_look_back) {
            std::swap(def.body_a, def.body_b);
            std::swap(def.local_anchor_a_m, def.local_anchor_b_m);
        }
        def.enable_motor = may_drive && !setting.is_row;
        joints.push_back(world.create_joint(def).value());
    }

    [[nodiscard]] double farthest_from(const Row& other) const {
        double farthest = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Position a = world.body(bodies[i])->world_center();
            const Position b = other.world.body(other.bodies[i])->world_center();
            farthest = std::max({farthest, std::fabs(a.x - b.x), std::fabs(a.y - b.y)});
        }
        return farthest;
    }
    [[nodiscard]] double greatest_gap() const {
        double gap = 0;
        for (const JointId id : joints)
            gap = std::max(gap, static_cast<double>(world.joint(id)->current_length()));
        return gap;
    }
};

}  // namespace

TEST_CASE("a row of pins moves as the solver of all structures moves it") {
    for (const Ends ends : {Ends::Held, Ends::Hanging, Ends::Free}) {
        for (const double ratio : {1.0, 1000.0}) {
            for (const float support_m_s : {0.0f, 1.0f}) {
                const Setting setting{.ends = ends, .ratio = ratio, .support_m_s = support_m_s};
                Setting other = setting;
                other.is_row = false;
                Row row(setting);
                Row structure(other);
                // Before the first snap, from which roundings grow.
                step_times(row.world, 8);
                step_times(structure.world, 8);
                INFO(static_cast<int>(ends) << ", ratio " << ratio << ", support " << support_m_s);
                CHECK(row.farthest_from(structure) < 1e-6);
                CHECK(row.greatest_gap() < 1e-5);
            }
        }
    }
}

TEST_CASE("which of its bodies is the first of a pin makes no difference to a row, but its reaction") {
    Row row({.ends = Ends::Held});
    Row reversed({.ends = Ends::Held, .reversed = true});
    step_times(row.world, 20);
    step_times(reversed.world, 20);
    CHECK(row.farthest_from(reversed) < 1e-5);
    for (std::size_t i = 0; i < row.joints.size(); ++i) {
        const Vec2 force = row.world.joint(row.joints[i])->reaction_force();
        const Vec2 other = reversed.world.joint(reversed.joints[i])->reaction_force();
        const Vec2 sum = i % 2 == 1 ? force + other : force - other;
        CHECK(length(sum) < 1e-2f * (1 + length(force)));
    }
}

TEST_CASE("a row of pins does the same at every level of SIMD") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    std::vector<std::uint64_t> hashes;
    for (const SimdLevel level : levels) {
        force_simd_level(level).value();
        Row row({.ends = Ends::Held, .ratio = 10});
        step_times(row.world, 60);
        hashes.push_back(row.world.state_hash());
    }
    force_simd_level(levels.back()).value();
    for (const std::uint64_t hash : hashes) CHECK(hash == hashes.front());
}

}  // namespace cairn::physics
