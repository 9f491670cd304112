// Box2D 2.4 behind the interface of engines, with the iterations that its manual recommends.
#include <algorithm>
#include <array>
#include <box2d/box2d.h>
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

constexpr int kVelocityIterations = 8;

// 3 for 8, as the manual has it.
int position_iterations(int velocity_iterations) {
    return std::max(1, 3 * velocity_iterations / 8);
}

b2Vec2 vec(Vec2 v) {
    return {v.x, v.y};
}
b2Vec2 vec(Position p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}
Position position_of(b2Vec2 p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
b2Body* body_of(BodyRef body) {
    return reinterpret_cast<b2Body*>(body.bits);
}

b2BodyType type_of(BodyType type) {
    switch (type) {
        case BodyType::Static:
            return b2_staticBody;
        case BodyType::Kinematic:
            return b2_kinematicBody;
        case BodyType::Dynamic:
            return b2_dynamicBody;
    }
    return b2_staticBody;
}

class Box2dEngine final : public Engine {
  public:
    explicit Box2dEngine(const WorldSetting& setting)
        : world_(vec(setting.gravity_m_s2)),
          iterations_(setting.effort > 0 ? setting.effort : kVelocityIterations) {
        world_.SetAllowSleeping(setting.enable_sleep);
    }

    BodyRef add_body(const physics::BodyDef& def) override {
        b2BodyDef peer;
        peer.type = type_of(def.type);
        peer.position = vec(def.position_m);
        peer.angle = static_cast<float>(def.angle_rad);
        peer.linearVelocity = vec(def.linear_velocity_m_s);
        peer.angularVelocity = def.angular_velocity_rad_s;
        peer.linearDamping = def.linear_damping_1_s;
        peer.angularDamping = def.angular_damping_1_s;
        peer.gravityScale = def.gravity_scale;
        peer.allowSleep = def.allow_sleep;
        peer.awake = def.awake;
        return {reinterpret_cast<std::uint64_t>(world_.CreateBody(&peer))};
    }

    void add_shape(BodyRef body, const physics::Geometry& geometry, const physics::ShapeDef& def) override {
        b2FixtureDef fixture;
        fixture.density = def.density_kg_m2;
        fixture.friction = def.material.friction;
        fixture.restitution = def.material.restitution;
        fixture.filter.categoryBits = static_cast<std::uint16_t>(def.filter.categories);
        fixture.filter.maskBits = static_cast<std::uint16_t>(def.filter.mask);
        fixture.filter.groupIndex = static_cast<std::int16_t>(def.filter.group);
        const auto add = [&](const b2Shape& shape) {
            fixture.shape = &shape;
            body_of(body)->CreateFixture(&fixture);
        };
        std::visit([&](const auto& shape) { add(made(shape)); }, geometry);
    }

    void add_closed_chain(BodyRef body, std::span<const Vec2> points_m, physics::Material material) override {
        std::vector<b2Vec2> points;
        for (const Vec2 p : points_m) points.push_back(vec(p));
        b2ChainShape chain;
        chain.CreateLoop(points.data(), static_cast<int>(points.size()));
        b2FixtureDef fixture;
        fixture.shape = &chain;
        fixture.friction = material.friction;
        fixture.restitution = material.restitution;
        body_of(body)->CreateFixture(&fixture);
    }

    void add_revolute(BodyRef a, BodyRef b, const physics::RevoluteJointDef& def) override {
        b2RevoluteJointDef joint;
        joint.bodyA = body_of(a);
        joint.bodyB = body_of(b);
        joint.localAnchorA = vec(def.local_anchor_a_m);
        joint.localAnchorB = vec(def.local_anchor_b_m);
        joint.referenceAngle = def.local_angle_a_rad - def.local_angle_b_rad;
        joint.enableLimit = def.enable_limit;
        joint.lowerAngle = def.lower_rad;
        joint.upperAngle = def.upper_rad;
        joint.enableMotor = def.enable_motor;
        joint.motorSpeed = def.motor_speed_rad_s;
        joint.maxMotorTorque = def.max_motor_torque_nm;
        joint.collideConnected = def.collide_connected;
        world_.CreateJoint(&joint);
    }

    void add_wheel(BodyRef a, BodyRef b, const physics::WheelJointDef& def) override {
        b2WheelJointDef joint;
        joint.bodyA = body_of(a);
        joint.bodyB = body_of(b);
        joint.localAnchorA = vec(def.local_anchor_a_m);
        joint.localAnchorB = vec(def.local_anchor_b_m);
        joint.localAxisA =
            vec(rotate(physics::Rotation::from_angle(static_cast<double>(def.local_angle_a_rad)), {1, 0}));
        b2LinearStiffness(joint.stiffness, joint.damping, def.frequency_hz, def.damping_ratio, joint.bodyA,
                          joint.bodyB);
        joint.enableLimit = def.enable_limit;
        joint.lowerTranslation = def.lower_m;
        joint.upperTranslation = def.upper_m;
        joint.enableMotor = def.enable_motor;
        joint.motorSpeed = def.motor_speed_rad_s;
        joint.maxMotorTorque = def.max_motor_torque_nm;
        world_.CreateJoint(&joint);
    }

    void add_distance(BodyRef a, BodyRef b, const physics::DistanceJointDef& def) override {
        b2DistanceJointDef joint;
        joint.bodyA = body_of(a);
        joint.bodyB = body_of(b);
        joint.localAnchorA = vec(def.local_anchor_a_m);
        joint.localAnchorB = vec(def.local_anchor_b_m);
        joint.length = def.length_m;
        joint.minLength = def.enable_spring ? def.min_length_m : def.length_m;
        joint.maxLength = def.enable_spring ? std::min(def.max_length_m, b2_maxFloat) : def.length_m;
        if (def.enable_spring) {
            b2LinearStiffness(joint.stiffness, joint.damping, def.frequency_hz, def.damping_ratio,
                              joint.bodyA, joint.bodyB);
        }
        joint.collideConnected = def.collide_connected;
        world_.CreateJoint(&joint);
    }

    void add_weld(BodyRef a, BodyRef b, const physics::WeldJointDef& def) override {
        b2WeldJointDef joint;
        joint.bodyA = body_of(a);
        joint.bodyB = body_of(b);
        joint.localAnchorA = vec(def.local_anchor_a_m);
        joint.localAnchorB = vec(def.local_anchor_b_m);
        joint.referenceAngle = def.local_angle_a_rad - def.local_angle_b_rad;
        if (def.angular_frequency_hz > 0) {
            b2AngularStiffness(joint.stiffness, joint.damping, def.angular_frequency_hz,
                               def.angular_damping_ratio, joint.bodyA, joint.bodyB);
        }
        joint.collideConnected = def.collide_connected;
        world_.CreateJoint(&joint);
    }

    void remove_body(BodyRef body) override { world_.DestroyBody(body_of(body)); }
    void set_transform(BodyRef body, Position position_m, double angle_rad) override {
        body_of(body)->SetTransform(vec(position_m), static_cast<float>(angle_rad));
        body_of(body)->SetAwake(true);
    }

    void set_linear_velocity(BodyRef body, Vec2 velocity_m_s) override {
        body_of(body)->SetLinearVelocity(vec(velocity_m_s));
    }
    void set_angular_velocity(BodyRef body, float velocity_rad_s) override {
        body_of(body)->SetAngularVelocity(velocity_rad_s);
    }
    void apply_force(BodyRef body, Vec2 force_n) override {
        body_of(body)->ApplyForceToCenter(vec(force_n), true);
    }
    [[nodiscard]] Motion motion(BodyRef body) const override {
        const b2Body& view = *body_of(body);
        const b2Transform pose = view.GetTransform();
        const b2Vec2 v = view.GetLinearVelocity();
        return {.position_m = position_of(pose.p),
                .center_m = position_of(view.GetWorldCenter()),
                .c = static_cast<double>(pose.q.c),
                .s = static_cast<double>(pose.q.s),
                .vx_m_s = static_cast<double>(v.x),
                .vy_m_s = static_cast<double>(v.y),
                .angular_velocity_rad_s = static_cast<double>(view.GetAngularVelocity()),
                .awake = view.IsAwake()};
    }
    [[nodiscard]] Mass mass(BodyRef body) const override {
        b2MassData data;
        body_of(body)->GetMassData(&data);  // its inertia is about the origin
        return {static_cast<double>(data.mass),
                static_cast<double>(data.I - data.mass * b2Dot(data.center, data.center))};
    }
    [[nodiscard]] Position position(BodyRef body) const override {
        return position_of(body_of(body)->GetPosition());
    }

    void step(float dt_s) override { world_.Step(dt_s, iterations_, position_iterations(iterations_)); }

    [[nodiscard]] int awake_bodies() const override {
        int awake = 0;
        for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (body->GetType() != b2_staticBody && body->IsAwake()) ++awake;
        }
        return awake;
    }

    [[nodiscard]] Tally tally() const override {
        Tally tally{.bodies = world_.GetBodyCount(),
                    .joints = world_.GetJointCount(),
                    .contacts = world_.GetContactCount()};
        for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
            for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) ++tally.shapes;
        }
        for (const b2Contact* c = world_.GetContactList(); c != nullptr; c = c->GetNext()) {
            if (c->IsTouching()) ++tally.touching;
        }
        return tally;
    }

    [[nodiscard]] float max_penetration_m() const override {
        float deepest = 0;
        for (const b2Contact* c = world_.GetContactList(); c != nullptr; c = c->GetNext()) {
            b2WorldManifold manifold;
            c->GetWorldManifold(&manifold);
            for (int i = 0; i < c->GetManifold()->pointCount; ++i) {
                deepest = std::max(deepest, -manifold.separations[i]);
            }
        }
        return deepest;
    }

    [[nodiscard]] std::vector<Vec2> velocities_m_s() const override {
        std::vector<Vec2> velocities;
        for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
            const b2Vec2 v = body->GetLinearVelocity();
            if (body->GetType() != b2_staticBody) velocities.push_back({v.x, v.y});
        }
        return velocities;
    }

  private:
    // Shapes are copied by the world.
    static b2CircleShape made(const Circle& circle) {
        b2CircleShape shape;
        shape.m_p = vec(circle.center_m);
        shape.m_radius = circle.radius_m;
        return shape;
    }
    static b2PolygonShape made(const Box& box) {
        b2PolygonShape shape;
        shape.SetAsBox(box.half_width_m, box.half_height_m, vec(box.center_m), box.angle_rad);
        return shape;
    }
    static b2PolygonShape made(const Polygon& polygon) {
        std::array<b2Vec2, physics::kMaxPolygonVertices> points;
        std::transform(polygon.points_m.begin(), polygon.points_m.end(), points.begin(),
                       [](Vec2 p) { return vec(p); });
        b2PolygonShape shape;
        shape.Set(points.data(), static_cast<int>(polygon.points_m.size()));
        return shape;
    }
    static b2EdgeShape made(const physics::Segment& segment) {
        b2EdgeShape shape;
        shape.SetTwoSided(vec(segment.a_m), vec(segment.b_m));
        return shape;
    }
    // Box2D 2.4 has no capsule; scenes with one do not ask for every engine. This is the box around its
    // middle.
    static b2PolygonShape made(const Capsule& capsule) {
        const Vec2 along = capsule.b_m - capsule.a_m;
        b2PolygonShape shape;
        shape.SetAsBox(0.5f * length(along), capsule.radius_m, vec(0.5f * (capsule.a_m + capsule.b_m)),
                       static_cast<float>(physics::deterministic::atan2(static_cast<double>(along.y),
                                                                        static_cast<double>(along.x))));
        return shape;
    }

    b2World world_;
    int iterations_;
};

}  // namespace

std::unique_ptr<Engine> make_box2d(const WorldSetting& setting) {
    return std::make_unique<Box2dEngine>(setting);
}

}  // namespace cairn::measure
