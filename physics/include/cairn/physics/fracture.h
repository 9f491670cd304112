// Bodies that are cut in two or break into pieces.
//
// The body goes, and its pieces are new bodies. They keep the frame of the body that they come from: a point
// of the material has the same local coordinates as before, so pictures and anchors of joints stay where they
// were. Each piece moves on as the material was moving. Mass, momentum and angular momentum are conserved to
// rounding. Pieces inherit what the body and its shapes are: type, damping, gravity scale, locks, sleep
// settings, user data, and of each shape material, filter, events, one-way side and user data. Joints stay,
// under the same JointId, with the piece that holds their anchor; sensors go whole with the piece nearest to
// their middle. Shapes that touch each other or overlap are one piece.
//
// What is cut has flat faces: circles, capsules and rounded polygons become sharp polygons, a disc one of 12
// corners. Their density grows a little so that the mass stays what it was. A piece of more than
// kMaxPolygonVertices corners is one body of several shapes.
#pragma once

#include <cstdint>
#include <limits>

#include <cairn/physics/ids.h>
#include <cairn/physics/math.h>

namespace cairn::physics {

/// m. No piece is narrower than this: the solver could not hold it. A cut that would shave off less does
/// nothing.
inline constexpr float kLeastPieceWidth_m = 0.01f;
inline constexpr int kMaxFracturePieces = 256;

enum class FracturePattern : std::uint8_t {
    Uniform,  ///< pieces of about the same size: stone, ice
    Radial,   ///< shards along rays from the impact, small about it and larger outward: glass
};

/// How a body breaks. The pieces are the Voronoi cells of random points.
struct FractureDef {
    FracturePattern pattern = FracturePattern::Uniform;
    int pieces = 12;         ///< about how many, 2..kMaxFracturePieces; fewer if they would be too narrow
    std::uint64_t seed = 0;  ///< the same seed, body and impact give the same pieces, on every machine
    /// Points of the pattern whose piece would be narrower are left out, and their neighbours are larger
    /// instead. At least kLeastPieceWidth_m.
    float min_width_m = 0.05f;
    /// What is farther than this from the impact stays in one piece, as far as it hangs together. > 0.
    float radius_m = std::numeric_limits<float>::infinity();
    /// In the body's frame: pieces are longer along this direction than across, by its length, 1..16: (6, 0)
    /// makes splinters of a plank. (0, 0): no grain.
    Vec2 grain{};
    /// Pieces of a static or kinematic body within radius_m of the impact become dynamic: a window pane falls
    /// out of its frame, and the rest of a wall stands.
    bool release = false;
};

/// A body that breaks when something presses on it hard enough: see World::set_breakable.
struct BreakableDef {
    /// N s. The normal impulse of one contact over one step that the body just withstands, > 0. A blow of
    /// mass m at speed v has about m v (1 + restitution); a mass m at rest presses with m g dt in each step.
    float strength_ns = 10;
    FractureDef fracture{};
    /// How often, 1..16: the pieces are breakable in the same way, one time less often, until none is left.
    /// What stays in one piece beyond FractureDef::radius_m loses none, and pieces of a cut neither.
    int generations = 1;
    /// The world breaks the body at the end of the step. Otherwise the host does, when it reads the event.
    bool automatic = false;
    /// What pressed on the body gets the impulse beyond its strength back when it breaks: a stone goes on
    /// through a window, slowed down by what the glass withstood, and pushes the pieces in the next step.
    /// Otherwise it bounces off, and then the body breaks.
    bool gives_back = true;
};

/// A body that lies across a cut.
struct CutHit {
    BodyId body{};
    Position enter_m{};  ///< where the way of the cut first enters the body, and where it leaves it last
    Position exit_m{};
    int pieces = 1;  ///< how many bodies World::cut_body would make of it; 1: the cut does not divide it
};

}  // namespace cairn::physics
