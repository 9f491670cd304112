// The report of a world as a table; its fields have the names of C++ without the units.
#include "bind/report.h"

namespace cairn::scripting {
namespace {

void set_field(lua_State* L, std::string_view name, double value) {
    lua_pushlstring(L, name.data(), name.size());
    lua_pushnumber(L, value);
    lua_rawset(L, -3);
}

void set_field(lua_State* L, std::string_view name, int value) {
    lua_pushlstring(L, name.data(), name.size());
    lua_pushinteger(L, value);
    lua_rawset(L, -3);
}

void set_stages(lua_State* L, const physics::Profile& profile) {
    lua_createtable(L, 0, static_cast<int>(physics::kStages.size()));
    for (const physics::Stage stage : physics::kStages) set_field(L, name(stage), profile[stage]);
    lua_setfield(L, -2, "stages");
}

}  // namespace

Pushed report(lua_State* L, WorldRef self) {
    const physics::WorldReport report = self.world.report();
    lua_createtable(L, 0, 21);
    set_field(L, "bodies", report.counts.bodies);
    set_field(L, "awake_bodies", report.counts.awake_bodies);
    set_field(L, "shapes", report.counts.shapes);
    set_field(L, "joints", report.counts.joints);
    set_field(L, "awake_joints", report.awake_joints);
    set_field(L, "contacts", report.counts.contacts);
    set_field(L, "touching", report.counts.touching);
    set_field(L, "awake_touching", report.awake_touching);
    set_field(L, "islands", report.islands);
    set_field(L, "max_penetration", static_cast<double>(report.max_penetration_m));
    set_field(L, "max_joint_error", static_cast<double>(report.max_joint_error_m));
    set_field(L, "max_joint_angle_error", static_cast<double>(report.max_joint_error_rad));
    set_field(L, "residual", static_cast<double>(report.residual_m_s));
    set_field(L, "angular_residual", static_cast<double>(report.residual_rad_s));
    set_field(L, "kinetic_energy", report.kinetic_energy_j);
    set_field(L, "potential_energy", report.potential_energy_j);
    set_field(L, "elastic_energy", report.elastic_energy_j);
    set_field(L, "momentum_x", report.momentum_x_kg_m_s);
    set_field(L, "momentum_y", report.momentum_y_kg_m_s);
    set_field(L, "angular_momentum", report.angular_momentum_kg_m2_s);
    set_stages(L, report.stages);
    return {1};
}

void set_profiling(WorldRef self, bool enabled) {
    self.object.is_profiled = enabled;
    self.world.set_profiling(enabled);
}

}  // namespace cairn::scripting
