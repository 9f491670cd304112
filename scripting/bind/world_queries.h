// Questions to a world and what acts on many bodies at once: as methods of World.
#pragma once

#include <lua.hpp>

#include "bind/function.h"
#include "bind/physics_fields.h"
#include "bind/physics_objects.h"
#include "bind/query_filter.h"

namespace cairn::scripting {

extern const FieldSet kExplosionFields;
extern const FieldSet kWindFields;
extern const FieldSet kMaterialRuleFields;

Pushed body_at(lua_State* L, WorldRef self, double x, double y, Filter filter, Ignored ignored);
Pushed cast_ray(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                Ignored ignored);
Pushed cast_ray_all(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                    Ignored ignored);
Pushed cast_shape(lua_State* L, WorldRef self, TableArgument shape, float dx, float dy, Filter filter,
                  Ignored ignored);
Pushed cast_shape_all(lua_State* L, WorldRef self, TableArgument shape, float dx, float dy, Filter filter,
                      Ignored ignored);
Pushed shapes_overlapping(lua_State* L, WorldRef self, TableArgument shape, Filter filter, Ignored ignored);
Pushed shapes_in_box(lua_State* L, WorldRef self, double x1, double y1, double x2, double y2, Filter filter,
                     Ignored ignored);
Pushed closest_point(lua_State* L, WorldRef self, double x, double y, NotNegative radius, Filter filter,
                     Ignored ignored);
Pushed closest_points(lua_State* L, WorldRef self, double x, double y, NotNegative radius, Filter filter,
                      Ignored ignored);
Pushed collision_planes(lua_State* L, WorldRef self, TableArgument shape, NotNegative reach, Filter filter,
                        Ignored ignored);

physics::Result<void> explode(lua_State* L, WorldRef self, TableArgument fields);
physics::Result<void> apply_wind(lua_State* L, WorldRef self, TableArgument fields, StepTime dt_s);
physics::Result<void> apply_wind_to_body(lua_State* L, BodyRef self, TableArgument fields, StepTime dt_s);
using MaterialKind = Ranged<kMaterialKindNumbers, std::int64_t>;
physics::Result<void> set_material_rule(lua_State* L, WorldRef self, MaterialKind kind_a, MaterialKind kind_b,
                                        TableArgument fields);
Pushed material_rule(lua_State* L, WorldRef self, MaterialKind kind_a, MaterialKind kind_b);

}  // namespace cairn::scripting
