// Changing what is there: motion, shapes, chains, joints and rules; explosions and wind.
#include "fuzz/world/session.h"

namespace cairn::physics::fuzz {

void Session::push() {
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

void Session::place() {
    auto b = body();
    if (!b) return;
    const Vec2 at = in_.hostile_vector(-10, 10);
    const auto x = static_cast<double>(at.x);
    const auto y = static_cast<double>(at.y);
    const Result<void> done = b->set_transform({x, y}, static_cast<double>(in_.hostile(-4, 4)));
    require(!done || is_finite(at), "places that are not finite are refused");
}

void Session::change_shape() {
    const ShapeId id = any_shape();
    Result<Shape> shape = world_.shape(id);
    require(static_cast<bool>(shape) == shapes_.is_there(id),
            "a good handle finds its shape, a bad one nothing");
    if (!shape) return;
    switch (in_.below(4)) {
        case 0:
            static_cast<void>(shape->set_material(material()));
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

void Session::change_body() {
    auto b = body();
    if (!b) return;
    switch (in_.below(7)) {
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
        case 4:
            static_cast<void>(b->set_sleep_speed(in_.hostile(0, 2)));
            return;
        case 5:
            return b->set_locks({in_.flag(), in_.flag(), in_.flag()});
        default:
            static_cast<void>(b->set_angular_damping(in_.hostile(0, 2)));
    }
}

void Session::change_chain() {
    const ChainId id = chains_.any(in_);
    Result<Chain> found = world_.chain(id);
    require(static_cast<bool>(found) == chains_.is_there(id),
            "a good handle finds its chain, a bad one nothing");
    if (!found) return;
    Chain chain = *found;
    const auto count = static_cast<int>(chain.points().size());
    const int index = in_.below(16) - 1;
    const Vec2 at = in_.hostile_vector(-6, 6);
    switch (in_.below(5)) {
        case 0: {
            const Result<void> done = chain.set_point(index, at);
            require(!done || (index >= 0 && index < count && is_finite(at)), "only good points are moved");
            break;
        }
        case 1: {
            const std::array<Vec2, 2> points{at, in_.hostile_vector(-6, 6)};
            const auto number = static_cast<std::size_t>(in_.below(3));
            const Result<void> done = chain.insert_points(index, std::span(points).first(number));
            const auto now = static_cast<int>(chain.points().size());
            require(now == count + (done ? static_cast<int>(number) : 0), "points come, all or none");
            break;
        }
        case 2: {
            const int number = in_.below(6) - 1;
            const Result<void> done = chain.remove_points(index, number);
            const auto now = static_cast<int>(chain.points().size());
            require(now == count - (done ? number : 0), "points go, all or none");
            break;
        }
        case 3: {
            const bool has_before = in_.flag();
            const bool has_after = in_.flag();
            static_cast<void>(chain.set_ends(has_before ? std::optional(at) : std::nullopt,
                                             has_after ? std::optional(-at) : std::nullopt));
            break;
        }
        default:
            static_cast<void>(chain.set_material(index, material()));
    }
    note_segments(id);
    const auto points_now = static_cast<int>(chain.points().size());
    require(chain.segment_count() == points_now - (chain.is_closed() ? 0 : 1),
            "a chain has a segment between any two points");
}

void Session::change_joint() {
    const JointId id = joints_.any(in_);
    Result<Joint> joint = world_.joint(id);
    require(static_cast<bool>(joint) == joints_.is_there(id),
            "a good handle finds its joint, a bad one nothing");
    if (!joint) return;
    const float a = in_.hostile(-3, 3);
    const float b = in_.hostile(0, 10);
    switch (in_.below(6)) {
        case 0:
            static_cast<void>(joint->set_motor(in_.flag(), a, b));
            return;
        case 1:
            static_cast<void>(joint->set_limits(in_.flag(), a, b));
            return;
        case 2:
            static_cast<void>(joint->set_length(b));
            return;
        case 3:
            static_cast<void>(joint->set_target(a));
            return;
        case 4:
            static_cast<void>(joint->set_target(Position{static_cast<double>(a), static_cast<double>(b)}));
            return;
        default:
            static_cast<void>(joint->set_spring(in_.flag(), b, a));
    }
}

// Answers by the shapes' slots alone, so that it says the same in each world.
bool Session::may_collide(void* session, ShapeId a, ShapeId b) {
    World& world = static_cast<Session*>(session)->world_;
    require(!world.create_body({}) && !world.step(1), "a world is not changed from within its step");
    return (a.index1 + b.index1) % 5 != 0;
}

void Session::change_world() {
    switch (in_.below(4)) {
        case 0:
            static_cast<void>(world_.set_gravity(in_.hostile_vector(-10, 10)));
            return;
        case 1:
            return world_.set_pair_filter(in_.flag() ? PairFilter{&Session::may_collide, this}
                                                     : PairFilter{});
        default: {
            MaterialRule rule;
            rule.friction = {static_cast<Mixing>(in_.below(6)), in_.hostile(0, 2)};
            rule.restitution = {static_cast<Mixing>(in_.below(6)), in_.hostile(0, 1)};
            static_cast<void>(world_.set_material_rule(in_.below(70) - 2, in_.below(70) - 2, rule));
        }
    }
}

void Session::blow() {
    const Vec2 v = in_.hostile_vector(-20, 20);
    if (in_.flag()) {
        ExplosionDef def;
        def.center_m = {static_cast<double>(v.x), static_cast<double>(v.y)};
        def.radius_m = in_.hostile(0, 5);
        def.falloff_m = in_.hostile(0, 5);
        def.impulse_ns_m = in_.hostile(-50, 50);
        if (in_.flag()) def.shelter = 1;
        const Result<void> done = world_.explode(def);
        require(!done || is_finite(v), "explosions that are nowhere are refused");
        return;
    }
    WindDef def;
    def.velocity_m_s = v;
    def.density_kg_m2 = in_.hostile(0, 3);
    def.drag = in_.hostile(0, 2);
    def.lift = in_.hostile(0, 2);
    const float dt_s = in_.hostile(0, 0.1f);
    if (in_.flag()) {
        const Result<void> done = world_.apply_wind(def, dt_s);
        require(!done || is_finite(v), "wind that is not finite is refused");
    } else {
        const BodyId id = any_body();
        const Result<void> done = world_.apply_wind(id, def, dt_s);
        require(!done || (is_finite(v) && bodies_.is_there(id)), "wind needs a body that is there");
    }
}

}  // namespace cairn::physics::fuzz
