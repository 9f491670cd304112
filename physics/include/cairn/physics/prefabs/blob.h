// A soft body: a disc of round pieces, each welded softly to its neighbours.
#pragma once

#include <cairn/physics/prefabs/prefab.h>

namespace cairn::physics {

struct BlobDef {
    Position position_m{};         ///< of the middle
    int rings = 3;                 ///< of pieces about the middle one, 1..50
    float piece_radius_m = 0.15f;  ///< > 0
    float stiffness_hz = 15;       ///< of each weld, > 0
    float damping_ratio = 0.7f;    ///< >= 0
    JointStrength strength{};      ///< of each weld
    ShapeDef shape{};              ///< of every piece
};

/// The middle piece is the first body.
struct Blob : Prefab {};

Result<Blob> create_blob(World& world, const BlobDef& def);

}  // namespace cairn::physics
