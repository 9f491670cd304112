// Making and destroying bodies, shapes, chains and joints, one by one and many at once; dividing bodies.
#include <cmath>

#include "fuzz/world/session.h"

namespace cairn::physics::fuzz {
namespace {

constexpr std::size_t kMostBodies = 120;
constexpr int kMostAtOnce = 24;

}  // namespace

BodyDef Session::body_def() {
    BodyDef def;
    def.type = static_cast<BodyType>(in_.below(3));
    def.position_m = {static_cast<double>(in_.hostile(-10, 10)), static_cast<double>(in_.hostile(-10, 10))};
    def.angle_rad = static_cast<double>(in_.hostile(-4, 4));
    def.linear_velocity_m_s = in_.hostile_vector(-20, 20);
    def.angular_velocity_rad_s = in_.hostile(-20, 20);
    def.linear_damping_1_s = in_.hostile(0, 1);
    def.gravity_scale = in_.hostile(-1, 2);
    const int bits = in_.byte();
    def.awake = (bits & 1) == 0;
    if ((bits & 2) != 0) def.locks = {(bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
    if ((bits & 32) != 0) def.sleep_speed_m_s = in_.hostile(0, 1);
    return def;
}

Material Session::material() {
    Material material;
    material.friction = in_.hostile(0, 1);
    material.restitution = in_.hostile(0, 1);
    const int bits = in_.byte();
    if ((bits & 1) != 0) material.rolling_resistance = in_.hostile(0, 1);
    if ((bits & 2) != 0) material.surface_speed_m_s = in_.hostile(-5, 5);
    if ((bits & 4) != 0) material.kind = in_.below(70) - 2;
    return material;
}

void Session::make_body() {
    if (world_.bodies().size() >= kMostBodies) return;
    const BodyDef def = body_def();
    const Result<BodyId> id = world_.create_body(def);
    require(!id || is_finite(def.position_m), "bodies at places that are not finite are refused");
    if (id) bodies_.add(*id);
}

// In rows, all alike, with a disc or a box each.
void Session::make_bodies() {
    if (world_.bodies().size() >= kMostBodies) return;
    BodyDef def = body_def();
    const Position first = def.position_m;
    std::vector<BodyDef> defs;
    const int count = in_.below(kMostAtOnce);
    for (int i = 0; i < count; ++i) {
        def.position_m = {first.x + 0.9 * (i % 6), first.y + 0.9 * (i / 6)};
        defs.push_back(def);
    }
    const int bad = in_.below(64);
    if (bad < count) defs[static_cast<std::size_t>(bad)].angle_rad = std::nan("");
    std::vector<BodyId> ids(defs.size());
    const int before = world_.counts().bodies;
    const Result<void> made = world_.create_bodies(defs, ids);
    require(world_.counts().bodies == before + (made ? count : 0), "all of many bodies are made, or none");
    require(!made || bad >= count, "many bodies of which one is bad are refused");
    if (!made) return;
    const bool round = in_.flag();
    for (const BodyId id : ids) {
        bodies_.add(id);
        const Geometry geometry = round ? Geometry{Circle{}} : Geometry{Box{}};
        shapes_.add(world_.create_shape(id, geometry).value());
    }
}

void Session::make_shape() {
    const BodyId body = any_body();
    Description shape;
    describe_hostile(shape, in_);
    ShapeDef def;
    def.density_kg_m2 = in_.hostile(0, 10);
    def.material = material();
    def.contact_events = in_.flag();
    def.hit_events = in_.flag();
    def.sensor = in_.below(8) == 7;
    if (in_.below(8) == 7) def.one_way_normal = in_.hostile_vector(-1, 1);
    const Result<ShapeId> id = world_.create_shape(body, shape.geometry, def);
    require(!id || bodies_.is_there(body), "a shape needs a body that is there");
    if (id) shapes_.add(*id);
}

void Session::make_chain() {
    const BodyId body = any_body();
    std::array<Vec2, 12> points;
    const int count = in_.below(static_cast<int>(points.size()) + 1);
    const bool steady = in_.flag();  // a ground from right to left; else points anywhere
    for (int i = 0; i < count; ++i) {
        points[static_cast<std::size_t>(i)] =
            steady ? Vec2{static_cast<float>(6 - i), in_.real(-1, 1)} : in_.hostile_vector(-4, 4);
    }
    std::array<Material, 2> materials{material(), material()};
    ChainDef def;
    def.points_m = std::span(points).first(static_cast<std::size_t>(count));
    def.closed = in_.below(4) == 0;
    if (in_.below(4) == 0) def.before_m = in_.hostile_vector(-8, 8);
    if (in_.below(4) == 0) def.after_m = in_.hostile_vector(-8, 8);
    def.materials = std::span(materials).first(static_cast<std::size_t>(in_.below(3)));
    def.contact_events = in_.flag();
    const Result<ChainId> id = world_.create_chain(body, def);
    require(!id || bodies_.is_there(body), "a chain needs a body that is there");
    if (!id) return;
    chains_.add(*id);
    chain_parts_.push_back({*id, body, {}});
    note_segments(*id);
    const int segments = count - (def.closed ? 0 : 1);
    require(static_cast<int>(chain_parts_.back().segments.size()) == segments,
            "a chain has a segment between any two points");
}

// Brings the books up to the segments that a chain has now.
void Session::note_segments(ChainId id) {
    const auto parts = std::find_if(chain_parts_.begin(), chain_parts_.end(),
                                    [&](const ChainParts& p) { return p.chain == id; });
    std::vector<ShapeId> now;
    const Chain chain = *world_.chain(id);
    for (int i = 0; i < chain.segment_count(); ++i) now.push_back(chain.segment(i).value());
    const auto has = [](const std::vector<ShapeId>& list, ShapeId shape) {
        return std::find(list.begin(), list.end(), shape) != list.end();
    };
    for (const ShapeId old : parts->segments) {
        if (!has(now, old)) shapes_.gone(old);
    }
    for (const ShapeId shape : now) {
        if (has(parts->segments, shape)) continue;
        shapes_.add(shape);
        segments_.insert(shape.bits());
    }
    parts->segments = now;
}

void Session::make_joint() {
    // Draws whatever numbers this kind has.
    const auto drawn = [&](auto def) {
        if constexpr (requires { def.body_a; }) {
            def.body_a = any_body();
            def.body_b = any_body();
        }
        if constexpr (requires { def.joint_1; }) {
            def.joint_1 = joints_.any(in_);
            def.joint_2 = joints_.any(in_);
        }
        if constexpr (requires { def.local_anchor_a_m; }) def.local_anchor_a_m = in_.hostile_vector(-1, 1);
        if constexpr (requires { def.local_anchor_b_m; }) def.local_anchor_b_m = in_.hostile_vector(-1, 1);
        if constexpr (requires { def.local_angle_a_rad; }) def.local_angle_a_rad = in_.hostile(-4, 4);
        if constexpr (requires { def.local_target_m; }) def.local_target_m = in_.hostile_vector(-4, 4);
        if constexpr (requires { def.length_m; }) def.length_m = in_.hostile(0, 4);
        if constexpr (requires { def.max_length_m; }) def.max_length_m = in_.hostile(4, 8);
        if constexpr (requires { def.wheel_a_m; }) def.wheel_a_m = {in_.real(-9, 0), in_.real(0, 9)};
        if constexpr (requires { def.wheel_b_m; }) def.wheel_b_m = {in_.real(0, 9), in_.real(0, 9)};
        if constexpr (requires { def.ratio; }) def.ratio = in_.hostile(-2, 2);
        if constexpr (requires { def.enable_spring; }) def.enable_spring = in_.flag();
        if constexpr (requires { def.frequency_hz; }) {
            def.frequency_hz = in_.hostile(0.1f, 20);
            def.damping_ratio = in_.hostile(0, 1);
        }
        if constexpr (requires { def.linear_frequency_hz; }) {
            def.linear_frequency_hz = in_.flag() ? in_.hostile(0, 20) : 0;
            def.angular_frequency_hz = in_.flag() ? in_.hostile(0, 20) : 0;
        }
        if constexpr (requires { def.enable_limit; }) def.enable_limit = in_.flag();
        if constexpr (requires { def.lower_rad; }) {
            def.lower_rad = in_.hostile(-3, 0);
            def.upper_rad = in_.hostile(0, 3);
        }
        if constexpr (requires { def.lower_m; }) {
            def.lower_m = in_.hostile(-2, 0);
            def.upper_m = in_.hostile(0, 2);
        }
        if constexpr (requires { def.enable_motor; }) def.enable_motor = in_.flag();
        if constexpr (requires { def.motor_speed_rad_s; }) def.motor_speed_rad_s = in_.hostile(-10, 10);
        if constexpr (requires { def.motor_speed_m_s; }) def.motor_speed_m_s = in_.hostile(-10, 10);
        if constexpr (requires { def.max_motor_torque_nm; }) def.max_motor_torque_nm = in_.hostile(0, 100);
        if constexpr (requires { def.max_motor_force_n; }) def.max_motor_force_n = in_.hostile(0, 100);
        if constexpr (requires { def.max_force_n; }) def.max_force_n = in_.hostile(0, 500);
        if constexpr (requires { def.max_torque_nm; }) def.max_torque_nm = in_.hostile(0, 100);
        if constexpr (requires { def.strength; }) {
            if (in_.below(4) == 0) def.strength.break_force_n = in_.hostile(0, 500);
        }
        if constexpr (requires { def.collide_connected; }) def.collide_connected = in_.flag();
        return def;
    };
    const auto make = [&](auto def) {
        const Result<JointId> id = world_.create_joint(def);
        if constexpr (requires { def.body_a; }) {
            require(!id || (bodies_.is_there(def.body_a) && bodies_.is_there(def.body_b) &&
                            def.body_a != def.body_b),
                    "a joint needs two bodies that are there");
        } else {
            require(!id || (joints_.is_there(def.joint_1) && joints_.is_there(def.joint_2)),
                    "a gear needs two joints that are there");
            if (id) gears_.push_back({*id, def.joint_1, def.joint_2});
        }
        if (id) joints_.add(*id);
    };
    switch (static_cast<JointKind>(in_.below(11))) {
        case JointKind::Distance:
            return make(drawn(DistanceJointDef{}));
        case JointKind::Revolute:
            return make(drawn(RevoluteJointDef{}));
        case JointKind::Prismatic:
            return make(drawn(PrismaticJointDef{}));
        case JointKind::Weld:
            return make(drawn(WeldJointDef{}));
        case JointKind::Wheel:
            return make(drawn(WheelJointDef{}));
        case JointKind::Motor:
            return make(drawn(MotorJointDef{}));
        case JointKind::Mouse:
            return make(drawn(MouseJointDef{}));
        case JointKind::Gear:
            return make(drawn(GearJointDef{}));
        case JointKind::Pulley:
            return make(drawn(PulleyJointDef{}));
        case JointKind::Friction:
            return make(drawn(FrictionJointDef{}));
        case JointKind::Filter:
            return make(drawn(FilterJointDef{}));
    }
}

void Session::divide_body() {
    if (world_.bodies().size() >= kMostBodies) return;
    const BodyId id = any_body();
    std::vector<ShapeId> shapes;
    if (const Result<Body> body = world_.body(id)) shapes = body->shapes();
    const Vec2 a = in_.hostile_vector(-10, 10);
    const Vec2 b = in_.hostile_vector(-10, 10);
    const Position from{static_cast<double>(a.x), static_cast<double>(a.y)};
    const Position to{static_cast<double>(b.x), static_cast<double>(b.y)};
    Result<std::vector<BodyId>> pieces = std::vector<BodyId>{};
    if (in_.flag()) {
        pieces = world_.cut_body(id, from, to);
    } else {
        FractureDef def;
        def.pieces = in_.below(8);
        def.seed = in_.byte();
        def.pattern = in_.flag() ? FracturePattern::Radial : FracturePattern::Uniform;
        def.radius_m = in_.hostile(0.5f, 4);
        pieces = world_.break_body(id, from, def);
    }
    require(!pieces || bodies_.is_there(id), "only a body that is there is divided");
    if (!pieces || pieces->empty()) return;
    require(pieces->size() >= 2, "what is divided is two pieces at least");
    bodies_.gone(id);
    for (const ShapeId shape : shapes) shapes_.gone(shape);
    for (const BodyId piece : *pieces) {
        bodies_.add(piece);
        for (const ShapeId shape : world_.body(piece)->shapes()) shapes_.add(shape);
    }
}

void Session::destroy() {
    switch (in_.below(5)) {
        case 0:
            return destroy_body();
        case 1:
            return destroy_bodies();
        case 2:
            return destroy_shape();
        case 3:
            return destroy_chain();
        default:
            return destroy_joint();
    }
}

void Session::destroy_body() {
    const BodyId id = any_body();
    const bool was_there = bodies_.is_there(id);
    if (was_there) body_is_gone(id);
    require(static_cast<bool>(world_.destroy_body(id)) == was_there, "a body can be destroyed once");
}

void Session::destroy_bodies() {
    std::vector<BodyId> ids;
    for (int i = in_.below(kMostAtOnce); i > 0; --i) ids.push_back(any_body());
    if (in_.flag()) {  // as they are mostly meant: good ones, each once
        std::vector<BodyId> good;
        for (const BodyId id : ids) {
            if (bodies_.is_there(id) && std::find(good.begin(), good.end(), id) == good.end()) {
                good.push_back(id);
            }
        }
        ids = good;
    }
    bool all_good = true;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto here = ids.begin() + static_cast<std::ptrdiff_t>(i);
        all_good = all_good && bodies_.is_there(ids[i]) && std::find(ids.begin(), here, ids[i]) == here;
    }
    if (all_good) {
        for (const BodyId id : ids) body_is_gone(id);
    }
    require(static_cast<bool>(world_.destroy_bodies(ids)) == all_good,
            "many bodies are destroyed at once that are there, each once");
}

void Session::destroy_shape() {
    const ShapeId id = any_shape();
    const bool may_go = shapes_.is_there(id) && !segments_.contains(id.bits());
    require(static_cast<bool>(world_.destroy_shape(id)) == may_go,
            "a shape can be destroyed once, unless it belongs to a chain");
    if (may_go) shapes_.gone(id);
}

void Session::destroy_chain() {
    const ChainId id = chains_.any(in_);
    require(static_cast<bool>(world_.destroy_chain(id)) == chains_.is_there(id),
            "a chain can be destroyed once");
    chains_.gone(id);
    for (const ChainParts& parts : chain_parts_) {
        if (parts.chain != id) continue;
        for (const ShapeId segment : parts.segments) shapes_.gone(segment);
    }
}

void Session::destroy_joint() {
    const JointId id = joints_.any(in_);
    require(static_cast<bool>(world_.destroy_joint(id)) == joints_.is_there(id),
            "a joint can be destroyed once");
    joint_is_gone(id);
}

// Before it is: with all that goes with it.
void Session::body_is_gone(BodyId id) {
    const Body body = *world_.body(id);
    for (const ShapeId shape : body.shapes()) shapes_.gone(shape);
    for (const JointId joint : body.joints()) joint_is_gone(joint);
    for (const ChainParts& parts : chain_parts_) {
        if (parts.body == id) chains_.gone(parts.chain);
    }
    bodies_.gone(id);
}

void Session::joint_is_gone(JointId id) {
    joints_.gone(id);
    for (const GearParts& gear : gears_) {
        const bool loses_one = gear.joint_1 == id || gear.joint_2 == id;
        if (loses_one && joints_.is_there(gear.gear)) joint_is_gone(gear.gear);
    }
}

}  // namespace cairn::physics::fuzz
