// Fuzz target: any sequence of calls leaves a world whose numbers are finite and whose counts are right, that
// knows which handles are good, and that does the same again when it gets the same calls.
#include <algorithm>
#include <cmath>
#include <vector>

#include <cairn/physics/world.h>

#include "fuzz/input.h"

using namespace cairn::physics;
using fuzz::Input;
using fuzz::require;

namespace {

constexpr std::size_t kMostBodies = 40;
constexpr int kMostCalls = 400;

/// An object that was made, and whether it should still be there.
struct Made {
    std::uint64_t bits;
    bool alive = true;
};

class Session {
  public:
    explicit Session(Input in) : in_(in) {
        foreign_ = other_.create_body({}).value();
        foreign_shape_ = other_.create_shape(foreign_, Circle{}).value();
    }

    std::uint64_t run() {
        for (int calls = 0; calls < kMostCalls && !in_.is_empty(); ++calls) call();
        step();
        return world_.state_hash();
    }

  private:
    void call() {
        switch (in_.below(20)) {
            case 0:
            case 1:
                return make_body();
            case 2:
            case 3:
                return make_shape();
            case 4:
                return make_joint();
            case 5:
                return destroy();
            case 6:
                return push();
            case 7:
                return place();
            case 8:
                return change_shape();
            case 9:
                return change_body();
            case 10:
                return change_joint();
            case 11:
                return change_world();
            case 12:
                return ask();
            default:
                return step();
        }
    }

    // A handle: mostly one that was given out, gone or not; at times any bits.
    template <class Id>
    Id any_of(const std::vector<Made>& made) {
        const int choice = in_.below(16);
        if (choice == 15) return Id::from_bits(in_.bits());
        if (choice == 14 || made.empty()) return Id{};
        return Id::from_bits(made[static_cast<std::size_t>(in_.byte()) % made.size()].bits);
    }
    BodyId any_body() { return in_.below(32) == 31 ? foreign_ : any_of<BodyId>(bodies_); }
    ShapeId any_shape() { return in_.below(32) == 31 ? foreign_shape_ : any_of<ShapeId>(shapes_); }
    JointId any_joint() { return any_of<JointId>(joints_); }

    static bool is_there(const std::vector<Made>& made, std::uint64_t bits) {
        return std::any_of(made.begin(), made.end(),
                           [&](const Made& m) { return m.alive && m.bits == bits; });
    }
    bool is_there(BodyId id) const { return is_there(bodies_, id.bits()); }
    bool is_there(ShapeId id) const { return is_there(shapes_, id.bits()); }
    bool is_there(JointId id) const { return is_there(joints_, id.bits()); }

    static void gone(std::vector<Made>& made, std::uint64_t bits) {
        for (Made& m : made) {
            if (m.bits == bits) m.alive = false;
        }
    }

    void make_body() {
        if (world_.bodies().size() >= kMostBodies) return;
        BodyDef def;
        def.type = static_cast<BodyType>(in_.below(3));
        def.position_m = {static_cast<double>(in_.hostile(-10, 10)),
                          static_cast<double>(in_.hostile(-10, 10))};
        def.angle_rad = static_cast<double>(in_.hostile(-4, 4));
        def.linear_velocity_m_s = in_.hostile_vector(-20, 20);
        def.angular_velocity_rad_s = in_.hostile(-20, 20);
        def.linear_damping_1_s = in_.hostile(0, 1);
        def.gravity_scale = in_.hostile(-1, 2);
        def.awake = in_.flag();
        const Result<BodyId> id = world_.create_body(def);
        require(!id || is_finite(def.position_m), "bodies at places that are not finite are refused");
        if (id) bodies_.push_back({id->bits()});
    }

    void make_shape() {
        const BodyId body = any_body();
        fuzz::Description shape;
        fuzz::describe_hostile(shape, in_);
        ShapeDef def;
        def.density_kg_m2 = in_.hostile(0, 10);
        def.material.friction = in_.hostile(0, 1);
        def.material.restitution = in_.hostile(0, 1);
        def.material.rolling_resistance = in_.flag() ? in_.hostile(0, 1) : 0;
        def.material.surface_speed_m_s = in_.flag() ? in_.hostile(-5, 5) : 0;
        def.contact_events = in_.flag();
        def.hit_events = in_.flag();
        def.sensor = in_.below(8) == 7;
        if (in_.below(8) == 7) def.one_way_normal = in_.hostile_vector(-1, 1);
        const Result<ShapeId> id = world_.create_shape(body, shape.geometry, def);
        require(!id || is_there(body), "a shape needs a body that is there");
        if (id) shapes_.push_back({id->bits()});
    }

