// The order of a session, and what must hold after each step of it.
#include "fuzz/world/session.h"

#include <cmath>

namespace cairn::physics::fuzz {
namespace {

constexpr int kMostCalls = 400;

WorldDef with_threads(int threads) {
    WorldDef def;
    def.threads = threads;
    return def;
}

std::uint64_t bits_of(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

}  // namespace

Session::Session(Input in, int threads) : in_(in), world_(with_threads(threads)) {
    foreign_ = other_.create_body({}).value();
    foreign_shape_ = other_.create_shape(foreign_, Circle{}).value();
}

std::uint64_t Session::run() {
    for (int calls = 0; calls < kMostCalls && !in_.is_empty(); ++calls) call();
    step();
    const Position p = mover_ ? mover_->position() : Position{};
    return world_.state_hash() ^ bits_of(p.x) ^ (bits_of(p.y) << 1);
}

void Session::call() {
    switch (in_.below(28)) {
        case 0:
            return make_body();
        case 1:
            return make_bodies();
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
        case 13:
            return make_chain();
        case 14:
            return change_chain();
        case 15:
            return blow();
        case 16:
            return walk();
        case 17:
            return divide_body();
        default:
            return step();
    }
}

// A body to work on, if the handle drawn is good. Errors must tell good handles from bad ones.
std::optional<Body> Session::body() {
    const BodyId id = any_body();
    Result<Body> found = world_.body(id);
    require(static_cast<bool>(found) == bodies_.is_there(id),
            "a good handle finds its body, a bad one nothing");
    return found ? std::optional(*found) : std::nullopt;
}

void Session::step() {
    const float dt_s = in_.below(8) == 7 ? in_.hostile(0, 0.1f) : 1.0f / 60;
    const Result<void> done = world_.step(dt_s);
    require(static_cast<bool>(done) == (dt_s > 0 && dt_s <= 1), "a step takes more than 0 and at most 1 s");
    if (!done) return;
    check_joint_breaks();
    check_bodies();
    check_counts();
    check_contact_events();
    check_sensors();
}

void Session::check_bodies() {
    int shapes = 0;
    int awake = 0;
    for (const BodyId id : world_.bodies()) {
        require(bodies_.is_there(id), "the bodies listed are those that were made and not destroyed");
        const Body body = *world_.body(id);
        const Vec2 v = body.linear_velocity();
        require(is_finite(body.position()), "positions are finite");
        require(is_finite(v), "velocities are finite");
        require(std::isfinite(body.angular_velocity()), "spins are finite");
        const Rotation q = body.transform().q;
        require(std::abs(q.c * q.c + q.s * q.s - 1) < 1e-3f, "rotations have length 1");
        if (body.type() == BodyType::Dynamic) {
            const AxisLocks locks = body.locks();
            require(!locks.x || v.x == 0, "nothing moves along a locked x");
            require(!locks.y || v.y == 0, "nothing moves along a locked y");
            require(!locks.rotation || body.angular_velocity() == 0,
                    "nothing turns whose rotation is locked");
        }
        for (const ShapeId shape : body.shapes()) {
            require(shapes_.is_there(shape), "the shapes listed are those that were made and not destroyed");
            ++shapes;
        }
        for (const JointId joint : body.joints()) {
            require(joints_.is_there(joint), "the joints listed are those that were made and not destroyed");
        }
        awake += body.is_awake() ? 1 : 0;
    }
    const Counts counts = world_.counts();
    require(counts.shapes == shapes, "each shape is in the list of its body");
    require(counts.awake_bodies == awake, "all awake bodies are counted");
    for (const BodyId id : world_.quarantined()) {
        require(bodies_.is_there(id), "what was halted is there");
        const Body body = *world_.body(id);
        require(body.linear_velocity() == Vec2{} && body.angular_velocity() == 0, "what was halted stands");
    }
}

void Session::check_counts() {
    const Counts counts = world_.counts();
    require(counts.bodies == bodies_.alive(), "all bodies are counted");
    require(counts.shapes == shapes_.alive(), "all shapes are counted");
    require(counts.joints == joints_.alive(), "all joints are counted");
    require(counts.touching <= counts.contacts, "what touches is near");
    require(counts.awake_bodies == world_.awake_body_count(), "both ways to count give the same");
}

void Session::check_contact_events() {
    const auto pair_of = [](const auto& event) {
        return ShapePair{std::min(event.shape_a.bits(), event.shape_b.bits()),
                         std::max(event.shape_a.bits(), event.shape_b.bits())};
    };
    for (const ContactEnd& end : world_.contact_ends()) {
        require(touching_.erase(pair_of(end)) == 1, "what ceases to touch has touched");
    }
    for (const ContactBegin& begin : world_.contact_begins()) {
        require(shapes_.is_there(begin.shape_a) && shapes_.is_there(begin.shape_b),
                "what begins to touch is there");
        require(is_finite(begin.point_m), "what begins to touch does so somewhere");
        require(std::abs(length(begin.normal) - 1) < 1e-3f, "the normal of a touch has length 1");
        require(touching_.insert(pair_of(begin)).second, "what begins to touch did not touch before");
    }
    for (const ShapePair& pair : touching_) {
        require(shapes_.is_there(ShapeId::from_bits(pair.first)) &&
                    shapes_.is_there(ShapeId::from_bits(pair.second)),
                "an end is told of all touching whose shapes are gone");
    }
    require(static_cast<int>(touching_.size()) <= world_.counts().touching, "what was told to touch does");
    for (const ContactHit& hit : world_.contact_hits()) {
        require(std::isfinite(hit.approach_speed_m_s) && std::isfinite(hit.impulse_ns), "hits are finite");
    }
}

void Session::check_sensors() {
    const auto pair_of = [](const auto& event) {
        return ShapePair{event.sensor.bits(), event.visitor.bits()};
    };
    for (const SensorEnd& end : world_.sensor_ends()) {
        require(seen_.erase(pair_of(end)) == 1, "what a sensor ceases to see it has seen");
    }
    for (const SensorBegin& begin : world_.sensor_begins()) {
        require(seen_.insert(pair_of(begin)).second, "what a sensor begins to see it did not see before");
    }
    std::set<ShapePair> listed;
    for (const BodyId id : world_.bodies()) {
        for (const ShapeId shape : world_.body(id)->shapes()) {
            if (!world_.shape(shape)->is_sensor()) continue;
            const auto overlaps = world_.sensor_overlaps(shape);
            require(static_cast<bool>(overlaps), "a sensor tells what it sees");
            for (const ShapeId visitor : *overlaps) {
                require(shapes_.is_there(visitor), "what a sensor sees after a step is there");
                listed.insert({shape.bits(), visitor.bits()});
            }
        }
    }
    require(listed == seen_, "sensors see what their events told");
}

void Session::check_joint_breaks() {
    for (const JointBreak& event : world_.joint_breaks()) {
        require(joints_.is_there(event.joint), "a joint breaks that was there");
        require(!world_.contains(event.joint), "a joint that broke is gone");
        joint_is_gone(event.joint);
    }
}

}  // namespace cairn::physics::fuzz
