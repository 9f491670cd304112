// Draws what a physics world looks like inside: true shapes, contacts with their impulses, joints by kind,
// islands, sleep, boxes of the broad phase. Invariant: it reads the world and draws under the renderer's
// present transform, metres to pixels, so any camera will do; lines, dots and marks keep their size on the
// screen.
#pragma once

#include <cairn/engine/renderer.h>
#include <cairn/physics/world.h>

namespace cairn::scripting {

struct DebugDrawOptions {
    bool shapes = true;    ///< with a mark of how the body is turned; sleeping bodies are dark
    bool contacts = true;  ///< points, and impulses along the normal and along the surface
    bool joints = true;
    bool islands = false;  ///< bodies that fall asleep together have one color, instead of that of their type
    bool boxes = false;    ///< of the broad phase
    bool centers = false;  ///< of mass
    float alpha = 1;       ///< the picture lies so far between the last two steps
};

/// What lies outside of the picture is left out.
void draw_debug(engine::Renderer& renderer, const physics::World& world, const DebugDrawOptions& options);

}  // namespace cairn::scripting
