// What all prefabs have in common: bodies and joints that were made together. Each is plain data: the parts
// belong to the world, and may be changed, taken apart and destroyed like any others.
#pragma once

#include <vector>

#include <cairn/physics/world.h>

namespace cairn::physics {

/// In the order in which they were made.
struct Prefab {
    std::vector<BodyId> bodies{};
    std::vector<JointId> joints{};
};

/// Destroys what is left of it.
void destroy_prefab(World& world, const Prefab& prefab);

/// What one end of a chain, rope or bridge is held by.
struct PrefabEnd {
    bool held = true;  ///< otherwise it is free
    BodyId body{};     ///< null: the world
};

}  // namespace cairn::physics
