// The public Shape view.
#include <cairn/physics/world.h>

#include "world/bodies.h"
#include "world/one_way.h"
#include "world/sleep.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

int slot_of(const WorldState& world, ShapeId id) {
    const int shape = world.stores.shapes.find(id);
    CAIRN_ASSERT(shape != kNone, "a Shape view was used after its shape was destroyed");
    return shape;
}

const ShapeRecord& record_of(const WorldState& world, ShapeId id) {
    return world.stores.shapes[slot_of(world, id)];
}

template <class Change>
void redefine(WorldState& world, ShapeId id, const Change& change) {
    redefine_shape(world.stores, slot_of(world, id), change);
}

}  // namespace

BodyId Shape::body() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body);
}
ChainId Shape::chain() const {
    const int chain = record_of(*world_, id_).chain;
    return chain == kNone ? ChainId{} : world_->stores.chains.id(chain);
}
Outline Shape::outline() const {
    return record_of(*world_, id_).convex().outline;
}
float Shape::density() const {
    return record_of(*world_, id_).def().density_kg_m2;
}
Result<void> Shape::set_density(float density_kg_m2) {
    const ShapeRecord& record = record_of(*world_, id_);
    if (auto fault = check::not_negative("shape.density_kg_m2", static_cast<double>(density_kg_m2)))
        return *fault;
    if (record.chain != kNone) return Error{"shape is a segment of a chain, and a chain has no mass"};
    redefine(*world_, id_, [&](ShapeDef& def) { def.density_kg_m2 = density_kg_m2; });
    lose_mass(world_->stores, record.body);
    settle_mass(world_->stores, record.body);
    wake_body(world_->stores, record.body);
    return {};
}
Material Shape::material() const {
    return record_of(*world_, id_).def().material;
}

Result<void> Shape::set_material(Material material) {
    if (auto fault = validate(material)) return *fault;
    redefine(*world_, id_, [&](ShapeDef& def) { def.material = material; });
    remix_contacts_of_shape(world_->stores, slot_of(*world_, id_));
    return {};
}

Filter Shape::filter() const {
    return record_of(*world_, id_).def().filter;
}

void Shape::set_filter(Filter filter) {
    redefine(*world_, id_, [&](ShapeDef& def) { def.filter = filter; });
    refilter_shape(*world_, slot_of(*world_, id_));
}

Vec2 Shape::one_way_normal() const {
    return record_of(*world_, id_).def().one_way_normal;
}

Result<void> Shape::set_one_way_normal(Vec2 normal) {
    if (auto fault = check::finite("shape.one_way_normal", normal)) return *fault;
    redefine(*world_, id_, [&](ShapeDef& def) { def.one_way_normal = unit_or_zero(normal); });
    reconsider_one_way(world_->stores, slot_of(*world_, id_));
    return {};
}

bool Shape::is_sensor() const {
    return record_of(*world_, id_).def().sensor;
}
bool Shape::is_seen_by_sensors() const {
    return record_of(*world_, id_).def().seen_by_sensors;
}
void Shape::set_seen_by_sensors(bool seen) {
    redefine(*world_, id_, [&](ShapeDef& def) { def.seen_by_sensors = seen; });
    world_->stores.sensors.outdated = true;
}

std::uint64_t Shape::user_data() const {
    return record_of(*world_, id_).user_data;
}
void Shape::set_user_data(std::uint64_t data) {
    world_->stores.shapes[slot_of(*world_, id_)].user_data = data;
}

}  // namespace cairn::physics
