// Queries, explosions, wind, rules of materials and movers from Lua: each against what can be said
// beforehand.
#include <catch2/catch.hpp>

#include "scripting/support/lua_bench.h"

namespace cairn::scripting::test {
namespace {

using Catch::Matchers::Contains;

const char* const kYard =
    "w = cairn.physics.new_world{}\n"
    "ground = w:add_box{ type = 'static', y = -1, width = 100, height = 2 }\n"
    "a = w:add_box{ x = 4, y = 1, width = 2, height = 2, categories = 2 }\n"
    "b = w:add_circle{ x = 8, y = 1, radius = 1 }\n";

TEST_CASE("rays and shapes find what lies in their way, in its order") {
    LuaBench bench;
    REQUIRE(bench.run(std::string(kYard) + "hits = w:cast_ray_all(0, 1, 20, 1)") == "");
    CHECK(bench.value("#hits") == "2");
    CHECK(bench.value(
              "hits[1].body == a and hits[1].x == 3 and hits[1].nx == -1 and hits[1].fraction == 0.15") ==
          "false");  // floats
    CHECK(bench.value("hits[1].body == a and hits[1].x == 3 and math.abs(hits[1].fraction - 0.15) < 1e-6") ==
          "true");
    CHECK(bench.value("hits[2].body == b and hits[2].shape == b:shapes()[1]") == "true");
    CHECK(bench.value("#w:cast_ray_all(0, 1, 20, 1, 2)") == "1");
    CHECK(bench.value("#w:cast_ray_all(0, 1, 20, 1, 2^1)") == "1");  // a float, but whole
    CHECK(bench.value("#w:cast_ray_all(0, 1, 20, 1, { mask = 2^1 })") == "1");
    CHECK(bench.value("#w:cast_ray_all(0, 1, 20, 1, -1, a)") == "1");

    // A circle of radius 0.5 meets the box when its centre is 0.5 before it: after 2.5 of 10 metres.
    REQUIRE(bench.run("body, x, y, nx, ny, fraction, overlap, shape = w:cast_shape({ shape = 'circle', "
                      "radius = 0.5, y = "
                      "1 }, 10, 0)") == "");
    CHECK(bench.value(
              "body == a and x == 3 and nx == -1 and math.abs(fraction - 0.25) < 1e-3 and overlap == 0") ==
          "true");
    CHECK(bench.value("#w:cast_shape_all({ shape = 'box', width = 1, height = 1, y = 1 }, 20, 0)") == "2");
    CHECK(bench.value("w:cast_shape({ shape = 'circle', radius = 0.5, y = 20 }, 10, 0)") == "nil");
    CHECK_THAT(bench.run("w:cast_shape({ shape = 'circel', radius = 1 }, 1, 0)"),
               Contains("did you mean \"circle\"?"));
    CHECK_THAT(bench.run("w:cast_shape({ shape = 'circle' }, 1, 0)"), Contains("radius is missing"));
    CHECK_THAT(bench.run("w:cast_shape({ shape = 'circle', radius = 1, whidth = 2 }, 1, 0)"),
               Contains("unknown field"));
}

// The same question to each query: with a filter it must give what it gives in a world that holds only what
// the filter lets pass.
TEST_CASE("each query sees what a bit set, a table or a function lets pass, and nothing else") {
    LuaBench bench;
    REQUIRE(bench.run(R"(
        -- Rings of boxes about (0, 0), each box of one of three teams.
        function make(only)
            if w then w:destroy() end
            w = cairn.physics.new_world{ gravity_y = 0 }
            for i = 0, 35 do
                local team, angle, r = i % 3, i * math.pi / 18, 2 + i % 4
                if not only or team == only then
                    w:add_box{ x = r * math.cos(angle), y = r * math.sin(angle), width = 0.7, height = 0.5,
                        angle = angle, categories = 1 << team, mask = ~(1 << team), data = { team = team, i = i } }
                end
            end
            return w
        end
        local function names(list)  -- in the order given
            local out = {}
            for i, v in ipairs(list) do
                out[i] = (v.body and type(v.body) ~= 'function' and v.body or v:body()).data.i
            end
            return table.concat(out, ' ')
        end
        local ball = { shape = 'circle', radius = 0.8, x = 0.1, y = 0.2 }
        queries = {
            function(w, f) local b = w:body_at(4 * math.cos(math.pi / 9), 4 * math.sin(math.pi / 9), f) return b and b.data.i end,
            function(w, f) local b = w:cast_ray(0, 0, 9, 1, f) return b and b.data.i end,
            function(w, f) return names(w:cast_ray_all(-9, -1, 9, 1, f)) end,
            function(w, f) local b = w:cast_shape(ball, -7, 3, f) return b and b.data.i end,
            function(w, f) return names(w:cast_shape_all(ball, -7, 3, f)) end,
            function(w, f) return names(w:shapes_overlapping({ shape = 'circle', radius = 3 }, f)) end,
            function(w, f) return names(w:shapes_in_box(0, 0, 4, 4, f)) end,
            function(w, f) local b = w:closest_point(0.3, 0, 9, f) return b and b.data.i end,
            function(w, f) return names(w:closest_points(0, 0, 4, f)) end,
            function(w, f) return names(w:collision_planes({ shape = 'circle', radius = 2 }, 1, f)) end,
            function(w, f) return names(w:cuts_along(-9, 2, 9, 2, f)) end,
            function(w, f)
                w:explode{ radius = 5, impulse = 1, accepts = type(f) == 'function' and f or type(f) == 'table' and f.accepts or nil,
                    mask = type(f) == 'number' and f or type(f) == 'table' and f.mask or nil,
                    categories = type(f) == 'table' and f.categories or nil }
                local out = {}
                for _, b in ipairs(w:bodies()) do if b:linear_velocity() ~= 0 then out[#out + 1] = b.data.i end end
                return table.concat(out, ' ')
            end,
        }
        function compare(number)
            local seen = 0
            for team = 0, 2 do
                local expected = queries[number](make(team), -1)
                if expected and expected ~= '' then seen = seen + 1 end
                for _, filter in ipairs{ 1 << team, { mask = 1 << team },
                        function(body, shape) assert(shape:body() == body) return body.data.team == team end,
                        { accepts = function(body) return body.data.team == team end } } do
                    local got = queries[number](make(), filter)
                    assert(got == expected, tostring(got) .. ' but expected ' .. tostring(expected))
                end
                -- What would collide with this team alone is all the others.
                local others = queries[number](make(), function(body) return body.data.team ~= team end)
                assert(queries[number](make(), { categories = 1 << team }) == others)
            end
            return seen
        end
    )") == "");
    for (int number = 1; number <= 12; ++number) {
        INFO("query " << number);
        CHECK(bench.run("seen = compare(" + std::to_string(number) + ")") == "");
        CHECK(bench.value("seen > 0") == "true");
    }
}

TEST_CASE("a filter's function may do anything, and is asked in the order in which shapes were made") {
    LuaBench bench;
    REQUIRE(bench.run(std::string(kYard) + R"(
        order = {}
        first = w:cast_ray(0, 1, 20, 1, function(body) order[#order + 1] = body return true end)
    )") == "");
    CHECK(bench.value("first == a and order[1] == a and order[2] == b and #order") == "2");
    CHECK(
        bench.run("w:cast_ray(0, 1, 20, 1, function(body) w:add_circle{ radius = 1, x = 30 } w:step(1 / 60) "
                  "return #w:cast_ray_all(0, 1, 20, 1) == 2 end)") == "");
    // One that is destroyed in the middle is not met.
    REQUIRE(bench.run("met = w:cast_ray_all(0, 1, 20, 1, function(body) if a:is_valid() then a:destroy() end "
                      "return true end)") == "");
    CHECK(bench.value("#met == 1 and met[1].body == b") == "true");
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, function() return 1 end)"),
               Contains("test.lua:1: World:cast_ray: the filter returned 1; expected true or false"));
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, function() error('no') end)"), Contains("test.lua:1: no"));
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, { accept = print })"),
               Contains("did you mean \"accepts\"?"));
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, 0.5)"), Contains("filter is 0.5; expected an integer"));
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, 'all')"),
               Contains("filter is \"all\"; expected a bit set of categories, a function, or a table"));
    CHECK_THAT(bench.run("local dead = w:add_circle{ radius = 1 } dead:destroy() "
                         "w:cast_ray(0, 1, 20, 1, { ignored = dead })"),
               Contains("ignored = a Body: must be a body that was not destroyed"));
    CHECK_THAT(bench.run("w:cast_ray(0, 1, 20, 1, function() w:destroy() return true end)"),
               Contains("the filter has destroyed the world"));
}

