// Making, changing and destroying chains. Callers have checked every number.
#pragma once

#include "world/world_state.h"

namespace cairn::physics {

int create_chain(WorldState& world, int body, const ChainDef& def);
void destroy_chain(WorldState& world, int chain);

void set_chain_point(WorldState& world, int chain, int index, Vec2 point_m);
void insert_chain_points(WorldState& world, int chain, int index, std::span<const Vec2> points_m);
void remove_chain_points(WorldState& world, int chain, int first, int count);
void set_chain_ends(WorldState& world, int chain, std::optional<Vec2> before_m, std::optional<Vec2> after_m);

}  // namespace cairn::physics