    void make_joint() {
        const BodyId a = any_body();
        const BodyId b = any_body();
        const Vec2 anchor_a = in_.hostile_vector(-1, 1);
        const Vec2 anchor_b = in_.hostile_vector(-1, 1);
        Result<JointId> id = Error{};
        if (in_.flag()) {
            id = world_.create_joint(RevoluteJointDef{.body_a = a,
                                                      .body_b = b,
                                                      .local_anchor_a_m = anchor_a,
                                                      .local_anchor_b_m = anchor_b,
                                                      .enable_limit = in_.flag(),
                                                      .lower_rad = in_.hostile(-3, 0),
                                                      .upper_rad = in_.hostile(0, 3),
                                                      .enable_motor = in_.flag(),
                                                      .motor_speed_rad_s = in_.hostile(-10, 10),
                                                      .max_motor_torque_nm = in_.hostile(0, 100)});
        } else {
            id = world_.create_joint(DistanceJointDef{.body_a = a,
                                                      .body_b = b,
                                                      .local_anchor_a_m = anchor_a,
                                                      .local_anchor_b_m = anchor_b,
                                                      .length_m = in_.hostile(0.1f, 4),
                                                      .enable_spring = in_.flag(),
                                                      .frequency_hz = in_.hostile(0.1f, 20),
                                                      .damping_ratio = in_.hostile(0, 1),
                                                      .max_length_m = in_.hostile(4, 8)});
        }
        require(!id || (is_there(a) && is_there(b) && a != b), "a joint needs two bodies that are there");
        if (id) joints_.push_back({id->bits()});
    }

    void destroy() {
        switch (in_.below(3)) {
            case 0: {
                const BodyId id = any_body();
                std::vector<ShapeId> shapes;
                std::vector<JointId> joints;
                if (const Result<Body> body = world_.body(id)) {
                    shapes = body->shapes();
                    joints = body->joints();
                }
                require(static_cast<bool>(world_.destroy_body(id)) == is_there(id),
                        "a body can be destroyed once");
                gone(bodies_, id.bits());
                for (const ShapeId shape : shapes) gone(shapes_, shape.bits());
                for (const JointId joint : joints) gone(joints_, joint.bits());
                return;
            }
            case 1: {
                const ShapeId id = any_shape();
                require(static_cast<bool>(world_.destroy_shape(id)) == is_there(id),
                        "a shape can be destroyed once");
                return gone(shapes_, id.bits());
            }
            default: {
                const JointId id = any_joint();
                require(static_cast<bool>(world_.destroy_joint(id)) == is_there(id),
                        "a joint can be destroyed once");
                return gone(joints_, id.bits());
            }
        }
    }

    // A body to work on, if the handle drawn is good. Errors must tell good handles from bad ones.
    std::optional<Body> body() {
        const BodyId id = any_body();
        Result<Body> found = world_.body(id);
        require(static_cast<bool>(found) == is_there(id), "a good handle finds its body, a bad one nothing");
        return found ? std::optional(*found) : std::nullopt;
    }

    void push() {
        auto b = body();
        if (!b) return;
        const Vec2 v = in_.hostile_vector(-100, 100);
        const Position at = b->world_center() + in_.vector(-1, 1);
        Result<void> done;
        switch (in_.below(6)) {
            case 0:
                done = b->apply_force(v, at);
                break;
            case 1:
                done = b->apply_impulse(v, at);
                break;
            case 2:
                done = b->set_linear_velocity(v);
                break;
            case 3:
                done = b->set_angular_velocity(v.x);
                break;
            case 4:
                done = b->apply_torque(v.x);
                break;
            default:
                done = b->apply_angular_impulse(v.x);
                break;
        }
        require(!done || is_finite(v.x), "numbers that are not finite are refused");
    }

    void place() {
        auto b = body();
        if (!b) return;
        const Vec2 at = in_.hostile_vector(-10, 10);
        const auto x = static_cast<double>(at.x);
        const auto y = static_cast<double>(at.y);
        const Result<void> done = b->set_transform({x, y}, static_cast<double>(in_.hostile(-4, 4)));
        require(!done || is_finite(at), "places that are not finite are refused");
    }

    void change_shape() {
        const ShapeId id = any_shape();
        Result<Shape> shape = world_.shape(id);
        require(static_cast<bool>(shape) == is_there(id), "a good handle finds its shape, a bad one nothing");
        if (!shape) return;
        switch (in_.below(4)) {
            case 0:
                static_cast<void>(
                    shape->set_material({.friction = in_.hostile(0, 2), .restitution = in_.hostile(0, 1)}));
                return;
            case 1:
                static_cast<void>(shape->set_one_way_normal(in_.hostile_vector(-1, 1)));
                return;
            case 2:
                shape->set_seen_by_sensors(in_.flag());
                return;
            default:
                shape->set_filter({.categories = std::uint64_t{1} << in_.below(4),
                                   .mask = in_.byte() | std::uint64_t{1},
                                   .group = in_.below(3) - 1});
        }
    }

    void change_body() {
        auto b = body();
        if (!b) return;
        switch (in_.below(5)) {
            case 0:
                return b->set_awake(in_.flag());
            case 1:
                return b->set_allow_sleep(in_.flag());
            case 2:
                static_cast<void>(b->set_gravity_scale(in_.hostile(-1, 2)));
                return;
            case 3:
                static_cast<void>(b->set_linear_damping(in_.hostile(0, 2)));
                return;
            default:
                static_cast<void>(b->set_angular_damping(in_.hostile(0, 2)));
        }
    }