TEST_CASE("a ray looks past the body that asks, and wind and movers past what a function refuses") {
    LuaBench bench;
    REQUIRE(bench.run(kYard) == "");
    CHECK(bench.value("w:cast_ray(0, 1, 20, 1, -1, a) == b") == "true");
    CHECK(bench.value("w:cast_ray(0, 1, 20, 1, { ignored = a }) == b") == "true");
    CHECK(bench.value("select(7, w:cast_ray(0, 1, 20, 1)) == a:shapes()[1]") == "true");
    REQUIRE(
        bench.run(
            "w:set_gravity(0, 0) w:apply_wind({ velocity_x = 20, accepts = function(body) return body == b "
            "end }, 1 / 60) w:step(1 / 60)") == "");
    CHECK(bench.value("b:linear_velocity() > 0 and a:linear_velocity() == 0") == "true");
    REQUIRE(bench.run("a:apply_wind({ velocity_x = 20, accepts = function() return false end }, 1 / 60) "
                      "w:step(1 / 60)") == "");
    CHECK(bench.value("a:linear_velocity()") == "0.0");
    REQUIRE(bench.run(R"(
        w = cairn.physics.new_world{}
        w:add_box{ type = 'static', y = -1, width = 100, height = 2 }
        ghost = w:add_box{ type = 'static', x = 3, y = 2, width = 1, height = 4 }
        w:add_box{ type = 'static', x = 6, y = 2, width = 1, height = 4 }
        m = cairn.physics.new_mover{ y = 0.02 }
        for i = 1, 180 do
            local _, vy = m:velocity()
            m:move(w, 3, vy - 10 / 60, 1 / 60, function(body) return body ~= ghost end)
        end
    )") == "");
    // The second wall's face is at 5.5, the capsule 0.3 wide each way.
    CHECK(bench.value("math.abs(m:position() - 5.2) < 0.02 and m:is_grounded()") == "true");
}

TEST_CASE("overlaps, boxes and nearest points see the shapes that are there") {
    LuaBench bench;
    REQUIRE(bench.run(kYard) == "");
    CHECK(bench.value("#w:shapes_overlapping{ shape = 'circle', radius = 1.5, x = 6, y = 2 }") == "2");
    CHECK(bench.value("#w:shapes_overlapping({ shape = 'circle', radius = 1.5, x = 6, y = 2 }, 2)") == "1");
    CHECK(bench.value("w:shapes_in_box(10, 3, 7, 1)[1] == b:shapes()[1]") == "true");
    REQUIRE(bench.run("body, x, y, nx, ny, distance, shape = w:closest_point(8, 5, 10)") == "");
    CHECK(bench.value("body == b and math.abs(distance - 3) < 1e-3 and math.abs(ny - 1) < 1e-6") == "true");
    CHECK(bench.value("w:closest_point(8, 50, 10)") == "nil");
    CHECK(bench.value("#w:closest_points(6, 1, 3)") == "3");
    CHECK(bench.value("#w:collision_planes({ shape = 'circle', radius = 0.5, x = 6, y = 0.5 }, 1)") != "0");
}

TEST_CASE("explosions push outward, and shelter keeps them off") {
    LuaBench bench;
    REQUIRE(bench.run(std::string(kYard) + "w:explode{ x = 6, y = 1, radius = 5, impulse = 10 }") == "");
    CHECK(bench.value("a:linear_velocity() < 0 and b:linear_velocity() > 0") == "true");
    REQUIRE(bench.run("b:set_linear_velocity(0, 0) w:explode{ x = 0, y = 1, radius = 20, impulse = 10, "
                      "shelter = 2 }") == "");
    CHECK(bench.value("b:linear_velocity()") == "0.0");
}

TEST_CASE("wind takes along what it meets and no faster than itself") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{ gravity_y = 0 } b = w:add_circle{ radius = 1, density = 0.01 }\n"
            "c = w:add_circle{ y = 9, radius = 1, density = 0.01 }\n"
            "for i = 1, 600 do b:apply_wind({ velocity_x = 5 }, 1 / 60) w:step(1 / 60) end") == "");
    CHECK(bench.value("b:linear_velocity() > 4.5 and b:linear_velocity() <= 5") == "true");
    CHECK(bench.value("c:linear_velocity()") == "0.0");
    REQUIRE(bench.run("w:apply_wind({ velocity_x = 5 }, 1 / 60) w:step(1 / 60)") == "");
    CHECK(bench.value("c:linear_velocity() > 0 or not c:is_awake()") == "true");
}

