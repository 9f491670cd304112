// Chipmunk 7 behind the interface of engines, with its default of 10 iterations.
#include <algorithm>
#include <array>
#include <chipmunk/chipmunk.h>
#include <cmath>
#include <cstdio>
#include <unistd.h>
#include <variant>

#include "engine.h"

namespace cairn::measure {
namespace {

using physics::BodyType;
using physics::Box;
using physics::Capsule;
using physics::Circle;
using physics::Polygon;
using physics::Position;
using physics::Vec2;

constexpr double kTimeToSleep_s = 0.5;  // Cairn's

cpVect vec(Vec2 v) {
    return cpv(static_cast<double>(v.x), static_cast<double>(v.y));
}
cpBody* body_of(BodyRef body) {
    return reinterpret_cast<cpBody*>(body.bits);
}

// 0 for what nothing moves.
double mass_of(const cpBody* body) {
    return cpBodyGetType(const_cast<cpBody*>(body)) == CP_BODY_TYPE_DYNAMIC ? cpBodyGetMass(body) : 0;
}
double inertia_of(const cpBody* body) {
    return cpBodyGetType(const_cast<cpBody*>(body)) == CP_BODY_TYPE_DYNAMIC ? cpBodyGetMoment(body) : 0;
}
double inverse(double mass) {
    return mass > 0 ? 1 / mass : 0;
}

cpBody* new_body(BodyType type) {
    switch (type) {
        case BodyType::Static:
            return cpBodyNewStatic();
        case BodyType::Kinematic:
            return cpBodyNewKinematic();
        case BodyType::Dynamic:
            return cpBodyNew(0, 0);  // its shapes will give it mass
    }
    return nullptr;
}

cpShape* new_poly(cpBody* body, std::span<const Vec2> points, float radius) {
    std::array<cpVect, physics::kMaxPolygonVertices> corners;
    std::transform(points.begin(), points.end(), corners.begin(), [](Vec2 p) { return vec(p); });
    return cpPolyShapeNew(body, static_cast<int>(points.size()), corners.data(), cpTransformIdentity,
                          static_cast<double>(radius));
}

cpShape* new_shape(cpBody* body, const Circle& circle) {
    return cpCircleShapeNew(body, static_cast<double>(circle.radius_m), vec(circle.center_m));
}
cpShape* new_shape(cpBody* body, const Capsule& capsule) {
    return cpSegmentShapeNew(body, vec(capsule.a_m), vec(capsule.b_m), static_cast<double>(capsule.radius_m));
}
cpShape* new_shape(cpBody* body, const Box& box) {
    const physics::Rotation turn = physics::Rotation::from_angle(static_cast<double>(box.angle_rad));
    std::array corners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
    for (Vec2& p : corners) {
        p = box.center_m + rotate(turn, {p.x * box.half_width_m, p.y * box.half_height_m});
    }
    return new_poly(body, corners, box.radius_m);
}
cpShape* new_shape(cpBody* body, const Polygon& polygon) {
    return new_poly(body, polygon.points_m, polygon.radius_m);
}
cpShape* new_shape(cpBody* body, const physics::Segment& segment) {
    return cpSegmentShapeNew(body, vec(segment.a_m), vec(segment.b_m), 0);
}

// A Chipmunk that was built with its assertions, as Debian's is, greets on standard output: that belongs to
// the results.
cpSpace* new_space() {
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    cpSpace* space = cpSpaceNew();
    std::fflush(stdout);
    dup2(kept, STDOUT_FILENO);
    close(kept);
    return space;
}

class ChipmunkEngine final : public Engine {
  public:
    explicit ChipmunkEngine(const WorldSetting& setting) : space_(new_space()) {
        cpSpaceSetGravity(space_, vec(setting.gravity_m_s2));
        if (setting.effort > 0) cpSpaceSetIterations(space_, setting.effort);
        sleeps_ = setting.enable_sleep;
        if (sleeps_) cpSpaceSetSleepTimeThreshold(space_, kTimeToSleep_s);
    }
    ~ChipmunkEngine() override {
        for (cpConstraint* joint : joints_) free_joint(joint);
        for (cpShape* shape : shapes_) free_shape(shape);
        for (cpBody* body : bodies_) free_body(body);
        cpSpaceFree(space_);
    }

