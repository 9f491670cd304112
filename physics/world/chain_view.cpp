// The public Chain view.
#include <algorithm>

#include <cairn/physics/chain.h>

#include "world/chain_rules.h"
#include "world/chains.h"
#include "world/material_mixing.h"
#include "world/validation.h"

namespace cairn::physics {
namespace {

int slot_of(const WorldState& world, ChainId id) {
    const int chain = world.stores.chains.find(id);
    CAIRN_ASSERT(chain != kNone, "a Chain view was used after its chain was destroyed");
    return chain;
}

ChainRecord& record_of(WorldState& world, ChainId id) {
    return world.stores.chains[slot_of(world, id)];
}

}  // namespace

BodyId Chain::body() const {
    return world_->stores.bodies.slots.id(record_of(*world_, id_).body);
}
bool Chain::is_closed() const {
    return record_of(*world_, id_).closed;
}
std::span<const Vec2> Chain::points() const {
    return record_of(*world_, id_).points_m;
}
int Chain::segment_count() const {
    return static_cast<int>(record_of(*world_, id_).segments.size());
}

Result<ShapeId> Chain::segment(int index) const {
    const ChainRecord& record = record_of(*world_, id_);
    if (auto fault = validate_segment_index(record, index)) return *fault;
    return world_->stores.shapes.id(record.segments[index]);
}

std::optional<int> Chain::index_of(ShapeId shape) const {
    const auto& segments = record_of(*world_, id_).segments;
    const auto found = std::find(segments.begin(), segments.end(), world_->stores.shapes.find(shape));
    if (found == segments.end()) return {};
    return static_cast<int>(found - segments.begin());
}

Result<void> Chain::set_point(int index, Vec2 point_m) {
    if (auto fault = refuse_within_step(*world_)) return *fault;
    if (auto fault = validate_set_point(record_of(*world_, id_), index, point_m)) return *fault;
    set_chain_point(*world_, slot_of(*world_, id_), index, point_m);
    return {};
}

Result<void> Chain::insert_points(int index, std::span<const Vec2> points_m) {
    if (auto fault = refuse_within_step(*world_)) return *fault;
    if (auto fault = validate_insert(record_of(*world_, id_), index, points_m)) return *fault;
    if (world_->stores.shapes.room() < points_m.size())
        return Error{"the world has no room for " + std::to_string(points_m.size()) + " more shapes"};
    insert_chain_points(*world_, slot_of(*world_, id_), index, points_m);
    return {};
}

Result<void> Chain::remove_points(int first, int count) {
    if (auto fault = refuse_within_step(*world_)) return *fault;
    if (auto fault = validate_remove(record_of(*world_, id_), first, count)) return *fault;
    remove_chain_points(*world_, slot_of(*world_, id_), first, count);
    return {};
}

Result<void> Chain::set_ends(std::optional<Vec2> before_m, std::optional<Vec2> after_m) {
    if (auto fault = refuse_within_step(*world_)) return *fault;
    if (auto fault = validate_ends(record_of(*world_, id_), before_m, after_m)) return *fault;
    set_chain_ends(*world_, slot_of(*world_, id_), before_m, after_m);
    return {};
}

Material Chain::material(int segment) const {
    const ChainRecord& record = record_of(*world_, id_);
    CAIRN_ASSERT(segment >= 0 && segment < static_cast<int>(record.segments.size()),
                 "a chain was asked for a segment that it does not have");
    return world_->stores.shapes[record.segments[segment]].def().material;
}

Result<void> Chain::set_material(int segment, Material material) {
    const ChainRecord& record = record_of(*world_, id_);
    if (auto fault = validate_segment_index(record, segment)) return *fault;
    if (auto fault = validate(material)) return *fault;
    const int shape = record.segments[segment];
    redefine_shape(world_->stores, shape, [&](ShapeDef& def) { def.material = material; });
    remix_contacts_of_shape(world_->stores, shape);
    return {};
}

std::uint64_t Chain::user_data() const {
    return record_of(*world_, id_).user_data;
}
void Chain::set_user_data(std::uint64_t data) {
    record_of(*world_, id_).user_data = data;
}

}  // namespace cairn::physics
