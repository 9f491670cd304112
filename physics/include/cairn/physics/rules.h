// Rules of a whole world for pairs of shapes: which may meet, and how their materials mix.
#pragma once

#include <cstdint>

#include <cairn/physics/ids.h>

namespace cairn::physics {

/// A question to the host about two shapes whose boxes have come together and whose filters agree: may they
/// collide? Asked once for each new pair, at the start of a step and before anything is solved, in an order
/// that depends only on the history of the world; the answer stands until the pair parts or one of the two
/// is refiltered. It must not change the world (calls that make, destroy or step give an error meanwhile),
/// and replays repeat only if its answers do.
struct PairFilter {
    bool (*may_collide)(void* context, ShapeId a, ShapeId b) = nullptr;  ///< null: every pair may
    void* context = nullptr;
};

/// How the values of two materials become the one of their contact.
enum class Mixing : std::uint8_t {
    GeometricMean,  ///< sqrt(a b)
    Average,        ///< (a + b) / 2
    Minimum,
    Maximum,
    Multiply,
    Fixed,  ///< whatever a and b are: MixRule::fixed
};

struct MixRule {
    Mixing mixing = Mixing::GeometricMean;
    float fixed = 0;  ///< for Mixing::Fixed
};

/// How two kinds of material (Material::kind) rub and bounce against each other.
struct MaterialRule {
    MixRule friction{Mixing::GeometricMean};  ///< fixed: >= 0
    MixRule restitution{Mixing::Maximum};     ///< fixed: 0..1
};

}  // namespace cairn::physics