    // Of damping Chipmunk has one for the whole space: that of the last body that asks for some.
    BodyRef add_body(const physics::BodyDef& def) override {
        if (def.linear_damping_1_s > 0) {
            cpSpaceSetDamping(space_,
                              physics::deterministic::exp(-static_cast<double>(def.linear_damping_1_s)));
        }
        cpBody* body = cpSpaceAddBody(space_, new_body(def.type));
        cpBodySetPosition(body, cpv(def.position_m.x, def.position_m.y));
        cpBodySetAngle(body, def.angle_rad);
        if (def.type != BodyType::Static) {
            cpBodySetVelocity(body, vec(def.linear_velocity_m_s));
            cpBodySetAngularVelocity(body, static_cast<double>(def.angular_velocity_rad_s));
        }
        if (def.type == BodyType::Dynamic && !def.awake && sleeps_) to_sleep_.push_back(body);
        bodies_.push_back(body);
        return {reinterpret_cast<std::uint64_t>(body)};
    }

    void add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def) override {
        cpShape* shape = std::visit([&](const auto& g) { return new_shape(body_of(body), g); }, geometry);
        // Chipmunk multiplies those of two shapes: of the roots, that is the geometric mean.
        cpShapeSetFriction(shape, std::sqrt(static_cast<double>(def.material.friction)));
        cpShapeSetElasticity(shape, std::sqrt(static_cast<double>(def.material.restitution)));
        cpShapeSetFilter(shape, cpShapeFilterNew(static_cast<cpGroup>(-std::min(def.filter.group, 0)),
                                                 static_cast<cpBitmask>(def.filter.categories),
                                                 static_cast<cpBitmask>(def.filter.mask)));
        if (cpBodyGetType(body_of(body)) == CP_BODY_TYPE_DYNAMIC) {
            cpShapeSetDensity(shape, static_cast<double>(def.density_kg_m2));
        }
        shapes_.push_back(cpSpaceAddShape(space_, shape));
    }

    void add_closed_chain(BodyRef body, std::span<const Vec2> points_m, physics::Material material) override {
        for (std::size_t i = 0; i < points_m.size(); ++i) {
            const Vec2 next = points_m[(i + 1) % points_m.size()];
            add_shape(body, physics::Segment{points_m[i], next}, {.material = material});
        }
    }

    void add_revolute(BodyRef a, BodyRef b, const physics::RevoluteJointDef& def) override {
        cpBody* body_a = body_of(a);
        cpBody* body_b = body_of(b);
        const bool collide = def.collide_connected;
        add_joint(cpPivotJointNew2(body_a, body_b, vec(def.local_anchor_a_m), vec(def.local_anchor_b_m)),
                  collide);
        if (def.enable_limit) {
            const float offset = def.local_angle_a_rad - def.local_angle_b_rad;
            add_joint(cpRotaryLimitJointNew(body_a, body_b, static_cast<double>(def.lower_rad + offset),
                                            static_cast<double>(def.upper_rad + offset)),
                      collide);
        }
        if (def.enable_motor)
            add_turning(body_a, body_b, def.motor_speed_rad_s, def.max_motor_torque_nm, collide);
    }

    // A groove along the suspension, and a spring from its far end.
    void add_wheel(BodyRef a, BodyRef b, const physics::WheelJointDef& def) override {
        cpBody* body_a = body_of(a);
        cpBody* body_b = body_of(b);
        const Vec2 axis =
            rotate(physics::Rotation::from_angle(static_cast<double>(def.local_angle_a_rad)), {1, 0});
        constexpr float kReach_m = 1;
        const Vec2 far = def.local_anchor_a_m + kReach_m * axis;
        const Vec2 near = def.local_anchor_a_m - kReach_m * axis;
        add_joint(cpGrooveJointNew(body_a, body_b, vec(near), vec(far), vec(def.local_anchor_b_m)), false);
        const double mass = 1 / (1 / cpBodyGetMass(body_a) + 1 / cpBodyGetMass(body_b));
        const double omega = 2 * static_cast<double>(physics::kPi * def.frequency_hz);
        add_joint(cpDampedSpringNew(body_a, body_b, vec(far), vec(def.local_anchor_b_m),
                                    static_cast<double>(kReach_m - def.target_m), mass * omega * omega,
                                    2 * mass * static_cast<double>(def.damping_ratio) * omega),
                  false);
        if (def.enable_motor)
            add_turning(body_a, body_b, def.motor_speed_rad_s, def.max_motor_torque_nm, false);
    }