    void change_joint() {
        const JointId id = any_joint();
        Result<Joint> joint = world_.joint(id);
        require(static_cast<bool>(joint) == is_there(id), "a good handle finds its joint, a bad one nothing");
        if (!joint) return;
        const float a = in_.hostile(-3, 3);
        const float b = in_.hostile(0, 10);
        switch (in_.below(4)) {
            case 0:
                static_cast<void>(joint->set_motor(in_.flag(), a, b));
                return;
            case 1:
                static_cast<void>(joint->set_limits(in_.flag(), a, b));
                return;
            case 2:
                static_cast<void>(joint->set_length(b));
                return;
            default:
                static_cast<void>(joint->set_spring(in_.flag(), b, a));
        }
    }

    void change_world() {
        if (in_.flag()) {
            static_cast<void>(world_.set_gravity(in_.hostile_vector(-10, 10)));
        } else {
            static_cast<void>(world_.set_material_rule(in_.below(70) - 2, in_.below(70) - 2, {}));
        }
    }

    void ask() {
        const Vec2 at = in_.hostile_vector(-10, 10);
        const Position from{static_cast<double>(at.x), static_cast<double>(at.y)};
        const Vec2 way = in_.hostile_vector(-20, 20);
        const Result<std::optional<RayHit>> ray = world_.cast_ray(from, way);
        require(!ray || (is_finite(at) && is_finite(way)), "rays that are not finite are refused");
        if (ray && *ray) {
            require(is_there((*ray)->shape) && is_there((*ray)->body), "a ray hits what is there");
            require((*ray)->fraction >= 0 && (*ray)->fraction <= 1, "a ray is hit between its ends");
        }
        const Result<std::vector<RayHit>> all = world_.cast_ray_all(from, way);
        require(static_cast<bool>(all) == static_cast<bool>(ray), "both casts refuse the same rays");
        if (all) require(all->empty() == !ray->has_value(), "there is a first hit when there is any");
        fuzz::Description shape;
        fuzz::describe_hostile(shape, in_);
        const Transform pose{from, Rotation::from_angle(static_cast<double>(in_.real(-4, 4)))};
        if (const auto hit = world_.cast_shape(shape.geometry, pose, way); hit && *hit) {
            require(is_there((*hit)->shape), "a moving shape meets what is there");
        }
        if (const auto overlapping = world_.shapes_overlapping(shape.geometry, pose)) {
            for (const ShapeId id : *overlapping) require(is_there(id), "what overlaps is there");
        }
        if (const auto near = world_.closest_point(from, in_.hostile(0, 10)); near && *near) {
            require(is_there((*near)->shape), "the nearest shape is there");
        }
    }

    void step() {
        const float dt_s = in_.below(8) == 7 ? in_.hostile(0, 0.1f) : 1.0f / 60;
        const Result<void> done = world_.step(dt_s);
        require(static_cast<bool>(done) == (dt_s > 0 && dt_s <= 1),
                "a step takes more than 0 and at most 1 s");
        check();
    }

    void check() {
        int shapes = 0;
        int awake = 0;
        for (const BodyId id : world_.bodies()) {
            require(is_there(id), "the bodies listed are those that were made and not destroyed");
            const Body body = *world_.body(id);
            require(is_finite(body.position()), "positions are finite");
            require(is_finite(body.linear_velocity()), "velocities are finite");
            require(std::isfinite(body.angular_velocity()), "spins are finite");
            const Rotation q = body.transform().q;
            require(std::abs(q.c * q.c + q.s * q.s - 1) < 1e-3f, "rotations have length 1");
            shapes += static_cast<int>(body.shapes().size());
            awake += body.is_awake() ? 1 : 0;
        }
        const auto alive = [](const std::vector<Made>& made) {
            return static_cast<int>(
                std::count_if(made.begin(), made.end(), [](const Made& m) { return m.alive; }));
        };
        const Counts counts = world_.counts();
        require(counts.bodies == alive(bodies_), "all bodies are counted");
        require(counts.shapes == alive(shapes_) && counts.shapes == shapes, "all shapes are counted");
        require(counts.joints == alive(joints_), "all joints are counted");
        require(counts.awake_bodies == awake, "all awake bodies are counted");
        require(counts.touching <= counts.contacts, "what touches is near");
        for (const ContactBegin& begin : world_.contact_begins()) {
            require(is_there(begin.shape_a) && is_there(begin.shape_b), "what begins to touch is there");
        }
        for (const BodyId id : world_.quarantined()) require(is_there(id), "what was halted is there");
    }

    Input in_;
    World world_;
    World other_;
    BodyId foreign_;
    ShapeId foreign_shape_;
    std::vector<Made> bodies_;
    std::vector<Made> shapes_;
    std::vector<Made> joints_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input in(data, size);
    const bool twice = in.below(4) == 0;
    const std::uint64_t hash = Session(in).run();
    if (twice) require(Session(in).run() == hash, "the same calls give the same bits");
    return 0;
}
