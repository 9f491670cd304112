// A run of bodies from point to point, pinned where they meet: what chains, ropes and bridges are made of.
#pragma once

#include <functional>
#include <vector>

#include "prefabs/builder.h"

namespace cairn::physics {

struct LinkedBodies {
    std::vector<BodyId> links{};
    std::vector<JointId> pins{};
};

struct LinkingDef {
    PrefabEnd from{};
    PrefabEnd to{};
    float damping_1_s = 0;
    float friction_torque_nm = 0;
    JointStrength strength{};
    const ShapeDef* shape = nullptr;
};

/// One body from each point to the next; `outline` gives its geometry, lying along x about its origin, from
/// its length.
LinkedBodies link_bodies(Builder& builder, const std::vector<Position>& points, const LinkingDef& def,
                         const std::function<Geometry(float length_m)>& outline);

}  // namespace cairn::physics
