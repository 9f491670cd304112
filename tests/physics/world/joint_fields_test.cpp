// Every number and switch of every kind of joint, found by walking through the members of its definition:
// what is no number is refused, and what is changed while the joint lives is as if it had been made so.
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "physics/support/making.h"
#include "state/fields.h"

namespace cairn::physics {
namespace {

using namespace test;

// Visits the numbers and switches of a definition, also those within its parts.
template <class Part, class Visit>
void for_each_leaf(Part& part, const Visit& visit) {
    if constexpr (std::is_same_v<Part, float> || std::is_same_v<Part, double> || std::is_same_v<Part, bool>) {
        visit(part);
    } else if constexpr (std::is_same_v<Part, Vec2> || std::is_same_v<Part, Position>) {
        visit(part.x);
        visit(part.y);
    } else if constexpr (requires { fields(part, [](auto&...) {}); }) {
        fields(part, [&](auto&... parts) { (for_each_leaf(parts, visit), ...); });
    }
}

// Calls change(leaf) for the leaf at a place.
template <class Change>
void at_leaf(JointDef& def, int place, const Change& change) {
    std::visit(
        [&](auto& d) {
            int i = 0;
            for_each_leaf(d, [&](auto& leaf) {
                if (i++ == place) change(leaf);
            });
        },
        def);
}

int leaves_of(JointDef def) {
    int count = 0;
    std::visit([&](auto& d) { for_each_leaf(d, [&](auto&) { ++count; }); }, def);
    return count;
}

// Two boxes that overlap a wall and each other, thrown, and a joint in which all that can act does.
struct Scene {
    World world{WorldDef{.enable_sleep = false}};
    BodyId wall = add(world, {.type = BodyType::Static}, Box{});
    BodyId box = thrown({0.6, 0.2}, {3, 2}, 2);
    BodyId other = thrown({1.2, 0.1}, {1, 0}, -1);
    JointId pin = world.create_joint(RevoluteJointDef{.body_a = wall, .body_b = other}).value();

    BodyId thrown(Position at, Vec2 velocity, float spin) {
        return add(world, {.position_m = at, .linear_velocity_m_s = velocity, .angular_velocity_rad_s = spin},
                   Box{});
    }
    /// By its place in JointDef; after them, some in which other numbers act.
    [[nodiscard]] JointDef def(std::size_t kind) const {
        static_assert(std::variant_size_v<JointDef> == 11);
        switch (kind) {
            case 0:
                return DistanceJointDef{.body_a = wall,
                                        .body_b = box,
                                        .local_anchor_b_m = {0.1f, 0.1f},
                                        .enable_spring = true,
                                        .frequency_hz = 3,
                                        .damping_ratio = 0.1f,
                                        .min_spring_force_n = -100,
                                        .max_spring_force_n = 20,
                                        .min_length_m = 0.8f,
                                        .max_length_m = 1.1f};
            case 1:
                return RevoluteJointDef{.body_a = wall,
                                        .body_b = box,
                                        .local_anchor_a_m = {0.5f, 0},
                                        .enable_limit = true,
                                        .lower_rad = -0.1f,
                                        .upper_rad = 0.2f,
                                        .enable_motor = true,
                                        .motor_speed_rad_s = 1,
                                        .max_motor_torque_nm = 1,
                                        .enable_spring = true,
                                        .target_rad = 0.1f};
            case 2:
                return PrismaticJointDef{.body_a = wall,
                                         .body_b = box,
                                         .local_angle_a_rad = -0.5f,
                                         .local_angle_b_rad = -0.5f,
                                         .enable_limit = true,
                                         .lower_m = -0.1f,
                                         .upper_m = 0.7f,
                                         .enable_motor = true,
                                         .motor_speed_m_s = 1,
                                         .max_motor_force_n = 2,
                                         .enable_spring = true,
                                         .target_m = 0.5f};
            case 3:
                return WeldJointDef{.body_a = wall,
                                    .body_b = box,
                                    .local_anchor_a_m = {0.5f, 0},
                                    .linear_frequency_hz = 3,
                                    .angular_frequency_hz = 2};
            case 4:
                return WheelJointDef{.body_a = wall,
                                     .body_b = box,
                                     .local_angle_a_rad = 1,
                                     .enable_limit = true,
                                     .lower_m = -0.1f,
                                     .upper_m = 0.4f,
                                     .enable_motor = true,
                                     .motor_speed_rad_s = 3,
                                     .max_motor_torque_nm = 1};
            case 5:
                return MotorJointDef{.body_a = wall,
                                     .body_b = box,
                                     .target_offset_m = {1, 1},
                                     .target_angle_rad = 1,
                                     .linear_frequency_hz = 2,
                                     .angular_frequency_hz = 2,
                                     .max_force_n = 50,
                                     .max_torque_nm = 5,
                                     .collide_connected = false};
            case 6:
                return MouseJointDef{.body_a = wall,
                                     .body_b = box,
                                     .local_target_m = {2, 2},
                                     .max_force_n = 30,
                                     .collide_connected = false};
            case 7:
                return GearJointDef{.joint_1 = slide, .joint_2 = pin, .collide_connected = false};
            case 8:
                return PulleyJointDef{.body_a = box,
                                      .body_b = other,
                                      .wheel_a_m = {0, 3},
                                      .wheel_b_m = {2, 3},
                                      .length_m = 4,
                                      .collide_connected = false};
            case 9:
                return FrictionJointDef{.body_a = other,
                                        .body_b = box,
                                        .local_anchor_b_m = {0.6f, 0.1f},
                                        .max_force_n = 3,
                                        .max_torque_nm = 1,
                                        .collide_connected = false};
            case 10:
                return FilterJointDef{.body_a = wall, .body_b = box};
            case 11:
                return WeldJointDef{.body_a = wall, .body_b = box, .local_anchor_a_m = {0.5f, 0}};
            case 12:
                return MotorJointDef{.body_a = wall,
                                     .body_b = box,
                                     .linear_velocity_m_s = {1, 2},
                                     .angular_velocity_rad_s = 1,
                                     .max_force_n = 50,
                                     .max_torque_nm = 5,
                                     .collide_connected = false};
            default:
                return GearJointDef{.joint_1 = pin, .joint_2 = slide, .collide_connected = false};
        }
    }
    /// What `def` of a gear needs besides.
    void prepare(std::size_t kind) {
        if (kind != 7 && kind != 13) return;
        slide = world
                    .create_joint(PrismaticJointDef{
                        .body_a = wall, .body_b = box, .local_angle_a_rad = 0.3f, .local_angle_b_rad = 0.3f})
                    .value();
    }
    JointId slide{};
};

// The places and speeds of the bodies over two seconds, and when the joint broke.
std::vector<std::uint64_t> history(World& world) {
    std::vector<std::uint64_t> states;
    for (int i = 0; i < 120; ++i) {
        world.step(kStep_s).value();
        states.push_back(world.state_hash() + world.joint_breaks().size());
    }
    return states;
}

constexpr std::size_t kKinds = std::variant_size_v<JointDef>;
constexpr std::size_t kScenes = 14;

// What cannot matter: joints that pull at a point bear no torque.
bool is_idle(std::size_t kind, int leaf) {
    const auto is = [&](JointKind k, int torque) {
        return kind == static_cast<std::size_t>(k) && leaf == torque;
    };
    return is(JointKind::Distance, 15) || is(JointKind::Mouse, 8) || is(JointKind::Pulley, 13);
}

}  // namespace

TEST_CASE("no number of any kind of joint may be none, when it is made and when it is changed") {
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        Scene scene;
        scene.prepare(kind);
        const JointDef good = scene.def(kind);
        const JointId joint = scene.world.create_joint(good).value();
        const std::uint64_t before = scene.world.state_hash();
        const int joints = scene.world.counts().joints;
        std::set<std::string> messages;
        int numbers = 0;
        for (int leaf = 0; leaf < leaves_of(good); ++leaf) {
            JointDef bad = good;
            bool is_number = false;
            at_leaf(bad, leaf, [&](auto& x) {
                using Number = std::remove_cvref_t<decltype(x)>;
                is_number = !std::is_same_v<Number, bool>;
                if constexpr (!std::is_same_v<Number, bool>) x = std::numeric_limits<Number>::quiet_NaN();
            });
            if (!is_number) continue;
            ++numbers;
            const auto made = scene.world.create_joint(bad);
            const auto changed = scene.world.joint(joint)->redefine(bad);
            INFO("kind " << kind << ", number " << leaf);
            REQUIRE_FALSE(made);
            REQUIRE_FALSE(changed);
            CHECK_THAT(made.error().message, Catch::Contains("_joint.") && Catch::Contains("nan"));
            CHECK(changed.error().message == made.error().message);
            messages.insert(made.error().message);
        }
        // Each says which one it was.
        CHECK(messages.size() == static_cast<std::size_t>(numbers));
        CHECK(scene.world.state_hash() == before);
        CHECK(scene.world.counts().joints == joints);
        CHECK(scene.world.joint(joint)->definition().index() == kind);
    }
}