TEST_CASE("rules say how kinds of material mix") {
    LuaBench bench;
    REQUIRE(
        bench.run(
            "w = cairn.physics.new_world{}\n"
            "w:add_box{ type = 'static', y = -1, width = 40, height = 2, material_kind = 1, friction = 1 }\n"
            "b = w:add_box{ y = 0.5, width = 1, height = 1, material_kind = 2, friction = 1, "
            "linear_velocity_x = 3 }\n"
            "w:set_material_rule(1, 2, { friction = 'fixed', fixed_friction = 0 })\n"
            "for i = 1, 60 do w:step(1 / 60) end") == "");
    CHECK(bench.value("math.abs(b:linear_velocity() - 3) < 1e-3") == "true");
    CHECK(bench.value("w:material_rule(2, 1).friction") == "fixed");
    CHECK(bench.value("w:material_rule(3, 1).restitution") == "maximum");
    CHECK_THAT(bench.run("w:set_material_rule(1, 64, {})"),
               Contains("kind_b is 64; expected an integer from 0 to 63"));
    CHECK_THAT(bench.run("w:set_material_rule(1, 2, { friction = 'avrage' })"),
               Contains("did you mean \"average\"?"));
}

TEST_CASE("places of all bodies are read at once, in the order of bodies, without garbage") {
    LuaBench bench;
    REQUIRE(bench.run(
                "w = cairn.physics.new_world{} for i = 1, 50 do w:add_circle{ x = i, y = i * i, angle = 0.01 "
                "* i, radius = "
                "0.1 } end\n"
                "w:bodies()[7]:destroy() t = cairn.physics.new_transforms() n = w:read_transforms(t)") == "");
    CHECK(bench.value("n == 49 and t:count() == 49") == "true");
    CHECK(
        bench.run(
            "w:step(1 / 60) w:read_transforms(t) for i, body in ipairs(w:bodies()) do\n"
            "  local x, y, angle = body:transform() local tx, ty, tangle = t:transform(i)\n"
            "  assert(x == tx and y == ty and angle == tangle and t:body(i) == body and t:position(i) == x)\n"
            "end") == "");
    CHECK_THAT(bench.run("t:position(50)"), Contains("index is 50; expected 1 to 49"));
    REQUIRE(bench.run("w:destroy()") == "");
    CHECK_THAT(bench.run("w:read_transforms(t)"), Contains("this world was destroyed"));
}

