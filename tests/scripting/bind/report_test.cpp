// The report of a world in Lua, against formulas.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

TEST_CASE("a report tells energy, momentum and counts of the world as it is") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} "
                      "b = w:add_box{ x = 3, y = 4, width = 2, height = 1, density = 3, "
                      "linear_velocity_x = 2 } "
                      "r = w:report()") == "");
    CHECK(std::stod(bench.value("r.kinetic_energy")) == Approx(0.5 * 6 * 4));
    CHECK(std::stod(bench.value("r.potential_energy")) == Approx(6 * 10 * 4));
    CHECK(std::stod(bench.value("r.elastic_energy")) == 0);
    CHECK(std::stod(bench.value("r.momentum_x")) == Approx(12));
    CHECK(std::stod(bench.value("r.momentum_y")) == 0);
    CHECK(std::stod(bench.value("r.angular_momentum")) == Approx(-4 * 12));
    CHECK(bench.value("r.bodies") == "1");
    CHECK(bench.value("r.islands") == "1");
    CHECK(bench.value("r.joints + r.touching + r.awake_joints") == "0");
}

TEST_CASE("a report tells how far a joint is from what it holds") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{ gravity_y = 0 } "
                      "b = w:add_box{ width = 1, height = 1 } "
                      "j = w:add_weld_joint{ body_a = w:ground(), body_b = b, x = 0, y = 0 } "
                      "b:set_position(0.3, 0.4) b:set_angle(0.25) "
                      "r = w:report()") == "");
    CHECK(std::stod(bench.value("r.max_joint_error")) == Approx(0.5));
    CHECK(std::stod(bench.value("r.max_joint_angle_error")) == Approx(0.25));
    CHECK(std::stod(bench.value("r.residual")) == 0);
}

TEST_CASE("stages have times once the world was told to measure them") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{} w:add_box{ width = 1, height = 1 } w:step(1/60) "
                      "function total() local t = 0 "
                      "for _, ms in pairs(w:report().stages) do t = t + ms end return t end") == "");
    CHECK(bench.value("total() == 0") == "true");
    REQUIRE(bench.run("w:set_profiling(true) w:step(1/60)") == "");
    CHECK(bench.value("total() > 0") == "true");
    CHECK(bench.value("w:report().stages.solve >= 0") == "true");
}

}  // namespace
}  // namespace cairn::scripting::test