TEST_CASE("whatever is changed of a living joint is as if it had been made so, and matters") {
    // Turned on or off; or the first of these that is allowed and makes a difference.
    const std::vector<std::function<double(double)>> changes{
        [](double x) { return x + 0.05; }, [](double x) { return x - 0.05; }, [](double x) { return x / 2; },
        [](double) { return 1e-6; },       [](double x) { return x * 100; },
    };
    std::map<std::pair<std::size_t, int>, bool> matters;
    for (std::size_t kind = 0; kind < kScenes; ++kind) {
        Scene plain;
        plain.prepare(kind);
        plain.world.create_joint(plain.def(kind)).value();
        const auto unchanged = history(plain.world);
        for (int leaf = 0; leaf < leaves_of(plain.def(kind)); ++leaf) {
            bool& differs = matters[{plain.def(kind).index(), leaf}];
            bool found = false;
            for (std::size_t c = 0; c < changes.size() && !found; ++c) {
                const auto second = [&](const Scene& scene) {
                    JointDef def = scene.def(kind);
                    at_leaf(def, leaf, [&](auto& x) {
                        using Number = std::remove_cvref_t<decltype(x)>;
                        if constexpr (std::is_same_v<Number, bool>) {
                            x = !x;
                        } else {
                            x = static_cast<Number>(changes[c](static_cast<double>(x)));
                        }
                    });
                    return def;
                };
                Scene made;
                made.prepare(kind);
                if (!made.world.create_joint(second(made))) continue;
                Scene changed;
                changed.prepare(kind);
                const JointId joint = changed.world.create_joint(changed.def(kind)).value();
                changed.world.joint(joint)->redefine(second(changed)).value();
                const auto after = history(changed.world);
                INFO("kind " << kind << ", leaf " << leaf << ", change " << c);
                const bool same = after == history(made.world);
                CHECK(same);
                found = after != unchanged;
            }
            differs = differs || found;
        }
    }
    for (const auto& [place, differs] : matters) {
        INFO("kind " << place.first << ", leaf " << place.second);
        CHECK(differs != is_idle(place.first, place.second));
    }
}

}  // namespace cairn::physics
