// From manifolds to constraints: arms, masses, and the impulses of the last step by feature.
#pragma once

#include "base/motion.h"
#include "collide/box_lanes.h"
#include "resolve/contact_block.h"

namespace cairn::physics {

/// Of both points of a manifold.
using FeatureLanes = std::array<Lanes<std::int32_t>, 2>;

struct PreparedLanes {
    unsigned apart = 0;   // bits: lanes without points
    unsigned fast = 0;    // lanes of which a point closes or opens faster than was asked for
    unsigned swings = 0;  // lanes whose points would go far astray if a body turned by a quarter radian
    unsigned deep = 0;    // lanes of which a point overlaps deeply (resolve/deep_overlap.h)
};

/// The rows `a` and `b` of the block, its friction and its impulses are given; the rest is made. `features`
/// are those of the last step, and become those of the manifold. Where lanes bounce, closing velocities are
/// noted in `impacts`, which may be null.
PreparedLanes prepare_block(const PoseLanes& poses, const ManifoldLanes& manifold,
                            const VelocityRow* velocity, const PoseRow* pose, FeatureLanes& features,
                            float impact_speed_m_s, ContactBlock& block, ImpactLanes* impacts);

}  // namespace cairn::physics
