// The described fields of bodies and shapes, and how they become physics definitions.
#pragma once

#include <lua.hpp>

#include <cairn/physics/world.h>

#include "bind/fields.h"

namespace cairn::scripting {

extern const FieldSet kWorldFields;
extern const FieldSet kNewBodyFields;
/// Of a shape: who collides with whom, and who is told.
extern const FieldSet kFilterFields;

enum class GeometryKind { Box, Circle, Capsule, Polygon };

/// By GeometryKind.
extern const FieldSet kWorldAddFields[4];
extern const FieldSet kBodyAddFields[4];

/// The fields of `world:add_...`: those of the body, the shape and the geometry.
constexpr const FieldSet& fields_of_world_add(GeometryKind kind) {
    return kWorldAddFields[static_cast<int>(kind)];
}
/// The fields of `body:add_...`: those of the shape, the geometry and its place in the body.
constexpr const FieldSet& fields_of_body_add(GeometryKind kind) {
    return kBodyAddFields[static_cast<int>(kind)];
}

physics::WorldDef read_world_def(const FieldReader& reader, lua_State* L);
physics::BodyDef read_body_def(const FieldReader& reader);
physics::ShapeDef read_shape_def(const FieldReader& reader);
/// The part of it that kFilterFields describe.
void read_filter(const FieldReader& reader, physics::ShapeDef& def);

/// Where a shape sits in its body.
struct ShapePlace {
    physics::Vec2 position_m;
    double angle_rad = 0;
};
ShapePlace read_shape_place(const FieldReader& reader);

/// A geometry together with the points that a polygon borrows.
struct OwnedGeometry {
    std::vector<physics::Vec2> points_m;
    physics::Geometry geometry;
};
void read_geometry(lua_State* L, const FieldReader& reader, GeometryKind kind, const ShapePlace& place,
                   OwnedGeometry& out);

/// Pushes the `data` table of a body's description, or a new one.
void push_data_table(lua_State* L, const FieldReader& reader);

}  // namespace cairn::scripting
