// The described fields of bodies and shapes, and how they become physics definitions.
#pragma once

#include <lua.hpp>
#include <string>
#include <vector>

#include <cairn/physics/world.h>

#include "bind/fields.h"
#include "bind/matter.h"

namespace cairn::scripting {

/// What `group` of a shape's filter may be: it fits into 32 bits.
inline constexpr Range kGroups{std::numeric_limits<std::int32_t>::min(),
                               std::numeric_limits<std::int32_t>::max()};
inline constexpr Range kMaterialKindNumbers{0, physics::kMaterialKinds - 1};

extern const FieldSet kWorldFields;
extern const FieldSet kNewBodyFields;
/// Of a shape: who collides with whom, and who is told.
extern const FieldSet kFilterFields;

/// Of a shape: matter, filter and what else is not geometry.
extern const FieldSet kShapeFields;
/// Where a shape sits in its body.
extern const FieldSet kPlaceFields;

enum class GeometryKind { Box, Circle, Capsule, Polygon, Segment };
inline constexpr int kGeometryKinds = 5;
/// By GeometryKind: "box", ...
inline constexpr const char* kGeometryNames[kGeometryKinds] = {"box", "circle", "capsule", "polygon",
                                                               "segment"};

/// By GeometryKind: of the geometry alone.
extern const FieldSet kGeometryFields[kGeometryKinds];
extern const FieldSet kWorldAddFields[kGeometryKinds];
extern const FieldSet kBodyAddFields[kGeometryKinds];

/// Of a shape's surface.
extern const FieldSet kMaterialFields;
/// The same with the density: what a material with a name is.
extern const FieldSet kMatterFields;
/// What things made of several shapes have besides fields of their own for density, friction and restitution.
extern const FieldSet kOtherMatterFields;
/// The field by which shapes name one.
extern const FieldSet kMaterialNameFields;
/// Of `world:add_chain`, `body:add_chain`, and of the chain alone.
extern const FieldSet kWorldAddChainFields;
extern const FieldSet kBodyAddChainFields;
extern const FieldSet kChainShapeFields;
/// Where a chain runs.
extern const FieldSet kChainOutlineFields;

/// The fields of `world:add_...`: those of the body, the shape and the geometry.
constexpr const FieldSet& fields_of_world_add(GeometryKind kind) {
    return kWorldAddFields[static_cast<int>(kind)];
}
/// The fields of `body:add_...`: those of the shape, the geometry and its place in the body.
constexpr const FieldSet& fields_of_body_add(GeometryKind kind) {
    return kBodyAddFields[static_cast<int>(kind)];
}

physics::WorldDef read_world_def(const FieldReader& reader);
physics::BodyDef read_body_def(const FieldReader& reader);
physics::ShapeDef read_shape_def(const FieldReader& reader);
/// The part of it that kFilterFields describe.
void read_filter(const FieldReader& reader, physics::ShapeDef& def);
/// What the table says, else what the material says that it names, else what is so by default.
Matter read_matter(const FieldReader& reader);
/// Of a table with kOtherMatterFields: puts what its material says and what these fields say over what is so
/// by default there.
void read_other_matter(const FieldReader& reader, physics::ShapeDef& def);
/// Of it the part that the surface has.
physics::Material read_material(const FieldReader& reader);
/// Pushes a table with the fields of a surface.
void push_material(lua_State* L, const physics::Material& material);

/// The definition of a chain together with what it borrows.
struct OwnedChain {
    std::vector<physics::Vec2> points_m;
    physics::Material material;
    physics::ChainDef def;
};
void read_chain(lua_State* L, const FieldReader& reader, OwnedChain& out);
/// A list { {x, y}, ... } at an index; `name` is what messages call it.
std::vector<physics::Vec2> read_point_list(lua_State* L, int index, const std::string& name);

/// Where a shape sits in its body.
struct ShapePlace {
    physics::Vec2 position_m;
    double angle_rad = 0;
};
ShapePlace read_shape_place(const FieldReader& reader);

/// The same in the world.
struct BodyPlace {
    physics::Position position_m;
    double angle_rad = 0;
};
BodyPlace read_body_place(const FieldReader& reader);

/// A geometry together with the points that polygons borrow. One part, but for a polygon that is not convex
/// or has many corners.
struct OwnedGeometry {
    std::vector<physics::Geometry> parts;
    std::vector<std::vector<physics::Vec2>> points_m;
};
void read_geometry(lua_State* L, const FieldReader& reader, GeometryKind kind, const ShapePlace& place,
                   OwnedGeometry& out);

/// Pushes the `data` table of a body's description, or a new one.
void push_data_table(lua_State* L, const FieldReader& reader);

}  // namespace cairn::scripting