TEST_CASE("a mover walks on the ground, stops at walls, and is carried by nothing else") {
    LuaBench bench;
    REQUIRE(bench.run("w = cairn.physics.new_world{}\n"
                      "w:add_box{ type = 'static', y = -1, width = 100, height = 2 }\n"
                      "w:add_box{ type = 'static', x = 5, y = 2, width = 1, height = 4 }\n"
                      "m = cairn.physics.new_mover{ x = 0, y = 0.5 }\n"
                      "for i = 1, 180 do local vx, vy = m:velocity() m:move(w, 3, m:is_grounded() and 0 or "
                      "vy - 10 / 60, 1 / 60) "
                      "w:step(1 / 60) end") == "");
    CHECK(bench.value("m:is_grounded()") == "true");
    CHECK(bench.value("m:ground_body(w):type()") == "static");
    // The wall's face is at 4.5, the capsule 0.3 wide each way.
    CHECK(bench.value("math.abs(m:position() - 4.2) < 0.02") == "true");
    CHECK(bench.value("math.abs(select(2, m:position())) < 0.02") == "true");
    REQUIRE(bench.run("m:teleport(0, 9)") == "");
    CHECK(bench.value("m:is_grounded()") == "false");
    CHECK_THAT(bench.run("cairn.physics.new_mover{ radius = 1 }"),
               Contains("must be less than half the height"));
    CHECK_THAT(bench.run("cairn.physics.new_mover{ height = 0.1 }"),
               Contains("height = 0.1: must be more than twice the radius, which is 0.3 unless given"));
    CHECK_THAT(bench.run("cairn.physics.new_mover{ up_y = 0 }"), Contains("must be a direction"));
}

}  // namespace
}  // namespace cairn::scripting::test