    void add_distance(BodyRef a, BodyRef b, const physics::DistanceJointDef& def) override {
        cpBody* body_a = body_of(a);
        cpBody* body_b = body_of(b);
        const cpVect at_a = vec(def.local_anchor_a_m);
        const cpVect at_b = vec(def.local_anchor_b_m);
        const auto length = static_cast<double>(def.length_m);
        if (!def.enable_spring) {
            cpConstraint* pin = cpPinJointNew(body_a, body_b, at_a, at_b);
            cpPinJointSetDist(pin, length);
            add_joint(pin, def.collide_connected);
            return;
        }
        const double mass = 1 / (inverse(mass_of(body_a)) + inverse(mass_of(body_b)));
        const double omega = 2 * static_cast<double>(physics::kPi * def.frequency_hz);
        add_joint(cpDampedSpringNew(body_a, body_b, at_a, at_b, length, mass * omega * omega,
                                    2 * mass * static_cast<double>(def.damping_ratio) * omega),
                  def.collide_connected);
    }

    // A pivot; and gears of ratio 1, or a spring, that hold the angle.
    void add_weld(BodyRef a, BodyRef b, const physics::WeldJointDef& def) override {
        cpBody* body_a = body_of(a);
        cpBody* body_b = body_of(b);
        add_joint(cpPivotJointNew2(body_a, body_b, vec(def.local_anchor_a_m), vec(def.local_anchor_b_m)),
                  def.collide_connected);
        const auto rest = static_cast<double>(def.local_angle_a_rad - def.local_angle_b_rad);
        if (def.angular_frequency_hz == 0) {
            add_joint(cpGearJointNew(body_a, body_b, rest, 1), def.collide_connected);
            return;
        }
        const double inertia = 1 / (inverse(inertia_of(body_a)) + inverse(inertia_of(body_b)));
        const double omega = 2 * static_cast<double>(physics::kPi * def.angular_frequency_hz);
        // Its angle is that of a relative to b.
        add_joint(
            cpDampedRotarySpringNew(body_a, body_b, -rest, inertia * omega * omega,
                                    2 * inertia * static_cast<double>(def.angular_damping_ratio) * omega),
            def.collide_connected);
    }

    void remove_body(BodyRef ref) override {
        cpBody* body = body_of(ref);
        const auto drop = [](auto& list, auto&& belongs, auto&& remove) {
            const auto first = std::stable_partition(list.begin(), list.end(),
                                                     [&](const auto* item) { return !belongs(item); });
            std::for_each(first, list.end(), remove);
            list.erase(first, list.end());
        };
        drop(
            joints_,
            [&](const cpConstraint* joint) {
                return cpConstraintGetBodyA(joint) == body || cpConstraintGetBodyB(joint) == body;
            },
            [&](cpConstraint* joint) { free_joint(joint); });
        drop(
            shapes_, [&](const cpShape* shape) { return cpShapeGetBody(shape) == body; },
            [&](cpShape* shape) { free_shape(shape); });
        drop(
            bodies_, [&](const cpBody* other) { return other == body; },
            [&](cpBody* gone) { free_body(gone); });
    }

    void set_linear_velocity(BodyRef body, Vec2 velocity_m_s) override {
        cpBodySetVelocity(body_of(body), vec(velocity_m_s));
    }
    void set_transform(BodyRef body, Position position_m, double angle_rad) override {
        cpBodySetPosition(body_of(body), cpv(position_m.x, position_m.y));
        cpBodySetAngle(body_of(body), angle_rad);
        cpSpaceReindexShapesForBody(space_, body_of(body));
    }
    void set_angular_velocity(BodyRef body, float velocity_rad_s) override {
        cpBodySetAngularVelocity(body_of(body), static_cast<double>(velocity_rad_s));
    }
    void apply_force(BodyRef body, Vec2 force_n) override {
        cpBody* peer = body_of(body);
        cpBodyApplyForceAtWorldPoint(peer, vec(force_n),
                                     cpBodyLocalToWorld(peer, cpBodyGetCenterOfGravity(peer)));
    }
    [[nodiscard]] Motion motion(BodyRef body) const override {
        const cpBody* view = body_of(body);
        const cpVect p = cpBodyGetPosition(view);
        const cpVect center = cpBodyLocalToWorld(view, cpBodyGetCenterOfGravity(view));
        const cpVect q = cpBodyGetRotation(view);
        const cpVect v = cpBodyGetVelocity(view);
        return {.position_m = {p.x, p.y},
                .center_m = {center.x, center.y},
                .c = q.x,
                .s = q.y,
                .vx_m_s = v.x,
                .vy_m_s = v.y,
                .angular_velocity_rad_s = cpBodyGetAngularVelocity(view),
                .awake = cpBodyIsSleeping(view) == cpFalse};
    }
    [[nodiscard]] Mass mass(BodyRef body) const override {
        return {mass_of(body_of(body)), inertia_of(body_of(body))};
    }
    [[nodiscard]] Position position(BodyRef body) const override {
        const cpVect p = cpBodyGetPosition(body_of(body));
        return {p.x, p.y};
    }

