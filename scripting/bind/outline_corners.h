// Outlines of shapes as polygons.
#pragma once

#include <vector>

#include <cairn/engine/geometry.h>
#include <cairn/physics/shape.h>

namespace cairn::scripting {

/// The true outline in the body's frame, with its rounded parts as many short edges: what a polygon of it
/// looks like.
std::vector<engine::Vec2> rounded_corners(const physics::Outline& outline);

}  // namespace cairn::scripting
