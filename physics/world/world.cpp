// The public World: checks what comes from outside, then calls the functions that do the work.
#include <atomic>
#include <bit>

#include <cairn/physics/world.h>

#include "collide/convex.h"
#include "world/bodies.h"
#include "world/chain_rules.h"
#include "world/chains.h"
#include "world/contact_events.h"
#include "world/joint_rules.h"
#include "world/joints.h"
#include "world/measures.h"
#include "world/sleep.h"
#include "world/step.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

// Tells handles of different worlds apart; tag 0 is nobody's.
std::uint16_t next_world_tag() {
    static std::atomic<std::uint32_t> made{0};
    return static_cast<std::uint16_t>(made++ % 0xffff + 1);
}

Error full(const char* kind) {
    return {"the world holds 16777214 " + std::string(kind) + " already, and has room for no more"};
}

template <class Id, class Slots>
std::vector<Id> ids(const Slots& slots) {
    std::vector<Id> result;
    result.reserve(slots.size());
    for (int i = 0; i < slots.end_index(); ++i) {
        if (slots.alive(i)) result.push_back(slots.id(i));
    }
    return result;
}

template <class Slots, class Id>
Result<int> find(const Slots& slots, Id id, const char* kind) {
    return find_slot(slots, id, kind, slots.world_tag());
}

}  // namespace

World::World(const WorldDef& def) : World(create(def).value()) {}
World::World(std::unique_ptr<WorldState> state) : state_(std::move(state)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldDef& def) {
    if (auto fault = validate(def)) return *fault;
    return World(std::make_unique<WorldState>(def, next_world_tag()));
}

Result<void> World::step(float dt_s) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (auto fault = validate_step(dt_s)) return *fault;
    state_->stepping = true;
    step_world(*state_, dt_s);
    state_->stepping = false;
    return {};
}

Result<BodyId> World::create_body(const BodyDef& def) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (auto fault = validate(def)) return *fault;
    if (state_->stores.bodies.slots.full()) return full("bodies");
    return state_->stores.bodies.slots.id(physics::create_body(state_->stores, def));
}

Result<void> World::destroy_body(BodyId id) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> body = find(state_->stores.bodies.slots, id, "body");
    if (!body) return body.error();
    physics::destroy_body(*state_, *body);
    return {};
}

Result<Body> World::body(BodyId id) {
    const Result<int> body = find(state_->stores.bodies.slots, id, "body");
    if (!body) return body.error();
    return Body(*state_, id);
}

Result<const Body> World::body(BodyId id) const {
    const Result<int> body = find(state_->stores.bodies.slots, id, "body");
    if (!body) return body.error();
    return Body(*state_, id);
}

std::optional<Body> World::living_body(BodyId id) {
    return contains(id) ? std::optional(Body(*state_, id)) : std::nullopt;
}

std::optional<Position> World::position_of(BodyId id) {
    const int body = state_->stores.bodies.slots.find(id);
    if (body == kNone) return std::nullopt;
    if (state_->stores.masses.entries[body].lacks_shapes) return Body(*state_, id).position();
    const BodyStore& bodies = state_->stores.bodies;
    // Most bodies have their origin in their centre: one thing less to do where scripts ask most.
    if (bodies.slots[body].mass.center_m == Vec2{})
        return bodies.places[static_cast<std::size_t>(body)].center;
    return bodies.origin(body);
}

bool World::contains(BodyId id) const {
    return state_->stores.bodies.slots.find(id) != kNone;
}
void World::read_transforms(std::vector<BodyTransform>& out) const {
    const BodyStore& bodies = state_->stores.bodies;
    out.resize(static_cast<std::size_t>(bodies.slots.size()));
    std::size_t next = 0;
    for (int i = 0; i < bodies.slots.end_index(); ++i) {
        if (!bodies.slots.alive(i)) continue;
        // The handle goes out as one word. Written field by field it would be read back half written in
        // between, and wait for its own writing: 4 of 5.5 ns a body.
        const auto id = std::bit_cast<std::uint64_t>(bodies.slots.id(i));
        out[next++] = {std::bit_cast<BodyId>(id), bodies.transform(i)};
    }
}

std::vector<BodyId> World::bodies() const {
    return ids<BodyId>(state_->stores.bodies.slots);
}

Result<ShapeId> World::create_shape(BodyId body_id, const Geometry& geometry, const ShapeDef& def) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> body = find(state_->stores.bodies.slots, body_id, "body");
    if (!body) return body.error();
    if (auto fault = validate(def)) return *fault;
    const Result<Convex> convex = make_convex(geometry);
    if (!convex) return convex.error();
    if (state_->stores.shapes.full()) return full("shapes");
    return state_->stores.shapes.id(physics::create_shape(state_->stores, *body, *convex, def));
}

Result<void> World::destroy_shape(ShapeId id) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> shape = find(state_->stores.shapes, id, "shape");
    if (!shape) return shape.error();
    if (state_->stores.shapes[*shape].chain != kNone) {
        return Error{"the shape is a segment of a chain: remove points of the chain, or destroy the chain"};
    }
    physics::destroy_shape(*state_, *shape);
    return {};
}

Result<Shape> World::shape(ShapeId id) {
    const Result<int> shape = find(state_->stores.shapes, id, "shape");
    if (!shape) return shape.error();
    return Shape(*state_, id);
}

Result<const Shape> World::shape(ShapeId id) const {
    const Result<int> shape = find(state_->stores.shapes, id, "shape");
    if (!shape) return shape.error();
    return Shape(*state_, id);
}

