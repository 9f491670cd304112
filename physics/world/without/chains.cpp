// Stands for chains in a build without them: none can be made, so nothing collides with one.
#include "world/chains.h"

#include "collide/manifold.h"
#include "world/chain_rules.h"
#include "world/features.h"

namespace cairn::physics {

check::Fault validate(const ChainDef&) {
    return absence(Feature::Chains);
}
check::Fault validate_set_point(const ChainRecord&, int, Vec2) {
    return absence(Feature::Chains);
}
check::Fault validate_insert(const ChainRecord&, int, std::span<const Vec2>) {
    return absence(Feature::Chains);
}
check::Fault validate_remove(const ChainRecord&, int, int) {
    return absence(Feature::Chains);
}
check::Fault validate_ends(const ChainRecord&, std::optional<Vec2>, std::optional<Vec2>) {
    return absence(Feature::Chains);
}
check::Fault validate_segment_index(const ChainRecord&, int) {
    return absence(Feature::Chains);
}

int create_chain(WorldState&, int, const ChainDef&) {
    return kNone;
}
void destroy_chain(WorldState&, int) {}
void set_chain_point(WorldState&, int, int, Vec2) {}
void insert_chain_points(WorldState&, int, int, std::span<const Vec2>) {}
void remove_chain_points(WorldState&, int, int, int) {}
void set_chain_ends(WorldState&, int, std::optional<Vec2>, std::optional<Vec2>) {}

Manifold collide_chain_and_circle(const Convex&, const Convex&, const RelativePose&, float) {
    return {};
}
Manifold collide_chain_and_hull(const Convex&, const Convex&, const RelativePose&, float) {
    return {};
}
bool is_behind(const Convex&, Vec2) {
    return false;
}
bool leaves_to_neighbour(const Convex&, int) {
    return false;
}

}  // namespace cairn::physics