    void step(float dt_s) override {
        // Only now have they all their shapes.
        for (cpBody* body : to_sleep_) cpBodySleepWithGroup(body, nullptr);
        to_sleep_.clear();
        cpSpaceStep(space_, static_cast<double>(dt_s));
    }

    [[nodiscard]] int awake_bodies() const override {
        return static_cast<int>(std::count_if(bodies_.begin(), bodies_.end(), [](cpBody* body) {
            return cpBodyGetType(body) != CP_BODY_TYPE_STATIC && cpBodyIsSleeping(body) == cpFalse;
        }));
    }

    [[nodiscard]] Tally tally() const override {
        // Chipmunk knows the pairs that touch only, each from both bodies.
        int ends = 0;
        each_touch([&](cpArbiter*) { ++ends; });
        return {.bodies = static_cast<int>(bodies_.size()),
                .shapes = static_cast<int>(shapes_.size()),
                .joints = static_cast<int>(joints_.size()),
                .contacts = ends / 2,
                .touching = ends / 2};
    }

    [[nodiscard]] float max_penetration_m() const override {
        double deepest = 0;
        each_touch([&](cpArbiter* touch) {
            for (int i = 0; i < cpArbiterGetCount(touch); ++i) {
                deepest = std::max(deepest, -cpArbiterGetDepth(touch, i));
            }
        });
        return static_cast<float>(deepest);
    }

    [[nodiscard]] std::vector<Vec2> velocities_m_s() const override {
        std::vector<Vec2> velocities;
        for (cpBody* body : bodies_) {
            if (cpBodyGetType(body) == CP_BODY_TYPE_STATIC) continue;
            const cpVect v = cpBodyGetVelocity(body);
            velocities.push_back({static_cast<float>(v.x), static_cast<float>(v.y)});
        }
        return velocities;
    }

  private:
    void add_joint(cpConstraint* joint, bool collide) {
        cpConstraintSetCollideBodies(joint, collide ? cpTrue : cpFalse);
        joints_.push_back(cpSpaceAddConstraint(space_, joint));
    }
    // A motor's rate is that of a relative to b.
    void add_turning(cpBody* a, cpBody* b, float speed_rad_s, float max_torque_nm, bool collide) {
        cpConstraint* motor = cpSimpleMotorNew(a, b, -static_cast<double>(speed_rad_s));
        cpConstraintSetMaxForce(motor, static_cast<double>(max_torque_nm));
        add_joint(motor, collide);
    }

    void free_joint(cpConstraint* joint) {
        cpSpaceRemoveConstraint(space_, joint);
        cpConstraintFree(joint);
    }
    void free_shape(cpShape* shape) {
        cpSpaceRemoveShape(space_, shape);
        cpShapeFree(shape);
    }
    void free_body(cpBody* body) {
        cpSpaceRemoveBody(space_, body);
        cpBodyFree(body);
    }

    template <class Visit>
    void each_touch(Visit visit) const {
        for (cpBody* body : bodies_) {
            cpBodyEachArbiter(
                body, [](cpBody*, cpArbiter* touch, void* data) { (*static_cast<Visit*>(data))(touch); },
                &visit);
        }
    }

    cpSpace* space_;
    bool sleeps_ = true;
    std::vector<cpBody*> bodies_;
    std::vector<cpShape*> shapes_;
    std::vector<cpConstraint*> joints_;
    std::vector<cpBody*> to_sleep_;
};

}  // namespace

std::unique_ptr<Engine> make_chipmunk(const WorldSetting& setting) {
    return std::make_unique<ChipmunkEngine>(setting);
}

}  // namespace cairn::measure
