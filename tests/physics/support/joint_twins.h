// The same joints in lanes and as scalars, on the same bodies: the scalar solver of all kinds is a second
// implementation of the same laws.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "integrator/integrate.h"
#include "physics/support/random.h"
#include "resolve/joints/joint_lanes.h"
#include "resolve/joints/joint_solver.h"
#include "resolve/joints/kinds.h"
#include "resolve/joints/spring_mobility.h"
#include "resolve/joints/torn_joints.h"

namespace cairn::physics::test {

inline constexpr float kSubstep_s = 1.0f / 240;

struct JointTwins {
    std::vector<Place> places{Place{}};
    Motions swept;
    Motions in_lanes;
    std::vector<JointConstraint> constraints;
    JointLanes lanes;
    std::vector<JointSeat> seats;
    std::vector<JointPlace> joint_places;
    TaskPool tasks{1, nullptr};
    std::vector<TornJoint> torn;  // of the scalars
    std::vector<TornJoint> torn_in_lanes;
    bool has_crowded_springs = false;

    JointTwins() {
        lanes.h_s = kSubstep_s;
        for (Motions* motions : {&swept, &in_lanes}) motions->add({}, 0, 0, 0);
    }

    void add_body(Random& random, bool pushed, double spread_m = 0.1) {
        const Vec2 v = random.vector(-2, 2);
        const float w = random.real_f(-20, 20);
        const float inverse_mass = pushed ? random.real_f(0.1, 2) : 0;
        const float inverse_inertia = pushed ? random.real_f(0.1, 9) : 0;
        for (Motions* motions : {&swept, &in_lanes}) {
            motions->add(v, w, inverse_mass, inverse_inertia);
            motions->mover.back() = MovedBy::Turning;
        }
        const Rotation rotation = Rotation::from_angle(random.real(-3, 3));
        const Vec2 center = random.vector(-spread_m, spread_m);
        places.push_back({Position{} + center, rotation, static_cast<int>(places.size())});
    }

    [[nodiscard]] const Place& place(int body) const { return places[static_cast<std::size_t>(body)]; }

    /// A constraint without laws, the centres of mass being the origins of the bodies.
    [[nodiscard]] JointConstraint constraint(JointKind kind, int a, int b, Vec2 local_a, Vec2 local_b) const {
        JointConstraint c;
        c.kind = kind;
        c.rows = {a, b};
        c.anchors = {a, b, rotate(place(a).rotation, local_a), rotate(place(b).rotation, local_b),
                     place(b).center - place(a).center};
        c.start_angle_rad = turn(a, b).angle_rad();
        return c;
    }
    [[nodiscard]] Rotation turn(int a, int b) const { return inverse(place(a).rotation) * place(b).rotation; }

    /// Of the constraint of the same number.
    [[nodiscard]] bool is_rigid(int joint) const {
        const JointConstraint& c = constraints[static_cast<std::size_t>(joint)];
        return std::any_of(c.laws.begin(), c.laws.begin() + c.law_count,
                           [](const JointLaw& law) { return law.kind == LawKind::Hold && law.rigid; });
    }

    /// When all joints are there.
    void begin() {
        std::vector<SpringLoad> loads(places.size());
        lanes.arrange();
        if (lanes.place(places, in_lanes, 1, 4 * kSubstep_s, tasks))
            lanes.hide_tears([&](int joint) { return is_rigid(joint); }, torn_in_lanes);
        for (JointConstraint& c : constraints) {
            if (TornJoint tear{}; hide_tear(c, tear)) torn.push_back(tear);
        }
        place_joints(constraints, swept, joint_places);
        weigh_springs(constraints, joint_places);
        add_spring_loads(constraints, joint_places, swept, loads);
        std::vector<SpringLoad> of_lanes(places.size());
        lanes.add_spring_loads(in_lanes, of_lanes, tasks);
        for (std::size_t row = 0; row < loads.size(); ++row) {
            CHECK(of_lanes[row].springs == loads[row].springs);
            CHECK(of_lanes[row].together_1_s2 == Approx(loads[row].together_1_s2).epsilon(1e-5));
        }
        has_crowded_springs = make_springs(constraints, kSubstep_s, loads);
        lanes.settle_springs(loads, false, tasks);
        CHECK(lanes.has_crowded_springs() == has_crowded_springs);
    }

    void substep() {
        const JointPassTime time{softness_of(JointStiffness{}, kSubstep_s), 1 / kSubstep_s};
        note_spring_speeds(constraints, joint_places, swept);
        lanes.note_spring_speeds(in_lanes, tasks);
        for (Motions* motions : {&swept, &in_lanes}) {
            for (std::size_t row = 1; row < places.size(); ++row) {
                if (motions->velocity[row].inverse_mass > 0) motions->velocity[row].v += Vec2{0, -0.04f};
            }
        }
        warm_start_joints(constraints, joint_places, swept);
        lanes.warm_start(in_lanes, tasks);
        for (int i = 0; has_crowded_springs && i < kCrowdedSweeps; ++i) {
            for (const bool back : {false, true}) {
                sweep_crowded_springs(constraints, joint_places, swept, back);
                lanes.sweep_crowded_springs(in_lanes, back);
            }
        }
        solve_joints(constraints, joint_places, swept, kSubstep_s, Pass::Biased);
        lanes.solve(in_lanes, time, tasks);
        integrate_positions(swept, kSubstep_s);
        integrate_positions(in_lanes, kSubstep_s);
        solve_joints(constraints, joint_places, swept, kSubstep_s, Pass::Relax);
        lanes.relax(in_lanes, time, tasks);
    }

    void check_agree() const {
        for (std::size_t row = 0; row < places.size(); ++row) {
            INFO("row " << row);
            const VelocityRow& expected = swept.velocity[row];
            const VelocityRow& found = in_lanes.velocity[row];
            const float room = 2e-3f * (1 + length(expected.v) + std::fabs(expected.w));
            CHECK(length(found.v - expected.v) < room);
            CHECK(std::fabs(found.w - expected.w) < room);
        }
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            INFO("joint " << i);
            const JointMemory memory = lanes.memory(seats[i]);
            for (std::size_t k = 0; k < memory.impulse.size(); ++k) {
                const float expected = constraints[i].impulse[k];
                CHECK(std::fabs(memory.impulse[k] - expected) < 2e-3f * (1 + std::fabs(expected)));
            }
        }
    }
};

}  // namespace cairn::physics::test