bool World::contains(ShapeId id) const {
    return state_->stores.shapes.find(id) != kNone;
}

Result<ChainId> World::create_chain(BodyId body_id, const ChainDef& def) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> body = find(state_->stores.bodies.slots, body_id, "body");
    if (!body) return body.error();
    if (auto fault = validate(def)) return *fault;
    if (state_->stores.shapes.room() < def.points_m.size()) return full("shapes");
    if (state_->stores.chains.full()) return full("chains");
    return state_->stores.chains.id(physics::create_chain(*state_, *body, def));
}

Result<void> World::destroy_chain(ChainId id) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> chain = find(state_->stores.chains, id, "chain");
    if (!chain) return chain.error();
    physics::destroy_chain(*state_, *chain);
    return {};
}

Result<Chain> World::chain(ChainId id) {
    const Result<int> chain = find(state_->stores.chains, id, "chain");
    if (!chain) return chain.error();
    return Chain(*state_, id);
}

Result<const Chain> World::chain(ChainId id) const {
    const Result<int> chain = find(state_->stores.chains, id, "chain");
    if (!chain) return chain.error();
    return Chain(*state_, id);
}

bool World::contains(ChainId id) const {
    return state_->stores.chains.find(id) != kNone;
}

Result<JointId> World::create_joint(const JointDef& def) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (auto fault = validate(def, state_->stores)) return *fault;
    if (state_->stores.joints.slots.full()) return full("joints");
    return state_->stores.joints.slots.id(physics::create_joint(*state_, def));
}

Result<void> World::destroy_joint(JointId id) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    const Result<int> joint = find(state_->stores.joints.slots, id, "joint");
    if (!joint) return joint.error();
    physics::destroy_joint(state_->stores, *joint);
    return {};
}

Result<Joint> World::joint(JointId id) {
    const Result<int> joint = find(state_->stores.joints.slots, id, "joint");
    if (!joint) return joint.error();
    return Joint(*state_, id);
}

Result<const Joint> World::joint(JointId id) const {
    const Result<int> joint = find(state_->stores.joints.slots, id, "joint");
    if (!joint) return joint.error();
    return Joint(*state_, id);
}

bool World::contains(JointId id) const {
    return state_->stores.joints.slots.find(id) != kNone;
}

std::span<const ContactBegin> World::contact_begins() const {
    return state_->events.begins;
}
std::span<const ContactEnd> World::contact_ends() const {
    return state_->events.ends;
}
std::span<const ContactHit> World::contact_hits() const {
    return state_->events.hits;
}
std::span<const JointBreak> World::joint_breaks() const {
    return state_->events.joint_breaks;
}
std::span<const SensorBegin> World::sensor_begins() const {
    return state_->events.sensor_begins;
}
std::span<const SensorEnd> World::sensor_ends() const {
    return state_->events.sensor_ends;
}

Result<std::vector<ShapeId>> World::sensor_overlaps(ShapeId sensor) const {
    const Result<int> shape = find(state_->stores.shapes, sensor, "shape");
    if (!shape) return shape.error();
    const int place = state_->stores.shapes[*shape].sensor;
    if (place == kNone) return Error{"the shape is no sensor, but must be one (ShapeDef::sensor)"};
    return state_->stores.sensors.all[place].inside;
}

std::span<const BodyId> World::quarantined() const {
    return state_->events.quarantined;
}

void World::set_pair_filter(PairFilter filter) {
    state_->stores.rules.filter = filter;
}

Result<void> World::set_material_rule(int kind_a, int kind_b, const MaterialRule& rule) {
    if (auto fault = check::first_of({validate_material_kinds(kind_a, kind_b), validate(rule)}))
        return *fault;
    state_->stores.rules.mixing.set(kind_a, kind_b, rule);
    remix_contacts_of_kinds(state_->stores, kind_a, kind_b);
    return {};
}

Result<MaterialRule> World::material_rule(int kind_a, int kind_b) const {
    if (auto fault = validate_material_kinds(kind_a, kind_b)) return *fault;
    return state_->stores.rules.mixing.rule(kind_a, kind_b);
}

Vec2 World::gravity() const {
    return state_->def.gravity_m_s2;
}

Result<void> World::set_gravity(Vec2 gravity_m_s2) {
    if (auto fault = refuse_within_step(*state_)) return *fault;
    if (auto fault = check::finite("world.gravity_m_s2", gravity_m_s2)) return *fault;
    state_->def.gravity_m_s2 = gravity_m_s2;
    const BodyRows& asleep = state_->stores.bodies.rows(RowSet::Asleep);
    while (asleep.size() > 0) wake_body(state_->stores, asleep.body.back());
    return {};
}

Counts World::counts() const {
    return count_objects(state_->stores);
}
int World::awake_body_count() const {
    return state_->stores.bodies.rows(RowSet::Awake).size();
}
float World::max_penetration_m() const {
    return physics::max_penetration_m(state_->stores);
}
WorldReport World::report() const {
    return make_report(*state_);
}
void World::set_profiling(bool enabled) {
    state_->profiling = enabled;
}
const Profile& World::profile() const {
    return state_->profile;
}

std::uint64_t World::step_count() const {
    return state_->step_count;
}
std::uint64_t World::state_hash() const {
    settle_masses(state_->stores);
    return hash_state(*state_);
}

}  // namespace cairn::physics
